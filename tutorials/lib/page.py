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

from tutorial import np

try:
    import matplotlib

    matplotlib.use("Agg")
    matplotlib.rcParams["legend.frameon"] = False
    matplotlib.rcParams["legend.fontsize"] = 9
    from matplotlib import pyplot
except ImportError:
    pyplot = None

COLOURS = ("#1f5fa8", "#c8501e", "#3c8c46")
GREY = "#777777"


def can_plot():
    """Says what is missing where it is."""
    if not pyplot:
        print("no plots, as python3 has no matplotlib; remedy: "
              "apt-get install python3-matplotlib")
    return bool(pyplot)


def new_plot(x_label, y_label):
    figure, axes = pyplot.subplots(figsize=(7, 3.6), layout="constrained")
    axes.set_xlabel(x_label)
    axes.set_ylabel(y_label)
    axes.spines[["top", "right"]].set_visible(False)
    return figure, axes


def band(axes, x, mean, error, colour, label=None, marker="o"):
    """Means, and their standard errors as a band about them."""
    axes.plot(x, mean, color=colour, marker=marker, ms=3, label=label)
    axes.fill_between(x, mean - error, mean + error, color=colour, alpha=0.2,
                      lw=0)


def save(figure, path):
    figure.savefig(path, dpi=130)
    pyplot.close(figure)


def image(folder, name, text, need="python3-matplotlib"):
    """A picture of the page, or why it is not there."""
    if not (folder / name).exists():
        return f"(Not drawn: {text}, as {need} is not installed.)"
    return f"![{text}]({name})"


def write_table(path, columns, fmt="%.8g"):
    """columns: names with their units, and values."""
    np.savetxt(path, np.column_stack(list(columns.values())), fmt=fmt,
               delimiter=",", header=",".join(columns), comments="")


def as_table(rows, head=("", "", "")):
    """Rows of texts: of the columns, all but the first and the last are numbers
    and stand to the right."""
    lines = ["| " + " | ".join(head) + " |",
             "|---|" + "--:|" * (len(head) - 2) + "---|"]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines)


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
