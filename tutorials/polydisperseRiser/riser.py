# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What a run of the polydisperse riser has left, as numbers: the one place
#     from which evaluate, validate and the test take them.
# ------------------------------------------------------------------------------
"""The riser's slice: solids in it, fed and gone; sizes and velocities."""

import sys
from pathlib import Path

PROJECT = next((folder for folder in Path(__file__).resolve().parents
                if (folder / "etc" / "openfoam").exists()), None)
if PROJECT is None:
    sys.exit(f"{Path(__file__).parent} is not within a cghsFoam")
sys.path.append(str(PROJECT / "tutorials" / "lib"))
from gasColumn import GasColumn  # noqa: E402
from tutorial import (  # noqa: E402
    BLOCKS, columns, mean_of, np, number, of, ratio_of, seconds,
)

CLASSES = 5    # of size, from the smallest to the largest
LEVELS = 15    # of height
BLOCK = 0.8e-3  # [m]


class Riser(GasColumn):
    """A run."""

    def __init__(self, case):
        super().__init__(case)
        self.window = (self.average_from, self.end)
        self._read_parcels()

    def read_inputs(self):
        super().read_inputs()
        constant = self.case / "constant"
        parcels = constant / "parcelsProperties"
        self.feed = number(parcels, "massFlowRate")
        self.feed_speed = number(parcels, "speed")
        self.smallest = number(constant / "sizes", "minValue")
        self.largest = number(constant / "sizes", "maxValue")
        self.gas_viscosity = self.gas_density * number(
            constant / "transportProperties", "nu")
        self.volume = self.size.prod()

    def read_series(self):
        super().read_series()
        self.inventory = columns(self.case, "inventory")
        self.weight = self.parcels["mass"] * self.g / self.area

    def carried_pressure(self):
        """The part with which the solids leave faster than they are fed."""
        return self.feed / self.area * (
            np.mean(self.leaving) - self.feed_speed)

    # The particles at the times that were written

    def _read_parcels(self):
        self.last = self.frames[-1]
        self.frames = [
            t for t in self.frames if float(t) > self.average_from + 1e-9]
        self.averaged = len(self.frames) >= 2 * max(BLOCKS)

        edges = np.linspace(self.smallest, self.largest, CLASSES + 1)
        levels = np.linspace(0, self.size[1], LEVELS + 1)
        self.class_middle = 0.5 * (edges[1:] + edges[:-1])
        self.level_middle = 0.5 * (levels[1:] + levels[:-1])

        # Of each frame: how many are in each class, and their summed velocity;
        # how many on each level, and sums of their diameters
        count, velocity, many, first, second, third = [], [], [], [], [], []
        self.crowding, self.leaving = [], []
        for time in self.frames:
            x, d, v = self.snapshot(time)
            count.append(np.histogram(d, edges)[0])
            velocity.append(np.histogram(d, edges, weights=v[:, 1])[0])
            for values, power in ((many, 0), (first, 1), (second, 2),
                                  (third, 3)):
                values.append(np.histogram(x[:, 1], levels, weights=d**power)[0])
            self.crowding.append(self._crowding(x))
            top = x[:, 1] > levels[-2]
            self.leaving.append(np.average(v[top, 1], weights=d[top]**3))
        self.count, self.velocity = np.array(count), np.array(velocity)
        self.many, self.first = np.array(many), np.array(first)
        self.second, self.third = np.array(second), np.array(third)

    def snapshot(self, time):
        """Places, diameters and velocities of all particles at a time."""
        return (of.positions(self.case, time, "parcels"),
                of.cloud_field(self.case, time, "parcels", "dParcel"),
                of.cloud_field(self.case, time, "parcels", "U"))

    def _crowding(self, x):
        """Variance over mean of the number of particles in squares of about
        BLOCK, on each level: 1 where they are strewn at random, more where they
        cluster."""
        across = round(self.size[0] / BLOCK)
        up = round(self.size[1] / LEVELS / BLOCK)
        counts = np.histogram2d(
            x[:, 0], x[:, 1], bins=(across, LEVELS * up),
            range=((0, self.size[0]), (0, self.size[1])))[0]
        counts = counts.reshape(across, LEVELS, up)
        return counts.var(axis=(0, 2)) / counts.mean(axis=(0, 2))

    # Means over the frames, and their standard errors

    def class_velocity(self):
        """Mean upward velocity of the particles of each class."""
        return ratio_of(self.velocity, self.count)

    def class_flux(self):
        """Particles of each class that pass a height in a second."""
        mean, error = mean_of(self.velocity)
        return mean / self.size[1], error / self.size[1]

    # What is fed, as many of each size

    def mass_of(self, d):
        return np.pi / 6 * self.density * d**3

    def _fed_moment(self, power):
        a, b, n = self.smallest, self.largest, power + 1
        return (b**n - a**n) / (n * (b - a))

    def fed_flux(self):
        """Particles of each class that are fed in a second."""
        mass = np.pi / 6 * self.density * self._fed_moment(3)
        return self.feed / mass / CLASSES

    def fed_mean(self):
        return self._fed_moment(1)

    def fed_sauter(self):
        return self._fed_moment(3) / self._fed_moment(2)

    # The gas

    def gas_between(self):
        """Mean velocity of the gas between the particles, if it were even."""
        mass, _ = self.mean(self.parcels["mass"])
        fraction = mass / self.density / self.volume
        return float(np.mean(self.inflow)) / (1 - fraction)

    def terminal_velocity(self):
        """Of one particle alone, in the middle of each class: drag of Schiller
        and Naumann."""
        d = self.class_middle
        stokes = (self.density - self.gas_density) * self.g * d**2 \
            / (18 * self.gas_viscosity)
        u = stokes
        for _ in range(50):
            re = self.gas_density * u * d / self.gas_viscosity
            u = stokes / (1 + 0.15 * re**0.687)
        return u

    def mean_diameter(self):
        """By number, on each level."""
        return ratio_of(self.first, self.many)

    def sauter_diameter(self):
        return ratio_of(self.third, self.second)

    def fraction(self):
        """Solids volume fraction on each level."""
        mean, error = mean_of(np.pi / 6 * self.third)
        volume = self.volume / LEVELS
        return mean / volume, error / volume

    def number_on_levels(self):
        return mean_of(self.many)

    # Balance

    def solids_balance(self):
        """Mass at the start, fed since, gone since, and there at the end [kg]."""
        _, d, _ = self.snapshot("0")
        start = self.mass_of(d).sum()
        fed = of.log_values(self.case / "log.cghsFoam", "parcels now,")[-1]
        return (start, fed, self.parcels["escapedMass"][-1],
                self.parcels["mass"][-1])
