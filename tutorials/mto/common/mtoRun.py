# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What a run of the reactor in three dimensions has left, as numbers: the
#     one place from which the tutorials' evaluate and validate take them.
# ------------------------------------------------------------------------------
"""The reactor in three dimensions: its inputs and series in time."""

import sys

from fedRun import FedRun
from lowerEnd import RADIUS
from tutorial import (
    PROJECT, columns, mean_of, newest, np, of, option, ratio_of, series)

sys.path.append(str(PROJECT / "tutorials" / "mto" / "0D"))
from limits import peak  # noqa: E402

AREA = np.pi*RADIUS**2                  # [m2]

# 4.2.1 and Table 10
FEED, STEAM = 27/3600, 0.12/3600        # gas [kg/s]
CATALYST = 8.8/3600                     # [kg/s]
INVENTORY, BED_HEIGHT = 9.0, 0.4        # [kg], [m]
PRESSURE = 101325.0                     # [Pa]
CELL = 0.02                             # [m]
METHANOL = 2/3                          # of the feed, by mass

GAS = ("CH4", "C2H4", "C3H6", "C3H8", "C4H8", "C5H10")
LIGHT = ("C2H4", "C3H6")

# [s] over which the gas that leaves is averaged
BLOCK = 1

# [s] until the gas of the start has left: 0.2 m3 at 0.02 m3/s, and a bit; in
# the lower part of the reactor sooner
RENEWED = 12


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

    def near(self, hour):
        """The time written that is nearest, by the slow clock."""
        return min(self.frames, key=lambda f: abs(self.hours(f) - hour))

    def new(self, frame):
        """Share of the catalyst that has come in by then [%]."""
        _, age, mass = self.parcels_at(frame)
        return 100*mass[age < self.slow(float(frame)) - 1e-3].sum()

    def most(self, frame):
        """Coke of the fullest class of the catalyst [%]."""
        coke, _, mass = self.parcels_at(frame)
        return peak(coke, mass)

    def passing(self):
        """Time that catalyst stays: what there is over what is fed [s, by the
        slow clock]."""
        return (self.mean(self.mass)[0] if self.window else INVENTORY)/CATALYST

    def ages_of_leaving(self):
        """Of what leaves: upper ends of classes of age [s, by the slow clock],
        the share that is younger, mean age and error. None before any has."""
        rows = newest(self.case, "ageOfLeaving", "histogram")
        if not rows or not np.sum(rows["share"]):
            return None
        mean, error, _ = self.leaving("ageOfLeaving")
        ends = rows["x"] + 0.5*(rows["x"][1] - rows["x"][0])
        return ends, rows["cumulative"], mean, error

    def coke(self):
        """Times and mean coke of the parcels [%]."""
        table = columns(self.case, "reactionHistory")
        return table["time"], 100*table["Y.coke"]

    def settled_from(self):
        """Time when the slow clock shows four times that which catalyst stays
        [s]."""
        settled = 4*INVENTORY/CATALYST
        return self.slow_from + (settled - self.slow_from)/self.factor

    def settled_coke(self):
        """Mean over what has settled, and its error [%]; none before."""
        time, coke = self.coke()
        late = coke[time > self.settled_from()]
        return mean_of(late) if late.size >= 20 else None

    # Of the gas that leaves. What the table has is sum(phi Y)/sum(phi): where
    # gas flows in and out at a time, sum(phi) can be next to nothing, and only
    # their product means something.

    def outflows(self):
        """Times, the gas that flows out, and by names the species [kg/s]."""
        rows = series(self.case, "products")
        flow = series(self.case, "outletFlow")
        out = np.interp(rows[:, 0], flow[:, 0], flow[:, 1])
        return rows[:, 0], out, {
            name: Y*out for name, Y in zip(("MeOH", "H2O", *GAS),
                                           rows[:, 1:].T)}

    def products(self):
        """Times, and by names mass fractions of the gas that leaves, in blocks
        of time."""
        time, out, flows = self.outflows()
        _, block = np.unique(np.floor(time/BLOCK + 1e-9), return_inverse=True)

        def total(values):
            return np.bincount(block, values)

        return (total(time)/np.bincount(block),
                {name: total(flow)/total(out) for name, flow in flows.items()})

    def light_at(self, time):
        """Light olefins of the hydrocarbon gas that leaves, mean of the second
        before [%]."""
        times, _, flows = self.outflows()
        late = (times > time - BLOCK) & (times <= time + 1e-9)
        made = sum(flows[s][late].sum() for s in GAS)
        return 100*sum(flows[s][late].sum() for s in LIGHT)/max(made, 1e-30)

    def late(self):
        """From when on means are taken of the gas that leaves [s]."""
        return max(self.window[0], RENEWED)

    def light(self, start):
        """The same from a time on, and the error of that [-]."""
        time, _, flows = self.outflows()
        late = time > start
        return ratio_of(*(sum(flows[s][late] for s in names)
                          for names in (LIGHT, GAS)))

    def methanol_in(self):
        """Net through all openings, by flow and diffusion, mean of the run
        [kg/s]."""
        return columns(self.case, "balance")["in(MeOH)Mean"][-1]
