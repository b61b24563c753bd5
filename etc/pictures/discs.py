#!/usr/bin/python3
# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Parcels of a case at some times, side by side, as discs of their size in
#     colours of their speed, with matplotlib:
#
#         discs.py CASE PICTURE.png TIME[,TIME...] [CLOUD]
#
#     etc/pictures/parcels runs it where ParaView is not installed. It looks along
#     -z with y upward: near parcels cover far ones, which are darker, and each has
#     a light from the upper left. It reads decomposed cases as well as whole ones.
# ------------------------------------------------------------------------------
"""Draws the parcels of an OpenFOAM case with matplotlib."""

import re
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import numpy as np
from matplotlib import cm, colors, pyplot
from matplotlib.collections import EllipseCollection
from matplotlib.patches import Rectangle

sys.path.append(str(Path(__file__).resolve().parents[2] / "tests/lib"))
import cghsTest as of

HEIGHT = 8.5    # of the picture, in inches
FAR = 0.55      # brightness of the furthest parcels
MOST = 99.5     # per cent of the parcels, whose speeds the colours tell apart
# From the middle of a disc to its edge: the lit part, in diameters, its shift
# towards the light and its brightness
LIGHT = ((1.0, 0.0, 0.62), (0.82, 0.05, 0.85), (0.56, 0.11, 1.0))


def bounds_of(case):
    """Corners of the mesh."""
    meshes = list(case.glob("processor[0-9]*/constant/polyMesh/points*"))
    whole = list((case / "constant/polyMesh").glob("points*"))
    points = []
    for path in whole or meshes:
        text = of.read(path.with_name("points"))
        points.append(np.array(re.findall(r"\(([^()]+)\)", text[text.index("("):]
                                          .replace("\n", " ")[1:]),
                               dtype=object))
    x = np.array([row.split() for part in points for row in part
                  if len(row.split()) == 3], float)
    return x.min(axis=0), x.max(axis=0)


def draw(axes, case, cloud, time, low, high, largest):
    """One time; colours end at this speed."""
    x = of.positions(case, time, cloud)
    d = of.cloud_field(case, time, cloud, "dParcel")
    speed = np.linalg.norm(of.cloud_field(case, time, cloud, "U"), axis=1)

    order = np.argsort(x[:, 2])
    x, d, speed = x[order], d[order], speed[order]
    depth = (high[2] - x[:, 2]) / max(high[2] - low[2], 1e-300)
    colour = cm.viridis(np.minimum(speed / largest, 1))[:, :3]
    colour *= (1 - (1 - FAR) * np.clip(depth, 0, 1))[:, None]

    # All discs of a parcel before those of a nearer one
    n, k = len(x), len(LIGHT)
    size, place, face = (np.empty((n, k)), np.empty((n, k, 2)),
                         np.empty((n, k, 3)))
    for i, (share, shift, bright) in enumerate(LIGHT):
        size[:, i] = share * d
        place[:, i] = x[:, :2] + shift * d[:, None] * np.array([-1, 1])
        face[:, i] = colour * bright
    size = size.ravel()
    axes.add_collection(EllipseCollection(
        size, size, np.zeros(n * k), units="xy", offsets=place.reshape(-1, 2),
        offset_transform=axes.transData, facecolors=face.reshape(-1, 3), lw=0))

    axes.add_patch(Rectangle(low[:2], *(high - low)[:2], fill=False, lw=0.8))
    margin = 0.01 * (high - low)
    axes.set_xlim(low[0] - margin[0], high[0] + margin[0])
    axes.set_ylim(low[1] - margin[1], high[1] + margin[1])
    axes.set_aspect("equal")
    axes.set_title(f"t = {time} s", fontsize=10)
    axes.set_xlabel("x (m)")


def main():
    case, picture = Path(sys.argv[1]).resolve(), sys.argv[2]
    wanted = [float(time) for time in sys.argv[3].split(",")]
    cloud = sys.argv[4] if len(sys.argv) > 4 else "parcels"
    names = of.times(case)
    times = [min(names, key=lambda name: abs(float(name) - t)) for t in wanted]

    low, high = bounds_of(case)
    # A few fast ones must not leave all others in the dark
    speeds = np.concatenate([
        np.linalg.norm(of.cloud_field(case, t, cloud, "U"), axis=1)
        for t in times])
    largest = np.percentile(speeds, MOST) or 1.0

    width = HEIGHT * (high - low)[0] / (high - low)[1]
    figure, row = pyplot.subplots(
        1, len(times), squeeze=False, sharey=True, layout="constrained",
        figsize=(len(times) * (max(width, 0.8) + 0.35) + 1.4, HEIGHT))
    for axes, time in zip(row[0], times):
        draw(axes, case, cloud, time, low, high, largest)
        axes.locator_params(axis="x", nbins=3)
    row[0][0].set_ylabel("height (m)")
    figure.colorbar(
        cm.ScalarMappable(colors.Normalize(0, largest), "viridis"),
        ax=row[0], label="parcel velocity (m/s)", shrink=0.6,
        extend="max" if speeds.max() > largest else "neither")
    figure.savefig(picture, dpi=110)


if __name__ == "__main__":
    main()
