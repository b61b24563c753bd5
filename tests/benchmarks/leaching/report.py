#!/usr/bin/python3
# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
# ------------------------------------------------------------------------------
"""Figures of the benchmark leaching, from its runs: report.py STEP..., the
finest last."""

import os
import sys
from pathlib import Path

import numpy as np

sys.path.append(os.environ["PROJECT_DIR"] + "/tests/benchmarks/lib")
sys.path.append(os.environ["PROJECT_DIR"] + "/tests/lib")
import cghsTest as of
import measure as ms

START, FROM = 2.0, 3.0


def measured(log):
    """Steps, simulated seconds in a day and mean rate of leaching after the
    first second."""
    time = of.log_values(log, r"\nTime =")
    cpu = of.log_values(log, r"\nExecutionTime =")
    rate = of.log_values(log, r"\nreactions: leaching")
    n = min(time.size, cpu.size)
    time, cpu, rate = time[:n], cpu[:n], rate[:n]
    late = time > FROM
    first = np.argmax(late) - 1
    dt = np.diff(time, prepend=START)
    return (n, 86400*(time[-1] - time[first])/(cpu[-1] - cpu[first]),
            np.average(rate[late], weights=dt[late]))


runs = {step: measured(Path(f"log.{step}")) for step in sys.argv[1:]}
reference = runs[sys.argv[-1]][2]

print(f"\n    {'step':>8s} {'steps':>6s} {'s per day':>10s} {'leached':>14s}"
      f" {'difference':>10s}")
for step, (n, day, rate) in runs.items():
    print(f"    {step:>6s} s {n:6d} {day:10.0f} {rate:8.5f} mol/s"
          f" {100*(rate/reference - 1):9.2f}%")

print()
_, day, rate = runs[sys.argv[1]]
ms.figure("leaching.secondsPerDay", day)
ms.figure("leaching.splittingErrorPercent", 100*abs(rate/reference - 1))
