#!/usr/bin/python3
# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
# ------------------------------------------------------------------------------
"""Figures of the benchmark mto, from its runs: report.py STEP..., the
finest last."""

import os
import sys

sys.path.append(os.environ["PROJECT_DIR"] + "/tests/benchmarks/lib")
from steps import compare

compare("mto", sys.argv[1:], "olefins made", start=0.2, since=1.0,
        reactions=("toC2H4", "toC3H6"))
