# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
# ------------------------------------------------------------------------------
"""Times out of OpenFOAM's logs and profiling files, and how they are told.

All times are CPU times of the process (user and system), since other work on
the machine does not enter them. OpenFOAM's profiling measures by the clock on
the wall; what it gives is scaled by CPU time over wall time of its run."""

import re
import statistics
from pathlib import Path

_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"

median = statistics.median


def spread(values):
    """Half the range over the median, in percent: the noise of a figure."""
    middle = median(values)
    return 50 * (max(values) - min(values)) / middle if middle else 0.0


# ---- What a solver has logged -----------------------------------------------


class Log:
    """The steps of a run: time, CPU time and, for cghsFoam, solids steps."""

    def __init__(self, path):
        text = Path(path).read_text()
        self.times = self._all(r"^Time = ({})", text)
        self.cpu = self._all(r"ExecutionTime = ({}) s", text)
        self.solids_steps = self._all(r"^solids: ({}) steps", text)
        self.lists = self._all(r"s, ({}) lists,", text)
        self.overlaps = self._all(r"largest overlap ({}) %", text)
        n = len(self.cpu)
        if n < 2:
            raise ValueError(f"{path}: only {n} steps, see its end")
        self.times = self.times[-n:]

    @staticmethod
    def _all(pattern, text):
        found = re.findall(pattern.format(_NUMBER), text, re.M)
        return [float(x) for x in found]

    # The first step pays for the start, so all is counted from its end

    @property
    def steps(self):
        return len(self.cpu) - 1

    @property
    def cpu_seconds(self):
        return self.cpu[-1] - self.cpu[0]

    @property
    def cpu_per_step(self):
        return self.cpu_seconds / self.steps

    @property
    def cpu_per_simulated_second(self):
        return self.cpu_seconds / (self.times[-1] - self.times[0])


# ---- OpenFOAM's profiling ---------------------------------------------------


class Profile:
    """The stages of a cghsFoam run, from the profiling file it wrote last,
    scaled to the CPU time of its log."""

    def __init__(self, case, log):
        files = list(Path(case).glob("*/uniform/profiling"))
        if not files:
            raise FileNotFoundError(f"{case} has no profiling file")
        newest = max(files, key=lambda path: path.stat().st_mtime)
        triggers = [
            dict(re.findall(r"(\w+)\s+\"?([^;\"]+)\"?;", body))
            for body in re.findall(
                r"trigger\d+\s*\{(.*?)\}", newest.read_text(), re.S
            )
        ]
        for t in triggers:
            t["self"] = float(t["totalTime"]) - float(t["childTime"])

        main = next(t for t in triggers if "parentId" not in t)
        loop = next(
            t for t in triggers if t["description"].startswith("time.run()")
        )
        self.cpu_over_wall = min(log.cpu[-1] / float(main["totalTime"]), 1.0)

        names = {t["id"]: t for t in triggers}
        self.seconds = {}
        self.calls = {}
        for t in triggers:
            stage = self._stage(t, names, loop["id"])
            if stage:
                cpu = t["self"] * self.cpu_over_wall
                self.seconds[stage] = self.seconds.get(stage, 0.0) + cpu
                if t["description"] == stage:
                    calls = self.calls.get(stage, 0) + int(t["calls"])
                    self.calls[stage] = calls

        memory = re.search(r"\brss\s+(\d+)", newest.read_text())
        self.resident_bytes = 1024 * int(memory[1]) if memory else 0

    @staticmethod
    def _stage(t, names, loop):
        """The innermost of our stages that a section of the time loop is part
        of; 'other' for what is none of theirs."""
        stage = None
        while True:
            if stage is None and t["description"].startswith("cghs::"):
                stage = t["description"]
            if t["id"] == loop:
                return stage or "other"
            if "parentId" not in t:
                return None
            t = names[t["parentId"]]

    @property
    def total(self):
        return sum(self.seconds.values())


STAGES = {
    "cghs::suspension": "suspension",
    "cghs::contactList": "contact list",
    "cghs::contact": "contact: find, impact, correct",
    "cghs::move": "motion and cells",
    "cghs::feed": "feeding",
    "cghs::evolve": "rest of the solids steps",
    "cghs::mapping": "mapping to and from the mesh",
    "cghs::heat": "heat",
    "cghs::conduction": "conduction",
    "cghs::radiation": "radiation",
    "cghs::reactions": "reactions",
    "cghs::complete": "completion after the fluid",
    "cghs::fluid": "fluid",
    "cghs::energy": "energy of the fluid",
    "cghs::species": "species of the fluid",
    "cghs::report": "report",
    "other": "rest: step control, log, writing",
}


def print_stages(profiles, n_parcels, n_cells, solids_steps, fluid_steps):
    """Medians over runs of the same length: shares, and the time per parcel
    and solids step and per cell and fluid step, where there are such."""
    units = [
        (heading, 1e9 / (n * steps))
        for heading, n, steps in (
            ("ns/parcel-step", n_parcels, solids_steps),
            ("ns/cell-step", n_cells, fluid_steps),
        )
        if n and steps
    ]
    rows = [
        (title, median([p.seconds.get(stage, 0.0) for p in profiles]))
        for stage, title in STAGES.items()
    ]
    total = median([p.total for p in profiles])

    headings = "".join(f" {heading:>15s}" for heading, _ in units)
    print(f"    {'stage':33s} {'share':>6s}{headings}")
    for title, cpu in rows + [("all", total)]:
        if cpu:
            values = "".join(f" {cpu*unit:15.1f}" for _, unit in units)
            print(f"    {title:33s} {100*cpu/total:5.1f}%{values}")


# ---- How figures are told ---------------------------------------------------


def figure(name, value):
    """A figure alone on its line, for anyone to read."""
    print(f"{name} = {value:.4g}", flush=True)
