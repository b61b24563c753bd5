#!/usr/bin/python3
# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
# ------------------------------------------------------------------------------
"""makeParcels.py POSITIONS CLOUD: parcels of cghsFoam in the folder CLOUD, at
rest where the injector of OpenFOAM's Goldschmidt tutorial puts them."""

import os
import re
import sys
from pathlib import Path

import numpy as np

sys.path.append(os.environ["PROJECT_DIR"] + "/tests/benchmarks/lib")
import cloudFiles as cf

source, folder = sys.argv[1:]
text = Path(source).read_text()
rows = re.findall(r"\((\S+) (\S+) (\S+)\)", text)
x = np.array(rows, float)

block = cf.Block((-0.0075, -0.075, 0), (0.0075, 0.075, 0.45), (2, 30, 90))
cf.write_parcels(folder, block, x, np.zeros(3), 2.5e-3, 2526)
print(f"{len(x)} parcels")
