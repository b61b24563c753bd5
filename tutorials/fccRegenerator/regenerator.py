# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What a run of the regenerator has left, as numbers: the one place from
#     which both evaluate (page of results) and validate (checks) take them.
# ------------------------------------------------------------------------------
"""The regenerator: its inputs, its series in time, its means with errors."""

import sys
from pathlib import Path

PROJECT = next((folder for folder in Path(__file__).resolve().parents
                if (folder / "etc" / "openfoam").exists()), None)
if PROJECT is None:
    sys.exit(f"{Path(__file__).parent} is not within a cghsFoam")
sys.path.append(str(PROJECT / "tutorials" / "lib"))
from fedRun import FedRun  # noqa: E402
from tutorial import (  # noqa: E402
    columns, mean_of, np, of, ranks, seconds, series)

# [m], as the script vessel has them
RADIUS, WIDE_RADIUS, CONE, HEIGHT = 1.05, 1.35, (8.0, 8.4), 17.6
AREA = np.pi*RADIUS**2
FEED_HEIGHT = 5.0

# Tables 7 and 8
AIR, SPENT = 1.7435, 22.7               # [kg/s]
INVENTORY = 4950.0                      # [kg]
VOIDAGE, BED_HEIGHT = 0.8794, 7.9       # [-], [m]
OUTLET_PRESSURE = 1.4e5                 # [Pa]

# With the catalyst at its voidage of 0.9, 0.5 m/s, 140 kPa and 753 K [kg/s]
SPENT_GAS = 0.117

# What draws the catalyst to the valve, at most [kg/s]
CATALYST_GAS = 0.2

# The bed without what is next to its floor and its surface [m]
BED = (1.0, 7.0)

# Over this height the catalyst is called entrained [m]
FREEBOARD = 10.0

# [s] over which series are averaged
STEP = 0.5


class Regenerator(FedRun):
    """A run. Masses in kg."""

    def read_series(self):
        super().read_series()
        self.air = -self.at_steps("airFlow")
        self.spent_gas = -self.at_steps("spentGasFlow")
        self.catalyst_gas = self.at_steps("catalystGasFlow")
        self.gas_in = self.air + self.spent_gas
        self.gas_out = self.at_steps("outletFlow") + self.catalyst_gas
        self.gas_mass = self.at_steps("gasMass")

    # Profiles along the height

    def has_means(self):
        return self.window is not None and self.profile("height") is not None

    def density_profile(self):
        """Heights, mean bed density [kg/m3] and its standard error."""
        height = self.profile("height")
        return (height["coordinate"], self.density*height["solidsFraction"],
                self.density*height["solidsFractionError"])

    def density_between(self, low, high):
        """Mean of the height's bins there, and standard error as if they erred
        together [kg/m3]."""
        z, density, error = self.density_profile()
        inside = (z > low) & (z < high)
        return density[inside].mean(), error[inside].mean()

    def share_above(self, height):
        """Of the solids."""
        z, density, _ = self.density_profile()
        held = density*np.where(z < CONE[1], RADIUS, WIDE_RADIUS)**2
        return held[z > height].sum()/held.sum()

    def surface(self):
        """Height below which 95 % of the solids are [m]."""
        return super().surface(
            lambda z: np.where(z < CONE[1], RADIUS, WIDE_RADIUS))

    def fluctuation(self):
        """Standard deviation of the pressure drop in the window, and its
        standard error by blocks [Pa]: what bubbles make of it."""
        inside = self.time > self.window[0]
        drop = self.pressure_drop[inside]
        variance, error = mean_of((drop - drop.mean())**2)
        return np.sqrt(variance), 0.5*error/np.sqrt(variance)

    def weight_drop(self):
        """Weight of solids and gas over the area of the bed, and its standard
        error [Pa]: what the walls of the cone bear is in it."""
        mean, error = self.mean(self.mass + self.gas_mass)
        return mean*self.g/AREA, error*self.g/AREA

    # What burns: means of the window and their standard errors

    def exchange_mean(self, table, name):
        """Of a figure of exchangeHistory."""
        rows = columns(self.case, table)
        return (rows[name + "Mean"][-1], rows[name + "Error"][-1])

    def coke(self):
        """Carbon and hydrogen of the catalyst in the vessel [%]."""
        carbon, hydrogen = (np.array(self.exchange_mean("reactionHistory", n))
                            for n in ("Y.C", "Y.H"))
        return 100*(carbon[0] + hydrogen[0]), 100*(carbon[1] + hydrogen[1])

    def flue_gas(self):
        """Mass fractions and temperature of the gas that leaves."""
        rows = series(self.case, "flueGas")
        inside = rows[:, 0] > self.window[0]

        def mean(values):
            """Of few values the error is not known."""
            enough = values.size > 20
            return mean_of(values) if enough else (values.mean(), np.nan)

        return dict(zip(("O2", "CO2", "CO", "H2O", "T"),
                        (mean(v) for v in rows[inside, 1:].T)))

    def gas_by_height(self, name, step=0.4):
        """Middles of layers, means of a field's means over the gas there."""
        z = self.field("C")[:, 2]
        weight = self.field("V")*self.field("alpha")
        layer = (z/step).astype(int)
        sums = [np.bincount(layer, weights=weight*w)
                for w in (self.field(name + "Mean"), 1)]
        return step*(np.arange(sums[0].size) + 0.5), sums[0]/np.maximum(
            sums[1], 1e-30)

    # Cost

    def gas_step(self):
        """Mean [s]."""
        return float(np.mean(self.dt[1:]))

    def solids_steps(self):
        """In a step of the gas, mean."""
        return float(self.parcels["nSolidsSteps"][1:].mean())
