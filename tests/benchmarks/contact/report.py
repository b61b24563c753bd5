#!/usr/bin/python3
# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
# ------------------------------------------------------------------------------
"""Figures of the benchmark contact, from its logs."""

import os
import re
import sys
from pathlib import Path

root = os.environ["PROJECT_DIR"] + "/tests"
sys.path += [root + "/lib", root + "/benchmarks/lib"]
import cghsTest as of
import measure as ms

N = 4586
ROUNDS = (1, 2, 3)
DT, DT_LAMMPS = 1e-4, 1e-5
STAGES = ("suspension", "contact", "contactList", "move", "evolve")


# ---- LAMMPS -----------------------------------------------------------------


def lammps_runs(path):
    """CPU time of a particle and step [ns] of each run in a log of LAMMPS."""
    return [
        1e9 * float(seconds) * float(use) / 100 / (int(steps) * N)
        for seconds, steps, use in re.findall(
            r"Loop time of (\S+) on 1 procs for (\d+) steps.*?\n\n"
            r"(\S+)% CPU use",
            Path(path).read_text(),
            re.S,
        )
    ]


def lammps_state(path):
    """Step, height of the centre [m] and energy [J], first and last line."""
    text = Path(path).read_text()
    table = text[text.index("Step v_centre"):text.index("Loop time")]
    rows = [line.split() for line in table.strip().splitlines()[1:]]
    return [[float(x) for x in row] for row in (rows[0], rows[-1])]


lammps = [lammps_runs(f"log.lmp-{r}")[-1] for r in ROUNDS]
(_, lmp_centre0, lmp_energy0), (_, lmp_centre, lmp_energy) = lammps_state(
    "log.lmp.settle"
)


# ---- Ours -------------------------------------------------------------------


class Bed:
    """A settled bed of cghsFoam: its cost and how it rests."""

    def __init__(self, case):
        self.logs = [ms.Log(f"log.{case}-{r}") for r in ROUNDS]
        self.profiles = [
            ms.Profile(f"{case}-{r}", log) for r, log in zip(ROUNDS, self.logs)
        ]
        self.steps = sum(self.logs[0].solids_steps)
        self.ns = [
            1e9 * sum(p.seconds.get(f"cghs::{s}", 0.0) for s in STAGES)
            / (N * self.steps)
            for p in self.profiles
        ]

        # At the end of settling, over what it began with; the largest overlap
        # of the last tenth of a second
        columns = of.table(f"{case}/postProcessing/parcels/0/parcels.dat")
        time, energy, overlap = columns[:, 0], columns[:, 9], columns[:, 12]
        v = of.cloud_field(case, 0, "parcels", "U")
        x = of.cloud_field(case, 0, "parcels", "position")
        mass = columns[0, 2] / N

        self.ke_residual = energy[-1] / (0.5 * mass * (v**2).sum())
        self.weight_centre = columns[-1, 8] / x[:, 2].mean()
        self.max_overlap = overlap[time > time[-1] - 0.1].max()


ours, chapter = Bed("cghsFoam"), Bed("chapter")


# ---- The report -------------------------------------------------------------

print(
    f"\n    {'settled bed, 1 core':22s} {'ns/particle-step':>16s} {'noise':>6s}"
    f" {'dt [s]':>7s} {'KE/KE0':>8s} {'centre':>7s} {'overlap':>8s}"
)
for name, ns, dt, ke, centre, overlap in (
    ("LAMMPS", lammps, DT_LAMMPS, lmp_energy / lmp_energy0,
     lmp_centre / lmp_centre0, None),
    ("cghsFoam", ours.ns, DT, ours.ke_residual, ours.weight_centre,
     ours.max_overlap),
    ("chapter's corrections", chapter.ns, DT, chapter.ke_residual,
     chapter.weight_centre, chapter.max_overlap),
):
    print(
        f"    {name:22s} {ms.median(ns):16.1f} {ms.spread(ns):5.1f}%"
        f" {dt:7.0e} {ke:8.1e} {centre:7.4f}"
        + (f" {100*overlap:7.2f}%" if overlap is not None else "")
    )

print(
    f"\n    cghsFoam: {ours.steps:.0f} steps, {sum(ours.logs[0].lists):.0f}"
    " contact lists"
)
ms.print_stages(ours.profiles, N, 0, ours.steps, 0)
print()

ms.figure("contact.nsPerParcelStep", ms.median(ours.ns))
ms.figure("contact.ratioToLammps", ms.median(ours.ns) / ms.median(lammps))
ms.figure(
    "contact.speedupOverLammps",
    ms.median(lammps) / DT_LAMMPS * DT / ms.median(ours.ns),
)
ms.figure("contact.keResidual", ours.ke_residual)
ms.figure("contact.weightCentre", ours.weight_centre)
ms.figure("contact.maxOverlap", ours.max_overlap)
