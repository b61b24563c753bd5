#!/usr/bin/python3
# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
# ------------------------------------------------------------------------------
"""tile.py TILE CASE NX NY NZ [COUNT]: set the parcels of the last time of TILE
side by side in the box of CASE, in all of its tiles or in the first COUNT."""

import itertools
import os
import sys

import numpy as np

root = os.environ["PROJECT_DIR"] + "/tests"
sys.path += [root + "/lib", root + "/benchmarks/lib"]
import cghsTest as of
import cloudFiles as cf

SIDE, CELLS = 0.022, 11

tile, case, *numbers = sys.argv[1:]
nx, ny, nz, *count = (int(n) for n in numbers if n)

last = of.times(tile)[-1]
x = of.cloud_field(tile, last, "parcels", "position")
v = of.cloud_field(tile, last, "parcels", "U")

places = np.array(list(itertools.product(range(nz), range(ny), range(nx))))
places = places[: count[0] if count else None, ::-1] * SIDE

block = cf.Block(
    (0, 0, 0),
    (nx * SIDE, ny * SIDE, nz * SIDE),
    (nx * CELLS, ny * CELLS, nz * CELLS),
)
cf.write_parcels(
    f"{case}/0/lagrangian/parcels",
    block,
    (places[:, None, :] + x).reshape(-1, 3),
    np.tile(v, (len(places), 1)),
    1e-3,
    2500,
)
