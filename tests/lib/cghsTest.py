# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Reads what a case has written (etc/python/caseFiles.py), for the tests and
#     for the tutorials' pages of results, and reports the tests' results. Use
#     Debian's python, which has numpy:
#
#         #!/usr/bin/python3
#         import os, sys
#         sys.path.append(os.environ["PROJECT_DIR"] + "/tests/lib")
#         import cghsTest as of
#
#         U = of.cloud_field(".", of.times(".")[-1], "cghsCloud", "U")
#         of.result("restSpeed", abs(U).max(), 1e-6)
# ------------------------------------------------------------------------------
"""Reading OpenFOAM's ASCII files with numpy, and judging what is read."""

import sys
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).resolve().parents[2] / "etc" / "python"))
from caseFiles import (  # noqa: E402
    NUMBER, cloud_by_id, cloud_field, columns, field, has, joined, log_values,
    patch_field, positions, read, read_list, table, times)

# What the tests read with, beside what is below
__all__ = (
    "NUMBER", "cloud_by_id", "cloud_field", "columns", "field", "has",
    "joined", "log_values", "patch_field", "positions", "read", "read_list",
    "table", "times")


def result(case, error, tolerance, seconds=None):
    """Report a result to tests/Alltest."""
    line = f"RESULT {case} {error:.6g} {tolerance:.6g}"
    print(line if seconds is None else f"{line} {seconds:.1f}", flush=True)


def relative_error(value, reference):
    """Largest difference over the largest magnitude of the reference."""
    value, reference = np.asarray(value), np.asarray(reference)
    return float(np.abs(value - reference).max() / np.abs(reference).max())


def difference(one, other):
    """Largest difference; infinite if there are not as many of each."""
    if one.shape != other.shape:
        return np.inf
    return float(np.abs(one - other).max())


def kolmogorov_smirnov(drawn, distribution):
    """Largest distance of the cumulative distributions of what was drawn and of
    what was asked for, a function, times the root of the number drawn: more
    than 1.63 once in a hundred."""
    n = len(drawn)
    asked = distribution(np.sort(drawn))
    steps = np.arange(n + 1)/n
    return np.sqrt(n)*max(np.abs(asked - steps[1:]).max(),
                          np.abs(asked - steps[:-1]).max())
