#!/usr/bin/python3
# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
# ------------------------------------------------------------------------------
"""Figures of the benchmark parcelStep, from its logs."""

import os
import sys
from pathlib import Path

sys.path.append(os.environ["PROJECT_DIR"] + "/tests/benchmarks/lib")
import measure as ms

ROUNDS = (1, 2, 3)
BEDS = {"1e4": (10**4, 1331), "1e5": (10**5, 13310), "1e6": (10**6, 133100)}
NOT_OURS = ("cghs::fluid", "cghs::report", "other")


def memory(bed, k):
    """Resident bytes after the last step (k = 0), or the most (k = 1)."""
    return ms.median(
        [
            int(Path(f"log.{bed}-{r}.memory").read_text().split()[k])
            for r in ROUNDS
        ]
    )


step = {}
for bed, (n, cells) in BEDS.items():
    logs = [ms.Log(f"log.{bed}-{r}") for r in ROUNDS]
    profiles = [
        ms.Profile(f"profile-{bed}-{r}", log) for r, log in zip(ROUNDS, logs)
    ]
    solids_steps = sum(logs[0].solids_steps)
    fluid_steps = len(logs[0].solids_steps)
    step[bed] = [
        1e6 * sum(s for k, s in p.seconds.items() if k not in NOT_OURS)
        / (n * solids_steps)
        for p in profiles
    ]
    print(
        f"\n    {bed} parcels, {cells} cells: {solids_steps:.0f} steps,"
        f" {sum(logs[0].lists):.0f} contact lists;"
        f" parcel-step {ms.median(step[bed]):.3f} us"
        f" (noise {ms.spread(step[bed]):.1f} %)"
    )
    ms.print_stages(profiles, n, cells, solids_steps, fluid_steps)

growth = ms.median(step["1e6"]) / ms.median(step["1e4"])
per_parcel = [
    (memory("1e5", k) - memory("sparse", k)) / 9e4 for k in (0, 1)
]
print(f"\n    growth of the parcel-step from 1e4 to 1e6: {growth:.2f}")
print(
    f"    memory of a parcel: {per_parcel[0]:.0f} bytes while it runs,"
    f" {per_parcel[1]:.0f} at the most (reading)\n"
)

for bed in BEDS:
    ms.figure(f"parcelStep.us{bed}", ms.median(step[bed]))
ms.figure("parcelStep.bytesPerParcel", per_parcel[0])
