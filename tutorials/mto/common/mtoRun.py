# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What a run of the reactor in three dimensions has left, as numbers: the
#     one place from which the tutorials' evaluate and validate take them.
# ------------------------------------------------------------------------------
"""The reactor in three dimensions: its inputs and series in time."""

from fedRun import FedRun
from lowerEnd import RADIUS
from tutorial import columns, np, of, option, series

AREA = np.pi*RADIUS**2                  # [m2]

# 4.2.1 and Table 10
FEED, STEAM = 27/3600, 0.12/3600        # gas [kg/s]
CATALYST = 8.8/3600                     # [kg/s]
INVENTORY, BED_HEIGHT = 9.0, 0.4        # [kg], [m]
PRESSURE = 101325.0                     # [Pa]
CELL = 0.02                             # [m]

GAS = ("CH4", "C2H4", "C3H6", "C3H8", "C4H8", "C5H10")
LIGHT = ("C2H4", "C3H6")


class Reactor(FedRun):
    """A run. Masses in kg."""

    def read_inputs(self):
        super().read_inputs()
        self.factor, self.slow_from = (
            option(self.case, name, "constant/parcelsProperties")
            for name in ("slowFactor", "slowFrom"))

    def slow(self, time):
        """Time by the slow clock [s], see slowClock.H."""
        return time + (self.factor - 1)*np.maximum(time - self.slow_from, 0)

    def hours(self, frame):
        """Of a time that was written, by the slow clock."""
        return self.slow(float(frame))/3600

    def bed_cells(self):
        """As many as fill the bed."""
        return AREA*BED_HEIGHT/CELL**3

    def read_series(self):
        super().read_series()
        self.feed = -self.at_steps("feedFlow")
        self.steam = -self.at_steps("steamFlow")

    def due(self):
        """The time is by the slow clock."""
        time, due, fed = super().due()
        return self.slow(time), due, fed

    def parcels_at(self, frame):
        """Coke by mass [%], age [s, by the slow clock] and share of the mass of
        each parcel at a time that was written."""
        coke, age, density = (
            of.cloud_field(self.case, frame, "parcels", name)
            for name in ("Y.coke", "age", "rho"))
        # All are of one size
        return 100*coke, age, density/density.sum()

    def new(self, frame):
        """Share of the catalyst that has come in by then [%]."""
        _, age, mass = self.parcels_at(frame)
        return 100*mass[age < self.slow(float(frame)) - 1e-3].sum()

    def coke(self):
        """Times and mean coke of the parcels [%]."""
        table = columns(self.case, "reactionHistory")
        return table["time"], 100*table["Y.coke"]

    def products(self):
        """Times, and by names mass fractions of the gas that leaves."""
        rows = series(self.case, "products")
        return rows[:, 0], dict(zip(("MeOH", "H2O", *GAS), rows[:, 1:].T))

    def light_at(self, time):
        """Light olefins of the hydrocarbon gas that leaves, mean of the second
        before [%]."""
        times, Y = self.products()
        late = (times > time - 1) & (times <= time + 1e-9)
        made = sum(Y[s][late].mean() for s in GAS)
        return 100*sum(Y[s][late].mean() for s in LIGHT)/max(made, 1e-30)
