# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Numbers of interest, and where in a run they stand. Each becomes a value
#     with what of it the run alone can say is noise.
#
#         pressureDrop
#         {
#             type        mean;           // deviation, last, profile
#             table       inletPressure;  // function object; or log, field
#             column      areaAverage(p);
#             window      (1 2);          // [s], to the end if there is no 2nd
#             factor      1.2;            // what the number is multiplied by
#             unit        Pa;
#         }
#         temperature     { type mean; log "granular temperature"; ... }
#         solids
#         {
#             type        profile;        // of the last time that is written
#             table       solidsProfiles; file height;
#             column      solidsFraction;
#             range       (0 0.1);        // of the coordinate
#             relativeTo  range;          // mean: what an error is a share of
#         }
#         voidage
#         {
#             type        profile;
#             field       alpha;
#             axis        y;
#             bins        20;
#         }
#
#     Samples at the steps of a run are as long as the steps; here they become
#     means over equal pieces of the window, which correlations are known of.
# ------------------------------------------------------------------------------
"""What is read from a run."""

import re
import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import caseFiles
import runLog
import windows

TYPES = ("mean", "deviation", "last", "profile")
SOURCES = ("table", "log", "field")
AXES = ("x", "y", "z")

MOST_PIECES = 4000
LEAST_PIECES = 10


class NotMeasured(Exception):
    """With the reason. The run may be whole; what it left is not enough."""


@dataclass
class Measurement:
    """Of one run. error: standard error by what the run itself knows, nan if it
    knows nothing; enough: is the window long enough to tell it?"""
    value: object           # a number, or an array along the coordinate
    error: object
    freedom: float = np.inf
    enough: bool = True
    note: str = ""
    coordinate: object = None


def stem(path):
    """Of a table's file, without the time of one that was there before."""
    return re.sub(r"_[\d.e+-]+$", "", path.stem)


class Quantity:
    """One of them."""

    def __init__(self, name, block):
        self.name, self.block = name, block
        self.type = block.word("type", "mean", TYPES)
        self.source = self._read_source(block)
        self.where = block.word(self.source)
        self.factor = block.number("factor", 1)
        self.unit = block.word("unit", " ").strip()
        self.label = block.word("label", name)
        self.scale = block.number("scale", 0)
        self.window = self._read_window(block)
        if self.source == "table":
            self.file = block.word("file", " ").strip()
            self.column = block.word("column")
        if self.type == "profile":
            self._read_profile(block)
        elif self.source == "field":
            block.fail("field", "is of a profile only", (),
                       "write 'type profile;'")
        block.refuse_others()

    @staticmethod
    def _read_source(block):
        given = [source for source in SOURCES if block.has(source)]
        if len(given) != 1:
            block.fail("table", "is missing" if not given else
                       f"stands beside {given[1]}", SOURCES,
                       "say where the quantity stands")
        return given[0]

    def _read_window(self, block):
        window = block.numbers("window", [])
        if len(window) > 2 or (len(window) == 2 and window[1] <= window[0]):
            block.fail("window", f"is {window}", (),
                       "write (from to) or (from)")
        if self.type in ("mean", "deviation") and not window:
            block.fail("window", "is missing", (),
                       f"a {self.type} is over a window of time: (from to)")
        return (*window, np.inf)[:2] if window else (0, np.inf)

    def _read_profile(self, block):
        if self.source == "log":
            block.fail("log", "has no profiles", ("table", "field"))
        self.along = block.word("coordinate", "coordinate")
        self.range = block.numbers("range", [-np.inf, np.inf], 2)
        self.relative_to = block.word("relativeTo", "range",
                                      ("range", "mean"))
        if self.source == "field":
            self.axis = AXES.index(block.word("axis", "y", AXES))
            self.bins = block.count("bins", 20)

    # Reading a run

    def measure(self, run):
        """Of a run's folder; NotMeasured where it has not what it takes."""
        if self.type == "profile":
            made = (self._profile_of_table(run.path) if self.source == "table"
                    else self._profile_of_field(run.path))
        else:
            made = self._of_series(*self._series(run))
        made.value = made.value*self.factor
        made.error = made.error*abs(self.factor)
        if not np.all(np.isfinite(made.value)):
            raise NotMeasured(f"{self.name} is not finite: it has diverged")
        return made

    def _series(self, run):
        """Times and values of its steps."""
        if self.source == "log":
            words = r"\s+".join(map(re.escape, self.where.split()))
            steps = runLog.steps(run.log_text(), runLog.number_after(words))
            if not steps:
                raise NotMeasured(f"the log has no number after '{self.where}'")
            return np.array([*steps]), np.array([*steps.values()])
        tables = self._tables(run.path)
        rows = caseFiles.joined(tables)
        if not rows.size:
            raise NotMeasured(f"the table {self.where} has no rows")
        return rows[:, 0], rows[:, self._index(tables[-1], rows.shape[1])]

    def _tables(self, case):
        """Of all starts, the earliest first."""
        folder = case / "postProcessing" / self.where
        pattern = f"{self.file}*.dat" if self.file else "*.dat"
        paths = [path for path in folder.glob(f"*/{pattern}")
                 if not self.file
                 or re.fullmatch(rf"{re.escape(self.file)}(_[\d.e+-]+)?",
                                 path.stem)]
        if not paths:
            there = sorted(path.name for path in folder.parent.glob("*"))
            raise NotMeasured(
                f"there is no table {self.where}{' ' + self.file or ''};"
                f" function objects that have some: {', '.join(there)}")
        stems = {stem(p) for p in paths}
        if len(stems) > 1:
            raise NotMeasured(f"{self.where} has several tables: name one by"
                              f" 'file': {', '.join(sorted(stems))}")
        return sorted(paths, key=lambda path: (float(path.parent.name),
                                               path.stat().st_mtime))

    def _index(self, path, n):
        lines = [line for line in path.read_text().splitlines()
                 if line.lstrip().startswith("#")]
        names = lines[-1].strip(" #").split() if lines else []
        if self.column not in names or len(names) != n:
            raise NotMeasured(f"{self.where} has no column {self.column};"
                              f" it has: {', '.join(names)}")
        return names.index(self.column)

    # Series in time

    def _of_series(self, time, value):
        if self.type == "last":
            return Measurement(value[-1], np.nan)
        pieces, dt = self._pieces(time, value)
        if self.type == "mean":
            mean, scale = pieces.mean(), 1.0
        else:
            pieces = (pieces - pieces.mean())**2
            mean = np.sqrt(pieces.mean())
            scale = 0.5/mean if mean > 0 else 0.0
        window = windows.judge(pieces, dt)
        error = pieces.std()/np.sqrt(window.independent)*scale
        return Measurement(mean, error, max(window.independent - 1, 0.1),
                           window.enough, str(window))

    def _pieces(self, time, value):
        """Means over equal pieces of the window, and their length. A value is
        that of the step before it."""
        step = np.diff(time, prepend=time[0] - (time[1] - time[0])
                       if time.size > 1 else 0)
        start = max(self.window[0], time[0] - step[0])
        end = min(self.window[1], time[-1])
        # A step may end beyond the end that the dictionary names, or before
        if np.isfinite(self.window[1]) and (
                self.window[1] - time[-1] > 2*step.max()):
            raise NotMeasured(f"the run has reached {time[-1]:g} s, the window"
                              f" ends at {self.window[1]:g} s")
        inside = np.count_nonzero((time > start) & (time <= end))
        n = min(inside, MOST_PIECES)
        if n < LEAST_PIECES:
            raise NotMeasured(f"there are {inside} values from {start:g} to"
                              f" {end:g} s: at least {LEAST_PIECES} are needed")
        edges = np.linspace(start, end, n + 1)
        total = np.interp(edges, np.r_[time[0] - step[0], time],
                          np.r_[0, np.cumsum(value*step)])
        return np.diff(total)/np.diff(edges), (end - start)/n

    # Profiles

    def _profile_of_table(self, case):
        """A function object's last, which is a mean over time already; with its
        errors, where it gives them."""
        path = self._tables(case)[-1]
        table = caseFiles.columns(path)
        for name in (self.along, self.column):
            if name not in table:
                raise NotMeasured(f"{path.name} has no column {name}; it has: "
                                  f"{', '.join(table)}")
        error = table.get(f"{self.column}Error", np.full_like(
            table[self.column], np.nan))
        enough = bool(np.all(table.get("windowLongEnough", 1)))
        return self._cut(table[self.along], Measurement(
            table[self.column], error, enough=enough,
            note="" if enough else "window too short, by the function object"))

    def _profile_of_field(self, case):
        """Of the cells of the last time, in bins along the axis, by volume."""
        time = caseFiles.times(case)[-1]
        x = self._mesh_field(case, time, "C")[:, self.axis]
        volume = self._mesh_field(case, time, "V")*np.ones(len(x))
        try:
            value = caseFiles.field(case, time, self.where)*np.ones(len(x))
        except FileNotFoundError as missing:
            raise NotMeasured(f"there is no field {missing}") from None
        low, high = (max(self.range[0], x.min()), min(self.range[1], x.max()))
        edges = np.linspace(low, high, self.bins + 1)
        at = np.clip(np.searchsorted(edges, x, "right") - 1, 0, self.bins - 1)
        inside = (x >= low) & (x <= high)
        sums = [np.bincount(at[inside], w[inside], self.bins)
                for w in (volume, volume*value)]
        if not np.all(sums[0] > 0):
            raise NotMeasured(f"{self.name}: some of {self.bins} bins have no"
                              " cell: choose fewer bins")
        return Measurement(sums[1]/sums[0], np.full(self.bins, np.nan),
                           coordinate=0.5*(edges[1:] + edges[:-1]))

    @staticmethod
    def _mesh_field(case, time, name):
        """Centres or volumes of cells, which postProcess is asked for once."""
        try:
            return caseFiles.field(case, time, name)
        except FileNotFoundError:
            function = {"C": "writeCellCentres", "V": "writeCellVolumes"}[name]
            parallel = list(Path(case).glob("processor[0-9]*"))
            words = ["postProcess", "-func", function, "-time", time]
            if parallel:
                words = ["mpirun", "-np", str(len(parallel)), *words,
                         "-parallel"]
            subprocess.run(words, cwd=case, stdout=subprocess.DEVNULL,
                           stderr=subprocess.DEVNULL, check=False)
        try:
            return caseFiles.field(case, time, name)
        except FileNotFoundError:
            raise NotMeasured(f"postProcess -func {function} fails") from None

    def _cut(self, coordinate, made):
        inside = ((coordinate >= self.range[0])
                  & (coordinate <= self.range[1]))
        if np.count_nonzero(inside) < 2:
            raise NotMeasured(f"{self.name}: the range {self.range} has less"
                              " than two points")
        made.value, made.error = made.value[inside], made.error[inside]
        made.coordinate = coordinate[inside]
        return made

    def header(self):
        return f"{self.label} [{self.unit}]" if self.unit else self.label


def read_quantities(block):
    quantities = [Quantity(name, block.block(name)) for name in block.keys()]
    if not quantities:
        block.fail("", "names no quantity of interest", (), "name one")
    return quantities
