# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What a run of the riser has left, as numbers: the one place from which both
#     evaluate (page of results) and validate (checks) take them.
# ------------------------------------------------------------------------------
"""The riser: its inputs, its series in time, its means with errors."""

import sys
from pathlib import Path

PROJECT = next((folder for folder in Path(__file__).resolve().parents
                if (folder / "etc" / "openfoam").exists()), None)
if PROJECT is None:
    sys.exit(f"{Path(__file__).parent} is not within a cghsFoam")
sys.path.append(str(PROJECT / "tutorials" / "lib"))
from fedRun import FedRun  # noqa: E402
from tutorial import np, of, option, ranks, seconds  # noqa: E402

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


class Riser(FedRun):
    """A run. Masses in kg."""

    least_window = 1

    def __init__(self, case):
        super().__init__(case)
        self.name = self.case.resolve().name

    def read_inputs(self):
        super().read_inputs()
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
        self.gas_in = (-self.at_steps("inletFlow")
                       - self.at_steps("sideInletFlow"))
        self.gas_out = self.at_steps("outletFlow")
        self.gas_mass = self.at_steps("gasMass")

    # Profiles that solidsProfiles has made

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

    def apparent_voidage(self):
        """Heights between the taps, and the voidage there if the pressure's
        slope were nothing but weight."""
        z, pressure, _ = self.taps()
        gas = self.psi*(OUTLET_PRESSURE + 0.5*(pressure[1:] + pressure[:-1]))
        slope = -np.diff(pressure)/np.diff(z)/self.g
        return (0.5*(z[1:] + z[:-1]),
                1 - (slope - gas)/(self.density - gas))

    # Mean fields of the last time written

    def has_means(self):
        return self.window is not None and bool(
            list((self.case / self.last()).glob("solidsAverages:*")))

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
