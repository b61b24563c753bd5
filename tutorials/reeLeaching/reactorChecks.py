# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What validate of counterCurrent and of scaleUp check of each run: inputs,
#     balances, what the valve keeps, and in a long run the steady state between
#     its limits. Each has further checks of its own.
# ------------------------------------------------------------------------------
"""Checks of counter-current reactors."""

from leaching import AMMONIUM, CATIONS, M_NH4, M_REE, STEADY, np


def inputs(name, run, checks):
    reactor = run.reactor
    for text, flow, given in (
            ("fresh liquid that enters", -run.flow("freshFlow"), reactor.fresh()),
            ("recycled liquid that enters", -run.flow("recycleFlow"),
             reactor.recycle*reactor.liquid),
            ("liquid that leaves with the ore", run.flow("drainFlow"),
             reactor.drained())):
        checks.equal(f"{name}: {text} [kg/s]", flow, given, 1e-6,
                     "Tables 13 and 14; the voidage of ore that leaves")
    checks.below(f"{name}: ore fed, less that due [parcels]",
                 abs(run.fed[-1] - reactor.solids*run.end)/run.parcel_mass,
                 2, "Tables 13 and 14")


def conservation(name, run, checks):
    defects = run.element_defects()
    for ion in ("La", "N", "H", "mass"):
        checks.below(f"{name}: {ion} from nowhere in a step, of what is there "
                     "and flows [-]", defects[ion], 1e-6,
                     "balance: to the tolerance of p")
    for species in ("REEaq", "NH4"):
        checks.below(f"{name}: {species} from nowhere in the run, of what is "
                     "there and has come in [-]", run.species_defect(species),
                     5e-6,
                     "balance: to the tolerance of p")
    run.check_solids(checks, raised=0.01*run.bed_cells(), who=f"{name}: ")
    # Each of the rare earth is there for so many ammonium that have gone, and
    # both are carried alike
    for place, (_, earth, ammonium) in run.liquids.items():
        missing = ammonium + CATIONS*M_NH4/M_REE*earth - AMMONIUM
        checks.below(f"{name}: ammonium of the liquid '{place}', less what the "
                     "rare earth leaves of it, most, of the fresh one's [-]",
                     abs(missing).max()/AMMONIUM, 1e-5,
                     "balance: three for each of the rare earth")


def valve(name, run, checks):
    low = run.mass.min()
    checks.below(f"{name}: ore below the inventory, most [parcels]",
                 max(run.reactor.inventory - low, 0)/run.parcel_mass, 1.5,
                 "input: the valve lets none out below it; with what it loses")
    inside = run.time > run.window[0]
    checks.below(f"{name}: ore above the inventory, mean of the window [-]",
                 run.mass[inside].mean()/run.reactor.inventory - 1, 0.02,
                 "limit: what is above it is at the valve")
    checks.below(f"{name}: largest overlap, median of the window, of d [-]",
                 np.median(run.parcels["maxOverlap"][inside]), 0.05,
                 "limit: parcels are hard")


def recycle(name, run, checks):
    """What comes back has what has left: of the step before."""
    for ion, text in ((1, "rare earth"), (2, "ammonium")):
        back, left = (
            run.windowed(run.liquids[place][0], run.liquids[place][ion])[0]
            for place in ("recycled", "outlet"))
        checks.equal(f"{name}: {text} of the liquid that comes back [-]", back,
                     left, 5e-3, "input: the outlet's, of the step before")


def steady(name, run, checks):
    reactor = run.reactor
    a = run.leached_leaving()[0]
    age = run.leaving("ageOfLeaving")
    tau = run.mean(run.mass)[0]/reactor.solids
    checks.add(f"{name}: age of the ore that leaves [s]", age[0],
               f"{tau:.4g}", abs(age[0] - tau), 0.03*tau + 3*age[1],
               "limit: ore there over feed; 3 %")
    poor = run.windowed(run.outlet_time, run.outlet_ammonium)[0]/AMMONIUM
    checks.within(f"{name}: leached, of the ore that leaves [-]", a,
                  run.by_ages(poor) - 0.01, run.by_ages() + 0.01,
                  "Eq 103 for its ages, in the outlet's and in fresh liquid;"
                  " one in a hundred")
    found, error = run.mean_outlet()
    balanced, other = run.balanced_outlet()
    checks.add(f"{name}: rare earth of the liquid that leaves [-]", found,
               f"{balanced:.4g}", abs(found - balanced),
               0.02*balanced + min(3*np.hypot(error, other), 0.02*balanced),
               "balance: what the ore that leaves has lost; 2 %, and 3 standard"
               " errors up to 2 %")


def check(runs, checks):
    """Returns those whose means are long enough."""
    for name, run in runs.items():
        inputs(name, run, checks)
        conservation(name, run, checks)
    for name, run in runs.items():
        if run.is_long() and run.has_ended():
            checks.below(f"{name}: rare earth that the liquid stores, of what"
                         " it takes up [-]", run.drift(), STEADY,
                         "limit: the liquid is steady, too")
    judged = {n: r for n, r in runs.items() if r.is_steady()}
    for name, run in judged.items():
        valve(name, run, checks)
        recycle(name, run, checks)
        steady(name, run, checks)
    if len(judged) < len(runs):
        print("Some runs have no steady state to be judged yet.\n")
    return judged
