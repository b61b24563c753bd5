#!/usr/bin/python3
# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
# ------------------------------------------------------------------------------
"""report.py ROUNDS: figures of the benchmark scenes, from its logs, and what
each feature costs that a scene leaves out."""

import os
import re
import sys
from pathlib import Path

sys.path.append(os.environ["PROJECT_DIR"] + "/tests/benchmarks/lib")
import measure as ms

ROUNDS = range(1, int(sys.argv[1]) + 1)
N, CELLS = 10**5, 13310
DUCT_CELLS = 15*15*90
NOT_OURS = ("cghs::fluid", "cghs::energy", "cghs::species",
            "cghs::report", "other")
# Parts whose cost is a figure of its own
ALONE = dict(hot=("heat",), reacting=("reactions",))

# The stages that a feature has to itself, and its bytes of a parcel in columns
# (each is there twice, as columns keep the other half of a reordering)
FEATURES = {
    "state": ((), 2*88),            # x, r, v, 1/m, W, d, cell, number
    "contacts": (("contactList", "contact"), 2*4),      # the former index
    "spin": ((), 2*24),             # omega; its time is in contact
    "drag": (("mapping", "complete"), 2*8),     # its rate
    "fluid": (("fluid",), 0),
    "heat": (("heat", "conduction", "radiation"), 2*16),   # T, conductance
    "energy": (("energy",), 0),
    "reactions": (("reactions",), 2*32),        # C, H, catalyst, mass gained
    "species": (("species",), 0),
    "feeding": (("feed",), 0),      # and taking out what is used up
}
SCENES = {
    "kinematic": "state contacts drag fluid",
    "spinning": "state contacts drag fluid spin",
    "hot": "state contacts drag fluid spin heat energy",
    "reacting": "state contacts drag fluid spin heat energy reactions species"
                " feeding",
    "dilute": "state drag fluid",
    "frozenFluid": "state contacts drag spin",
    "particlesOnly": "state contacts spin",
    "oneSpecies": "state contacts drag fluid species",
    "fiveSpecies": "state contacts drag fluid species",
}


class Scene:
    """The runs of a scene, and what of them is due to what it leaves out."""

    def __init__(self, name):
        self.name = name
        self.logs = [ms.Log(f"log.{name}-{r}") for r in ROUNDS]
        self.profiles = [ms.Profile(f"profile-{name}-{r}", log)
                         for r, log in zip(ROUNDS, self.logs)]
        self.steps = sum(self.logs[0].solids_steps)
        self.features = SCENES[name].split()

    def ns(self, stages):
        """Of a parcel-step, by round."""
        return [1e9/(N*self.steps)*sum(p.seconds.get(s, 0) for s in stages)
                for p in self.profiles]

    def ours(self):
        """All stages but those of the fluid and the report."""
        seen = set().union(*(p.seconds for p in self.profiles))
        return sorted(seen.difference(NOT_OURS))

    def left_out(self):
        return [f for f in FEATURES if f not in self.features]

    def stages_left_out(self):
        return [f"cghs::{s}" for f in self.left_out() for s in FEATURES[f][0]]

    def calls_left_out(self):
        return sum(p.calls.get(s, 0) for p in self.profiles
                   for s in self.stages_left_out())

    def cost_left_out(self):
        """At most [%]: the stages of what is left out, which must not be
        there, and all the time between stages, in which the solids steps ask
        for what is left out. By round."""
        beside = self.ns(self.stages_left_out() + ["cghs::evolve"])
        return [100*b/o for b, o in zip(beside, self.ns(self.ours()))]

    def bytes(self):
        """Resident, of a parcel."""
        return (memory(self.name) - memory(self.name + ".sparse"))/9e4

    def told(self):
        """Bytes of a parcel in columns, and in lists and contacts."""
        text = Path(f"log.{self.name}-1").read_text()
        both, columns = re.findall(
            r"^memory: (\d+) bytes a parcel, (\d+)", text, re.M)[-1]
        return int(columns), int(both) - int(columns)

    def bytes_left_out(self):
        """In columns, beside those of what the scene has."""
        return self.told()[0] - sum(FEATURES[f][1] for f in self.features)


def memory(bed):
    """Resident bytes after the last step."""
    return ms.median([int(Path(f"log.{bed}-{r}.memory").read_text().split()[0])
                      for r in ROUNDS])


def told(stages):
    """But for evolve: what is between the stages."""
    return ", ".join(s.replace("cghs::", "") for s in stages
                     if s != "cghs::evolve")


def report(scene):
    ns = scene.ns(scene.ours())
    print(f"\n    {scene.name}: {scene.steps:.0f} steps, {ms.median(ns):.0f} ns"
          f" per parcel-step (noise {ms.spread(ns):.1f} %)")
    ms.print_stages(scene.profiles, N, CELLS, scene.steps,
                    len(scene.logs[0].solids_steps))
    columns, lists = scene.told()
    print(f"    bytes of a parcel: {columns} in columns, {lists} in lists and"
          f" contacts, {scene.bytes():.0f} resident\n")

    figure = f"scenes.{scene.name}"
    ms.figure(f"{figure}.nsPerParcelStep", ms.median(ns))
    ms.figure(f"{figure}.bytesPerParcel", scene.bytes())
    ms.figure(f"{figure}.percentLeftOut", ms.median(scene.cost_left_out()))
    ms.figure(f"{figure}.callsLeftOut", scene.calls_left_out())
    ms.figure(f"{figure}.bytesLeftOut", scene.bytes_left_out())
    for part in ALONE.get(scene.name, ()):
        ms.figure(f"{figure}.nsOf{part.capitalize()}",
                  ms.median(scene.ns([f"cghs::{part}"])))


def with_noise(values):
    """The median, and half the range, of percentages."""
    return f"{ms.median(values):.1f} +- {(max(values) - min(values))/2:.1f}"


# ---- Against what cannot have the feature ------------------------------------


class NoParcels:
    """A duct without parcels. By round: time of a cell-step [us]; what of it
    is in the stages of parcels [%], those that the first step alone has
    included; what it is over pimpleFoam's [%]."""

    def __init__(self):
        ours, others = (
            [ms.Log(f"log.noParcels-{solver}-{r}") for r in ROUNDS]
            for solver in ("cghsFoam", "pimpleFoam"))
        profiles = [ms.Profile(f"noParcels-cghsFoam-{r}", log)
                    for r, log in zip(ROUNDS, ours)]
        stages = set(profiles[0].seconds).difference(NOT_OURS)

        self.stages = sorted(stages)
        self.us = [1e6*log.cpu_per_step/DUCT_CELLS for log in ours]
        self.left_out = [100*sum(p.seconds[s] for s in stages)/p.total
                         for p in profiles]
        self.more = [100*(a.cpu_per_step/b.cpu_per_step - 1)
                     for a, b in zip(ours, others)]


def four_species(one, five):
    """What one species takes beyond a fifth of five, over all of the fluid
    [%], by round."""
    species = ("cghs::species",)
    return [100*(a - b/5)/all_ for a, b, all_ in zip(
        one.ns(species), five.ns(species),
        one.ns(("cghs::fluid", "cghs::species")))]


# ---- The table ---------------------------------------------------------------


def row(*cells):
    print("| " + " | ".join(cells) + " |")


def table(scenes):
    print("\n")
    row("left out", "scene", "ns per parcel-step", "bytes per parcel",
        "stages that remain", "cost of what is left out, %")
    print("|---|---|---|---|---|---|")
    for scene in scenes.values():
        row(", ".join(scene.left_out()),
            f"`{scene.name}`", f"{ms.median(scene.ns(scene.ours())):.0f}",
            f"{scene.bytes():.0f}", told(scene.ours()),
            f"< {with_noise(scene.cost_left_out())};"
            f" {scene.calls_left_out()} calls, {scene.bytes_left_out()} bytes")
    duct = NoParcels()
    row("parcels", "`noParcels`", f"{ms.median(duct.us):.2f} us per cell-step",
        "-", told(duct.stages), f"{with_noise(duct.left_out)}")
    row("parcels, against pimpleFoam", "`noParcels`", "see above", "-",
        "all", with_noise(duct.more))
    row("four of five species", "`oneSpecies`", "see above", "see above",
        "species", with_noise(four_species(scenes["oneSpecies"],
                                           scenes["fiveSpecies"])))
    print("\n")
    ms.figure("scenes.noParcels.usPerCellStep", ms.median(duct.us))
    ms.figure("scenes.noParcels.percentLeftOut", ms.median(duct.left_out))
    ms.figure("scenes.noParcels.percentBeyondPimpleFoam",
              ms.median(duct.more))


scenes = {name: Scene(name) for name in SCENES}
for one in scenes.values():
    report(one)
table(scenes)
