# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What a study recommends, in sentences. A variant keeps an error if the
#     estimate and its 95 % interval are below it. One whose estimate is, but
#     whose interval is not, may keep it; that is said, too, and never more. The
#     same goes for one whose noise is not to be relied upon: windows too short
#     for one run, replicas that are identical or have failed. What costs as
#     much as the reference is not recommended.
# ------------------------------------------------------------------------------
"""Plain sentences."""

from dataclasses import dataclass

import numpy as np


def percent(share):
    return f"{100*share:.2g} %"


def times(ratio):
    """A ratio of speeds in words."""
    if not np.isfinite(ratio):
        return "at a cost that is not known"
    if abs(ratio - 1) < 0.005:
        return "as fast as"
    if ratio > 1:
        return f"{ratio:.2g} times faster than" if ratio < 99.5 else (
            f"{ratio:.0f} times faster than")
    return f"{1/ratio:.2g} times slower than"


def listed(words):
    """'1, 5 or 10'."""
    head, last = words[:-1], words[-1]
    return f"{', '.join(head)} or {last}" if head else last


@dataclass
class Choice:
    """Of a threshold."""
    certain: object = None      # cheapest that keeps it for sure
    likely: object = None       # cheapest that may
    dearer: object = None       # cheapest that does, but not than the reference
    best: object = None         # that of the least error, whatever it is
    hidden: bool = False        # may the noise of one hide that it keeps it?


def choose(results, quantities, threshold):
    """Among all but the reference."""
    made = Choice()
    found = [(outcome, [outcome.comparisons[q.name] for q in quantities])
             for outcome in results.candidates(quantities)]
    found = [(o, c) for o, c in found
             if all(np.isfinite(x.error) for x in c)]
    for outcome, comparisons in sorted(found, key=lambda f: f[0].processor):
        if not results.is_cheaper(outcome):
            if all(abs(c.error) <= threshold for c in comparisons):
                made.dearer = made.dearer or outcome
        elif all(c.bound() <= threshold for c in comparisons):
            made.certain = made.certain or outcome
        elif all(abs(c.error) <= threshold for c in comparisons):
            made.likely = made.likely or outcome
        made.hidden |= not any(c.least() > threshold for c in comparisons)
    if found:
        made.best = min(found, key=lambda f: max(
            c.seen() if np.isfinite(c.noise) else abs(c.error)
            for c in f[1]))[0]
    return made


class Sentences:
    """Of a study's results."""

    def __init__(self, results):
        self.results, self.study = results, results.study

    def all(self):
        """By quantity, then for all of them at once: lists of sentences."""
        groups = {q.label: [q] for q in self.study.quantities}
        if len(groups) > 1:
            groups["all quantities at once"] = self.study.quantities
        return {label: self.of_group(label, quantities)
                for label, quantities in groups.items()}

    def of_group(self, label, quantities):
        """Errors for which the same is to be said share a sentence."""
        same = {}
        for threshold in self.study.thresholds:
            said = self.sentence(quantities, 0.01*threshold)
            same.setdefault(said, []).append(f"{threshold:g}")
        return [f"For {listed(numbers)} % error in {label} {said}"
                for said, numbers in same.items()]

    def sentence(self, quantities, threshold):
        """What follows 'For 5 % error in pressure drop'."""
        choice = choose(self.results, quantities, threshold)
        if choice.best is None:
            return f"nothing can be said: {self._why_not(quantities)}."
        likely = self._likely(choice, quantities)
        if choice.certain:
            return (f"use {self._what(choice.certain)}"
                    f" ({self._errors(choice.certain, quantities)}).{likely}")
        best = choice.best
        instead = self._instead()
        if choice.likely:
            known = all(choice.likely.comparisons[q.name].is_known()
                        for q in quantities)
            why = "is too large to tell" if known else "is not known"
            which = "cheaper variant" if choice.dearer else "variant"
            remedy = (" More replicas or longer windows would tell; until then"
                      f" {instead}." if not self.results.reference.failed()
                      else f" First {instead}.")
            return f"no {which} is certain to do: noise {why}.{likely}{remedy}"
        if choice.dearer:
            return (f"{instead}, as no cheaper variant will do: of the others"
                    f" the cheapest is {self._what(choice.dearer)}.")
        verdict = ("is known to do, though noise may hide one that does"
                   if choice.hidden else "will do")
        return (f"no variant {verdict}: {self._best(best, quantities)}."
                f" So {instead}.")

    def _instead(self):
        """Of a variant."""
        if self.results.reference.failed():
            return "see why the reference has failed"
        return "use the reference" if self.study.reference else "refine further"

    def _why_not(self, quantities):
        results = self.results
        if any(q.name not in results.reference.estimates for q in quantities):
            return "the reference has no value yet"
        if results.candidates(quantities):
            return "the reference is zero; give the quantity a 'scale'"
        others = [results.outcomes[name] for name in self.study.others()]
        if not any(o.finished() for o in others):
            return "no variant has run to its end"
        if any(o.is_usable(quantities) for o in others):
            return ("what variants cost is not known, as their logs have no"
                    " ExecutionTime after costFrom, or one of 0")
        return ("each variant has a replica that has failed or is not finished,"
                " or no value of this")

    def _what(self, outcome):
        ratio = self.results.speed_ratio(outcome)
        base = self.results.slowest_name()
        speed = (times(ratio) + (f" {base}" if np.isfinite(ratio) else ""))
        if base == "the slowest variant" and ratio == 1:
            speed = "itself the slowest variant"
        return f"{self.study.describe(outcome.name)}: {speed}"

    def _errors(self, outcome, quantities):
        """'error 1.2 ± 0.3 %'; of several the worst."""
        worst = max((outcome.comparisons[q.name] for q in quantities),
                    key=lambda c: c.bound())
        if not worst.noise > 0:
            return f"error {percent(abs(worst.error))}"
        return (f"error {percent(abs(worst.error))}, at most"
                f" {percent(worst.bound())} with 95 % confidence")

    def _likely(self, choice, quantities):
        """Of one that may keep it, if that is cheaper than what does."""
        likely = choice.likely
        if likely is None or (choice.certain and likely.processor
                              > choice.certain.processor):
            return ""
        worst = max((likely.comparisons[q.name] for q in quantities),
                    key=lambda c: c.bound())
        known = (f"only {percent(worst.bound())} can be vouched for"
                 if worst.is_known() else " and ".join(worst.doubts)
                 or "its noise is not known")
        return (f" {self._what(likely)} may do: its error is estimated at"
                f" {percent(abs(worst.error))}, but {known}.")

    def _best(self, outcome, quantities):
        worst = max((outcome.comparisons[q.name] for q in quantities),
                    key=lambda c: abs(c.error))
        noise = (f" ± {percent(worst.noise)}" if worst.noise > 0 else "")
        return (f"the least error is that of"
                f" {self.study.describe(outcome.name)},"
                f" {percent(abs(worst.error))}{noise}")
