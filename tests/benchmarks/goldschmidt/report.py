#!/usr/bin/python3
# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
# ------------------------------------------------------------------------------
"""Figures of the benchmark goldschmidt, from its logs."""

import os
import sys

sys.path.append(os.environ["PROJECT_DIR"] + "/tests/benchmarks/lib")
import measure as ms

N_PARCELS, N_CELLS = 24750, 5400
ROUNDS = (1, 2, 3)
SOLVERS = ("DPMFoam", "MPPICFoam", "cghsFoam")

logs = {
    solver: [ms.Log(f"log.{solver}-{r}") for r in ROUNDS] for solver in SOLVERS
}
cost = {
    solver: [log.cpu_per_simulated_second for log in logs[solver]]
    for solver in SOLVERS
}

print(f"\n    {'':12s} {'CPU s per simulated s':>22s} {'noise':>8s}", end="")
print(f" {'ms a step':>10s} {'step [s]':>10s}")
for solver in SOLVERS:
    log = logs[solver][0]
    dt = (log.times[-1] - log.times[0]) / log.steps
    print(
        f"    {solver:12s} {ms.median(cost[solver]):22.4g}"
        f" {ms.spread(cost[solver]):7.1f}%"
        f" {1e3*log.cpu_per_step:10.1f} {dt:10.3g}"
    )

ours = logs["cghsFoam"]
solids_steps = sum(ours[0].solids_steps)
fluid_steps = len(ours[0].solids_steps)
print(
    f"\n    cghsFoam: {fluid_steps} fluid steps, {solids_steps:.0f} solids"
    f" steps, {sum(ours[0].lists):.0f} contact lists, largest overlap"
    f" {max(ours[0].overlaps):.2g} % of d"
)
profiles = [
    ms.Profile(f"cghsFoam-{r}", log) for r, log in zip(ROUNDS, ours)
]
ms.print_stages(profiles, N_PARCELS, N_CELLS, solids_steps, fluid_steps)
print()

for peer in ("DPMFoam", "MPPICFoam"):
    ms.figure(
        f"goldschmidt.speedupOver{peer}",
        ms.median(cost[peer]) / ms.median(cost["cghsFoam"]),
    )
