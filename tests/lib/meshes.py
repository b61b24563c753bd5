# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Meshes of a box that are not made of regular hexahedra, for the cases of
#     cghsCase. All of the boundary is the patch walls; and a wedge. Needs
#     OpenFOAM's gmshToFoam, topoSet and createBaffles.
# ------------------------------------------------------------------------------
"""Meshes of hexahedra, prisms, tetrahedra and polyhedra; thin walls in them."""

import shutil

import numpy as np

from cghsCase import COMMON

# Corners of a cell, and how it is cut, so that neighbours' faces fit
TETS = [(0, a, a + b, 7) for a in (1, 2, 4) for b in (1, 2, 4) if a != b]
PRISMS = [(0, 1, 3, 4, 5, 7), (0, 3, 2, 4, 7, 6)]
HEXES = [(0, 1, 3, 2, 4, 5, 7, 6)]
GMSH_TYPE = {4: 4, 6: 6, 8: 5}

HEAD = ("FoamFile {{ version 2.0; format ascii; class dictionary;"
        " object {}; }}\n")


def displaced(size, cells, shift, seed=1):
    """Points of a box of cells, the inner ones displaced by up to a share of a
    cell."""
    n = np.array(cells) + 1
    index = np.stack(np.meshgrid(*[np.arange(k) for k in n], indexing="ij"), -1)
    inner = (index > 0) & (index < n - 1)
    random = np.random.default_rng(seed).uniform(-shift, shift, index.shape)
    return (index + inner*random)*np.array(size)/cells


def pieces(case, size, cells, cuts, shift=0.12):
    """A mesh of such pieces of the cells."""
    x = displaced(size, cells, shift)
    n = np.array(cells) + 1
    number = np.arange(n.prod()).reshape(n) + 1
    elements = []
    for i, j, k in np.ndindex(*cells):
        corners = [number[i + (c & 1), j + (c >> 1 & 1), k + (c >> 2 & 1)]
                   for c in range(8)]
        for cut in cuts:
            piece = [corners[c] for c in cut]
            if len(piece) == 4:
                a, b, c, d = (x.reshape(-1, 3)[p - 1] for p in piece)
                if np.dot(np.cross(b - a, c - a), d - a) < 0:
                    piece[1], piece[2] = piece[2], piece[1]
            elements.append(piece)
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes",
             str(number.size)]
    lines += [f"{i + 1} {p[0]:.17g} {p[1]:.17g} {p[2]:.17g}"
              for i, p in enumerate(x.reshape(-1, 3))]
    lines += ["$EndNodes", "$Elements", str(len(elements))]
    lines += [f"{i + 1} {GMSH_TYPE[len(e)]} 2 1 1 " + " ".join(map(str, e))
              for i, e in enumerate(elements)]
    (case.folder/"mesh.msh").write_text("\n".join([*lines, "$EndElements", ""]))
    case.run("gmshToFoam", "mesh.msh")
    boundary = case.folder/"constant/polyMesh/boundary"
    boundary.write_text(boundary.read_text().replace("defaultFaces", "walls")
                        .replace("type            patch", "type wall"))


def polyhedra(case, size, cells):
    """The dual of tetrahedra."""
    pieces(case, size, cells, TETS)
    case.run("polyDualMesh", "60", "-overwrite")


WEDGE = """
vertices ((0 0 0) (1 0 0) (1 RC -RS) (0 RC -RS) (0 RC RS) (1 RC RS));
blocks (hex (0 1 2 3 0 1 5 4) (CELLS 1) simpleGrading (1 1 1));
boundary
(
    xMin { type wall; faces ((0 4 3 0)); }
    xMax { type wall; faces ((1 2 5 1)); }
    yMax { type wall; faces ((3 4 5 2)); }
    zMin { type wedge; faces ((0 3 2 1)); }
    zMax { type wedge; faces ((0 1 5 4)); }
    axis { type empty; faces ((0 1 1 0)); }
);
"""


def wedge(case, cells):
    """Of 5 degrees about the x axis, 1 m long and wide, in so many cells along
    and across it."""
    angle = np.radians(2.5)
    (case.folder/"system/blockMeshDict").write_text(
        HEAD.format("blockMeshDict")
        + WEDGE.replace("RC", f"{np.cos(angle):.15g}")
        .replace("RS", f"{np.sin(angle):.15g}")
        .replace("CELLS", f"{cells[0]} {cells[1]}"))
    case.run("blockMesh")


def _sets(*actions):
    return HEAD.format("topoSetDict") + "actions (" + "".join(
        f"{{ name {name}; type {kind}; action {action}; source {source};"
        f" {entries} }}" for name, kind, action, source, entries in actions) + ");"


def in_box(low, high):
    """Faces whose centres are in a box."""
    low, high = (" ".join(map(str, x)) for x in (low, high))
    return [("b", "faceSet", "new", "boxToFace", f"box ({low}) ({high});")]


def between(height):
    """Faces between cells whose centres are below a height and those above."""
    below, above = f"box (-1 -1 -1) (1 {height} 1);", f"box (-1 {height} -1) (1 1 1);"
    return [("low", "cellSet", "new", "boxToCell", below),
            ("high", "cellSet", "new", "boxToCell", above),
            ("b", "faceSet", "new", "cellToFace", "set low; option all;"),
            ("b", "faceSet", "subset", "cellToFace", "set high; option all;")]


def baffles(case, faces, patches, fields=("U", "p", "T"), overlay="case"):
    """Make these inner faces a pair of patches: (name, entries) of the side of the
    owner and of the neighbour. Fields are taken anew from an overlay."""
    (case.folder/"system/topoSetDict").write_text(_sets(
        *faces, ("b", "faceZoneSet", "new", "setToFaceZone", "faceSet b;")))
    sides = "".join(f"{side} {{ name {name}; {entries} }}" for side, (name, entries)
                    in zip(("master", "slave"), patches))
    (case.folder/"system/createBafflesDict").write_text(
        HEAD.format("createBafflesDict") + "internalFacesOnly true; baffles { b {"
        f" type faceZone; zoneName b; patches {{ {sides} }} }} }}")
    case.run("topoSet")
    case.run("createBaffles", "-overwrite")
    for field in fields:
        shutil.copy(COMMON/overlay/"0"/field, case.folder/"0"/field)
