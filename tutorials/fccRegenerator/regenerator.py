# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What a run of the regenerator has left, as numbers: the one place from
#     which both evaluate (page of results) and validate (checks) take them.
# ------------------------------------------------------------------------------
"""The regenerator: its inputs, its series in time, its means with errors."""

import re
import sys
from pathlib import Path

PROJECT = next((folder for folder in Path(__file__).resolve().parents
                if (folder / "etc" / "openfoam").exists()), None)
if PROJECT is None:
    sys.exit(f"{Path(__file__).parent} is not within a cghsFoam")
sys.path.append(str(PROJECT / "tutorials" / "lib"))
from tutorial import (  # noqa: E402
    Run, clock_series, columns, mean_of, np, number, of, ranks,
    seconds, series)

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
CATALYST_GAS = 0.12

# The bed without what is next to its floor and its surface [m]
BED = (1.0, 7.0)

# Over this height the catalyst is called entrained [m]
FREEBOARD = 10.0

# [s] over which series are averaged
STEP = 0.5


class Regenerator(Run):
    """A run. Masses in kg."""

    def __init__(self, case):
        super().__init__(case)
        self._taps = {}
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
        self.air = -self.at_steps("airFlow")
        self.spent_gas = -self.at_steps("spentGasFlow")
        self.catalyst_gas = self.at_steps("catalystGasFlow")
        self.gas_out = self.at_steps("outletFlow") + self.catalyst_gas
        self.gas_mass = self.at_steps("gasMass")

        # Coke that parcels have lost to the gas, by each step of the log [kg]
        log = self.case / "log.cghsFoam"
        lost = -of.log_values(log, r"\nreactions:.* gained")
        times = of.log_values(log, r"\nTime =")[:lost.size]
        self.burnt = np.cumsum(np.interp(self.time, times, lost)*self.dt)

    def mean_flow(self, flow):
        """Over the run: steps are implicit, see gas_defect."""
        return (flow*self.dt)[1:].sum()/self.dt[1:].sum()

    # Balances

    def gas_defect(self):
        """What of the gas has come from nowhere, over what has entered: steps
        are implicit, so that flows hold for the step before their time."""
        flow = self.air + self.spent_gas
        gained = self.gas_mass[-1] - self.gas_mass[0]
        flowed = ((flow - self.gas_out)*self.dt)[1:].sum()
        flowed += self.burnt[-1] - self.burnt[0]
        return abs(gained - flowed)/(flow*self.dt)[1:].sum()

    def solids_defect(self):
        """Furthest in the run, over what was there at the start."""
        mass = self.mass + self.escaped - self.fed + self.burnt
        return abs(mass - mass[0]).max()/mass[0]

    # Profiles that solidsProfiles has made

    def profile(self, name):
        """The columns of a profile by their names, of the last time written."""
        files = sorted(
            (self.case / "postProcessing" / "solidsProfiles").glob(
                f"*/{name}.dat"),
            key=lambda path: float(path.parent.name))
        return of.columns(files[-1]) if files else None

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
        z, density, _ = self.density_profile()
        held = density*np.where(z < CONE[1], RADIUS, WIDE_RADIUS)**2
        share = np.cumsum(held)/held.sum()
        step = z[1] - z[0]
        return float(np.interp(0.95, share, z + 0.5*step))

    # The taps along the wall

    def _tap_table(self):
        """The columns of the taps' table by their names."""
        if not self._taps:
            self._taps = columns(self.case, "taps")
        return self._taps

    def taps(self):
        """Heights, mean pressures over that at the top, errors [m, Pa]."""
        table = self._tap_table()
        pairs = [name for name in table if re.match(r"z[\d.]+$", name)]
        return (np.array([float(pair[1:]) for pair in pairs]),
                np.array([table[pair + "Mean"][-1] for pair in pairs]),
                np.array([table[pair + "Error"][-1] for pair in pairs]))

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

    def leaving(self, name):
        """Mean of a distribution of what leaves."""
        files = sorted(
            (self.case / "postProcessing" / name).glob(
                "*/parcelDistribution.dat"),
            key=lambda path: float(path.parent.name))
        rows = of.columns(files[-1])
        return rows["mean"][-1], rows["meanError"][-1]

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

    def element_defects(self):
        """From nowhere, over what there is and flows: largest of the run."""
        rows = columns(self.case, "balance")
        return {name[len("element.relative("):-1]: float(abs(value).max())
                for name, value in rows.items()
                if name.startswith("element.relative(")
                and name.endswith(")")}

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

    def seconds_per_day(self):
        """Simulated seconds in a day, from the second second on."""
        time, spent = clock_series(self.case)
        start = min(1, 0.5*time[-1])
        used = spent[-1] - np.interp(start, time, spent)
        return 86400*(time[-1] - start)/max(used, 1e-3)

    def gas_step(self):
        """Mean [s]."""
        return float(np.mean(self.dt[1:]))

    def solids_steps(self):
        """In a step of the gas, mean."""
        return float(self.parcels["nSolidsSteps"][1:].mean())

    # Fields of the last time written

    def field(self, name):
        return np.asarray(of.field(self.case, self.frames[-1], name))

    def due(self):
        """The last time written, solids that were to be fed until then, and
        that were [s, kg]."""
        time = float(self.frames[-1])
        due = number(self.case / self.frames[-1]
                     / "uniform/lagrangian/parcels/flows", "due")
        return time, due, np.interp(time, self.time, self.fed)
