# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What a run of the lower part of the reactor has left, as numbers: the
#     one place from which both evaluate and validate take them.
# ------------------------------------------------------------------------------
"""The reactor in three dimensions: its inputs and series in time."""

import sys
from pathlib import Path

PROJECT = next((folder for folder in Path(__file__).resolve().parents
                if (folder / "etc" / "openfoam").exists()), None)
if PROJECT is None:
    sys.exit(f"{Path(__file__).parent} is not within a cghsFoam")
sys.path.append(str(PROJECT / "tutorials" / "lib"))
from tutorial import (  # noqa: E402
    Run, clock_series, columns, np, number, of, ranks, seconds, series)

RADIUS, HEIGHT = 0.1305, 0.8            # [m], as the script vessel has them
AREA = np.pi*RADIUS**2

# 4.2.1 and Table 10
FEED, STEAM = 27/3600, 0.12/3600        # gas [kg/s]
CATALYST = 8.8/3600                     # [kg/s]
INVENTORY, BED_HEIGHT = 9.0, 0.4        # [kg], [m]
PRESSURE = 101325.0                     # [Pa]

GAS = ("CH4", "C2H4", "C3H6", "C3H8", "C4H8", "C5H10")
LIGHT = ("C2H4", "C3H6")


class Reactor(Run):
    """A run. Masses in kg."""

    def __init__(self, case):
        super().__init__(case)
        if self.end - self.average_from > 0.5:
            self.window = (self.average_from, self.end)

    def read_inputs(self):
        super().read_inputs()
        self.read_parcels()

    def read_series(self):
        super().read_series()
        self.mass = self.parcels["mass"]
        self.escaped = self.parcels["escapedMass"]
        self.fed = self.parcels["fedMass"]
        self.outlet_pressure = self.at_steps("outletPressure")
        self.pressure_drop = (
            self.at_steps("inletPressure") - self.outlet_pressure)
        self.feed = -self.at_steps("feedFlow")
        self.steam = -self.at_steps("steamFlow")

        # Coke that parcels have taken up, by each step of the log
        log = self.case / "log.cghsFoam"
        gained = of.log_values(log, r"\nreactions:.* gained")
        times = of.log_values(log, r"\nTime =")[:gained.size]
        self.gained = np.cumsum(np.interp(self.time, times, gained)*self.dt)

    def solids_defect(self):
        """Furthest in the run, over what was there at the start."""
        mass = self.mass + self.escaped - self.fed - self.gained
        return abs(mass - mass[0]).max()/mass[0]

    def mean_flow(self, flow):
        return (flow*self.dt)[1:].sum()/self.dt[1:].sum()

    def element_defect(self, name):
        """From nowhere, over what there is and flows: largest of the run."""
        table = columns(self.case, "balance")
        return float(abs(table[f"element.relative({name})"]).max())

    def due(self):
        """The last time written, solids that were to be fed until then, and
        that were [s, kg]."""
        time = float(self.frames[-1])
        due = number(self.case / self.frames[-1]
                     / "uniform/lagrangian/parcels/flows", "due")
        return time, due, np.interp(time, self.time, self.fed)

    def coke(self):
        """Times and mean coke of the parcels [%]."""
        table = columns(self.case, "reactionHistory")
        return table["time"], 100*table["Y.coke"]

    def products(self):
        """Times, and by names mass fractions of the gas that leaves."""
        rows = series(self.case, "products")
        return rows[:, 0], dict(zip(("MeOH", "H2O", *GAS), rows[:, 1:].T))

    def height_profile(self):
        """Middles of layers [m], solids fraction; none before there are
        means."""
        files = sorted(
            (self.case / "postProcessing" / "solidsProfiles").glob(
                "*/height.dat"),
            key=lambda path: float(path.parent.name))
        if not files:
            return None
        table = of.columns(files[-1])
        return table["coordinate"], table["solidsFraction"]

    def surface(self):
        """Below which 95 % of the solids are [m]."""
        z, fraction = self.height_profile()
        share = np.cumsum(fraction)/fraction.sum()
        return float(np.interp(0.95, share, z + 0.5*(z[1] - z[0])))

    def seconds_per_day(self):
        time, spent = clock_series(self.case)
        start = min(1, 0.5*time[-1])
        used = spent[-1] - np.interp(start, time, spent)
        return 86400*(time[-1] - start)/max(used, 1e-3)

    def seconds(self):
        return seconds(self.case)

    def ranks(self):
        return ranks(self.case)
