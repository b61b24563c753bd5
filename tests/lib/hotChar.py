# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Char, carbon and ash, that burns in a box of air and heats it: cases of
#     cghsCase, what they hold, and how hot they get.
#
#         case = burning("box", f"{BURN} A 3;", dt=0.05, steps=20,
#                        writeInterval=0.05)
#         case.solve()
#         history(case, V=np.array([1.0]))    # C, O, mass and energy
# ------------------------------------------------------------------------------
"""Char that burns and heats, and the balances of its box."""

import re

import numpy as np

import cghsTest as of
from cghsCase import lattice
from mixtures import fractions
from reacting import ATOMS, R, char, cloud, parcel_masses, reacting, weight

P = 1e5
AIR = {"O2": ({"O": 2}, 1070, 0), "CO2": ({"C": 1, "O": 2}, 1180, -8.9415e6),
       "N2": ({"N": 2}, 1130, 0)}
CP = {"C": 1600.0, "ash": 1150.0}       # J/kg/K

# %s: heat capacity of ash, equation, rate
REACTIONS = """
solids
{
    C { elements { C 1; } thermodynamics { Cp 1600; Hf 0; } }
    ash { specie { molWeight 60; } thermodynamics { Cp %g; Hf 0; } }
}
reactions { go { equation "%s"; rate massAction; %s } }
"""
BURN = 'of moles C; driving "mol/m3"; orders { O2 1; }'


def hot(name, equation, rate, species=AIR, ash=CP["ash"], **parameters):
    """A case in which one reaction heats parcels and gas."""
    case = reacting(name, species, list(species)[-1],
                    REACTIONS % (ash, equation, rate), **{**dict(
                        p=P, transported=("species", "energy"),
                        exchanges=("heat", "reactions"), molWeight=28.96,
                        heatTransferModel="RanzMarshall"), **parameters})
    case.append("constant/parcelsProperties",
                "subModels { reactionsCoeffs { absolute 1e-9; } }")
    case.species = species
    return case


def burning(name, rate, dt, steps, cells=(1, 1, 1), speed=0, x=None, W=1e6,
            make=None, **parameters):
    """Char with half as much carbon again as a box of 1 m3 has oxygen for, in x
    or four in each cell, at random speeds. make: what makes the mesh."""
    case = hot(name, "C + O2 = CO2", rate, cells=cells, deltaT=dt,
               endTime=steps*dt, **parameters)
    if make:
        make(case)
    random = np.random.default_rng(3)
    if x is None:
        x = np.concatenate([lattice(*cells)*0.9 + 0.01*j for j in range(4)])
    U = speed*random.normal(size=x.shape)
    C = random.uniform(0.03, 0.07, len(x))
    oxygen = P*28.0134/R/1100*1e-3*0.233
    each = 1.5*oxygen*12/32/0.05/len(x)
    rho = 2000
    T = random.uniform(900, 1000, len(x))
    case.parcels(x, U=U, d=(6*each/(W*np.pi*rho))**(1/3), W=W, rho=rho, T=T)
    char(case, C)
    fractions(case, O2=0.233, CO2=0, N2=0.767)
    case.C, case.T0 = C, T
    return case


def final_temperature(case):
    """All oxygen gone, one temperature, internal energy as at the start."""
    d, rho, W = (cloud(case, "0", n) for n in ("d", "rho", "nParticle"))
    m = W*rho*np.pi/6*d**3
    alpha = 1 - (W*np.pi/6*d**3).sum()
    Y = {"O2": 0.233, "CO2": 0.0, "N2": 0.767}
    n = {s: Y[s]/weight(AIR[s][0]) for s in Y}
    total = P/(R*1100)*alpha            # mol
    n = {s: total*v/sum(n.values()) for s, v in n.items()}

    def h(s, T):                        # J/mol
        e, Cp, Hf = AIR[s]
        return weight(e)*1e-3*(Cp*T + Hf)

    before = sum(n[s]*(h(s, 1100) - R*1100) for s in n) \
        + (m*(case.C*CP["C"] + (1 - case.C)*CP["ash"])*case.T0).sum()
    burnt = n["O2"]
    n.update(O2=0, CO2=burnt)
    carbon = (m*case.C).sum() - burnt*ATOMS["C"]*1e-3
    fixed = sum(n[s]*h(s, 0) for s in n)
    capacity = sum(n[s]*(h(s, 1) - h(s, 0) - R) for s in n) \
        + carbon*CP["C"] + (m*(1 - case.C)).sum()*CP["ash"]
    return (before - fixed)/capacity


# What there is at each time that was written


def contents(case, time, V):
    """Mass of carbon, oxygen and all [kg] and internal energy [J] in cells of
    volume V, which must have been solved in that form; and what of it is
    thermal."""
    alpha, rho, e = (of.field(case.folder, time, f)
                     for f in ("alpha", "rho", "e"))
    gas = V*alpha*rho
    Y = {s: gas*of.field(case.folder, time, s) for s in case.species}
    m = parcel_masses(case, time)
    C = m*cloud(case, time, "Y.C")
    T = cloud(case, time, "T")
    ofC = ATOMS["C"]/weight(case.species["CO2"][0])
    thermal = (gas*e).sum() + ((C*CP["C"] + (m - C)*CP["ash"])*T).sum()
    formed = sum(Y[s].sum()*case.species[s][2] for s in Y)
    return np.array([Y["CO2"].sum()*ofC + C.sum(),
                     Y["O2"].sum() + Y["CO2"].sum()*(1 - ofC),
                     gas.sum() + m.sum(), thermal + formed, thermal])


def history(case, V):
    return np.array([contents(case, t, V) for t in of.times(case.folder)
                     if float(t) > 0])


def powers(case, *names):
    """What the gas got by these ways, of each step [W]."""
    log = (case.folder/"log.cghsFoam").read_text()
    lines = re.findall(r"energy: stored .*", log)
    return sum(np.array([float(re.search(rf"{name} ({of.NUMBER})", line)[1])
                         for line in lines]) for name in names)


def closes(name, case, V, dt, radiated=0):
    """Elements, mass and energy in each step, each of which was written, over
    what there is. radiated: what walls got of the parcels by radiation, in each
    step [J]."""
    held = history(case, V)
    gained = np.diff(held, axis=0)
    gained[:, 3] += (radiated
                     - dt*powers(case, "inflow", "walls", "pressure"))[1:]
    scale = held[0, [0, 1, 2, 4]]
    for what, defect in zip(("C", "O", "mass", "energy"),
                            abs(gained[:, :4]).max(axis=0)/scale):
        of.result(f"{name}.{what}", defect, 1e-10)
    return held
