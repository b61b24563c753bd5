#!/usr/bin/python3
# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
# ------------------------------------------------------------------------------
"""report.py SCENE...: figures of the benchmark scenes, from its logs."""

import os
import sys
from pathlib import Path

sys.path.append(os.environ["PROJECT_DIR"] + "/tests/benchmarks/lib")
import measure as ms

ROUNDS = (1, 2, 3)
N, CELLS = 10**5, 13310
NOT_OURS = ("cghs::fluid", "cghs::energy", "cghs::species",
            "cghs::report", "other")
# Parts whose cost is a figure of its own
ALONE = dict(hot=("heat",), reacting=("reactions",))


def memory(bed):
    """Resident bytes after the last step."""
    return ms.median([int(Path(f"log.{bed}-{r}.memory").read_text().split()[0])
                      for r in ROUNDS])


for scene in sys.argv[1:]:
    logs = [ms.Log(f"log.{scene}-{r}") for r in ROUNDS]
    profiles = [ms.Profile(f"profile-{scene}-{r}", log)
                for r, log in zip(ROUNDS, logs)]
    steps = sum(logs[0].solids_steps)
    ns = [1e9/(N*steps)*sum(s for k, s in p.seconds.items()
                            if k not in NOT_OURS) for p in profiles]
    print(f"\n    {scene}: {steps:.0f} steps, {ms.median(ns):.0f} ns per"
          f" parcel-step (noise {ms.spread(ns):.1f} %)")
    ms.print_stages(profiles, N, CELLS, steps, len(logs[0].solids_steps))
    print()
    ms.figure(f"scenes.{scene}.nsPerParcelStep", ms.median(ns))
    ms.figure(f"scenes.{scene}.bytesPerParcel",
              (memory(scene) - memory(scene + ".sparse"))/9e4)
    for part in ALONE.get(scene, ()):
        ms.figure(f"scenes.{scene}.nsOf{part.capitalize()}", ms.median(
            [1e9*p.seconds[f"cghs::{part}"]/(N*steps) for p in profiles]))
