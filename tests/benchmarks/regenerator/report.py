#!/usr/bin/python3
# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
# ------------------------------------------------------------------------------
"""Figures of the benchmark regenerator, from its runs: report.py STEP..., the
finest last."""

import os
import re
import sys
from pathlib import Path

import numpy as np

sys.path.append(os.environ["PROJECT_DIR"] + "/tests/benchmarks/lib")
import measure as ms

NUMBER = r"[-+.e\d]+"
START, FROM = 1.0, 1.1


class Steps:
    """Those of a run that begins at START."""

    def __init__(self, log):
        text = Path(log).read_text()
        self.time = np.array(
            re.findall(rf"^Time = ({NUMBER})", text, re.M), float)
        self.dt = np.diff(self.time, prepend=START)
        self.cpu = np.array(
            re.findall(rf"ExecutionTime = ({NUMBER})", text), float)
        self.carbon = np.array([
            sum(float(v) for v in re.findall(
                rf"\b(?:toCO2|toCO) ({NUMBER})", line))
            for line in re.findall(r"^reactions: (.*)$", text, re.M)])

    def mean(self, values):
        late = self.time > FROM + 1e-9
        return (values[late]*self.dt[late]).sum()/self.dt[late].sum()

    def day(self):
        """Simulated seconds in a day, without the first steps."""
        late = self.time > FROM + 1e-9
        first = np.argmax(late) - 1
        return 86400*self.dt[late].sum()/max(
            self.cpu[-1] - self.cpu[first], 1e-9)


runs = {step: Steps(f"log.{step}") for step in sys.argv[1:]}
finest = runs[sys.argv[-1]]
reference = finest.mean(finest.carbon)

print(f"\n    {'step':>8s} {'steps':>6s} {'s per day':>10s} {'C burnt':>10s}"
      f" {'difference':>10s}")
for step, run in runs.items():
    carbon = run.mean(run.carbon)
    print(f"    {step:>6s} s {run.time.size:6d} {run.day():10.0f}"
          f" {carbon:8.4f}/s {100*(carbon/reference - 1):9.2f}%")

print()
coarse = runs[sys.argv[1]]
ms.figure("regenerator.secondsPerDay", coarse.day())
ms.figure("regenerator.splittingErrorPercent",
          100*abs(coarse.mean(coarse.carbon)/reference - 1))
