# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     A bed of a given number of parcels that the gas fluidises once it comes
#     on, and the checks that any such bed has to pass.
# ------------------------------------------------------------------------------
"""A fluidised bed."""

import re

from gasColumn import GasColumn
from tutorial import np, number


class FluidisedBed(GasColumn):
    """A run."""

    def read_inputs(self):
        super().read_inputs()
        parcels = self.case / "constant" / "parcelsProperties"
        self.diameter = number(parcels, "diameter")
        self.weight_of_parcel = self.parcel_weight()
        self.n_parcels = self.count_of_parcels()

        volume = self.weight_of_parcel * np.pi / 6 * self.diameter**3
        self.solids_volume = self.n_parcels * volume
        self.mass = self.solids_volume * self.density
        buoyant = self.solids_volume * (self.density - self.gas_density)
        self.weight = buoyant * self.g / self.area  # [Pa]

        self.gas_velocity = self.inlet_velocity()

    def inlet_velocity(self):
        """Superficial, once the gas is on [m/s]."""
        inlet = (self.case / "0.orig" / "U").read_text()
        return float(
            re.search(r'valueExpr\s+"vector\(0, ([\d.]+)', inlet)[1])

    def parcel_weight(self):
        return number(self.case / "constant" / "parcelsProperties",
                      "parcelWeight")

    def count_of_parcels(self):
        return int(number(self.case / "system" / "fillParcelsDict", "number"))

    def read_series(self):
        super().read_series()
        on = self.inflow > 1e-6 * self.gas_velocity
        self.gas_on = float(self.time[on][0]) if on.any() else None

    def rest(self):
        """The last time written before the gas came on, if there is one."""
        if self.gas_on is None:
            return None
        before = [t for t in self.frames if float(t) <= self.gas_on]
        return before[-1] if before else None

    # Checks. who: of several runs the name of this one and a colon

    def check_conservation(self, checks, who=""):
        """What holds at any time of any run with an incompressible gas."""
        self.check_parcels(checks, who)
        checks.below(f"{who}net gas through inlet and outlet [m/s]",
                     abs(self.outflow - self.inflow).max(),
                     1e-4 * self.gas_velocity,
                     "balance: gas and parcels keep their volume")

    def check_parcels(self, checks, who=""):
        """What holds at any time of any run."""
        n = self.parcels["nParcels"]
        checks.equal(f"{who}parcels, fewest in the run [-]", n.min(),
                     self.n_parcels, 0, "input: none is lost")
        checks.equal(f"{who}parcels, most in the run [-]", n.max(),
                     self.n_parcels, 0, "input: none is doubled")
        checks.below(f"{who}volume defect of a cell in a step [-]",
                     self.parcels["continuityError"].max(), 1e-5,
                     "balance: continuity, here to the solver's tolerance")

    def furthest_mass(self):
        """Of the run, from what was filled in."""
        mass = self.parcels["mass"]
        return mass[np.argmax(abs(mass - self.mass))]

    def check_gas(self, checks, who=""):
        """Once it is on."""
        full = self.time > (self.gas_on or self.end) + 0.1
        if full.any():
            flow = self.inflow[full]
            checks.equal(f"{who}superficial gas velocity [m/s]",
                         flow[np.argmax(abs(flow - self.gas_velocity))],
                         self.gas_velocity, 1e-6, "Table 2")

    def check_pressure_drop(self, checks, who=""):
        """Of what moves up and down, only the part that hangs in the gas."""
        mean, error = self.mean(self.pressure_drop - self.lifted_pressure())
        checks.add(f"{who}mean pressure drop, less what lifts the bed [Pa]",
                   mean, f"{self.weight:.6g}", abs(mean - self.weight),
                   3 * error + 0.1 * self.weight,
                   "balance: buoyant weight over area; 3 standard errors, and "
                   "a tenth for floor and walls")
