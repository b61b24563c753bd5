# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What a run of the riser has left, as numbers: the one place from which both
#     evaluate (page of results) and validate (checks) take them.
# ------------------------------------------------------------------------------
"""The riser: its inputs, its series in time, its means with errors."""

import re
import sys
from pathlib import Path

PROJECT = next((folder for folder in Path(__file__).resolve().parents
                if (folder / "etc" / "openfoam").exists()), None)
if PROJECT is None:
    sys.exit(f"{Path(__file__).parent} is not within a cghsFoam")
sys.path.append(str(PROJECT / "tutorials" / "lib"))
from tutorial import (  # noqa: E402
    Run, columns, np, number, of, option, ranks, seconds)

RADIUS, HEIGHT = 0.152, 16.8    # [m], as the script pipes has it
AREA = np.pi*RADIUS**2

# Table 5
INLET_PRESSURE, OUTLET_PRESSURE = 124339.0, 105000.0    # [Pa]
SOLIDS_RATE = 14.0                                      # [kg/s]
GAS_VELOCITY, SIDE_FLOW = 6.81, 2.37e-2                 # [m/s], [m3/s]
TEMPERATURE = 294.0                                     # [K]

# Heights of the probes [m], and the profiles there
HEIGHTS = {"Lower": 6.23, "Upper": 8.88}

# From where to where the riser is called bottom, middle and top [m]: the first
# and the last are free of the cells of the side pipes
PARTS = {"bottom": (0.4, 2.4), "middle": (5.0, 12.0), "top": (16.0, 16.8)}


class Riser(Run):
    """A run. Masses in kg."""

    def __init__(self, case):
        super().__init__(case)
        self.name = self.case.resolve().name
        self._taps = {}
        if self.end - self.average_from > 1:
            self.window = (self.average_from, self.end)

    def read_inputs(self):
        super().read_inputs()
        self.read_parcels()
        self.rate = option(self.case, "massFlowRate",
                           "constant/parcelsProperties")
        molar_mass = option(self.case, "molWeight",
                            "constant/thermophysicalProperties")
        self.psi = molar_mass/(8314.47*TEMPERATURE)     # rho/p [s2/m2]

        # Of the box that the mesh is cut from: across and along the riser
        mesh = "system/blockMeshDict"
        self.cell_size = (0.832/option(self.case, "nx", mesh),
                          17.12/option(self.case, "nz", mesh))

    def read_series(self):
        super().read_series()
        self.mass = self.parcels["mass"]
        self.escaped = self.parcels["escapedMass"]
        self.fed = self.parcels["fedMass"]
        self.inlet_pressure = self.at_steps("inletPressure")
        self.outlet_pressure = self.at_steps("outletPressure")
        self.pressure_drop = self.inlet_pressure - self.outlet_pressure
        self.gas_in = (-self.at_steps("inletFlow")
                       - self.at_steps("sideInletFlow"))
        self.gas_out = self.at_steps("outletFlow")
        self.gas_mass = self.at_steps("gasMass")

    def gas_defect(self):
        """What of the gas has come from nowhere, over what has entered: steps
        are implicit, so that flows hold for the step before their time."""
        gained = self.gas_mass[-1] - self.gas_mass[0]
        flowed = ((self.gas_in - self.gas_out)*self.dt)[1:].sum()
        return abs(gained - flowed)/(self.gas_in*self.dt)[1:].sum()

    # Profiles that solidsProfiles has made

    def profile(self, name):
        """The columns of a profile by their names, of the last time written."""
        files = sorted(
            (self.case / "postProcessing" / "solidsProfiles").glob(
                f"*/{name}.dat"),
            key=lambda path: float(path.parent.name))
        if not files:
            return None
        return of.columns(files[-1])

    def part_fraction(self, part):
        """Mean solids fraction of a part of the height, and standard error, as
        if its bins erred together."""
        low, high = PARTS[part]
        height = self.profile("height")
        inside = ((height["coordinate"] > low)
                  & (height["coordinate"] < high))
        return (height["solidsFraction"][inside].mean(),
                height["solidsFractionError"][inside].mean())

    def fall(self, place, column):
        """From the axis to the wall, and standard error."""
        profile = self.profile(f"radial{place}")
        mean, error = profile[column], profile[column + "Error"]
        return mean[0] - mean[-1], np.hypot(error[0], error[-1])

    # The taps along the wall

    def _tap_table(self):
        """The columns of the taps' table by their names. There is none before
        means begin."""
        if not self._taps:
            self._taps = columns(self.case, "taps")
        return self._taps

    def tap_series(self, pair):
        """Times, and what a pair of taps has shown."""
        table = self._tap_table()
        return table["time"], table[pair]

    def tap_mean(self, pair):
        """Mean of a pair of taps over the window, and its standard error."""
        table = self._tap_table()
        return table[pair + "Mean"][-1], table[pair + "Error"][-1]

    def taps(self):
        """Heights, mean pressures over that at the exit, errors."""
        pairs = [name for name in self._tap_table()
                 if re.match(r"z[\d.]+$", name)]
        mean, error = np.transpose([self.tap_mean(pair) for pair in pairs])
        return np.array([float(pair[1:]) for pair in pairs]), mean, error

    def apparent_voidage(self):
        """Heights between the taps, and the voidage there if the pressure's
        slope were nothing but weight."""
        z, pressure, _ = self.taps()
        gas = self.psi*(OUTLET_PRESSURE + 0.5*(pressure[1:] + pressure[:-1]))
        slope = -np.diff(pressure)/np.diff(z)/self.g
        return (0.5*(z[1:] + z[:-1]),
                1 - (slope - gas)/(self.density - gas))

    # Mean fields of the last time written

    def last(self):
        return self.frames[-1]

    def field(self, name):
        return np.asarray(of.field(self.case, self.last(), name))

    def has_means(self):
        return self.window is not None and bool(
            list((self.case / self.last()).glob("solidsAverages:*")))

    def due(self):
        """Solids that were to be fed since the start [kg]."""
        return number(self.case / self.last()
                      / "uniform/lagrangian/parcels/flows", "due")

    def scatter(self):
        """Standard error of a cell's mean solids fraction over that mean, in
        the median cell of those that have a tenth of the riser's mean."""
        mean = self.field("solidsAverages:fractionMean")
        error = self.field("solidsAverages:fractionMeanError")
        some = mean > 0.1*np.average(mean, weights=self.field("V"))
        return np.median(error[some]/mean[some])

    def section_rate(self, height, thickness=0.32):
        """Mean upward solids flow through a section [kg/s]: the momentum in
        the layers of cells about it, over their thickness."""
        layer_height = self.cell_size[1]
        layer = np.floor(self.field("C")[:, 2]/layer_height)
        inside = abs((layer + 0.5)*layer_height - height) < 0.5*thickness
        slab = np.unique(layer[inside]).size*layer_height
        flux = self.field("solidsAverages:massFluxMean")[:, 2]
        return (flux*self.field("V"))[inside].sum()/slab

    def residence_time(self):
        return self.mean(self.mass)[0]/self.rate

    def long_enough(self):
        """Is what means say to be certain? Over two residence times it is."""
        start, end = self.window
        return end - start > 2*self.residence_time()

    # What the pressure drop is made of

    def weight_drop(self):
        """Weight of the solids and the gas in the riser over its area, and its
        error [Pa]. What is in the side pipes, by their share of the mean, lies
        on their floors."""
        mean, error = self.mean(self.mass + self.gas_mass)
        share = self.share_in_riser()
        return share*mean*self.g/AREA, share*error*self.g/AREA

    def share_in_riser(self):
        """Of the solids, in the mean."""
        centre = self.field("C")
        mass = self.field("solidsAverages:densityMean")*self.field("V")
        inside = np.hypot(centre[:, 0], centre[:, 1]) < RADIUS
        return mass[inside].sum()/mass.sum()

    def momentum_drop(self):
        """Momentum that the solids carry up the middle of the riser, and leave
        at its top [Pa]."""
        height = self.profile("height")
        low, high = PARTS["middle"]
        inside = ((height["coordinate"] > low)
                  & (height["coordinate"] < high))
        return (height["massFluxZ"]*height["velocityZ"])[inside].mean()
