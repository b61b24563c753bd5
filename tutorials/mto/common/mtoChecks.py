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
    AREA, BED_HEIGHT, CATALYST, FEED, INVENTORY, PRESSURE, STEAM)


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
    checks.below("catalyst over the inventory at the end, of that [-]",
                 run.mass[-1]/INVENTORY - 1, 0.01,
                 "input: as much leaves as comes in")


def steady(run, checks):
    drop, error = run.mean(run.pressure_drop)
    carried = run.mean(run.mass)[0]*run.g/AREA
    checks.add("pressure drop over weight of catalyst [-]", drop/carried, "1",
               abs(drop/carried - 1), 0.05 + 3*error/carried,
               "balance: it hangs in the gas; 5 % for the tube")
    checks.within("height below which 95 % of the catalyst are [m]",
                  run.surface(), 0.75*BED_HEIGHT, 1.25*BED_HEIGHT,
                  "4.2.3: most are in the lowest 0.4 m or so; 25 % for both")
