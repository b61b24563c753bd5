# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What pages of results are made of, those of the tutorials and of
#     cghsStudy: plots in one style, tables.
# ------------------------------------------------------------------------------
"""Plots and tables for pages in Markdown."""

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


def save(figure, path):
    figure.savefig(path, dpi=130)
    pyplot.close(figure)


def as_table(rows, head=("", "", "")):
    """Rows of texts: of the columns, all but the first and the last are numbers
    and stand to the right."""
    lines = ["| " + " | ".join(head) + " |",
             "|---|" + "--:|" * (len(head) - 2) + "---|"]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines)
