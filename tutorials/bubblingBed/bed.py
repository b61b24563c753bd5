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

PROJECT = next((folder for folder in Path(__file__).resolve().parents
                if (folder / "etc" / "openfoam").exists()), None)
if PROJECT is None:
    sys.exit(f"{Path(__file__).parent} is not within a cghsFoam")
sys.path.append(str(PROJECT / "tutorials" / "lib"))
from fluidisedBed import FluidisedBed  # noqa: E402
import windows  # noqa: E402
from tutorial import BLOCKS, mean_of, np, of, stop  # noqa: E402

HEIGHTS = (0.025, 0.055, 0.085)  # [m] at which the chapter shows the flux


class Bed(FluidisedBed):
    """A run, with its fields at the times that were written."""

    def __init__(self, case):
        super().__init__(case)
        self._set_window()

    def cell_field(self, time, name):
        """A field as [x, y, z] (and component)."""
        values = np.asarray(of.field(self.case, time, name))
        tail = values.shape[1:]
        shape = tuple(self.cells[::-1]) + tail
        return values.reshape(shape).swapaxes(0, 2)

    def _set_window(self):
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
                stop(f"{self.case}: fieldAverage has not "
                     f"averaged without a gap from {self.averaged[0]} s on")
            self._flux = np.diff(sums, axis=0) / steps.reshape(-1, 1, 1, 1, 1)
        return self._flux

    def _duration(self, time):
        """What fieldAverage says on how long it has averaged up to a time."""
        places = [self.case, *sorted(self.case.glob("processor*"))]
        name = "uniform/functionObjects/functionObjectProperties"
        for place in places:
            path = place / time / name
            if of.has(path):
                text = of.read(path)
                part = text[text.index("averages"):]
                return float(re.search(r"totalTime\s+([^;\s]+);", part)[1])
        raise FileNotFoundError(f"{self.case}/{time}/{name}")

    def flux_mean(self, reduce):
        """Mean over the window and standard error of reduce(flux), where
        reduce makes an array of a flux [..., x, y, z, component]."""
        return mean_of(reduce(self.flux_frames()))

    def window_of(self, reduce):
        """How long the window is for reduce(flux), see windows.py."""
        frames = np.asarray(reduce(self.flux_frames()))
        start, end = self.window
        return windows.judge(frames, (end - start) / len(frames))

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
