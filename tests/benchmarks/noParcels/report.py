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

CELLS = 15 * 15 * 90
ROUNDS = range(1, 6)

logs = {
    solver: [ms.Log(f"log.{solver}-{r}") for r in ROUNDS]
    for solver in ("pimpleFoam", "cghsFoam")
}
cost = {s: [log.cpu_per_step for log in logs[s]] for s in logs}


def sweeps(solver):
    """Iterations of the pressure solver a step."""
    text = Path(f"log.{solver}-1").read_text()
    found = re.findall(r"for p, .*No Iterations (\d+)", text)
    return sum(map(int, found)) / len(logs[solver][0].cpu)


print(f"\n    {'':12s} {'us/cell-step':>13s} {'noise':>7s}", end="")
print(f" {'pressure iterations a step':>27s}")
for solver, values in cost.items():
    print(
        f"    {solver:12s} {1e6*ms.median(values)/CELLS:13.3f}"
        f" {ms.spread(values):6.1f}% {sweeps(solver):27.1f}"
    )

print()
log = logs["cghsFoam"][0]
profiles = [
    ms.Profile(f"cghsFoam-{r}", log)
    for r, log in zip(ROUNDS, logs["cghsFoam"])
]
ms.print_stages(profiles, 0, CELLS, 0, len(log.cpu))
print()

ms.figure(
    "noParcels.ratioToPimpleFoam",
    ms.median(cost["cghsFoam"]) / ms.median(cost["pimpleFoam"]),
)
