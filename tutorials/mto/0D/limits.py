# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     The stirred reactor solved without cghsFoam, from the same inputs, by two
#     ideas of its catalyst:
#
#     alike       all of it has the mean coke, as in the chapter's 0-D reactor
#                 with its one parcel;
#     mixed       each bit of it has its own age and coke, and goes out by lot.
#
#     Gas is well mixed and has no memory: it is renewed in a second, coke grows
#     in hours. Of methanol comes in n_0 [mol/s], C [mol/m3] is in the reactor,
#     and K = m <k phi> [m3/s] are the rates on m kg of catalyst; Q is the
#     volume that flows out, of as many moles as come in and are made:
#
#         n_0 = C (sum K + Q),    Q = (N_0 + C sum K nu) R T/p
#
#     Catalyst without coke comes in with F [kg/s] and its inventory is m, so
#     that in a steady reactor ages have the density exp(-t/tau)/tau, tau = m/F.
#     Run by itself it prints the steady limits, and what the plant's numbers
#     ask for:
#
#         python3 limits.py
# ------------------------------------------------------------------------------
"""Balances of the stirred reactor for methanol to olefins."""

import sys

sys.dont_write_bytecode = True
from mto import (  # noqa: E402
    CARBON, CHAPTER_LIGHT, CHAPTER_STIRRED, GAS, HERE, HOUR, HYDROGEN, LIGHT,
    PEAK, PLANT, PLANT_LIGHT, Inputs, np)

R = 8.31446261815324
LUMPS = list(CARBON)
IS_GAS = np.array([lump in GAS for lump in LUMPS])
IS_LIGHT = np.array([lump in LIGHT for lump in LUMPS])
COKE = LUMPS.index("coke")


def of_total(w):
    """Coke by mass of all [%] from that on the catalyst [g/100 g]; the other
    way round it is on_catalyst."""
    return 100*w/(100 + w)


def on_catalyst(Y):
    return 100*Y/(100 - Y)


class Stirred:
    """The reactor of a case. by_total: phi takes coke by mass of all, if not as
    the case says."""

    def __init__(self, case=HERE, by_total=None):
        i = self.inputs = Inputs(case)
        M = i.chemistry.M
        self.by_total = i.coke_by_total() if by_total is None else by_total
        self.A, self.alpha = i.rates()

        # Of one mole of methanol: grams and moles of gas, water closes the mass
        self.mass = np.array([M[s]/CARBON[s] for s in LUMPS])
        water = (M["MeOH"] - self.mass)/M["H2O"]
        share = np.array([1/CARBON[s] for s in LUMPS])
        self.more = np.where(IS_GAS, share, 0) + water - 1
        # Atoms of hydrogen and oxygen that come from nowhere
        hydrogen = np.array([HYDROGEN[s] for s in LUMPS])
        self.hydrogen = share*hydrogen + 2*water - 4
        self.oxygen = water - 1

        moles = {s: i.gas*Y/M[s] for s, Y in i.gas_Y.items()}
        self.methanol, self.all_gas = moles["MeOH"], sum(moles.values())
        self.concentration = i.p/(R*i.T)
        # Without coke [kg/s], and the coke on it [g/100 g]
        self.fresh = i.feed*(1 - i.feed_coke)
        self.fresh_coke = on_catalyst(100*i.feed_coke)

    def rates(self, w):
        """k phi of all lumps [m3/kg/s], a column for each coke w [g/100 g]."""
        w = np.atleast_1d(of_total(w) if self.by_total else w)
        phi = np.exp(-np.outer(self.alpha, w))/(1 + 9*np.exp(2*(w - 7.8)))
        return self.A[:, None]*phi

    def gas(self, K):
        """C, and of methanol what goes to each lump [mol/s], by K of each."""
        a = (K @ self.more)/self.concentration
        b = K.sum() + self.all_gas/self.concentration
        C = 2*self.methanol/(b + np.sqrt(b*b + 4*a*self.methanol))
        return C, K*C

    def gas_time(self, K):
        """In which the gas is renewed [s]."""
        i = self.inputs
        Q = (self.all_gas + self.gas(K)[1] @ self.more)/self.concentration
        return (i.volume - i.inventory/i.density)/Q

    def products(self, K):
        """Of K of each lump: conversion, shares of hydrocarbon gas by mass,
        coke made [kg/s], share of methanol's carbon in each lump [-]."""
        C, turned = self.gas(K)
        mass = turned*self.mass
        shares = np.where(IS_GAS, mass, 0)/mass[IS_GAS].sum()
        return dict(C=C, conversion=turned.sum()/self.methanol, shares=shares,
                    light=shares[IS_LIGHT].sum(), coke=mass[COKE],
                    carbon=turned/self.methanol, turned=turned)

    # All catalyst alike

    def alike_at(self, w):
        """With so much coke, and coke made less that carried away [kg/s]."""
        m = self.inputs.inventory/(1 + w/100)
        found = self.products(m*self.rates(w)[:, 0])
        away = self.fresh*(w - self.fresh_coke)/100
        return dict(found, w=w, coke_mean=of_total(w), m=m,
                    surplus=found["coke"] - away, away=away)

    def alike(self):
        """Steady, by halving."""
        low, high = self.fresh_coke, 30.0
        for _ in range(60):
            w = 0.5*(low + high)
            more = self.alike_at(w)["surplus"] > 0
            low, high = (w, high) if more else (low, w)
        return self.alike_at(w)

    def alike_over_time(self, end, dt=20.0):
        """Times [s] and coke by mass of all [%], by Runge and Kutta."""
        i = self.inputs

        def slope(y):
            m, k = y
            made = self.products(m*self.rates(100*k/m)[:, 0])["coke"]
            out = (i.feed + made)/(m + k)
            return np.array([self.fresh - out*m,
                             i.feed*i.feed_coke + made - out*k])

        y = i.inventory*np.array([1 - i.start, i.start])
        rows = [(0, 100*i.start)]
        for n in range(round(end/dt)):
            s1 = slope(y)
            s2 = slope(y + 0.5*dt*s1)
            s3 = slope(y + 0.5*dt*s2)
            s4 = slope(y + dt*s3)
            y = y + dt/6*(s1 + 2*s2 + 2*s3 + s4)
            rows.append(((n + 1)*dt, 100*y[1]/y.sum()))
        return np.array(rows).T

    # Each bit of it by itself

    def growth(self, w, C, dt):
        """One step of w at the concentration C, by Heun."""
        def slope(w):
            return 100*C*self.mass[COKE]*self.rates(w)[COKE]
        first = slope(w)
        return w + 0.5*dt*(first + slope(w + dt*first))

    def mixed(self, ages=20, n=3000):
        """Steady: as it grows along its age, over exponential ages."""
        C, m = 0.2, self.inputs.inventory
        for _ in range(200):
            tau = m/self.fresh
            dt = ages*tau/n
            w = np.empty(n + 1)
            w[0] = self.fresh_coke
            for j in range(n):
                w[j + 1] = self.growth(w[j], C, dt)[0]
            # What leaves within each step has its ages' share
            age = dt*np.arange(n + 1)
            share = np.exp(-age[:-1]/tau)*(1 - np.exp(-dt/tau))
            share /= share.sum()
            middle = 0.5*(w[1:] + w[:-1])
            mean = share @ middle
            K = self.inputs.inventory/(1 + mean/100)*(
                self.rates(middle) @ share)
            found = self.products(K)
            new = found["C"], self.inputs.inventory/(1 + mean/100)
            done = abs(new[0]/C - 1) + abs(new[1]/m - 1) < 1e-10
            C, m = new
            if done:
                break
        return dict(found, w=mean, coke_mean=of_total(mean), m=m, tau=tau,
                    along=middle, share=share, age=0.5*(age[1:] + age[:-1]),
                    away=self.fresh*(mean - self.fresh_coke)/100)

    def mixed_over_time(self, end, dt=20.0, at=()):
        """Times [s], coke by mass of all [%]; and at some times the coke by
        mass of all [%] of bits of catalyst, their mass [-], whether they came
        in."""
        i = self.inputs
        w = np.array([on_catalyst(100*i.start)])
        m = np.array([i.inventory/(1 + w[0]/100)])
        rows, seen = [(0, 100*i.start)], {}
        for n in range(round(end/dt)):
            C = self.gas(self.rates(w) @ m)[0]
            ahead = self.growth(w, C, dt)
            C = 0.5*(C + self.gas(self.rates(ahead) @ m)[0])
            w = self.growth(w, C, dt)
            # What comes in has half a step, on the average
            w = np.append(w, self.growth(self.fresh_coke, C, 0.5*dt))
            new = self.fresh*dt
            # By lot, so of all that was there before and of it alike
            m = np.append(m, new)
            m *= i.inventory/(m @ (1 + w/100))
            time = (n + 1)*dt
            rows.append((time, of_total(w @ m/m.sum())))
            if time in at:
                mass = m*(1 + w/100)
                seen[time] = (of_total(w), mass/mass.sum(),
                              np.arange(w.size) > 0)
        return np.array(rows).T, seen


def peak(coke, mass, width=0.25):
    """Where most of a distribution is: the middle of its fullest class above
    the coke of the feed [%]."""
    edges = np.arange(0, 15, width)
    found = np.histogram(coke, edges, weights=mass)[0]
    return edges[np.argmax(found)] + 0.5*width


def density(gas):
    """Of what comes in by the distributor, 2:1 [kg/m3]."""
    M = gas.inputs.chemistry.M
    return gas.concentration*3/(2/M["MeOH"] + 1/M["H2O"])


def line(name, found):
    print(f"{name}: coke {found['coke_mean']:.3f} % of all,"
          f" {found['w']:.3f} g/100 g; made {HOUR*found['coke']:.4f} kg/h,"
          f" carried away {HOUR*found['away']:.4f} kg/h; conversion"
          f" {100*found['conversion']:.2f} %, light olefins"
          f" {100*found['light']:.2f} %; "
          + ", ".join(f"{s} {100*y:.2f}" for s, y in
                      zip(LUMPS, found["shares"]) if s in GAS))


def main():
    reactor = Stirred()
    print(f"gas at the distributor: {density(reactor):.4f} kg/m3, Table 10:"
          " 0.4288\n")
    for by_total, what in ((False, "g/100 g of catalyst"),
                           (True, "g/100 g of all")):
        one = Stirred(by_total=by_total)
        print(f"phi takes coke in {what}")
        line("  alike", one.alike())
        mixed = one.mixed()
        line("  mixed", mixed)
        fullest = peak(of_total(mixed["along"]),
                       mixed["share"]*(1 + mixed["along"]/100))
        print(f"  mixed: residence time {mixed['tau']/HOUR:.4f} h, new after"
              f" half an hour {100*(1 - np.exp(-0.5*HOUR/mixed['tau'])):.1f} %,"
              f" most at {fullest:.2f} % (chapter {PEAK} %)")

    print(f"\nThe chapter's {CHAPTER_STIRRED} % and {CHAPTER_LIGHT} %, and the"
          f" plant's {PLANT} % and {PLANT_LIGHT} %")
    for Y in (CHAPTER_STIRRED, PLANT):
        found = reactor.alike_at(on_catalyst(Y))
        line(f"  catalyst alike, held at {Y} %", found)
    for light in (CHAPTER_LIGHT, PLANT_LIGHT):
        low, high = 0.0, 10.0
        for _ in range(60):
            w = 0.5*(low + high)
            more = reactor.alike_at(w)["light"] < light/100
            low, high = (w, high) if more else (low, w)
        print(f"  {light} % of light olefins: at {of_total(w):.2f} % of coke")


if __name__ == "__main__":
    main()
