# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     The runs of the batch beds, and Eq 103 beside them: for evaluate, validate
#     and the test.
# ------------------------------------------------------------------------------
"""Ore leached in a fluidised bed, by diameter and weight of the parcels."""

import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.append(str(Path(__file__).resolve().parents[1]))
from leaching import (  # noqa: E402
    Leaching, leached, np, of, rate, stop)

NAMES = [f"d{d}W{W}" for d in (45, 60) for W in (250, 500, 1000)]


class Bed(Leaching):
    """A run."""

    def fully(self):
        """Eq 103 at the times of the run, in the liquid that comes in."""
        time, found = self.leached_there()
        return time, found, leached(rate(self.diameter)*time)

    def in_poorest(self):
        """The same in the liquid of the cell that has least ammonium at a
        time: none of the ore has seen less."""
        steps, least = self.least_ammonium()
        seen = np.cumsum(least*np.diff(steps, prepend=0))
        return leached(rate(self.diameter)*np.interp(
            self.leached_there()[0], steps, seen))

    def scarcest(self):
        """The least ammonium of the run over that of the fresh liquid."""
        return self.least_ammonium()[1].min()


def beds_in(folder):
    """Those that there are."""
    beds = {name: Bed(Path(folder)/name) for name in NAMES
            if (Path(folder)/name/"log.cghsFoam").exists()}
    if not beds:
        stop(f"{folder} has no run: run ./Allrun first")
    return beds
