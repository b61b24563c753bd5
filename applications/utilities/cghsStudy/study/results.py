# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     All that a study has found out so far: of each variant what became of its
#     runs, estimates of the quantities, their errors against the reference, and
#     what a simulated second costs. Of what is stale nothing counts.
# ------------------------------------------------------------------------------
"""Collecting what the runs have left."""

import re
from dataclasses import dataclass, field

import numpy as np

import runLog
from study.quantities import NotMeasured
from study.runFolder import FAILED, FINISHED, RunFolder
from study.statistics import (
    Estimate, are_identical, compare, over_replicas, pareto_front)

DATA = "the data"   # the name of a reference from a file


@dataclass
class Outcome:
    """Of a variant. Costs are seconds for a simulated second."""
    name: str
    states: list                                    # (state, reason) by replica
    estimates: dict = field(default_factory=dict)   # by quantity
    missing: dict = field(default_factory=dict)     # why there is none
    comparisons: dict = field(default_factory=dict)
    processor: float = np.nan
    wall: float = np.nan
    ranks: int = 1

    def finished(self):
        return sum(state == FINISHED for state, _ in self.states)

    def failed(self):
        return sum(state == FAILED for state, _ in self.states)

    def problems(self):
        """Reasons of replicas that are not finished, and of what is not
        measured, each once."""
        found = [f"{state}: {reason}" if reason else state
                 for state, reason in self.states if state != FINISHED]
        found += [f"{name}: {why}" for name, why in self.missing.items()]
        return list(dict.fromkeys(found))

    def is_usable(self, quantities):
        """A variant that fails in one of its replicas cannot be relied upon;
        one of which some are still to be run can, by the others."""
        return (not self.failed()
                and all(q.name in self.comparisons for q in quantities))


class Results:
    """Of a study."""

    def __init__(self, study):
        self.study = study
        self.outcomes = {name: self._outcome(name) for name in study.variants}
        self.reference = self._reference()
        for outcome in self.outcomes.values():
            self._compare(outcome)

    # Of a variant

    def _outcome(self, name):
        runs = [RunFolder(self.study, name, replica + 1)
                for replica in range(self.study.replicas)]
        made = Outcome(name, [run.state() for run in runs])
        whole = [run for run, (state, _) in zip(runs, made.states)
                 if state == FINISHED]
        for quantity in self.study.quantities:
            self._estimate(made, quantity, whole)
        if are_identical(made.estimates.values()):
            made.estimates = {name: estimate.without_noise_known() for
                              name, estimate in made.estimates.items()}
        self._cost(made, whole)
        return made

    def _estimate(self, outcome, quantity, runs):
        """From the runs that have it; one without spoils it for all, as a run
        that diverges is no chance."""
        if not runs:
            return
        try:
            outcome.estimates[quantity.name] = over_replicas(
                [quantity.measure(run) for run in runs],
                self.study.deterministic)
        except NotMeasured as why:
            outcome.missing[quantity.name] = str(why)

    def _cost(self, outcome, runs):
        """Means over the replicas."""
        texts = [run.log_text() for run in runs]
        if not texts:
            return
        start = self.study.cost_from
        outcome.ranks = runs[0].note().get("ranks", 1)
        outcome.processor = outcome.ranks*np.mean(
            [runLog.cost(text, "ExecutionTime", start) for text in texts])
        if not outcome.processor > 0:
            outcome.processor = np.nan      # less than the clock can tell
        outcome.wall = np.mean(
            [runLog.cost(text, "ClockTime", start) for text in texts])

    # The reference

    def _reference(self):
        if self.study.data is None:
            return self.outcomes[self.study.reference]
        made = Outcome(DATA, [])
        for quantity in self.study.quantities:
            made.estimates[quantity.name] = from_data(
                self.study.data, quantity)
        made.processor = self.study.data.number("processorSeconds", np.nan)
        return made

    def _compare(self, outcome):
        for quantity in self.study.quantities:
            name = quantity.name
            if name in outcome.estimates and name in self.reference.estimates:
                outcome.comparisons[name] = compare(
                    outcome.estimates[name], self.reference.estimates[name],
                    quantity, self.study.paired)
                if self.reference.failed():
                    outcome.comparisons[name].doubt_it(
                        "a replica of the reference has failed")

    # What follows

    def reference_failed(self):
        return self.study.data is None and not self.reference.finished()

    def identical(self):
        """Names of variants whose replicas are."""
        return [o.name for o in self.outcomes.values()
                if any(e.same for e in o.estimates.values())]

    def is_cheaper(self, outcome):
        """Than the reference, if that can be run in its place."""
        base = self.reference.processor
        return (self.study.reference is None or self.reference.failed()
                or not np.isfinite(base) or outcome.processor < base)

    def speed_ratio(self, outcome):
        """To the reference, or to what costs most where that is data."""
        base = self.reference.processor
        if not np.isfinite(base):
            costs = [o.processor for o in self.outcomes.values()]
            base = np.nanmax(costs) if np.isfinite(costs).any() else np.nan
        return base/outcome.processor

    def slowest_name(self):
        if np.isfinite(self.reference.processor):
            return "the reference"
        return "the slowest variant"

    def candidates(self, quantities):
        """Those that a sentence may recommend."""
        return [outcome for name, outcome in self.outcomes.items()
                if name != self.study.reference
                and outcome.is_usable(quantities)
                and np.isfinite(outcome.processor)]

    def points(self, quantities):
        """Cost and error, the worst of the quantities, by variant."""
        return {o.name: (o.processor, max(
            o.comparisons[q.name].seen() for q in quantities))
            for o in self.candidates(quantities)
            if all(np.isfinite(o.comparisons[q.name].error)
                   for q in quantities)}

    def front(self, quantities):
        return pareto_front(self.points(quantities))


def from_data(data, quantity):
    """An estimate that a file gives: value and error (68 %), or, of a profile,
    lists of coordinate, value and error."""
    if not data.has(quantity.name):
        data.fail(quantity.name, "is missing", (), "give its value and error")
    block = data.block(quantity.name)
    value = np.array(block.numbers("value"))
    error = np.array(block.numbers("error", [0]))
    if quantity.type == "profile":
        x = np.array(block.numbers("coordinate", n=value.size))
        inside = (x >= quantity.range[0]) & (x <= quantity.range[1])
        error = np.broadcast_to(error, value.shape)[inside]
        made = value[inside], error, x[inside]
    else:
        if value.size != 1:
            block.fail("value", f"has {value.size} numbers in place of one")
        made = float(value[0]), float(error[0]), None
    block.refuse_others()
    return Estimate(made[0], made[1], np.inf, "data", (), made[2])


def short_windows(results):
    """Windows that cannot tell their errors: quantity, variant, why."""
    for outcome in results.outcomes.values():
        for name, estimate in outcome.estimates.items():
            if not estimate.enough:
                for note in estimate.notes:
                    yield name, outcome.name, note


def worst(notes):
    """Of several windows that are too short the one that needs most."""
    def needed(note):
        found = re.search(r"at least ([\d.e+-]+) s", note)
        return float(found[1]) if found else 0
    return max(notes, key=needed)
