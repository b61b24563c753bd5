# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Cases of cghsCase whose parcels react with the gas of their cells, at a
#     given temperature, or with heat: by transported and exchanges, and species
#     as (elements, Cp, Hf).
#
#         case = reacting("burn", {"O2": {"O": 2}, "CO2": {"C": 1, "O": 2},
#                                  "N2": {"N": 2}}, "N2", REACTIONS, ...)
#         case.parcels(x, ...)
#         composition(case, C=0.3, ash=0.7)
# ------------------------------------------------------------------------------
"""Parcels that react in the gas of a test's case."""

import numpy as np

from cghsCase import CLOUD, Case
import cghsTest as of
from mixtures import gas

# Constants and weights as OpenFOAM has them
R = 8.31447
ATOMS = {"C": 12.01115, "H": 1.00797, "O": 15.9994, "N": 14.0067}


def weight(elements):
    """Molar mass of what has so many atoms of each element [kg/kmol]."""
    return sum(ATOMS[e]*n for e, n in elements.items())


def thermo(elements, Cp=1100, Hf=0, mu=4e-5):
    atoms = " ".join(f"{e} {n};" for e, n in elements.items())
    return (f"elements {{ {atoms} }} thermodynamics {{ Cp {Cp}; Hf {Hf}; }}"
            f" transport {{ mu {mu}; Pr 0.7; }}")


def reacting(name, species, inert, reactions, T=1100.0, p=1e5, D=0, mu=4e-5,
             **parameters):
    """A case with constant/reactions of that text, without contacts and drag.
    D: diffusivity of species [m2/s], mu: viscosity [Pa s]."""
    data = {s: e if isinstance(e, tuple) else (e,) for s, e in species.items()}
    case = Case(name, **{**dict(
        fluid="gas", p=p, T=T, transported=("species",), coupling="twoWay",
        exchanges=("reactions",), contactModel="none", dragModel="none",
        mappingModel="centroid", g=(0, 0, 0), pTolerance=1e-14),
        **parameters})
    gas(case, {s: (weight(d[0]), thermo(*d, mu=mu)) for s, d in data.items()},
        inert, mu=mu, D=D)
    (case.folder/"constant/reactions").write_text(
        "FoamFile { version 2.0; format ascii; class dictionary;"
        " object reactions; }\n" + reactions)
    return case


def composition(case, **fractions):
    """Mass fractions of the parcels' solids, of each parcel."""
    for name, Y in fractions.items():
        case._field("scalar", f"Y.{name}", np.asarray(Y, float))


def char(case, C):
    """The parcels are of that share of carbon, and ash."""
    composition(case, C=C, ash=1 - np.asarray(C))


def cloud(case, time, name):
    return of.cloud_field(case.folder, time, CLOUD, name)


def parcel_masses(case, time):
    d, rho, W = (cloud(case, time, n) for n in ("d", "rho", "nParticle"))
    return W*rho*np.pi/6*d**3
