# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Parts of the pages of results of the reactor in three dimensions.
# ------------------------------------------------------------------------------
"""Plots of the reactor."""

from mtoRun import LIGHT
from page import COLOURS, new_plot, save


def plot_coke(run, results):
    time, coke = run.coke()
    figure, axes = new_plot("time (s)", "coke, by mass (%)")
    axes.plot(time, coke, color=COLOURS[0])
    save(figure, results/"coke.png")


def plot_products(run, results):
    time, Y = run.products()
    figure, axes = new_plot("time (s)", "in the gas that leaves, by mass (%)")
    for name in ("MeOH", *LIGHT):
        axes.plot(time, 100*Y[name], label=name)
    axes.legend()
    save(figure, results/"products.png")


def plot_height(run, results):
    """Of the solids, once there are means."""
    height = run.profile("height")
    if height:
        figure, axes = new_plot("solids fraction", "height (m)")
        axes.plot(height["solidsFraction"], height["coordinate"],
                  color=COLOURS[0])
        save(figure, results/"height.png")
