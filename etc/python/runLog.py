# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What the log of a solver says of its steps: times, what they have cost,
#     numbers of each. A run that was interrupted and went on has several starts
#     in one log, and may have taken some steps twice.
# ------------------------------------------------------------------------------
"""Reading the text of a solver's log."""

import re

import numpy as np

from caseFiles import NUMBER


def starts(text):
    """The parts of a log from each start of the solver on. cghsReactor says
    nothing of its loop; all that make a Time say that."""
    for words in ("Starting time loop", "Create time"):
        if words in text:
            return text.split(words)[1:]
    return [text]


def seconds(text, kind="ClockTime"):
    """What the solver has taken, over all its starts: ClockTime as on the wall,
    ExecutionTime of the processor [s]."""
    return sum(
        float(part.rsplit(f"{kind} = ", 1)[1].split()[0])
        for part in starts(text)
        if f"{kind} = " in part
    )


def clock_series(text, kind="ClockTime"):
    """Simulated times, and what the solver had taken up to them over all its
    starts, as above [s]."""
    steps = re.findall(
        rf"^Time = (\S+)$(?:(?!^Time =).*\n)*?.*\b{kind} = (\S+)", text, re.M)
    time, spent = np.array(steps, float).reshape(-1, 2).T
    again = np.diff(spent, prepend=0)
    again[again < 0] = spent[again < 0]
    return time, np.cumsum(again)


def cost(text, kind="ExecutionTime", start=0):
    """What a simulated second has taken from the time start on [s], by one
    process. The first step after each start of the solver, which pays for
    reading the case, does not count, nor do steps that were taken anew. If
    there is but one in each start, all that was taken from 0 on counts."""
    pieces = {}
    for part in starts(text):
        time, spent = clock_series(part, kind)
        for t in time[:1]:
            pieces = {end: piece for end, piece in pieces.items() if end < t}
        pieces.update(zip(time[1:], zip(np.diff(time), np.diff(spent))))
    if not pieces:
        time, spent = clock_series(starts(text)[-1], kind)
        pieces = dict(zip(time, zip(time, spent)))
    counted = [piece for end, piece in pieces.items() if end > start]
    simulated, taken = np.sum(counted, axis=0) if counted else (0, 0)
    return taken/simulated if simulated > 0 else np.nan


def ranks(text):
    return int(re.search(r"nProcs\s*:\s*(\d+)", text)[1])


def steps(text, pattern):
    """Time and the number that the pattern finds in each step that has one. A
    run that was interrupted ends with half a step, and makes those after the
    last time written anew when it goes on: the last stand."""
    found = {}
    for step in text.split("\nTime = ")[1:]:
        match = pattern.search(step)
        if match:
            time = float(step.split(None, 1)[0])
            while found and next(reversed(found)) >= time:
                found.popitem()
            found[time] = float(match[1])
    return found


def number_after(words):
    """The pattern of a number that follows the words in a line."""
    return re.compile(rf"{words}[ =:]*({NUMBER})")


def fatal_error(text):
    """What the last FATAL error says, in one line, or none. OpenFOAM puts the
    message on the lines after the word, until an empty one."""
    found = re.findall(r"FOAM FATAL (?:IO )?ERROR:?[^\n]*\n((?:.*\S.*\n)+)",
                       text)
    return " ".join(found[-1].split()) if found else None
