# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What the tutorials' pages of results are made of: plots, tables, and the
#     output of validate.
# ------------------------------------------------------------------------------
"""Parts of the pages of results."""

import subprocess
import sys

from tutorial import np, of

from pageParts import (
    COLOURS, GREY, as_table, can_plot, new_plot, pyplot, save)

# What the tutorials take from here, of other files
__all__ = ("COLOURS", "GREY", "as_table", "can_plot", "new_plot")


def band(axes, x, mean, error, colour, label=None, marker="o"):
    """Means, and their standard errors as a band about them."""
    axes.plot(x, mean, color=colour, marker=marker, ms=3, label=label)
    axes.fill_between(x, mean - error, mean + error, color=colour, alpha=0.2,
                      lw=0)


def image(folder, name, text, need="python3-matplotlib"):
    """A picture of the page, or why it is not there."""
    if not (folder / name).exists():
        return f"(Not drawn: {text}, as {need} is not installed.)"
    return f"![{text}]({name})"


def write_table(path, columns, fmt="%.8g"):
    """columns: names with their units, and values."""
    np.savetxt(path, np.column_stack(list(columns.values())), fmt=fmt,
               delimiter=",", header=",".join(columns), comments="")


def checks_of(here, *cases):
    """What the tutorial's validate says of its cases."""
    return subprocess.run(
        [sys.executable, here / "validate", *cases],
        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
        check=False,
    ).stdout.strip()


def draw_parcels(axes, place, diameter, values, bounds, colours="viridis"):
    """Parcels as discs to scale: place (x, y), diameter and value of each, and
    the bounds of the values that the colours stand for."""
    from matplotlib.collections import EllipseCollection

    discs = EllipseCollection(
        diameter, diameter, np.zeros(len(diameter)), units="xy", offsets=place,
        offset_transform=axes.transData, array=values, cmap=colours, lw=0)
    discs.set_clim(*bounds)
    axes.add_collection(discs)
    axes.set_aspect("equal")
    return discs


def draw_slices(beds, path, top, thickness, field, label, bounds=None,
                colours="viridis"):
    """The parcels of each run in a slice in the middle of the depth, at the
    last time that all have reached, up to the height top. field(bed, time): a
    value of each; bounds: of the colours, else those that all but 2 % at each
    end of what is drawn are in."""
    common = set.intersection(*(set(bed.frames) for bed in beds.values()))
    time = max(common, key=float, default=None)
    if time is None:
        return
    shape = top / max(bed.size[0] for bed in beds.values())
    figure, row = pyplot.subplots(
        1, len(beds), figsize=(2.8 * len(beds) + 1.4, 2.6 * shape + 1.2),
        layout="constrained", squeeze=False, sharey=True)
    drawn = []
    for axes, bed in zip(row[0], beds.values()):
        x = of.positions(bed.case, time, "parcels")
        near = abs(x[:, 2] - 0.5 * bed.size[2]) < 0.5 * thickness
        drawn.append(draw_parcels(
            axes, x[near, :2], np.full(near.sum(), bed.parcel_diameter()),
            field(bed, time)[near], bounds or (0, 1), colours))
        axes.set_title(f"{bed.name}, t = {time} s", loc="left", fontsize=10)
        axes.set_xlim(0, bed.size[0])
        axes.set_ylim(0, top)
        axes.set_xlabel("x (m)")
    if not bounds:
        values = np.concatenate(
            [np.asarray(discs.get_array()) for discs in drawn])
        for discs in drawn:
            discs.set_clim(*np.percentile(values, (2, 98)))
    row[0][0].set_ylabel("height (m)")
    figure.colorbar(drawn[-1], ax=row[0], label=label, shrink=0.6,
                    extend="neither" if bounds else "both")
    save(figure, path)
