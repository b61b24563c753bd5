#!/usr/bin/python3
# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
# ------------------------------------------------------------------------------
"""Figures of the benchmark regenerator, from its runs: report.py STEP..., the
finest last."""

import os
import sys

sys.path.append(os.environ["PROJECT_DIR"] + "/tests/benchmarks/lib")
from steps import compare

compare("regenerator", sys.argv[1:], "C burnt", start=1.0, since=1.1,
        reactions=("toCO2", "toCO"))
