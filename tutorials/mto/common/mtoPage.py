# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Parts of the pages of results of the reactor in three dimensions.
# ------------------------------------------------------------------------------
"""Plots of the reactor."""

from lowerEnd import RADIUS, TUBE_END
from mtoRun import BLOCK, LIGHT
from mto import PEAK
from page import COLOURS, GREY, draw_parcels, new_plot, pyplot, save
from tutorial import np, of


def plot_coke(run, results):
    time, coke = run.coke()
    figure, axes = new_plot("time (s)", "coke, by mass (%)")
    axes.plot(time, coke, color=COLOURS[0])
    save(figure, results/"coke.png")


def plot_products(run, results):
    time, Y = run.products()
    figure, axes = new_plot(
        "time (s)", f"of the gas that leaves, {BLOCK} s means (%)")
    for name in ("MeOH", *LIGHT):
        axes.plot(time, 100*Y[name], label=name, marker=".", ms=3)
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


def shown_frames(run):
    """Those written nearest to the start, 0.5, 1, 2, 4 and 8 h."""
    near = {run.near(hour) for hour in (0, 0.5, 1, 2, 4, 8)}
    return sorted(near, key=float)


def plot_distribution(run, results):
    """Coke over the catalyst as time goes on, and what of it is new."""
    figure, axes = pyplot.subplots(1, 2, figsize=(9, 3.6),
                                   layout="constrained")
    edges = np.arange(1.875, 9.2, 0.25)
    frames = shown_frames(run)
    shades = pyplot.get_cmap("viridis")(np.linspace(0.85, 0.1, len(frames)))
    for frame, colour in zip(frames, shades):
        coke, _, mass = run.parcels_at(frame)
        name = f"{run.hours(frame):.2g} h, {run.new(frame):.0f} % new"
        found = np.histogram(coke, edges, weights=mass)[0]
        axes[0].plot(0.5*(edges[1:] + edges[:-1]), 100*found, color=colour,
                     marker=".", ms=3)
        order = np.argsort(coke)
        axes[1].plot(coke[order], 100*np.cumsum(mass[order]), color=colour,
                     label=name)
    axes[0].axvline(PEAK, color=GREY, lw=0.7)
    axes[0].set_ylabel("catalyst in classes of 0.25 % (%)")
    axes[1].set_ylabel("catalyst with less coke (%)")
    axes[0].set_ylim(0, 30)
    axes[0].text(PEAK + 0.05, 28, "chapter's peak at 8 h", color=GREY,
                 fontsize=8)
    axes[1].legend()
    for each in axes:
        each.set_xlabel("coke, by mass of all (%)")
        each.spines[["top", "right"]].set_visible(False)
    save(figure, results/"distribution.png")


def plot_ages(run, results):
    """Residence times: ages of what leaves and of all, beside those of a bed
    that is well mixed."""
    figure, axes = new_plot("age by the slow clock (s)", "catalyst younger (%)")
    _, age, mass = run.parcels_at(run.last())
    order = np.argsort(age)
    axes.plot(age[order], 100*np.cumsum(mass[order]), color=COLOURS[1], lw=1,
              label="of all, at the end")
    leaving = run.ages_of_leaving()
    if leaving:
        axes.plot(leaving[0], 100*leaving[1], color=COLOURS[0], marker=".",
                  ms=3, label="of what leaves")
    time = np.linspace(0, max(age.max(), 1e-9), 200)
    axes.plot(time, 100*(1 - np.exp(-time/run.passing())), color=GREY, ls=":",
              label="well mixed")
    axes.legend()
    save(figure, results/"ages.png")


def age_rows(run):
    """Of the page: how long catalyst stays."""
    _, age, mass = run.parcels_at(run.last())
    leaving = run.ages_of_leaving()
    found = (f"{leaving[2]:.0f} ± {leaving[3]:.0f}" if leaving
             else "none has been counted")
    return [
        ("age of what leaves, mean, by the slow clock", found, "s"),
        ("of all at the end, by the slow clock",
         f"{(mass*age).sum():.0f}", "s"),
        ("inventory over feed, where both tend to", f"{run.passing():.0f}",
         "s"),
    ]


def plot_parcels(run, results, height):
    """Those about the plane through the axis and the feed, by coke."""
    frames = shown_frames(run)
    figure, row = pyplot.subplots(
        1, len(frames), figsize=(1.7*len(frames) + 1.2, 5.2), sharey=True,
        layout="constrained", squeeze=False)
    for axes, frame in zip(row[0], frames):
        x = of.positions(run.case, frame, "parcels")
        coke, _, _ = run.parcels_at(frame)
        near = abs(x[:, 1]) < run.parcel_diameter
        discs = draw_parcels(
            axes, x[near][:, ::2],
            np.full(near.sum(), run.parcel_diameter), coke[near], (2, 8))
        axes.set_title(f"{run.hours(frame):.2g} h", fontsize=10)
        axes.set_xlim(-RADIUS, RADIUS)
        axes.set_ylim(TUBE_END, height)
        axes.set_xlabel("x (m)")
    row[0][0].set_ylabel("height (m)")
    figure.colorbar(discs, ax=row[0], label="coke, by mass of all (%)",
                    shrink=0.6, extend="both")
    save(figure, results/"parcels.png")
