# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Table 1 of the chapter: 4586 particles of 1 mm, a solids fraction of 0.30
#     in a cube of 20 d, with velocities uniform in +-0.05 m/s, settle under
#     gravity.
#
#         bed = settle("chapter", 0.5, correctionModel="velocity")
#         energy = mean(bed.table(), "kineticEnergy", 0.49, 0.5)/KE0
# ------------------------------------------------------------------------------
"""The settling bed of Table 1."""

import numpy as np

from cghsCase import Case

D = 1e-3
SIDE = 20*D
N = 4586
MASS = N*np.pi/6*D**3*2500
SPREAD = 0.05
KE0 = 0.5*MASS*3*SPREAD**2/3


def prepare(name, until, **parameters):
    """The case, ready to run until this time."""
    case = Case(name, **{**dict(
        x1=SIDE, y1=SIDE, z1=SIDE, cells=(10, 10, 10), e=0.95, et=0.95, mu=0.1,
        deltaT=1e-4, endTime=until), **parameters})
    case.fill(fillNumber=N, fillSpread=(SPREAD,)*3)
    return case


def settle(name, until, **parameters):
    case = prepare(name, until, **parameters)
    case.solve()
    return case


def mean(table, name, start, end):
    """Mean of a column between two times."""
    inside = (table["time"] > start) & (table["time"] <= end)
    return table[name][inside].mean()
