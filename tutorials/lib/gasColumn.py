# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     A run in a box of blockMesh, of a gas that enters at inlet, y = 0, and
#     leaves at outlet, opposite: the function objects inletPressure, inletFlow
#     and outletFlow watch it. The gas is incompressible; a class for one that is
#     not has its own density_of_gas and read_gas.
# ------------------------------------------------------------------------------
"""A box with parcels and a gas that flows up."""

import re

from tutorial import Run, np, number, vector


class GasColumn(Run):
    """A run. Flows of the gas are superficial velocities."""

    def read_inputs(self):
        super().read_inputs()
        self.density = number(
            self.case / "constant" / "parcelsProperties", "density")
        self.gas_density = self.density_of_gas()

        mesh = (self.case / "system" / "blockMeshDict").read_text()
        scale = float(re.search(r"\bscale\s+(\S+);", mesh)[1])
        corners = re.findall(r"\(\s*(\d+) (\d+) (\d+)\s*\)(?=[\s(])", mesh)
        self.size = scale * np.array(corners[:8], float).max(axis=0)
        self.cells = self.numbers_of_cells(mesh)
        self.area = self.size[0] * self.size[2]

    def density_of_gas(self):
        return number(self.case / "constant" / "transportProperties", "rho")

    def numbers_of_cells(self, mesh):
        """By direction; mesh: the text of blockMeshDict."""
        return vector(mesh, r"hex\s*\([^()]*\)").astype(int)

    def read_series(self):
        super().read_series()
        self.read_gas()

    def read_gas(self):
        # The full pressure drop, less the weight of the gas in the column
        column = self.gas_density * self.g * self.size[1]
        self.pressure_drop = (
            self.gas_density * self.at_steps("inletPressure") - column
        )
        self.inflow = -self.at_steps("inletFlow") / self.area
        self.outflow = self.at_steps("outletFlow") / self.area

    def lifted_pressure(self):
        """The part of the pressure drop that sets the solids in motion."""
        momentum = np.diff(self.parcels["momentumY"], prepend=0)
        return momentum / self.dt / self.area

    def centres(self, axis):
        """Of the cells."""
        n = self.cells[axis]
        return (np.arange(n) + 0.5) * self.size[axis] / n
