# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     The steady limits of the regenerator: solids that are well mixed and all as
#     hot as the gas, which flows through them as a plug or is well mixed, too.
#     Balances of carbon, hydrogen, the gas's species and enthalpy are solved by
#     Newton's method. The flue gas that comes with the spent catalyst is mixed
#     with the air at the floor. Run by itself it prints both:
#
#         python3 limits.py
# ------------------------------------------------------------------------------
"""Steady limits of the regenerator."""

import numpy as np

R = 8.31446261815324
GAS = ("O2", "CO2", "CO", "H2O", "N2")

# kg/mol, J/kg/K, heat of formation at 298.15 K in J/kg: as in constant/
M = dict(O2=0.0319988, CO2=0.04400995, CO=0.02801055, H2O=0.01801534,
         N2=0.0280134, C=0.01201115, H=0.00100797)
CP = dict(O2=1010, CO2=1080, CO=1090, H2O=2020, N2=1080, C=1600, H=14300,
          catalyst=1150)
HF = dict(CO2=-8.9415e6, CO=-3.9462e6, H2O=-1.3423e7)

# Table 7; and the flue gas with the catalyst as in 0/U
FEED, T_FEED, INVENTORY, P = 22.7, 753.0, 4950.0, 1.5e5
FEED_Y = dict(C=0.009, H=0.00072, catalyst=0.99028)
FLOWS = ((1.7435, 573.0, dict(O2=0.232, CO2=0.0005, N2=0.7675)),
         (0.117, 753.0, dict(O2=0.0212, CO2=0.2617, CO=0.0093, H2O=0.0416,
                             N2=0.6662)))
VOLUME = INVENTORY/1500*(1/(1 - 0.8794) - 1)    # of gas in the bed [m3]
SLICES = 400


def enthalpy(name, T):
    return HF.get(name, 0) + CP[name]*(T - 298.15)


def gas_in():
    """[mol/s]"""
    return np.array([sum(flow*Y.get(s, 0)/M[s] for flow, _, Y in FLOWS)
                     for s in GAS])


def rates(T):
    """1/bar/s of C and H; share of CO that leaves the carbon; of CO's fire."""
    r = 5.28e-3*np.exp(34860/(R*T))
    return (2.78e8*np.exp(-161200/(R*T)), 4.17e8*np.exp(-157569/(R*T)),
            1/(1 + r), 1.3e8*np.exp(-15105/T))


def burning(n, C, H, T):
    """Of the whole bed, if gas of these flows [mol/s] were everywhere in it:
    what they gain, carbon and hydrogen that burn [mol/s]."""
    k_C, k_H, share, k_CO = rates(T)
    x = np.maximum(n, 0)/n.sum()
    O2, _, CO, H2O, _ = x
    carbon = k_C*O2*P/1e5*INVENTORY*C/M["C"]
    hydrogen = k_H*O2*P/1e5*INVENTORY*H/M["H"]
    fire = k_CO*VOLUME*(P/(R*T))**2*CO*np.sqrt(O2*H2O)
    gain = np.array([
        -carbon*(1 - 0.5*share) - 0.25*hydrogen - 0.5*fire,
        carbon*(1 - share) + fire, carbon*share - fire, 0.5*hydrogen, 0])
    return gain, carbon, hydrogen


def through(C, H, T, plug):
    """Gas that flows out, and what burns [mol/s]."""
    n = gas_in()
    if plug:
        carbon = hydrogen = 0
        for _ in range(SLICES):
            middle = n + 0.5*burning(n, C, H, T)[0]/SLICES
            gain, c, h = burning(middle, C, H, T)
            n = n + gain/SLICES
            carbon += c/SLICES
            hydrogen += h/SLICES
        return n, carbon, hydrogen

    # Mixed: towards the steady state, as long as it takes
    start, n = n, 0.5*n
    for _ in range(2000):
        J = np.empty((5, 5))
        f = start + burning(n, C, H, T)[0] - n
        for k in range(5):
            d = 1e-6*max(n[k], 1e-3)
            m = n.copy()
            m[k] += d
            J[:, k] = (start + burning(m, C, H, T)[0] - m - f)/d
        step = np.linalg.solve(J, -f)
        size = min(1, 0.5/max(np.max(-step/np.maximum(n, 1e-9)), 1e-9))
        n = np.maximum(n + size*step, 1e-9)
        if np.abs(step).max() < 1e-9:
            break
    _, carbon, hydrogen = burning(n, C, H, T)
    return n, carbon, hydrogen


def misfits(unknown, plug):
    """Of C, H and T, over what they are."""
    C, H, T = unknown
    n, carbon, hydrogen = through(C, H, T, plug)
    lost = (carbon*M["C"], hydrogen*M["H"])
    solids = FEED - sum(lost)
    heat_in = FEED*sum(y*enthalpy(s, T_FEED) for s, y in FEED_Y.items())
    for flow, t, Y in FLOWS:
        heat_in += flow*sum(y*enthalpy(s, t) for s, y in Y.items())
    left = dict(C=C, H=H, catalyst=1 - C - H)
    heat_out = solids*sum(y*enthalpy(s, T) for s, y in left.items())
    heat_out += sum(v*M[s]*enthalpy(s, T) for s, v in zip(GAS, n))
    return np.array([
        (FEED*FEED_Y["C"] - solids*C - lost[0])/(FEED*FEED_Y["C"]),
        (FEED*FEED_Y["H"] - solids*H - lost[1])/(FEED*FEED_Y["H"]),
        (heat_in - heat_out)/(FEED*CP["catalyst"]*300)])


def limit(plug):
    """Of the solids C and H, T [K], and mass fractions of the gas that leaves."""
    x = np.array([0.0043, 0.0001, 910.0])
    for _ in range(100):
        f = misfits(x, plug)
        J = np.empty((3, 3))
        for k in range(3):
            y = x.copy()
            y[k] *= 1 + 1e-5
            J[:, k] = (misfits(y, plug) - f)/(1e-5*x[k])
        step = np.linalg.solve(J, -f)
        x = x + min(1, 0.2/np.abs(step/x).max())*step
        if np.abs(step/x).max() < 1e-8:
            break
    else:
        raise RuntimeError("the steady limit has not been found")
    n = through(*x, plug)[0]
    mass = np.array([M[s] for s in GAS])*n
    return dict(C=x[0], H=x[1], T=x[2], **dict(zip(GAS, mass/mass.sum())))


def main():
    for name, plug in (("gas in plug flow", True), ("gas mixed", False)):
        found = limit(plug)
        print(f"{name}: {found['T']:.1f} K, coke"
              f" {100*(found['C'] + found['H']):.3f} %; gas by mass, %: "
              + ", ".join(f"{s} {100*found[s]:.3g}" for s in GAS))


if __name__ == "__main__":
    main()
