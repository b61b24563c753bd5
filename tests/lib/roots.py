# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
# ------------------------------------------------------------------------------
"""Where a function is zero."""


def root(f, low, high):
    """Of a function that rises or falls from low to high: by halving, to
    round-off."""
    rises = f(high) > f(low)
    for _ in range(200):
        middle = 0.5*(low + high)
        low, high = (low, middle) if (f(middle) > 0) == rises else (
            middle, high)
    return 0.5*(low + high)
