# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What a run of the jet has left, as numbers: the one place from which
#     evaluate (page of results), validate (checks) and the test take them.
# ------------------------------------------------------------------------------
"""The round jet: its fluxes along x, its decay, its spreading, its profiles."""

import re
import sys
from pathlib import Path

PROJECT = next((folder for folder in Path(__file__).resolve().parents
                if (folder / "etc" / "openfoam").exists()), None)
if PROJECT is None:
    sys.exit(f"{Path(__file__).parent} is not within a cghsFoam")
sys.path.append(str(PROJECT / "tutorials" / "lib"))
from tutorial import np, number, of, seconds, series  # noqa: E402

# Where the jet is taken to be like itself, in d: the potential core is five
# long, and the outlet is at thirty
SIMILAR = (12, 25)

SECTION = 20  # [d] side of the box


class Jet:
    """A run of one variant, in its mean over time. Lengths in nozzle diameters
    d, velocities in that of the nozzle u0, fluxes in those of the nozzle."""

    def __init__(self, case):
        self.case = Path(case)
        self._read_inputs()
        self._read_flows()
        self._read_fields()
        self._find_fluxes()
        self._find_shape()

    # Inputs, from the case's own dictionaries

    def _read_inputs(self):
        options = self.case / "system" / "runOptions"
        mesh = self.case / "system" / "blockMeshDict"
        velocity = re.search(r"referenceField\s+uniform \((\S+) 0 0\)",
                             (self.case / "0" / "U").read_text())

        self.turbulent = "RAS" in options.read_text()
        self.d = number(mesh, "scale")
        self.u0 = float(velocity[1])
        self.nu = number(self.case / "constant" / "transportProperties", "nu")
        self.reynolds = self.u0 * self.d / self.nu
        self.n_layers = int(number(options, "length", number(mesh, "length")))
        self.n_around = 4*int(number(options, "core", number(mesh, "core")))
        self.start = number(options, "averageFrom")
        self.end = number(options, "endTime")
        self.ranks = int(number(options, "ranks"))

    # Series in time

    def _read_flows(self):
        def flow(patch):
            return series(self.case, f"{patch}Flow")[:, 1]

        nozzle = self.case / "postProcessing/nozzleFlow/0/surfaceFieldValue.dat"
        area = float(re.search(r"# Area\s*:\s*(\S+)", nozzle.read_text())[1])
        self.nozzle_area = area / self.d**2

        self.flow_in = -flow("nozzle") / (self.u0 * area)
        self.net_flow = sum(
            flow(patch) for patch in ("nozzle", "surroundings", "outlet")
        ) / (self.u0 * area)

    def clock(self):
        """Wall-clock time of the solver [s]."""
        return seconds(self.case)

    def steps(self):
        return of.log_values(self.case / "log.cghsFoam", "ExecutionTime").size

    # Fields: one row a layer of cells across the jet

    def _read_fields(self):
        time = of.times(self.case)[-1]

        # Along the jet the cells of a block count fastest
        def layers(name):
            values = of.field(self.case, time, name)
            values = values.reshape(-1, self.n_layers, *values.shape[1:])
            return values.swapaxes(0, 1)

        volume = layers("V") / self.d**3
        centre = layers("C") / self.d
        self.x = (volume * centre[..., 0]).sum(axis=1) / volume.sum(axis=1)
        self.centre = centre
        self.r = np.hypot(centre[..., 1], centre[..., 2])
        self.thickness = volume.sum(axis=1) / SECTION**2
        self.area = volume / self.thickness[:, None]
        self.cells = volume.size
        self.resolved = self.n_around >= 24

        self.u = layers("UMean")[..., 0] / self.u0
        self.speed = np.linalg.norm(layers("U"), axis=-1) / self.u0

        # Of the eddies that are followed: u'u' - (v'v' + w'w')/2, what they and
        # the pressure that balances them carry along x. Modelled eddies, taken
        # as isotropic, carry nothing.
        stress = layers("UPrime2Mean") / self.u0**2
        self.stress = stress[..., 0] - 0.5*(stress[..., 3] + stress[..., 5])

    def _find_fluxes(self):
        def over_section(values):
            return (values * self.area).sum(axis=1) / self.nozzle_area

        self.mass = over_section(np.maximum(self.u, 0))
        self.momentum = over_section(self.u**2)
        self.momentum_all = over_section(self.u**2 + self.stress)

    # Shape

    def _find_shape(self):
        """Velocity on the axis and radius where it is halved, from Gaussians
        laid through the cells about the axis and about that radius."""
        self.axis = np.empty(self.n_layers)
        self.half = np.full(self.n_layers, np.nan)

        for i, (r, u) in enumerate(zip(self.r, self.u)):
            near = r < np.sort(r)[16]
            self.axis[i] = np.exp(np.polyfit(r[near]**2, np.log(u[near]), 1)[1])
            share = u / self.axis[i]
            about = (share > 0.3) & (share < 0.7)
            if about.sum() > 5:
                slope, level = np.polyfit(r[about]**2, np.log(share[about]), 1)
                self.half[i] = np.sqrt(max((-np.log(2) - level) / slope, 0))

        similar = (self.x > SIMILAR[0]) & (self.x < SIMILAR[1])
        slope, level = np.polyfit(self.x[similar], 1/self.axis[similar], 1)
        self.decay = 1/slope                # B in u_c/u0 = B d/(x - x0)
        self.origin = -level/slope          # x0
        self.spreading, _ = np.polyfit(self.x[similar], self.half[similar], 1)
        self.similar = similar

    def slice(self, values):
        """x, y and values of the cells beside the plane z = 0."""
        x, y, z = np.moveaxis(self.centre, -1, 0)
        row = np.abs(z).min(axis=1, keepdims=True)
        sector = np.pi/self.n_around
        beside = ((np.abs(z) < 1.01*row)
                  | (np.abs(z) < np.tan(2*sector)*np.abs(y)))
        return x[beside], y[beside], values[beside]

    def profile(self, x):
        """u/u_c over r/r_half, about the axis, in the layer nearest to x."""
        i = np.argmin(abs(self.x - x))
        order = np.argsort(self.r[i])
        return (self.r[i][order] / self.half[i],
                self.u[i][order] / self.axis[i])

    def profile_on(self, eta, x):
        """The same on given radii: means over rings of cells."""
        radius, share = self.profile(x)
        edges = np.append(eta - 0.5*(eta[1] - eta[0]),
                          eta[-1] + 0.5*(eta[1] - eta[0]))
        count, _ = np.histogram(radius, edges)
        total, _ = np.histogram(radius, edges, weights=share)
        where = np.histogram(radius, edges, weights=radius)[0]
        full = count > 0
        return np.interp(eta, where[full]/count[full], total[full]/count[full])

    def similarity_error(self, stations=(15, 20, 25)):
        """Largest difference of the profiles at the stations."""
        eta = np.arange(0.2, 1.81, 0.4)
        profiles = [self.profile_on(eta, x) for x in stations]
        return np.ptp(profiles, axis=0).max()

    def entrainment(self):
        """d(m/m0)/d(x/d) where the jet is like itself."""
        return np.polyfit(self.x[self.similar], self.mass[self.similar], 1)[0]
