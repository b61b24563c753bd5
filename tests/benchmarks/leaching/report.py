#!/usr/bin/python3
# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
# ------------------------------------------------------------------------------
"""Figures of the benchmark leaching, from its runs: report.py STEP..., the
finest last."""

import os
import sys

sys.path.append(os.environ["PROJECT_DIR"] + "/tests/benchmarks/lib")
from steps import compare

compare("leaching", sys.argv[1:], "leached", start=2.0, since=3.0,
        reactions=("leaching",))
