# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Reactions and heat at the ends of what can be given:
#
#     - atOnce: char in a closed box of air, at rates of 1e12 1/s, until all
#       oxygen is gone: elements, mass and energy close, temperature by balance.
#     - cold: parcels of 100 K in gas of 3000 K, and the other way round, come
#       to the temperature of the mixture; a reaction that asks for 24000 K does
#       not take place at 100 K.
#     - ignites: a gas that heats itself, A -> B with an activation temperature
#       of 30000 K: when half of it is gone against the rate equation, to
#       two steps, and the temperature at the end, also of one long step.
#     - husk: char of constant diameter and no ash burns up where nothing drags
#       at it: it is taken out at its leastDensity, not driven by the pressure
#       gradient; without that entry an error, before anything is written.
# ------------------------------------------------------------------------------
"""Reactions of the stability matrix."""

import numpy as np

import cghsTest as of
from cghsCase import CLOUD
from hotChar import AIR, BURN, CP, P, burning, final_temperature, history, hot
from matrix import refused, result, solve
from mixtures import fractions
from reacting import ATOMS, R, char, cloud, weight

ISOMERS = {"A": ({"N": 2}, 1100, 4e5), "B": ({"N": 2}, 1100, 0)}
FORM = dict(energyForm="sensibleInternalEnergy")


def off_from(case, exact):
    """The largest relative error of T at the end, of gas and parcels."""
    T = of.field(case.folder, case.last(), "T").mean()
    Tp = cloud(case, case.last(), "T")
    return max(abs(T/exact - 1), abs(Tp/exact - 1).max())


def at_once():
    for k in (1e12, 1e-12):
        name, dt = f"atOnce.{k:g}", 0.1
        case = burning(name, f"{BURN} A {k};", dt, 100, writeInterval=25*dt,
                       **FORM)
        solve(name, case)
        held = history(case, np.array([1.0]))
        for what, defect in zip(("C", "O", "mass"),
                                abs(held/held[0] - 1).max(axis=0)):
            result(f"{name}.{what}", defect, 1e-10)
        result(f"{name}.energy", np.ptp(held[:, 3])/held[0, 4], 1e-10)
        least = min(of.field(name, case.last(), s).min() for s in AIR)
        result(f"{name}.least", max(-least, 0), 1e-15)
        if k < 1:
            burnt = of.field(name, case.last(), "CO2").max()
            result(f"{name}.burnt", burnt, 1e-9)
            continue
        exact = final_temperature(case)
        result(f"{name}.T", off_from(case, exact), 1e-5)
        result(f"{name}.oxygen", of.field(name, case.last(), "O2").max(), 1e-12)


def cold():
    for gas, parcels in ((3000.0, 100.0), (100.0, 3000.0), (100.0, 100.0)):
        name = f"cold.{gas:g}.{parcels:g}"
        # At 3000 K it would be over at once
        rate = f"{BURN} A 1e6; Ta {24000 if parcels == gas else 1e6:g};"
        case = hot(name, "C + O2 = CO2", rate, cells=(1, 1, 1), T=gas,
                   deltaT=0.5, endTime=20, **FORM)
        d, W, rho = 1e-4, 1e6, 2000.0
        case.parcels([(0.4, 0.5, 0.5), (0.6, 0.5, 0.5)], d=d, W=W, rho=rho,
                     T=[parcels, parcels])
        char(case, [0.5, 0.5])
        fractions(case, O2=0.233, CO2=0, N2=0.767)
        solve(name, case)
        m = W*rho*np.pi/6*d**3
        Y = {"O2": 0.233, "N2": 0.767}
        M = 1e-3/sum(Y[s]/weight(AIR[s][0]) for s in Y)
        n = P/(R*gas)*(1 - 2*m/rho)
        C = n*(M*sum(Y[s]*AIR[s][1] for s in Y) - R)
        Cp = 2*m*0.5*sum(CP.values())
        exact = (C*gas + Cp*parcels)/(C + Cp)
        result(f"{name}.T", off_from(case, exact), 1e-5)
        result(f"{name}.burnt", of.field(name, case.last(), "CO2").max(), 1e-12)


def ignites():
    T0, q, Cp, Ta, end = 800.0, 4e5, 1100.0, 30000.0, 2.0
    M = weight({"N": 2})*1e-3
    rise = q/(Cp - R/M)
    # Ignites at half of the time
    A = np.exp(Ta/T0)*T0**2/(rise*Ta)/(0.5*end)

    # By hand, in steps of what has reacted: when half of it has
    y = np.linspace(0, 0.5, 200001)
    wait = 1/(A*np.exp(-Ta/(T0 + rise*y))*(1 - y))
    at = (0.5*(wait[1:] + wait[:-1])*np.diff(y)).sum()

    for steps in (100, 200, 1):
        name, dt = f"ignites.{steps}", end/steps
        case = hot(name, "A = B", 'of fluidVolume; driving "mol/m3";'
                   f" orders {{ A 1; }} A {A:.17g}; Ta {Ta};", species=ISOMERS,
                   cells=(1, 1, 1), T=T0, molWeight=M*1e3, deltaT=dt,
                   endTime=end, writeInterval=dt, **FORM)
        # So few that the gas does not feel them
        case.parcels([(0.5, 0.5, 0.5)], d=1e-6, W=1, rho=2000, T=[T0])
        char(case, [0.0])
        fractions(case, A=1, B=0)
        solve(name, case)
        t = [s for s in of.times(case.folder) if float(s) > 0]
        T = np.array([of.field(name, s, "T").mean() for s in t])
        result(f"{name}.end", abs(T[-1]/(T0 + rise) - 1), 1e-6)
        beyond = max(T.max() - T0 - rise, T0 - T.min(), 0)
        # To what OpenFOAM's iteration leaves of T
        result(f"{name}.range", beyond/rise, 1e-6)
        if steps > 1:
            half = np.interp(T0 + rise/2, T, np.array(t, float))
            print(f"{name}: ignites at {half:.5f} s, by hand {at:.5f} s")
            # Within a step the gas heats up at constant pressure: it is late
            # by (1 - Cv/Cp)/2 of a step for each e-fold of the rate
            result(f"{name}.time", abs(half - at)/dt, 2)


def gas_carbon(case):
    """In 1 m3 [kg]."""
    alpha, rho, Y = (of.field(case.folder, case.last(), f)
                     for f in ("alpha", "rho", "CO2"))
    return (alpha*rho*Y).mean()*ATOMS["C"]/weight(AIR["CO2"][0])


def husk(least, said=None):
    """In air under gravity."""
    name = "husk." + (f"{least:g}" if least else "none")
    d, W, rho, dt = 1e-4, 1e5, 2000.0, 0.05
    case = hot(name, "C + O2 = CO2", f"{BURN} A 2;", cells=(1, 4, 1),
               g=(0, -9.81, 0), deltaT=dt, endTime=160*dt, writeInterval=2*dt,
               **FORM)
    if least:
        case.append("constant/parcelsProperties", "subModels {"
                    f" reactionsCoeffs {{ leastDensity {least}; }} }}")
    case.parcels([(0.4, 0.5, 0.5), (0.6, 0.8, 0.5)], d=d, W=W, rho=rho,
                 T=[1000.0, 1000.0])
    char(case, [1.0, 1.0])
    fractions(case, O2=0.233, CO2=0, N2=0.767)
    if said:
        refused(name, case, *said)
        return
    solve(name, case)
    there = [t for t in of.times(case.folder)
             if of.has(case.folder/t/"lagrangian"/CLOUD/"d")]
    result(f"{name}.left", int(case.last() in there), 0)
    # Never lighter than that, in gas of 0.35 kg/m3 at most
    fastest = max(abs(cloud(case, t, "U")).max() for t in there)
    result(f"{name}.fastest", fastest, 9.81*(1 + 0.35/least)*160*dt)
    burnt = gas_carbon(case) - 2*W*rho*np.pi/6*d**3
    out = dt*of.log_values(case.folder/"log.cghsFoam", "burntOut").sum()
    print(f"{name}: up to {fastest:.3g} m/s, {abs(out):.3g} kg taken out")
    result(f"{name}.carbon", abs(burnt + abs(out))/(abs(out) - burnt), 1e-6)


def main():
    at_once()
    cold()
    ignites()
    for args in ((1.0,), (0, ["out of hand", "leastDensity"])):
        husk(*args)


if __name__ == "__main__":
    main()
