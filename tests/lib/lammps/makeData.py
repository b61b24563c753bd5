#!/usr/bin/python3
# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
# ------------------------------------------------------------------------------
"""makeData.py CASE FILE: the parcels that CASE starts from, for LAMMPS."""

import os
import sys

sys.path.append(os.environ["PROJECT_DIR"] + "/tests/lib")
import cghsTest as of

case, path = sys.argv[1:]
x = of.cloud_field(case, 0, "parcels", "position")
v = of.cloud_field(case, 0, "parcels", "U")

with open(path, "w", encoding="ascii") as out:
    out.write(f"The bed of {case}\n\n{len(x)} atoms\n1 atom types\n\n")
    for axis in "xyz":
        out.write(f"0 0.02 {axis}lo {axis}hi\n")
    out.write("\nAtoms\n\n")
    for i, (a, b, c) in enumerate(x, 1):
        out.write(f"{i} 1 1e-3 2500 {a:.12g} {b:.12g} {c:.12g}\n")
    out.write("\nVelocities\n\n")
    for i, (a, b, c) in enumerate(v, 1):
        out.write(f"{i} {a:.12g} {b:.12g} {c:.12g} 0 0 0\n")
