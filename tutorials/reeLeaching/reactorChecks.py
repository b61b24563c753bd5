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

from leaching import leached_in, np, rate, series


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
                     "and flows [-]", defects[ion], 1e-5,
                     "balance: to the tolerance of p")
    for species in ("REEaq", "NH4"):
        checks.below(f"{name}: {species} from nowhere in the run, of what is "
                     "there [-]", run.species_defect(species), 1e-5,
                     "balance: to the tolerance of p")
    checks.below(f"{name}: ore there and gone, less that fed and what it has "
                 "taken up, of that at the start [-]", run.solids_defect(),
                 1e-9, "balance: none is lost, to the digits written")


def valve(name, run, checks):
    low = run.mass.min()
    checks.below(f"{name}: ore below the inventory, most [parcels]",
                 max(run.reactor.inventory - low, 0)/run.parcel_mass, 1.5,
                 "input: the valve lets none out below it; with what it loses")
    inside = run.time > run.window[0]
    checks.below(f"{name}: ore above the inventory, mean of the window [-]",
                 run.mass[inside].mean()/run.reactor.inventory - 1, 0.02,
                 "limit: what is above it is at the valve")


def recycle(name, run, checks):
    """What comes back has what has left: of the step before."""
    rows = series(run.case, "recycled")
    back = run.windowed(rows[:, 0], rows[:, 1])[0]
    checks.equal(f"{name}: rare earth of the liquid that comes back [-]", back,
                 run.mean_outlet()[0], 5e-3,
                 "input: the outlet's, of the step before")


def steady(name, run, checks):
    reactor = run.reactor
    a, error = run.leached_leaving()
    age = run.leaving("ageOfLeaving")
    tau = run.mean(run.mass)[0]/reactor.solids
    checks.add(f"{name}: age of the ore that leaves [s]", age[0],
               f"{tau:.4g}", abs(age[0] - tau), 0.03*tau + 3*age[1],
               "limit: ore there over feed; 3 %")
    checks.within(f"{name}: leached, of the ore that leaves [-]", a,
                  reactor.poorest(1) - 3*error,
                  leached_in(rate(run.diameter), age[0], None) + 3*error,
                  "Eq 103: mixed in the outlet's liquid, plug flow in fresh")
    found, error = run.mean_outlet()
    balanced, other = run.balanced_outlet()
    checks.add(f"{name}: rare earth of the liquid that leaves [-]", found,
               f"{balanced:.4g}", abs(found - balanced),
               0.02*balanced + 3*np.hypot(error, other),
               "balance: what the ore that leaves has lost; 2 %")


def check(runs, checks):
    """Returns those whose means are long enough."""
    for name, run in runs.items():
        inputs(name, run, checks)
        conservation(name, run, checks)
    judged = {n: r for n, r in runs.items() if r.window and r.is_steady()}
    for name, run in judged.items():
        valve(name, run, checks)
        recycle(name, run, checks)
        steady(name, run, checks)
    if len(judged) < len(runs):
        print("Some runs are too short for a steady state to be judged yet.\n")
    return judged
