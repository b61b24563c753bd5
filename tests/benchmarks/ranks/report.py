#!/usr/bin/python3
# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
# ------------------------------------------------------------------------------
"""report.py STEPS FEW: figures of the benchmark ranks, from its logs.

A rank that waits for another is busy waiting, so that on cores of their own
CPU time is time on the wall. Where cores are shared, waiting grows and nothing
ever shortens it: so the least of the rounds counts."""

import os
import sys
from pathlib import Path

sys.path.append(os.environ["PROJECT_DIR"] + "/tests/benchmarks/lib")
import measure as ms

N, CELLS = 10**5, 13310
ROUNDS = range(1, 6)

logs = {
    ranks: [ms.Log(f"log.{ranks}-{r}") for r in ROUNDS]
    for ranks in ("one", "two")
}
cpu = {ranks: [log.cpu_seconds for log in logs[ranks]] for ranks in logs}
profiles = {}

for ranks in logs:
    solids_steps = sum(logs[ranks][0].solids_steps)
    fluid_steps = len(logs[ranks][0].solids_steps)
    least = cpu[ranks].index(min(cpu[ranks]))
    profiles[ranks] = ms.Profile(
        f"profile-{ranks}-{least + 1}", logs[ranks][least]
    )
    print(
        f"\n    {ranks}: {min(cpu[ranks]):.2f} s CPU of a rank at least,"
        f" {ms.median(cpu[ranks]):.2f} s in the median"
        f" (noise {ms.spread(cpu[ranks]):.0f} %)"
    )
    ms.print_stages([profiles[ranks]], N, CELLS, solids_steps, fluid_steps)

print(f"\n    {'stage':33s} {'speedup':>8s}")
for stage, title in ms.STAGES.items():
    one = profiles["one"].seconds.get(stage, 0.0)
    two = profiles["two"].seconds.get(stage, 0.0)
    if one > 0.01 * profiles["one"].total and two > 0:
        print(f"    {title:33s} {one/two:8.2f}")



def work(case):
    """CPU time of the busier rank outside MPI, start-up included [s]; least
    of the rounds."""
    rounds = []
    for r in ROUNDS:
        lines = Path(f"waiting.{case}-{r}").read_text().splitlines()
        pairs = [[float(x) for x in line.split()] for line in lines]
        rounds.append(max(cpu - waiting for cpu, waiting in pairs))
    return min(rounds)


steps, few = (int(n) for n in sys.argv[1:])
work_alone = min(cpu["one"]) / (steps - 1)
work_shared = (work("two") - work("short")) / (steps - few)
print(
    f"\n    work of a step without waiting: {1e3*work_alone:.1f} ms on one"
    f" rank, {1e3*work_shared:.1f} ms\n    on each of two:"
    f" {work_alone/work_shared:.2f} times faster if nothing ever waited"
)

load = os.getloadavg()[0]
print(f"\n    load of the machine in the last minute: {load:.1f}\n")

ms.figure("ranks.speedup2", min(cpu["one"]) / min(cpu["two"]))
