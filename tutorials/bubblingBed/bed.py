# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What a run of the bubbling bed has left, as numbers: the one place from
#     which both evaluate (page of results) and validate (checks) take them.
# ------------------------------------------------------------------------------
"""The bubbling bed: its inputs, its series in time, its means with errors."""

import re
import sys
from pathlib import Path

try:
    import numpy as np
except ImportError:
    sys.exit("bubblingBed: python3 has no numpy; remedy: "
             "apt-get install python3-numpy python3-matplotlib")

# The project that this case, or the copy of it, lies in
PROJECT = next(
    (folder for folder in Path(__file__).resolve().parents
     if (folder / "etc" / "openfoam").exists()),
    None,
)
if PROJECT is None:
    sys.exit(f"bubblingBed: {Path(__file__).parent} is not within a cghsFoam")

sys.path.append(str(PROJECT / "tests" / "lib"))
import cghsTest as of  # noqa: E402

HEIGHTS = (0.025, 0.055, 0.085)  # [m] at which the chapter shows the flux

# Over so many blocks the statistical error of a mean is estimated, and the
# largest of the estimates is taken: the bed pulsates at about 3 Hz, and blocks
# that are no multiple of its period alone would flatter or scold it
BLOCKS = (5, 6, 8, 10)


def _number(path, name):
    """The first number after an entry's name in a dictionary."""
    match = re.search(rf"\b{name}\s+({of._NUMBER})", path.read_text())
    if not match:
        sys.exit(f"bubblingBed: {path} has no number {name}")
    return float(match[1])


def _vector(text, after):
    match = re.search(after + r"\s*\(([^()]*)\)", text)
    return np.array(match[1].split(), float)


class Bed:
    """A run. Lengths in m, pressures in Pa, times in s."""

    def __init__(self, case):
        self.case = Path(case)
        self._read_inputs()
        self._read_series()
        self._read_frames()
        self._set_windows()

    # Inputs, all from the case's own dictionaries

    def _read_inputs(self):
        constant = self.case / "constant"
        parcels = constant / "parcelsProperties"
        self.diameter = _number(parcels, "diameter")
        self.density = _number(parcels, "density")
        self.gas_density = _number(constant / "transportProperties", "rho")
        gravity = _vector((constant / "g").read_text(), r"\bvalue")
        self.g = float(np.linalg.norm(gravity))

        mesh = (self.case / "system" / "blockMeshDict").read_text()
        scale = float(re.search(r"\bscale\s+(\S+);", mesh)[1])
        corners = re.findall(r"\(\s*(\d+) (\d+) (\d+)\s*\)(?=[\s(])", mesh)
        self.size = scale * np.array(corners[:8], float).max(axis=0)
        self.cells = _vector(mesh, r"hex\s*\([^()]*\)").astype(int)
        self.area = self.size[0] * self.size[2]

        fill = self.case / "system" / "fillParcelsDict"
        self.n_parcels = int(_number(fill, "number"))
        volume = np.pi / 6 * self.diameter**3
        self.solids_volume = self.n_parcels * volume
        self.mass = self.solids_volume * self.density
        buoyant = self.solids_volume * (self.density - self.gas_density)
        self.weight = buoyant * self.g / self.area  # [Pa]

        options = self.case / "system" / "runOptions"
        text = options.read_text() if options.exists() else ""
        self.average_from = _number(
            options if "averageFrom" in text
            else self.case / "system" / "controlDict", "averageFrom")

        inlet = (self.case / "0.orig" / "U").read_text()
        self.gas_velocity = float(
            re.search(r'valueExpr\s+"vector\(0, ([\d.]+)', inlet)[1]
        )

    # Series in time

    def _series(self, folder):
        """The tables of a function object. A run that was continued has left
        one from each start: what came later stands."""
        files = sorted(
            (self.case / "postProcessing" / folder).glob("*/*.dat"),
            key=lambda path: path.stat().st_mtime,
        )
        rows = np.empty((0, 0))
        for path in files:
            new = of.table(path)
            if not new.size:
                continue
            old = rows[rows[:, 0] < new[0, 0]] if rows.size else new[:0]
            rows = np.vstack([old, new])
        if not rows.size:
            sys.exit(f"bubblingBed: {self.case} has no table of {folder}: "
                     "run ./Allrun first")
        return rows

    def _read_series(self):
        table = next(
            (self.case / "postProcessing" / "parcels").glob("*/parcels.dat"),
            None,
        )
        rows = self._series("parcels")
        names = table.read_text().splitlines()[0].lstrip("# ").split()
        self.parcels = dict(zip(names, rows.T))
        self.time = self.parcels["time"]
        self.dt = np.diff(self.time, prepend=0)

        # The full pressure drop, less the weight of the gas in the column
        column = self.gas_density * self.g * self.size[1]
        self.pressure_drop = (
            self.gas_density * self._at_steps("inletPressure") - column
        )
        self.inflow = -self._at_steps("inletFlow") / self.area
        self.outflow = self._at_steps("outletFlow") / self.area

    def _at_steps(self, folder):
        """A function object's value at the times of the parcels' table."""
        rows = self._series(folder)
        return np.interp(self.time, rows[:, 0], rows[:, 1])

    # Fields at the times that were written

    def _read_frames(self):
        self.frames = [t for t in of.times(self.case) if float(t) > 0]

    def cell_field(self, time, name):
        """A field as [x, y, z] (and component)."""
        values = np.asarray(of.field(self.case, time, name))
        tail = values.shape[1:]
        shape = tuple(self.cells[::-1]) + tail
        return values.reshape(shape).swapaxes(0, 2)

    def centres(self, axis):
        n = self.cells[axis]
        return (np.arange(n) + 0.5) * self.size[axis] / n

    def _set_windows(self):
        on = self.inflow > 1e-6 * self.gas_velocity
        self.gas_on = float(self.time[on][0]) if on.any() else None
        self.end = float(self.time[-1])

        averaged = [
            t for t in self.frames
            if float(t) > self.average_from - 1e-6
            and list((self.case / t).glob("solidsFluxMean*"))
        ]
        self.averaged = averaged
        # The first may be from before the averages began anew
        if len(averaged) > 1 and self._duration(averaged[0]) > min(
                0.02, self._duration(averaged[1])):
            del averaged[0]
        self.window = None
        if len(averaged) > 2 * max(BLOCKS):
            self.window = (float(averaged[0]), float(averaged[-1]))

    def picture_times(self):
        """Three times that show what the bed does: at rest, with its centre
        highest in the last second, and at the end."""
        def centre(time):
            return np.interp(float(time), self.time, self.parcels["centreY"])

        last, rest = self.frames[-1], self.rest()
        late = [t for t in self.frames if float(t) > self.end - 1]
        if rest is None or float(last) < self.gas_on + 1:
            return [last]
        return list(dict.fromkeys([rest, max(late, key=centre), last]))

    def rest(self):
        """The last time written before the gas came on, if there is one."""
        if self.gas_on is None:
            return None
        before = [t for t in self.frames if float(t) <= self.gas_on]
        return before[-1] if before else None

    # Means and their statistical errors

    def integral(self, series, times):
        """Integral of a series over time from the start to each of times."""
        total = np.cumsum(series * self.dt)
        return np.interp(times, self.time, total)

    def mean(self, series, window=None):
        """Mean over the window, and its standard error by block averages."""
        start, end = window or self.window

        def blocks(n):
            edges = np.linspace(start, end, n + 1)
            return np.diff(self.integral(series, edges)) / np.diff(edges)

        return blocks(1)[0], block_error(blocks)

    def flux_frames(self):
        """Means of the solids flux from each averaged frame to the next, as
        [frame, x, y, z, component], and the times between which they are. A
        mean up to t, times its duration, is an integral: differences of those
        are exact means over the time between."""
        if not hasattr(self, "_flux"):
            durations = [self._duration(t) for t in self.averaged]
            sums = np.array([
                duration * self.cell_field(t, "solidsFluxMean")
                for t, duration in zip(self.averaged, durations)
            ])
            steps = np.diff(durations)
            between = np.diff(np.array(self.averaged, float))
            if not np.allclose(steps, between, rtol=0.01):
                sys.exit(f"bubblingBed: {self.case}: fieldAverage has not "
                         f"averaged without a gap from {self.averaged[0]} s on")
            self._flux = np.diff(sums, axis=0) / steps.reshape(-1, 1, 1, 1, 1)
        return self._flux

    def _duration(self, time):
        """What fieldAverage says on how long it has averaged up to a time."""
        places = [self.case, *sorted(self.case.glob("processor*"))]
        name = "uniform/functionObjects/functionObjectProperties"
        for place in places:
            path = place / time / name
            if path.exists():
                text = path.read_text()
                part = text[text.index("averages"):]
                return float(re.search(r"totalTime\s+([^;\s]+);", part)[1])
        raise FileNotFoundError(f"{self.case}/{time}/{name}")

    def flux_mean(self, reduce):
        """Mean over the window and standard error of reduce(flux), where
        reduce makes an array of a flux [..., x, y, z, component]."""
        values = reduce(self.flux_frames())

        def blocks(n):
            parts = np.array_split(values, n)
            return np.array([part.mean(axis=0) for part in parts])

        return values.mean(axis=0), block_error(blocks)

    def at_height(self, height):
        """A reduction of a flux to its vertical component at a height, over
        x: the mean over depth, interpolated between rows of cells."""
        y = self.centres(1)
        upper = int(np.searchsorted(y, height))
        share = (height - y[upper - 1]) / (y[upper] - y[upper - 1])

        def reduce(flux):
            vertical = flux[..., 1].mean(axis=-1)
            below, above = vertical[..., upper - 1], vertical[..., upper]
            return (1 - share) * below + share * above

        return reduce

    # The run itself

    def clock(self):
        """Wall-clock seconds of the solver, over all its starts."""
        text = (self.case / "log.cghsFoam").read_text()
        return sum(
            float(part.rsplit("ClockTime = ", 1)[1].split()[0])
            for part in text.split("Starting time loop")[1:]
            if "ClockTime = " in part
        )

    def ranks(self):
        text = (self.case / "log.cghsFoam").read_text()
        return int(re.search(r"nProcs\s*:\s*(\d+)", text)[1])


def block_error(blocks):
    """Standard error of a mean, from blocks(n) = the means of n blocks."""
    return np.max(
        [blocks(n).std(axis=0, ddof=1) / np.sqrt(n) for n in BLOCKS], axis=0
    )
