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
BEDS = {
    "1e4": (10**4, 1331, range(1, 10)),
    "1e5": (10**5, 13310, ROUNDS),
    "1e6": (10**6, 133100, ROUNDS),
}
NOT_OURS = ("cghs::fluid", "cghs::report", "other")


def memory(bed, k):
    """Resident bytes after the last step (k = 0), or the most (k = 1)."""
    return ms.median(
        [
            int(Path(f"log.{bed}-{r}.memory").read_text().split()[k])
            for r in ROUNDS
        ]
    )


step, stage_ns = {}, {}
for bed, (n, cells, rounds) in BEDS.items():
    logs = [ms.Log(f"log.{bed}-{r}") for r in rounds]
    profiles = [
        ms.Profile(f"profile-{bed}-{r}", log) for r, log in zip(rounds, logs)
    ]
    solids_steps = sum(logs[0].solids_steps)
    fluid_steps = len(logs[0].solids_steps)
    step[bed] = [
        1e6 * sum(s for k, s in p.seconds.items() if k not in NOT_OURS)
        / (n * solids_steps)
        for p in profiles
    ]
    stage_ns[bed] = {
        k: 1e9 * ms.median([p.seconds.get(k, 0.0) for p in profiles])
        / (n * solids_steps)
        for k in ms.STAGES
    }
    print(
        f"\n    {bed} parcels, {cells} cells: {solids_steps:.0f} steps,"
        f" {sum(logs[0].lists):.0f} contact lists;"
        f" parcel-step {ms.median(step[bed]):.3f} us"
        f" (noise {ms.spread(step[bed]):.1f} %)"
    )
    ms.print_stages(profiles, n, cells, solids_steps, fluid_steps)

print(f"\n    {'growth of what a parcel costs':33s}   to 1e5   to 1e6")
for stage, title in ms.STAGES.items():
    ns = [stage_ns[bed].get(stage, 0.0) for bed in BEDS]
    if stage not in NOT_OURS and ns[0] > 5:
        print(f"    {title:33s} {ns[1]/ns[0]:8.2f} {ns[2]/ns[0]:8.2f}")
us = [ms.median(step[bed]) for bed in BEDS]
print(f"    {'parcel-step':33s} {us[1]/us[0]:8.2f} {us[2]/us[0]:8.2f}")

per_parcel = [
    (memory("1e5", k) - memory("sparse", k)) / 9e4 for k in (0, 1)
]
print(
    f"\n    memory of a parcel: {per_parcel[0]:.0f} bytes while it runs,"
    f" {per_parcel[1]:.0f} at the most (reading)\n"
)

for bed in BEDS:
    ms.figure(f"parcelStep.us{bed}", ms.median(step[bed]))
ms.figure("parcelStep.bytesPerParcel", per_parcel[0])
