# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
# ------------------------------------------------------------------------------
"""The damping of softSphere's springs, which do not pull."""

import numpy as np

from roots import root


def damping_ratio(e):
    """eta/(2 sqrt(k m)) at which spheres that part when no force is left have
    the restitution e, from exp(-2) to 1: e = exp(-2 x atan(1/x)) with
    x = zeta/sqrt(1 - zeta^2)."""
    x = root(lambda x: np.exp(-2*x*np.arctan2(1, x)) - e, 0, 1e3)
    return x/np.hypot(1, x)
