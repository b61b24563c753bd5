# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     The program: options, runs, report, exit status.
# ------------------------------------------------------------------------------
"""What cghsStudy does when it is called."""

import argparse
import sys
import time
from pathlib import Path

from study.report import Report
from study.results import Results, from_data
from study.runFolder import FAILED, FINISHED, RunFolder
from study.runner import Runner, say
from study.settings import Study
from study.studyError import StudyError

HELP = """\
Runs variants of a case, and replicas of them, and writes what error each
has against a reference and what it costs: study/report/report.md,
table.csv and plots. The dictionary names knobs, reference, replicas and
quantities; all of its entries are in doc/errorAgainstTime.md.

Each run is in study/VARIANT/REPLICA. What is finished is not run again;
what was paused or killed goes on from its last complete time; what would
come out otherwise by now, as the case or the dictionary has changed, is
run anew, and what was there is kept as REPLICA.stale. Variants that fail
stay in the report with their reason."""

STATUS = """\
exit status: 0 if the report is written, even if variants have failed, or
if the study pauses; 1 if all replicas of the reference have failed, or all
variants have, or a dictionary is wrong; 2 for a wrong option. What has a
failed replica is not recommended; if that is the reference, nothing is."""


def parse(arguments):
    parser = argparse.ArgumentParser(
        prog="cghsStudy", description=HELP, epilog=STATUS, add_help=False,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False)
    add = parser.add_argument
    add("-case", type=Path, default=Path("."), metavar="DIR",
        help="the case, by default the current folder")
    add("-dict", type=Path, metavar="FILE",
        help="the dictionary in place of the case's system/studyDict")
    add("-hours", type=hours, metavar="H",
        help="pause after so much time: the next time that a run writes is its"
             " last, the same command goes on")
    ranks = parser.add_mutually_exclusive_group()
    ranks.add_argument("-serial", action="store_true",
                       help="each new run on one core: the default")
    ranks.add_argument("-np", type=cores, default=1, metavar="N",
                       help="each new run on N cores")
    add("-list", action="store_true",
        help="show variants and the state of their runs, run nothing")
    add("-report", action="store_true",
        help="write the report of what there is, run nothing")
    add("-help", action="help", help="show this")
    return parser.parse_args(arguments)


def hours(text):
    value = float(text)
    if not value >= 0:
        raise ValueError
    return value


def cores(text):
    value = int(text)
    if value < 1:
        raise ValueError
    return value


def show_runs(study):
    """One line for each."""
    for variant, replica in study.pairs():
        run = RunFolder(study, variant, replica)
        state, reason = run.state()
        what = " (reference)" if variant == study.reference else ""
        say(f"{run.name}{what}: {study.describe(variant)}: {state}"
            + (f": {reason}" if reason else ""))


def check_inputs(study):
    """All that is wrong with entries of the case, and of data, is said before
    anything is run."""
    if study.data is not None:
        for quantity in study.quantities:
            from_data(study.data, quantity)
    for variant, replica in study.pairs():
        RunFolder(study, variant, replica).state()


def failures(results):
    """What makes the study itself fail, or none."""
    outcomes = results.outcomes.values()
    if results.study.data is None and all(
            state == FAILED for state, _ in results.reference.states):
        return "the reference has failed: " + results.reference.states[0][1]
    if all(state == FAILED for o in outcomes for state, _ in o.states):
        return "all variants have failed"
    return None


def conclude(study):
    results = Results(study)
    paused = any(state not in (FINISHED, FAILED)
                 for o in results.outcomes.values() for state, _ in o.states)
    report = Report(results, paused)
    report.write()
    say("")
    if report.warnings():
        say(report.warnings() + "\n")
    say(report.recommendations())
    say(f"\nreport: {report.folder / 'report.md'}")
    failure = failures(results)
    if failure:
        print(f"cghsStudy: FAILED: {failure}", file=sys.stderr)
    return 1 if failure else 0


def study_case(options):
    case = options.case.resolve()
    study = Study(case, options.dict or case / "system" / "studyDict")
    check_inputs(study)
    if options.list:
        show_runs(study)
        return 0
    if not options.report:
        late = (float("inf") if options.hours is None
                else time.monotonic() + 3600*options.hours)
        if not Runner(study, options.np, late).run_all():
            say("paused: the same command goes on")
    return conclude(study)


def main(arguments):
    options = parse(arguments)
    try:
        return study_case(options)
    except StudyError as error:
        print(f"cghsStudy: error: {error}", file=sys.stderr)
    except KeyboardInterrupt:
        print("\ncghsStudy: interrupted: the same command goes on",
              file=sys.stderr)
    return 1
