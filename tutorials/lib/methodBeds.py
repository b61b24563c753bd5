# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     One bed by several methods, each of which is a file constant/method with
#     the weight and number of its parcels and how they touch: what their runs
#     have in common, side by side.
# ------------------------------------------------------------------------------
"""A fluidised bed by several methods."""

from pathlib import Path

from fluidisedBed import FluidisedBed
from tutorial import clock_series, np, number, ranks, stop


class MethodBed(FluidisedBed):
    """A run by one method, in the folder of its name."""

    def __init__(self, case):
        super().__init__(case)
        self.name = self.case.name

    def parcel_weight(self):
        return number(self.case / "constant" / "method", "weight")

    def count_of_parcels(self):
        return int(number(self.case / "constant" / "method", "nParcels"))

    def overlap_limit(self):
        """Largest overlap to expect, over the diameter, and why: of two hard
        spheres that each moved by maxDisplacement, or of two soft ones that
        meet at 4 m/s."""
        method = self.case / "constant" / "method"
        stiffness = number(method, "springConstant", 0)
        if not stiffness:
            return 0.2, "limit: two parcels, 0.1 d a step each"
        mass = self.mass / self.n_parcels
        d = self.diameter * self.weight_of_parcel**(1 / 3)
        return (4 * np.sqrt(0.5 * mass / stiffness) / d,
                "limit: two parcels that meet at 4 m/s")

    def cost(self):
        """Processor seconds for a simulated second, from the gas on."""
        time, spent = clock_series(self.case, "ExecutionTime")
        start = min(self.gas_on or 0, 0.5 * time[-1])
        used = spent[-1] - np.interp(start, np.maximum.accumulate(time), spent)
        return ranks(self.case) * used / (time[-1] - start)

    def solids_step(self):
        """Mean length of a solids step in the window or the run [s]."""
        steps = self.parcels["nSolidsSteps"]
        return self.dt[1:].sum() / steps[1:].sum()

    def parcel_diameter(self):
        return self.diameter * self.weight_of_parcel**(1 / 3)


def runs_by_method(folder, methods, kind):
    """The runs in a folder, by the name of their method: of the class kind."""
    beds = {
        name: kind(Path(folder) / name) for name in methods
        if list((Path(folder) / name).glob("postProcessing/parcels/*/*.dat"))
    }
    if not beds:
        stop(f"{folder} has no runs: run ./Allrun first")
    return beds


def rows_of_runs(beds):
    """Of the table of runs: what each is, and what it costs."""
    def row(text, unit, value):
        return [text, *(value(bed) for bed in beds.values()), unit]

    return [
        row("parcels", "", lambda b: f"{b.n_parcels}"),
        row("particles in a parcel", "", lambda b: f"{b.weight_of_parcel:g}"),
        row("mean solids step", "ms", lambda b: f"{1e3*b.solids_step():.3f}"),
        row("simulated", "s", lambda b: f"{b.end:g}"),
        row("ranks", "", lambda b: f"{ranks(b.case)}"),
        row("processor time for a simulated second", "s",
            lambda b: f"{b.cost():.0f}"),
    ]
