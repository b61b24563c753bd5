# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What the tutorials' evaluate and validate share in reading what a run has
#     left: inputs, series in time, means with errors. Each tutorial's module
#     finds the project that it, or the copy of it, lies in, and begins with
#
#         PROJECT = next((folder for folder in Path(__file__).resolve().parents
#                         if (folder / "etc" / "openfoam").exists()), None)
#         if PROJECT is None:
#             sys.exit(f"{Path(__file__).parent} is not within a cghsFoam")
#         sys.path.append(str(PROJECT / "tutorials" / "lib"))
#         from tutorial import np, of
# ------------------------------------------------------------------------------
"""Reading the runs of the tutorials."""

import re
import sys
from pathlib import Path

# The tutorial, as it calls itself in its messages
NAME = Path(sys.argv[0]).resolve().parent.name


def stop(message):
    sys.exit(f"{NAME}: {message}")


try:
    import numpy as np
except ImportError:
    stop("python3 has no numpy; remedy: "
         "apt-get install python3-numpy python3-matplotlib")

PROJECT = Path(__file__).resolve().parents[2]
sys.path.append(str(PROJECT / "tests" / "lib"))
import cghsTest as of  # noqa: E402
import runLog  # noqa: E402

# Over so many blocks the statistical error of a mean is estimated, and the
# largest of the estimates is taken: where a bed pulsates, blocks that are no
# multiple of its period alone would flatter or scold it
BLOCKS = (5, 6, 8, 10)


# Inputs


def number(path, name, default=None):
    """The number that is the value of an entry of a dictionary's file."""
    text = path.read_text() if path.exists() else ""
    match = re.search(rf"(?:^|;)\s*{name}\s+({of.NUMBER})", text, re.M)
    if match:
        return float(match[1])
    if default is None:
        stop(f"{path} has no number {name}")
    return default


def option(case, name, file="system/controlDict", default=None):
    """The number that Allrun has given to an entry, or that it has otherwise in
    the case's file."""
    return number(Path(case) / "system" / "runOptions", name,
                  number(Path(case) / file, name, default))


def vector(text, after):
    """The numbers in brackets that follow the pattern."""
    match = re.search(after + r"\s*\(([^()]*)\)", text)
    return np.array(match[1].split(), float)


# Series in time


def series(case, folder):
    """The tables of a function object, one row a time. A run that was continued
    has left one from each start: what came later stands."""
    files = sorted(
        (Path(case) / "postProcessing" / folder).glob("*/*.dat"),
        key=lambda path: path.stat().st_mtime,
    )
    rows = of.joined(files)
    if not rows.size:
        stop(f"{case} has no table of {folder}: run ./Allrun first")
    return rows


def columns(case, folder):
    """The same by the names over the columns."""
    rows = series(case, folder)
    table = next((Path(case) / "postProcessing" / folder).glob("*/*.dat"))
    return dict(zip(of.columns(table), rows.T))


def newest(case, folder, name):
    """The columns by their names of a table that a function object writes whole
    at each time that is written, of the last; none before there is one."""
    files = sorted(
        (Path(case) / "postProcessing" / folder).glob(f"*/{name}.dat"),
        key=lambda path: float(path.parent.name))
    return of.columns(files[-1]) if files else None


# Means and their statistical errors


def block_error(blocks):
    """Standard error of a mean, from blocks(n) = the means of n blocks."""
    return np.max(
        [blocks(n).std(axis=0, ddof=1) / np.sqrt(n) for n in BLOCKS], axis=0
    )


def mean_of(values):
    """Of values at equal steps of time, and its standard error."""
    values = np.asarray(values, float)

    def blocks(n):
        return np.array([part.mean(axis=0)
                         for part in np.array_split(values, n)])

    return values.mean(axis=0), block_error(blocks)


def ratio_of(above, below):
    """<above>/<below>, and a standard error that knows how they vary together:
    that of what above differs from the ratio times below."""
    whole = np.maximum(below.mean(axis=0), 1e-12)
    ratio = above.mean(axis=0) / whole
    return ratio, mean_of(above - ratio * below)[1] / whole


# The run itself


def log_of(case):
    return (Path(case) / "log.cghsFoam").read_text()


def seconds(case, kind="ClockTime"):
    """What the solver has taken, over all its starts: ClockTime as on the wall,
    ExecutionTime of the processor [s]."""
    return runLog.seconds(log_of(case), kind)


def clock_series(case, kind="ClockTime"):
    """Simulated times, and what the solver had taken up to them over all its
    starts, as above [s]."""
    return runLog.clock_series(log_of(case), kind)


def ranks(case):
    return runLog.ranks(log_of(case))


class Run:
    """A run with parcels: its table of them, and means over time. Lengths in m,
    pressures in Pa, times in s. A tutorial's own class reads what else it has
    in read_inputs and read_series."""

    def __init__(self, case):
        self.case = Path(case)
        self.window = None  # of the means
        self.read_inputs()
        self.read_series()

    def read_inputs(self):
        gravity = (self.case / "constant" / "g").read_text()
        self.g = float(np.linalg.norm(vector(gravity, r"\bvalue")))
        self.average_from = option(self.case, "averageFrom")

    def read_parcels(self):
        """Where all are of one size: particles and parcels [m, kg/m3, kg]."""
        for name, entry in (("weight", "parcelWeight"),
                            ("diameter", "diameter"), ("density", "density")):
            setattr(self, name,
                    option(self.case, entry, "constant/parcelsProperties"))
        self.parcel_diameter = self.diameter * self.weight**(1/3)
        self.parcel_mass = (
            np.pi / 6 * self.diameter**3 * self.density * self.weight)

    def read_series(self):
        self.parcels = columns(self.case, "parcels")
        self.time = self.parcels["time"]
        self.dt = np.diff(self.time, prepend=0)
        self.end = float(self.time[-1])
        self.frames = [t for t in of.times(self.case) if float(t) > 0]

    def at_steps(self, folder):
        """A function object's value at the times of the parcels' table."""
        rows = series(self.case, folder)
        return np.interp(self.time, rows[:, 0], rows[:, 1])

    # values are those of each step; totals grow from step to step

    def total(self, values):
        """Integral over time."""
        return np.cumsum(values * self.dt)

    def rate_of(self, total, window=None):
        """Mean rate at which a total grows in the window, and its standard
        error."""
        start, end = window or self.window

        def blocks(n):
            edges = np.linspace(start, end, n + 1)
            return np.diff(np.interp(edges, self.time, total)) / np.diff(edges)

        return blocks(1)[0], block_error(blocks)

    def mean(self, values, window=None):
        """Mean over the window, and its standard error."""
        return self.rate_of(self.total(values), window)

    def rates(self, total, step):
        """Middles of equal steps of time, how fast a total grows in each."""
        edges = np.arange(0, self.end + 1e-9, step)
        return (edges[1:] - 0.5 * step,
                np.diff(np.interp(edges, self.time, total)) / step)

    def smooth(self, values, step):
        """The same of the means of values."""
        return self.rates(self.total(values), step)
