# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Plots of work and precision: error over what it costs, both as logarithms.
#     Errors that cannot be told from noise are hollow, with the noise as their
#     bar; those that nothing is both cheaper and better than are joined.
# ------------------------------------------------------------------------------
"""Pictures of the report."""

import numpy as np

from pageParts import COLOURS, GREY, can_plot, pyplot, save

try:
    from matplotlib.ticker import LogLocator
except ImportError:
    pass    # can_plot() says so

SMALLEST = 1e-6     # an error of nothing is drawn there [-]
MANY = 14           # variants whose names do not crowd a plot


def draw(results, folder):
    """One plot for each quantity, one for all; profiles. Names of the files, by
    quantity."""
    drawn = {}
    if not can_plot():
        return drawn
    for quantity in results.study.quantities:
        path = folder / f"{quantity.name}.png"
        if draw_plot(results, [quantity], quantity.label, path):
            drawn[quantity.name] = path.name
        if quantity.type == "profile":
            draw_profile(results, quantity, folder)
    if len(results.study.quantities) > 1 and draw_plot(
            results, results.study.quantities, "the worst quantity",
            folder / "all.png"):
        drawn["all"] = "all.png"
    return drawn


def draw_plot(results, quantities, label, path):
    """Nothing is drawn before there is a point."""
    points = results.points(quantities)
    if not points:
        return False
    figure, axes = pyplot.subplots(figsize=(7, 4.6), layout="constrained")
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    front = results.front(quantities)
    draw_front(axes, [points[name] for name in front])
    for name in points:
        draw_point(axes, results.outcomes[name], points[name], quantities)
    write_names(axes, {name: place(point) for name, point in points.items()
                       if len(points) <= MANY or name in front})
    decorate(axes, results, points, label)
    save(figure, path)
    return True


def write_names(axes, places):
    """Beside their points; of neighbours that would cover each other's one
    after the other goes a line lower."""
    last, lower = None, 0
    for name, at in sorted(places.items(), key=lambda p: p[1]):
        near = last and np.all(abs(np.log(np.divide(at, last))) < 0.2)
        lower = lower + 1 if near else 0
        axes.annotate(name, at, (7, 5 - 11*lower), fontsize=8,
                      textcoords="offset points")
        last = at


def place(point):
    cost, error = point
    return cost, 100*max(error, SMALLEST)


def draw_front(axes, points):
    if points:
        axes.plot(*zip(*map(place, points)), color=COLOURS[0], lw=1.2,
                  marker="o", ms=13, mfc="none", mew=1, alpha=0.6, zorder=1,
                  label="Pareto front")


def draw_point(axes, outcome, point, quantities):
    """Filled if the error is told from noise."""
    worst = max((outcome.comparisons[q.name] for q in quantities),
                key=lambda c: c.seen())
    x, y = place(point)
    if worst.noise > 0:
        low = max(y - 100*worst.noise, 0.3*y)
        axes.plot((x, x), (low, y + 100*worst.noise), color=GREY, lw=1,
                  zorder=2)
    axes.plot(x, y, "o", ms=6, color=COLOURS[1], zorder=3,
              mfc=COLOURS[1] if worst.distinct else "white")


def decorate(axes, results, points, label):
    for axis, scale in ((axes.xaxis, axes.set_xscale),
                        (axes.yaxis, axes.set_yscale)):
        scale("log")
        axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
        axis.set_major_formatter("{x:g}")
        axis.set_minor_formatter("")
    axes.set_xlabel("processor seconds for a simulated second")
    axes.set_ylabel(f"error in {label} (%)")
    axes.grid(color="k", alpha=0.08, lw=0.6)
    cost = results.reference.processor
    if np.isfinite(cost):
        axes.axvline(cost, color=GREY, lw=1, ls=":", label="reference")
    axes.plot([], [], "o", color=COLOURS[1], label="error")
    axes.plot([], [], "o", color=COLOURS[1], mfc="white",
              label="not told from noise")
    for level in results.study.thresholds:
        axes.axhline(level, color=GREY, lw=0.7, ls="--", alpha=0.6)
    widen(axes, [*points.values(), (cost, np.nan)], results.study.thresholds)
    lost = [o.name for o in results.outcomes.values()
            if o.name not in points and o.name != results.study.reference]
    if lost:
        axes.set_title("no point: " + ", ".join(lost), fontsize=9, loc="left",
                       color=GREY)
    axes.legend(fontsize=8, loc="best")


def widen(axes, points, thresholds):
    """Half a decade about what is drawn, so that names have room and the axes
    have ticks."""
    costs = [cost for cost, _ in points if np.isfinite(cost)]
    axes.set_xlim(min(costs)/1.8, max(costs)*2.5)
    errors = [place((1, e))[1] for _, e in points if np.isfinite(e)]
    levels = [*errors, *(t for t in thresholds
                         if 0.1*min(errors) < t < 10*max(errors))]
    axes.set_ylim(min(levels)/2.5, max(levels)*2.5)


def draw_profile(results, quantity, folder):
    """Of each variant, with the standard error of the reference as a band."""
    found = {name: o.estimates[quantity.name]
             for name, o in results.outcomes.items()
             if quantity.name in o.estimates}
    figure, axes = pyplot.subplots(figsize=(7, 4.2), layout="constrained")
    reference = results.reference.estimates.get(quantity.name)
    if reference is not None:
        error = np.nan_to_num(reference.error)
        axes.fill_between(reference.coordinate, reference.value - error,
                          reference.value + error, color="k", alpha=0.15, lw=0)
        axes.plot(reference.coordinate, reference.value, "k", lw=2,
                  label=results.reference.name)
    for name, estimate in found.items():
        if name != results.study.reference:
            axes.plot(estimate.coordinate, estimate.value, lw=1, marker="o",
                      ms=2.5, label=name)
    axes.set_xlabel("coordinate (m)")
    axes.set_ylabel(quantity.header())
    axes.legend(fontsize=8)
    save(figure, folder / f"profile-{quantity.name}.png")
