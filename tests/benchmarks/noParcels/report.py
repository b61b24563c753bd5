#!/usr/bin/python3
# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
# ------------------------------------------------------------------------------
"""Figures of the benchmark noParcels, from its logs."""

import os
import re
import sys
from pathlib import Path

sys.path.append(os.environ["PROJECT_DIR"] + "/tests/benchmarks/lib")
import measure as ms

# Number of cells, figure
CASES = {
    "duct": (15 * 15 * 90, "noParcels.ratioToPimpleFoam"),
    "jet": (25200, "noParcels.jetRatioToPimpleFoam"),
}
SOLVERS = ("pimpleFoam", "cghsFoam")
ROUNDS = range(1, 6)


def sweeps(case, solver, n_steps):
    """Iterations of the pressure solver a step."""
    text = Path(f"log.{case}-{solver}-1").read_text()
    found = re.findall(r"for p, .*No Iterations (\d+)", text)
    return sum(map(int, found)) / n_steps


def report(case, cells):
    """Prints the table of a case, returns the ratio of the medians."""
    logs = {
        solver: [ms.Log(f"log.{case}-{solver}-{r}") for r in ROUNDS]
        for solver in SOLVERS
    }
    cost = {s: [log.cpu_per_step for log in logs[s]] for s in logs}

    print(f"\n    {case:12s} {'us/cell-step':>13s} {'noise':>7s}", end="")
    print(f" {'pressure iterations a step':>27s}")
    for solver, values in cost.items():
        print(
            f"    {solver:12s} {1e6*ms.median(values)/cells:13.3f}"
            f" {ms.spread(values):6.1f}%"
            f" {sweeps(case, solver, len(logs[solver][0].cpu)):27.1f}"
        )

    print()
    log = logs["cghsFoam"][0]
    profiles = [
        ms.Profile(f"{case}-cghsFoam-{r}", log)
        for r, log in zip(ROUNDS, logs["cghsFoam"])
    ]
    ms.print_stages(profiles, 0, cells, 0, len(log.cpu))

    return ms.median(cost["cghsFoam"]) / ms.median(cost["pimpleFoam"])


ratios = {case: report(case, cells) for case, (cells, _) in CASES.items()}

print()
for case, (_, figure) in CASES.items():
    ms.figure(figure, ratios[case])
