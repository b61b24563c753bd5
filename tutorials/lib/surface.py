# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What the surfaces of the tutorials' vessels are made of, for snappyHexMesh:
#     rows of points, triangles between them, pipes that are set in the side of a
#     cylinder, and an ASCII STL with a solid for each patch. Vessels stand on
#     z = 0 about the z axis; lengths in m.
#
#     A script that makes such a surface ends with
#
#         if __name__ == "__main__":
#             main(surfaces)
#
#     where surfaces() gives the triangles by the names of the patches.
# ------------------------------------------------------------------------------
"""Closed surfaces of vessels, as STL."""

import sys
from collections import namedtuple
from math import pi
from pathlib import Path

try:
    import numpy as np
except ImportError:
    sys.exit(f"{Path(sys.argv[0]).name}: python3 has no numpy; remedy: "
             "apt-get install python3-numpy")

# Circles are divided into steps of 5 degrees
STEPS = 72


# Rows of points, along the first index


def around(first=0, last=STEPS):
    """Angles of the steps."""
    return np.arange(first, last + 1)*2*pi/STEPS


def on_circle(radius, angle, z):
    return np.stack([radius*np.cos(angle), radius*np.sin(angle),
                     np.full(np.shape(angle), z)], axis=-1)


def ring(radius, z):
    """The whole circle."""
    return on_circle(radius, around(), z)


# Triangles


def strip(one, other):
    """Between two rows of as many points."""
    a, b, c, d = one[:-1], one[1:], other[1:], other[:-1]
    return [*np.stack([a, b, c], 1), *np.stack([a, c, d], 1)]


def fan(row, centre):
    apex = np.broadcast_to(centre, row[1:].shape)
    return list(np.stack([row[:-1], row[1:], apex], 1))


def disc(radius, z):
    return fan(ring(radius, z), [0, 0, z])


# A level pipe: wall and mouth are patches, side is that of the x axis; end is
# that of the pipe, from the vessel's axis
Pipe = namedtuple("Pipe", "wall mouth radius height end side", defaults=(1,))


class PipedWall:
    """The cylinder that pipes are set in. Each has a window in it, that reaches
    window steps to each side of the pipe's axis and reach up and down; what of a
    pipe lies within the cylinder is left out, so that the surface is closed and
    has an edge along each mouth."""

    def __init__(self, patch, radius, window, reach, rows=16):
        self.patch = patch
        self.radius = radius
        self.window = window
        self.reach = reach
        self.rows = rows

    def heights(self, pipe):
        """Of the rows of points at its window."""
        return pipe.height + np.linspace(-self.reach, self.reach,
                                         self.rows + 1)

    def beside(self, pipe):
        """Angles from one edge of its window around to the other."""
        start = 0 if pipe.side > 0 else pi
        return start + around(self.window, STEPS - self.window)

    def _edge(self, pipe):
        """Angle, from the pipe's side, and height of the points around its
        window."""
        across = around(-self.window, self.window)
        up = self.heights(pipe)
        left, right = (np.full(up.size, across[i]) for i in (0, -1))
        low, high = (np.full(across.size, up[i]) for i in (0, -1))
        angle = [across[:-1], right[:-1], across[:0:-1], left]
        z = [low[:-1], up[:-1], high[:-1], up[::-1]]
        return np.concatenate(angle), np.concatenate(z)

    def _mouth(self, pipe, angle, z):
        """Where the pipe meets the cylinder, in the directions of the
        points."""
        turn = np.arctan2(z - pipe.height,
                          angle*self.reach*STEPS/(2*pi*self.window))
        y = pipe.radius*np.cos(turn)
        return np.stack([np.sqrt(self.radius**2 - y**2), y,
                         pipe.height + pipe.radius*np.sin(turn)], axis=-1)

    def pipe_surfaces(self, pipe):
        """Of the wall between the mouth and the edge of the window, and of the
        pipe."""
        angle, z = self._edge(pipe)
        inner = self._mouth(pipe, angle, z)
        outer = on_circle(self.radius, angle, z)
        end = inner.copy()
        end[:, 0] = pipe.end
        turned = np.array([pipe.side, pipe.side, 1])
        inner, outer, end = inner*turned, outer*turned, end*turned
        return {
            self.patch: strip(inner, outer),
            pipe.wall: strip(inner, end),
            pipe.mouth: fan(end, [pipe.side*pipe.end, 0, pipe.height]),
        }


def add(surfaces, others):
    """To those of the same names."""
    for name, triangles in others.items():
        surfaces[name] = surfaces.get(name, []) + triangles


# The file


def write(file, name, triangles):
    file.write(f"solid {name}\n")
    for triangle in triangles:
        normal = np.cross(triangle[1] - triangle[0], triangle[2] - triangle[0])
        normal /= np.linalg.norm(normal)
        file.write("facet normal {:.8g} {:.8g} {:.8g}\nouter loop\n".format(
            *normal))
        for point in triangle:
            file.write("vertex {:.9f} {:.9f} {:.9f}\n".format(*point))
        file.write("endloop\nendfacet\n")
    file.write(f"endsolid {name}\n")


def main(surfaces):
    if len(sys.argv) != 2:
        sys.exit(f"usage: {Path(sys.argv[0]).name} FILE.stl")
    with open(sys.argv[1], "w", encoding="ascii") as file:
        for name, triangles in surfaces().items():
            write(file, name, triangles)
