# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Checks of a run of the reactor in three dimensions, each with what it is
#     held against: the case's inputs, a balance, or the chapter's text (Lu et
#     al., 2018, 4.2).
# ------------------------------------------------------------------------------
"""Checks of the reactor against balances, inputs and the chapter."""

from mtoRun import (
    AREA, BED_HEIGHT, CATALYST, FEED, INVENTORY, METHANOL, PRESSURE,
    RENEWED, STEAM)
from limits import Stirred
from mto import PEAK


def inputs(run, checks):
    checks.equal("outlet pressure [Pa]", run.outlet_pressure[-1], PRESSURE,
                 1e-6, "0.4288 kg/m3 of Table 10, at 723 K")
    for text, flow, given in (("methanol and steam", run.feed, FEED),
                              ("lift steam", run.steam, STEAM)):
        checks.equal(f"{text} that enter, mean of the run [kg/s]",
                     run.mean_flow(flow), given, 1e-4, "4.2.1")


def conservation(run, checks):
    run.check_solids(checks, 1e-8, raised=0.01*run.bed_cells())
    defects = run.element_defects()
    for element in ("C", "mass"):
        checks.below(f"{element} from nowhere, of what is there and flows [-]",
                     defects[element], 1e-7,
                     "balance: to the tolerance of p")


def feeding(run, checks):
    run.check_feeding(checks, CATALYST, run.parcel_mass/CATALYST, "4.2.1")
    low = run.mass.min()
    checks.below("catalyst below the inventory, most [parcels]",
                 max(INVENTORY - low, 0)/run.parcel_mass, 1.2,
                 "input: the valve lets out none below 9.0 kg; with its coke")
    mass = run.mean(run.mass)[0] if run.window else run.mass[-1]
    checks.below("catalyst over the inventory, mean of the window, of that [-]",
                 mass/INVENTORY - 1, 0.01, "input: as much leaves as comes in")


def steady(run, checks):
    drop, error = run.mean(run.pressure_drop)
    carried = run.mean(run.mass)[0]*run.g/AREA
    checks.add("pressure drop over weight of catalyst [-]", drop/carried, "1",
               abs(drop/carried - 1), 0.05 + 3*error/carried,
               "balance: it hangs in the gas; 5 % for the tube")
    checks.within("height below which 95 % of the catalyst are [m]",
                  run.surface(), 0.75*BED_HEIGHT, 1.25*BED_HEIGHT,
                  "4.2.3: most are in the lowest 0.4 m or so; 25 % for both")


def chemistry(run, checks):
    """Of what a run is long enough for: says what it is not."""
    if not run.window or run.end < RENEWED + 3:
        print("The gas of the start has not left yet: what the reactions make"
              " is not judged.\n")
        return
    stirred = Stirred()
    alike, mixed = stirred.alike(), stirred.mixed()
    methanol(run, checks)
    low, high = sorted(100*limit["light"] for limit in (alike, mixed))
    checks.within("light olefins of the hydrocarbon gas [%]",
                  100*run.light(run.late())[0], low - 0.5, high + 0.5,
                  "0D/limits.py: catalyst mixed, all alike; 0.5")

    if run.slow(run.end) >= 3600:
        new_catalyst(run, stirred, checks)
    coke = run.settled_coke()
    if coke is None:
        print("The catalyst has not settled yet: its coke is not judged.\n")
        return
    low, high = sorted(limit["coke_mean"] for limit in (alike, mixed))
    checks.within("coke of the catalyst, mean once it has settled [%]",
                  coke[0], low - 0.1, high + 0.1,
                  "0D/limits.py: all alike, mixed; 0.1")
    frame = run.near(8)
    if abs(run.hours(frame) - 8) < 0.1:
        found = run.most(frame)
        checks.add("coke that most of the catalyst has at 8 h [%]", found,
                   f"{PEAK:g}", abs(found - PEAK), 0.5, "4.2.3, Fig 36")


def methanol(run, checks):
    """Diffusion from the floor adds one in a hundred: it goes as what of the
    methanol has reacted half a cell over the floor."""
    fed = METHANOL*FEED
    checks.within("methanol that comes in, over that fed [-]",
                  run.methanol_in()/fed, 1, 1.015,
                  "input: 5 g/s, and what diffuses")


def new_catalyst(run, stirred, checks):
    frame = run.near(0.5)
    stirred.inputs.start = run.coke()[1][0]/100
    time = 20*round(run.slow(float(frame))/20)
    _, mass, new = stirred.mixed_over_time(time, at=(time,))[1][time]
    found, asked = run.new(frame), 100*mass[new].sum()
    checks.add(f"new catalyst after {run.hours(frame):.2f} h [%]", found,
               f"{asked:.4g}", abs(found - asked), 4,
               "0D/limits.py: well mixed; 4")
