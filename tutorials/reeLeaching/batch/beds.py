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
    AMMONIUM, CATIONS, LIQUID, M_NH4, M_REE, RARE_EARTH, Leaching, leached, np,
    of, rate, stop)

AREA, SPEED = 0.08**2, 0.004            # of the floor, superficial [m2, m/s]
NAMES = [f"d{d}W{W}" for d in (45, 60) for W in (250, 500, 1000)]


class Bed(Leaching):
    """A run."""

    def fully(self):
        """Eq 103 at the times of the run, in the liquid that comes in."""
        time, found = self.leached_there()
        return time, found, leached(rate(self.diameter)*time)

    def scarcest(self):
        """The ammonium of the bed over that of the fresh liquid, the mean of
        the run if all the liquid had what leaves in a steady state: what the
        ore takes up is missing in what flows past."""
        taken = (CATIONS*M_NH4/M_REE*RARE_EARTH*self.mass[0]
                 * self.leached_there()[1][-1]/self.end)
        return 1 - taken/(AMMONIUM*LIQUID*SPEED*AREA)


def beds_in(folder):
    """Those that there are."""
    beds = {name: Bed(Path(folder)/name) for name in NAMES
            if (Path(folder)/name/"log.cghsFoam").exists()}
    if not beds:
        stop(f"{folder} has no run: run ./Allrun first")
    return beds
