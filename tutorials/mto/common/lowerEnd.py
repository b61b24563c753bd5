# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     The floor of the reactor, its distributor, and the top of the lift tube in
#     its middle, as a part of surfaces of tutorials/lib/surface.py.
# ------------------------------------------------------------------------------
"""Where the gas comes in and the catalyst leaves."""

from surface import disc, ring, strip

RADIUS = 0.1305                     # [m] of the reaction section
TUBE_RADIUS, TUBE_END = 0.03, -0.06


def lower_end():
    """Triangles by the names of the patches."""
    return {
        "gasInlet": strip(ring(RADIUS, 0), ring(TUBE_RADIUS, 0)),
        "tubeWalls": strip(ring(TUBE_RADIUS, TUBE_END), ring(TUBE_RADIUS, 0)),
        "catalystOutlet": disc(TUBE_RADIUS, TUBE_END),
    }
