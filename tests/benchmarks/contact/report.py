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

logs = [ms.Log(f"log.cghsFoam-{r}") for r in ROUNDS]
profiles = [ms.Profile(f"cghsFoam-{r}", log) for r, log in zip(ROUNDS, logs)]
solids_steps = sum(logs[0].solids_steps)
ours = [
    1e9 * sum(p.seconds.get(f"cghs::{s}", 0.0) for s in STAGES)
    / (N * solids_steps)
    for p in profiles
]

# How the bed rests: its energy at the end of settling over that at the start,
# its centre, and the largest overlap of the last tenth of a second
columns = of.table("cghsFoam/postProcessing/parcels/0/parcels.dat")
time, energy, overlap = columns[:, 0], columns[:, 9], columns[:, 12]
velocities = of.cloud_field("cghsFoam", 0, "parcels", "U")
mass = columns[0, 2] / N
energy0 = 0.5 * mass * (velocities**2).sum()
centre0 = of.cloud_field("cghsFoam", 0, "parcels", "position")[:, 2].mean()

ke_residual = energy[-1] / energy0
weight_centre = columns[-1, 8] / centre0
max_overlap = overlap[time > time[-1] - 0.1].max()


# ---- The report -------------------------------------------------------------

print(
    f"\n    {'settled bed, 1 core':20s} {'ns/particle-step':>16s} {'noise':>7s}"
    f" {'dt [s]':>7s} {'us/particle/simulated ms':>25s}"
    f" {'KE/KE0':>9s} {'centre':>7s}"
)
for name, ns, dt, ke, centre in (
    ("LAMMPS", lammps, DT_LAMMPS, lmp_energy / lmp_energy0,
     lmp_centre / lmp_centre0),
    ("cghsFoam", ours, DT, ke_residual, weight_centre),
):
    print(
        f"    {name:20s} {ms.median(ns):16.1f} {ms.spread(ns):6.1f}%"
        f" {dt:7.0e} {1e-6*ms.median(ns)/dt:25.2f} {ke:9.1e} {centre:7.4f}"
    )

print(
    f"\n    cghsFoam: {solids_steps:.0f} steps, {sum(logs[0].lists):.0f}"
    " contact lists"
)
ms.print_stages(profiles, N, 0, solids_steps, 0)
print()

ms.figure("contact.nsPerParcelStep", ms.median(ours))
ms.figure("contact.ratioToLammps", ms.median(ours) / ms.median(lammps))
ms.figure(
    "contact.speedupOverLammps",
    ms.median(lammps) / DT_LAMMPS * DT / ms.median(ours),
)
ms.figure("contact.keResidual", ke_residual)
ms.figure("contact.weightCentre", weight_centre)
ms.figure("contact.maxOverlap", max_overlap)
