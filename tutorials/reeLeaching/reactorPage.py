# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     The pages of results of counterCurrent and of scaleUp: what each run has
#     become beside its limits, over time, and its parcels.
# ------------------------------------------------------------------------------
"""Pages of results of counter-current reactors."""

from leaching import RARE_EARTH, np, of
from page import (
    COLOURS, GREY, as_table, can_plot, checks_of, draw_parcels, image, new_plot,
    pyplot, save, write_table)

LINES = (*COLOURS, GREY)


def plot_outlet(runs, folder):
    figure, axes = new_plot("time (s)", "rare earth in the outlet (%)")
    for (name, run), colour in zip(runs.items(), LINES):
        axes.plot(run.outlet_time, 100*run.outlet, color=colour, lw=1,
                  label=name)
        axes.axhline(100*run.reactor.outlet(run.reactor.leached(10)),
                     color=colour, lw=0.8, ls=":")
    axes.legend(title="dotted: ten tanks")
    axes.set_xlim(left=0)
    axes.set_ylim(bottom=0)
    save(figure, folder/"outlet.png")


def plot_ages(runs, folder):
    figure, axes = new_plot("age of the ore that leaves over inventory/feed",
                            "share of the ore")
    for (name, run), colour in zip(runs.items(), LINES):
        ages, share = run.histogram("ageOfLeaving")
        width = (ages[1] - ages[0])/run.reactor.tau
        axes.step(ages/run.reactor.tau, share/width, where="mid", lw=1,
                  color=colour, label=f"{name}: {run.tanks():.1f} tanks")
    axes.legend()
    axes.set_xlim(0, 4)
    save(figure, folder/"ages.png")


def draw(runs, folder):
    """The parcels of a slice of a fifth of the diameter, by leached fraction."""
    figure, row = pyplot.subplots(1, len(runs), figsize=(2.2*len(runs) + 1.2, 6),
                                  layout="constrained", squeeze=False)
    for axes, (name, run) in zip(row[0], runs.items()):
        time = run.frames[-1]
        x = of.positions(run.case, time, "parcels")
        a = 1 - of.cloud_field(run.case, time, "parcels", "Y.REE")/RARE_EARTH
        size = run.diameter*run.weight**(1/3)
        near = abs(x[:, 1]) < 0.1*run.reactor.diameter
        discs = draw_parcels(axes, x[near][:, [0, 2]],
                             np.full(near.sum(), size), a[near], (0, 1))
        R = 0.5*run.reactor.diameter
        axes.set_xlim(-R, R)
        axes.set_xticks([-R, R])
        axes.set_ylim(0, 0.64*run.reactor.scale)
        if run.reactor.width > run.reactor.scale:
            axes.set_aspect("auto")
        axes.set_title(f"{name}, {float(time):g} s", fontsize=9)
        axes.tick_params(labelsize=7)
    figure.colorbar(discs, ax=row[0].tolist(), label="leached fraction")
    save(figure, folder/"parcels.png")


def with_error(mean_error, factor=1.0, digits=4):
    mean, error = mean_error
    return f"{factor*mean:.{digits}f} ± {factor*error:.{digits}f}"


def table(runs):
    """One column a run, one row a quantity."""
    def row(text, unit, value):
        return [text, *(value(run) for run in runs.values()), unit]

    def steady(value):
        return lambda run: value(run) if run.window else "-"

    def limit(run, tanks):
        high, low = run.reactor.leached(tanks), run.reactor.poorest(tanks)
        return f"{100*high:.1f} ({100*low:.1f})"

    rows = [
        row("reached, averaged from", "s",
            lambda r: f"{r.end:g}, {r.average_from:g}"),
        row("rare earth in the outlet", "%",
            steady(lambda r: with_error(r.mean_outlet(), 100))),
        row("in the liquid that leaves with the ore", "%",
            steady(lambda r: with_error(r.mean_drained(), 100))),
        row("by the balance, from what the ore has lost", "%",
            steady(lambda r: with_error(r.balanced_outlet(), 100))),
        row("leached, of the ore that leaves", "%",
            steady(lambda r: with_error(r.leached_leaving(), 100, 1))),
        row("Eq 103 for its ages, in fresh liquid", "%",
            steady(lambda r: f"{100*r.by_ages():.1f}")),
        row("plug flow (in the outlet's liquid)", "%",
            lambda r: limit(r, None)),
        row("ten mixed tanks", "%", lambda r: limit(r, 10)),
        row("one", "%", lambda r: limit(r, 1)),
        row("age of the ore that leaves", "s", steady(
            lambda r: with_error(r.leaving("ageOfLeaving")[:2], 1, 1))),
        row("inventory over feed", "s", lambda r: f"{r.reactor.tau:.1f}"),
        row("tanks whose ages vary as much", "",
            steady(lambda r: f"{r.tanks():.1f}")),
        row("rare earth made", "kg/day",
            steady(lambda r: with_error(r.made(), 1, 3))),
        row("parcels", "", lambda r: f"{r.parcels['nParcels'][-1]:.0f}"),
        row("La from nowhere in a step", "",
            lambda r: f"{r.element_defects()['La']:.1e}"),
        row("run time, cores", "s",
            lambda r: f"{r.seconds():.0f}, {r.ranks()}"),
        row("simulated", "s a day", lambda r: f"{r.seconds_per_day():.0f}"),
    ]
    return as_table(rows, ["", *runs, ""])


def make(here, folder, runs, title, text):
    """results/results.md and what is in it."""
    results = folder/"results"
    results.mkdir(exist_ok=True)
    averaged = {name: run for name, run in runs.items() if run.window}
    for name, run in runs.items():
        write_table(results/f"{name}.csv", {
            "time [s]": run.outlet_time, "REE [-]": run.outlet,
            "NH4 [-]": run.outlet_ammonium})
    if can_plot():
        plot_outlet(runs, results)
        draw(runs, results)
        if averaged:
            plot_ages(averaged, results)
    shown = table(runs)
    ages = image(results, "ages.png", "ages of what leaves") if averaged else ""
    (results/"results.md").write_text(f"""# {title}

{text}

{shown}

Errors (±) are standard errors by blocks in time.

{image(results, "outlet.png", "rare earth in the outlet over time")}

{ages}

{image(results, "parcels.png", "parcels by leached fraction")}

The checks of `validate`:

```
{checks_of(here, folder)}
```
""")
    print(shown)
