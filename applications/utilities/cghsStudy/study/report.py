# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     The report: study/report/report.md with its plots, and table.csv with a
#     row for each variant and quantity.
# ------------------------------------------------------------------------------
"""Writing the report."""

import csv

import numpy as np

from pageParts import as_table
from study.plots import draw
from study.results import short_windows, worst
from study.sentences import Sentences, percent

COLUMNS = (
    "variant", "replicas finished", "replicas", "quantity", "unit", "value",
    "standard error", "degrees of freedom", "error from",
    "window long enough", "reference value", "bias (share)",
    "noise of bias (share)", "bias told from zero", "bias bound 95 % (share)",
    "processor s per s", "wall s per s", "speed ratio", "Pareto front",
    "problems")


def number(x, digits=3):
    return f"{x:.{digits}g}" if np.isfinite(x) else "?"


def with_error(value, error):
    """Both to the digits that the error has."""
    if not np.isfinite(value):
        return "?"
    if not np.isfinite(error):
        return f"{value:.4g} ± ?"
    if not error > 0:
        return f"{value:.5g}"
    digits = max(int(np.floor(np.log10(abs(value) or error)))
                 - int(np.floor(np.log10(error))) + 2, 2)
    return f"{value:.{min(digits, 6)}g} ± {error:.2g}"


class Report:
    """Of a study's results, in a folder."""

    def __init__(self, results, paused):
        self.results, self.study = results, results.study
        self.paused = paused
        self.sentences = Sentences(results).all()
        self.folder = self.study.folder / "report"

    def write(self):
        self.folder.mkdir(parents=True, exist_ok=True)
        for old in self.folder.glob("*.png"):
            old.unlink()
        self.drawn = draw(self.results, self.folder)
        (self.folder / "report.md").write_text(self.page())
        with open(self.folder / "table.csv", "w", newline="") as out:
            csv.writer(out).writerows([COLUMNS, *self.rows()])

    # table.csv

    def rows(self):
        for outcome in self.results.outcomes.values():
            for quantity in self.study.quantities:
                yield [*self._of_run(outcome), quantity.name, quantity.unit,
                       *self._of_value(outcome, quantity.name),
                       *self._of_bias(outcome, quantity.name),
                       *self._of_cost(outcome, quantity)]

    def _of_run(self, outcome):
        return outcome.name, outcome.finished(), len(outcome.states)

    @staticmethod
    def _of_value(outcome, name):
        found = outcome.estimates.get(name)
        if found is None:
            return [""]*5
        return (f"{found.number():.8g}", f"{found.noise():.4g}",
                f"{found.freedom:.4g}", found.source,
                "yes" if found.enough else "no")

    def _of_bias(self, outcome, name):
        reference = self.results.reference.estimates.get(name)
        found = outcome.comparisons.get(name)
        value = "" if reference is None else f"{reference.number():.8g}"
        if found is None or outcome.name == self.study.reference:
            return [value, "", "", "", ""]
        return [value, f"{found.error:.4g}", f"{found.noise:.4g}",
                "yes" if found.distinct else "no", f"{found.bound():.4g}"]

    def _of_cost(self, outcome, quantity):
        front = self.results.front([quantity])
        return [f"{outcome.processor:.5g}", f"{outcome.wall:.5g}",
                f"{self.results.speed_ratio(outcome):.4g}",
                "yes" if outcome.name in front else "no",
                "; ".join(outcome.problems())]

    # report.md

    def page(self):
        parts = [
            "# Error against time", self.introduction(), self.warnings(),
            "## What to use", self.recommendations(),
            "## What it costs", self.costs(), self.picture("all")]
        for quantity in self.study.quantities:
            parts += [f"## {quantity.header()}", self.measure(quantity),
                      self.values(quantity), self.picture(quantity.name)]
            if quantity.type == "profile" and self.drawn:
                parts.append(f"![profile](profile-{quantity.name}.png)")
        parts += ["## Windows", self.windows(), "## How to read this", READING]
        return "\n\n".join(part for part in parts if part) + "\n"

    def introduction(self):
        study = self.study
        reference = (f"variant `{study.reference}`"
                     f" ({study.describe(study.reference)})"
                     if study.reference else f"data in `{study.data.file}`")
        replicas = ("which do not differ by chance" if study.deterministic
                    else f"{study.replicas} replica"
                         f"{'s' if study.replicas > 1 else ''} of each")
        knobs = ", ".join(study.varied()) or "none"
        return (f"Knobs: {knobs}. Variants: {len(study.variants)}, {replicas}."
                f" Reference: {reference}.")

    def warnings(self):
        lines = []
        if self.paused:
            lines.append("**Not all runs are finished.** The same command goes"
                         " on.")
        if self.results.reference_failed():
            lines.append("**The reference has not run to its end**, so that"
                         " there are no errors.")
        lines += self._failed_replicas() + self._identical_replicas()
        return "\n\n".join(lines)

    def _failed_replicas(self):
        reference = self.results.reference
        if not reference.failed() or self.results.reference_failed():
            return []
        return [f"**{reference.failed()} of {len(reference.states)} replicas of"
                " the reference have failed:** "
                + "; ".join(reference.problems())
                + ". Errors are against the others, so that nothing is certain:"
                " it may be that just these have not come to what failed."]

    def _identical_replicas(self):
        names, study = self.results.identical(), self.study
        if not names:
            return []
        entries = ", ".join(f"`{entry}` of `{file}`"
                            for file, entry in study.seeds.targets)
        return ["**Replicas are identical to all digits** in "
                + ", ".join(f"`{name}`" for name in names)
                + f": {entries} has no effect there, and noise is not known."
                " Remedy: name in `replicas` an entry that the run depends on,"
                " such as the seed of what places the parcels, and see that"
                " `prepare` reads it; or write `deterministic yes;` if chance"
                " has no part in these runs."]

    def recommendations(self):
        return "\n".join(f"- {sentence}" for group in self.sentences.values()
                         for sentence in group)

    def costs(self):
        rows = []
        for outcome in self.results.outcomes.values():
            name = outcome.name
            rows.append((
                f"`{name}`", f"{outcome.finished()} of {len(outcome.states)}",
                number(outcome.processor), number(outcome.wall),
                number(self.results.speed_ratio(outcome)),
                self._remark(outcome)))
        return ("Seconds for a simulated second, without the first step of each"
                " start.\n\n" + as_table(rows, (
                    "variant", "runs finished", "processor", "wall",
                    "speed ratio", "remarks")))

    def _remark(self, outcome):
        remarks = [self.study.describe(outcome.name)]
        if outcome.name == self.study.reference:
            remarks.append("reference")
        elif outcome.name in self.results.front(self.study.quantities):
            remarks.append("on the Pareto front")
        remarks += [f"**{problem}**" for problem in outcome.problems()]
        return "; ".join(remarks).replace("|", "\\|")

    def measure(self, quantity):
        if quantity.type != "profile":
            return ""
        return ("A profile; values are its mean. Its error is the root of the"
                " mean square of the difference along it, less what noise"
                f" makes, over the reference's {quantity.relative_to}.")

    def values(self, quantity):
        rows = []
        for outcome in self.results.outcomes.values():
            estimate = outcome.estimates.get(quantity.name)
            if estimate is None:
                rows.append((f"`{outcome.name}`", "-", "-", "-", "-", "-",
                             "; ".join(outcome.problems())))
                continue
            rows.append((
                f"`{outcome.name}`",
                with_error(estimate.number(), estimate.noise()),
                *self._errors(outcome, quantity.name),
                number(outcome.processor),
                estimate.source
                + ("" if estimate.enough else ", **window too short**")))
        return as_table(rows, (
            "variant", f"value ± standard error {quantity.unit}".strip(),
            "bias ± noise", "bias", "at most (95 %)", "processor s per s",
            "error from"))

    def _errors(self, outcome, name):
        """Shares of the reference as texts: bias with noise, verdict, bound."""
        if outcome.name == self.study.reference:
            return "0", "reference", "0"
        found = outcome.comparisons.get(name)
        if found is None or not np.isfinite(found.error):
            return "?", "?", "?"
        known = found.is_known()
        verdict = ("told from zero" if found.distinct else
                   "not told from noise" if known else
                   " and ".join(found.doubts) or "noise not known")
        bias = with_error(100*found.error, 100*found.noise) + " %"
        return bias, verdict, percent(found.bound()) if known else "?"

    def picture(self, name):
        if name not in self.drawn:
            return ""
        return f"![error over processor time]({self.drawn[name]})"

    def windows(self):
        """One line for each quantity, with the window that needs most."""
        found = {}
        for name, variant, note in short_windows(self.results):
            found.setdefault(name, {})[f"`{variant}`, {note}"] = variant
        if not found:
            return ("All windows are long enough for their correlation times,"
                    " as far as these are known.")
        lines = [f"- {name}: too short in"
                 f" {', '.join(dict.fromkeys(notes.values()))}. Most is needed"
                 f" in {worst(notes)}." for name, notes in found.items()]
        lines.append(
            "\nErrors by correlation time may be larger there than they say."
            " Errors over replicas do not mind, but means may still remember"
            " the start.")
        return "\n".join(lines)


READING = """\
- **Bias**: value less the reference's, as a share of the reference;
  systematic error, as well as it is known.
- **Noise**: standard error of that, from variant and reference together.
- **Told from zero**: chance alone would make such a bias in 5 of 100 studies
  at most. What is not told from noise is not known to be an error; neither is
  it known to be none: see the bound.
- **At most**: bias and its 95 % interval, by Student's t. With two replicas
  that is 13 times the noise, with four 2.4 to 3.2 times. *Use* is said of
  what keeps that.
- **Points** of the plots are at the bias, or at its noise where that is
  larger. Hollow ones are not told from noise. Nothing is both cheaper and
  better than what the Pareto front joins.
- Errors are those against the reference. What that is off itself is not in
  them."""
