# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
# ------------------------------------------------------------------------------
"""What steps of several lengths cost in time, and in accuracy of what reacts:
runs that go on from the same state, each with its log, log.<step>."""

import os
import sys

import numpy as np

import measure as ms

sys.path.append(os.environ["PROJECT_DIR"] + "/tests/lib")
import cghsTest as of


class Steps:
    """Those of a run that begins at start; what counts is from since on."""

    def __init__(self, log, start, since, reactions):
        self.time = of.log_values(log, r"\nTime =")
        self.cpu = of.log_values(log, r"\nExecutionTime =")
        rate = sum(of.log_values(log, rf"\nreactions:.*? {name}\b")
                   for name in reactions)
        late = self.time > since + 1e-9
        first = np.argmax(late) - 1
        dt = np.diff(self.time, prepend=start)[late]

        # Simulated seconds in a day, without the first steps
        self.day = 86400*dt.sum()/max(self.cpu[-1] - self.cpu[first], 1e-9)

        # Mean of what reacts [mol/s]
        self.rate = (rate[late]*dt).sum()/dt.sum()


def compare(benchmark, steps, what, **options):
    """Table and figures of a benchmark, its steps from the coarsest to the
    finest; what: reacts. options: those of Steps."""
    runs = {step: Steps(f"log.{step}", **options) for step in steps}
    reference = runs[steps[-1]].rate

    print(f"\n    {'step':>8s} {'steps':>6s} {'s per day':>10s}"
          f" {what:>14s} {'difference':>10s}")
    for step, run in runs.items():
        print(f"    {step:>6s} s {run.time.size:6d} {run.day:10.0f}"
              f" {run.rate:8.5g} mol/s {100*(run.rate/reference - 1):9.2f}%")

    print()
    coarse = runs[steps[0]]
    ms.figure(f"{benchmark}.secondsPerDay", coarse.day)
    ms.figure(f"{benchmark}.splittingErrorPercent",
              100*abs(coarse.rate/reference - 1))
