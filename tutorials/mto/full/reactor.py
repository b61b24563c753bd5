# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What a run of the whole reactor has left, beyond what those of mto/common
#     have: the one place from which both evaluate and validate take it.
# ------------------------------------------------------------------------------
"""The whole reactor in three dimensions."""

import sys
from pathlib import Path

PROJECT = next((folder for folder in Path(__file__).resolve().parents
                if (folder / "etc" / "openfoam").exists()), None)
if PROJECT is None:
    sys.exit(f"{Path(__file__).parent} is not within a cghsFoam")
sys.path += [str(PROJECT / "tutorials" / folder)
             for folder in ("lib", "mto/common")]
from lowerEnd import TUBE_END, TUBE_RADIUS  # noqa: E402, F401
from mtoRun import (  # noqa: E402, F401
    AREA, BED_HEIGHT, CATALYST, INVENTORY, RADIUS, RENEWED, Reactor)
from tutorial import columns, np, of, ratio_of, seconds  # noqa: E402, F401

# [m], as the script vessel has them
WIDE_RADIUS, CONE, HEIGHT = 0.225, (1.02, 1.2), 2.04
PIPE_RADIUS, PIPE_HEIGHT, PIPE_END = 0.03, 0.61, 0.15


def radius(z):
    """Of the vessel at the heights [m]."""
    return np.interp(z, CONE, (RADIUS, WIDE_RADIUS))


class WholeReactor(Reactor):
    """A run. Masses in kg."""

    def read_series(self):
        super().read_series()
        self.gas_in = self.feed + self.steam
        self.gas_out = self.at_steps("outletFlow")
        self.gas_mass = self.at_steps("gasMass")

    def surface(self):
        """Height below which 95 % of the solids are [m]."""
        return super().surface(radius)

    def has_means(self):
        return self.window is not None and self.profile("height") is not None

    def share_above(self, height):
        """Of the solids."""
        profile = self.profile("height")
        z = profile["coordinate"]
        held = profile["solidsFraction"]*radius(z)**2
        return held[z > height].sum()/held.sum()

    def lost(self):
        """What has left at the top, from the start on [kg]."""
        rows = columns(self.case, "lost")
        return rows["outflow(gasOutlet)Mean"][-1]*rows["time"][-1]

    def discharge(self):
        """Catalyst that leaves by the tube in the window, and its standard
        error [kg/s]."""
        return self.rate_of(self.escaped)

    # Of the gas that leaves: means from where that of the start has left

    def has_products(self):
        return self.window is not None and self.end > 1.25*RENEWED

    def converted(self):
        """Of the methanol that enters, and the error of that [-]."""
        rows = columns(self.case, "balance")
        inside = rows["time"] > self.late()
        left, error = ratio_of(rows["out(MeOH)"][inside],
                               rows["in(MeOH)"][inside])
        return 1 - left, error

    def gas_step(self):
        """Mean [s]."""
        return float(np.mean(self.dt[1:]))

    def solids_steps(self):
        """In a step of the gas, mean."""
        return float(self.parcels["nSolidsSteps"][1:].mean())
