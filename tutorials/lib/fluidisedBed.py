# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     A bed in a box of blockMesh, fluidised from below: its inputs, its series
#     in time and their means, with errors. Gas enters at inlet and leaves at
#     outlet; the function objects inletPressure, inletFlow and outletFlow watch
#     it.
# ------------------------------------------------------------------------------
"""A fluidised bed: its inputs, its series in time, their means with errors."""

import re
from pathlib import Path

from tutorial import block_error, column_names, np, number, of, series, vector


class FluidisedBed:
    """A run. Lengths in m, pressures in Pa, times in s."""

    def __init__(self, case):
        self.case = Path(case)
        self._read_inputs()
        self._read_series()
        self.frames = [t for t in of.times(self.case) if float(t) > 0]
        on = self.inflow > 1e-6 * self.gas_velocity
        self.gas_on = float(self.time[on][0]) if on.any() else None
        self.end = float(self.time[-1])
        self.window = None  # of the means

    # Inputs, all from the case's own dictionaries

    def _read_inputs(self):
        constant = self.case / "constant"
        parcels = constant / "parcelsProperties"
        self.diameter = number(parcels, "diameter")
        self.density = number(parcels, "density")
        self.weight_of_parcel = self._parcel_weight()
        self.gas_density = number(constant / "transportProperties", "rho")
        gravity = vector((constant / "g").read_text(), r"\bvalue")
        self.g = float(np.linalg.norm(gravity))

        mesh = (self.case / "system" / "blockMeshDict").read_text()
        scale = float(re.search(r"\bscale\s+(\S+);", mesh)[1])
        corners = re.findall(r"\(\s*(\d+) (\d+) (\d+)\s*\)(?=[\s(])", mesh)
        self.size = scale * np.array(corners[:8], float).max(axis=0)
        self.cells = vector(mesh, r"hex\s*\([^()]*\)").astype(int)
        self.area = self.size[0] * self.size[2]

        self.n_parcels = self._count_of_parcels()
        volume = self.weight_of_parcel * np.pi / 6 * self.diameter**3
        self.solids_volume = self.n_parcels * volume
        self.mass = self.solids_volume * self.density
        buoyant = self.solids_volume * (self.density - self.gas_density)
        self.weight = buoyant * self.g / self.area  # [Pa]

        self.average_from = number(
            self.case / "system" / "runOptions", "averageFrom",
            number(self.case / "system" / "controlDict", "averageFrom"))

        inlet = (self.case / "0.orig" / "U").read_text()
        self.gas_velocity = float(
            re.search(r'valueExpr\s+"vector\(0, ([\d.]+)', inlet)[1]
        )

    def _parcel_weight(self):
        return number(self.case / "constant" / "parcelsProperties",
                      "parcelWeight")

    def _count_of_parcels(self):
        return int(number(self.case / "system" / "fillParcelsDict", "number"))

    # Series in time

    def _read_series(self):
        rows = series(self.case, "parcels")
        self.parcels = dict(zip(column_names(self.case, "parcels"), rows.T))
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
        rows = series(self.case, folder)
        return np.interp(self.time, rows[:, 0], rows[:, 1])

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

    def lifted_pressure(self):
        """The part of the pressure drop that moves the bed up and down."""
        momentum = np.diff(self.parcels["momentumY"], prepend=0)
        return momentum / self.dt / self.area

    # Places

    def centres(self, axis):
        n = self.cells[axis]
        return (np.arange(n) + 0.5) * self.size[axis] / n

    def rest(self):
        """The last time written before the gas came on, if there is one."""
        if self.gas_on is None:
            return None
        before = [t for t in self.frames if float(t) <= self.gas_on]
        return before[-1] if before else None
