# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
# ------------------------------------------------------------------------------
"""Writing the files of OpenFOAM's clouds, so that the same parcels can be
given to cghsFoam, DPMFoam and MPPICFoam."""

from pathlib import Path

import numpy as np

HEADER = """FoamFile
{{
    version     2.0;
    format      ascii;
    class       {};
    object      {};
}}

"""


def text_of(value):
    """A number or a vector as OpenFOAM reads it."""
    if np.ndim(value):
        return "(" + " ".join(f"{x:.15g}" for x in value) + ")"
    return f"{value:.15g}"


def write_field(folder, name, kind, values, n):
    """A field of n entries: an array, one value for all, or, as a text, what
    OpenFOAM is to read for each."""
    if isinstance(values, str):
        body = f"{n}{{{values}}}\n"
    elif np.ndim(values) == 0 or len(values) != n:
        body = f"{n}{{{text_of(values)}}}\n"
    else:
        body = f"{n}\n(\n" + "\n".join(map(text_of, values)) + "\n)\n"
    (Path(folder) / name).write_text(HEADER.format(kind, name) + body)


def write_positions(folder, kind, x, cells):
    """kind: the class of the particles, e.g. passiveParticle. OpenFOAM looks
    for positions, and not for coordinates, only where it is told to."""
    folder = Path(folder)
    told = folder.parents[1] / "uniform" / "lagrangian" / folder.name
    told.mkdir(parents=True, exist_ok=True)
    (told / "cloudProperties").write_text(
        HEADER.format("dictionary", "cloudProperties")
        + "geometry    positions;\n"
    )

    rows = "\n".join(f"{text_of(p)} {c}" for p, c in zip(x, cells))
    (folder / "positions").write_text(
        HEADER.format(f"Cloud<{kind}>", "positions")
        + f"{len(x)}\n(\n{rows}\n)\n"
    )


def write_ids(folder, n):
    write_field(folder, "origId", "labelField", np.arange(n), n)
    write_field(folder, "origProcId", "labelField", 0, n)


class Block:
    """The cells of one blockMesh block of equal cells along x, y, z."""

    def __init__(self, low, high, cells):
        self.low = np.asarray(low, float)
        self.cells = np.asarray(cells)
        self.width = (np.asarray(high, float) - self.low) / self.cells

    def cell(self, x):
        """Index of the cell that each point is in, or is nearest to."""
        i = np.floor((x - self.low) / self.width).astype(int)
        i = np.clip(i, 0, self.cells - 1)
        return i[:, 0] + self.cells[0] * (i[:, 1] + self.cells[1] * i[:, 2])


def write_parcels(folder, block, x, v, diameter, density, weight=1.0):
    """Parcels for cghsFoam."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    n = len(x)
    write_positions(folder, "passiveParticle", x, block.cell(x))
    write_ids(folder, n)
    write_field(folder, "position", "vectorField", x, n)
    write_field(folder, "U", "vectorField", v, n)
    write_field(folder, "d", "scalarField", diameter, n)
    write_field(folder, "rho", "scalarField", density, n)
    write_field(folder, "nParticle", "scalarField", weight, n)
