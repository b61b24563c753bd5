# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What the tutorials' evaluate and validate share in reading what a run has
#     left: inputs, series in time, means with errors. Each tutorial's module
#     finds the project and begins with
#
#         PROJECT = next((folder for folder in Path(__file__).resolve().parents
#                         if (folder / "etc" / "openfoam").exists()), None)
#         if PROJECT is None:
#             sys.exit(f"{Path(__file__).parent} is not within a cghsFoam")
#         sys.path.append(str(PROJECT / "tutorials" / "lib"))
#         from tutorial import np, of
# ------------------------------------------------------------------------------
"""Reading the runs of the tutorials."""

import re
import sys
from pathlib import Path

# The tutorial, as it calls itself in its messages
NAME = Path(sys.argv[0]).resolve().parent.name


def stop(message):
    sys.exit(f"{NAME}: {message}")


try:
    import numpy as np
except ImportError:
    stop("python3 has no numpy; remedy: "
         "apt-get install python3-numpy python3-matplotlib")

PROJECT = Path(__file__).resolve().parents[2]
sys.path.append(str(PROJECT / "tests" / "lib"))
import cghsTest as of  # noqa: E402

# Over so many blocks the statistical error of a mean is estimated, and the
# largest of the estimates is taken: where a bed pulsates, blocks that are no
# multiple of its period alone would flatter or scold it
BLOCKS = (5, 6, 8, 10)


# Inputs


def number(path, name, default=None):
    """The number that is the value of an entry of a dictionary's file."""
    text = path.read_text() if path.exists() else ""
    match = re.search(rf"(?:^|;)\s*{name}\s+({of._NUMBER})", text, re.M)
    if match:
        return float(match[1])
    if default is None:
        stop(f"{path} has no number {name}")
    return default


def vector(text, after):
    """The numbers in brackets that follow the pattern."""
    match = re.search(after + r"\s*\(([^()]*)\)", text)
    return np.array(match[1].split(), float)


# Series in time


def series(case, folder):
    """The tables of a function object, one row a time. A run that was continued
    has left one from each start: what came later stands."""
    files = sorted(
        (Path(case) / "postProcessing" / folder).glob("*/*.dat"),
        key=lambda path: path.stat().st_mtime,
    )
    rows = np.empty((0, 0))
    for path in files:
        new = of.table(path)
        if not new.size:
            continue
        old = rows[rows[:, 0] < new[0, 0]] if rows.size else new[:0]
        rows = np.vstack([old, new])
    if not rows.size:
        stop(f"{case} has no table of {folder}: run ./Allrun first")
    return rows


def column_names(case, folder):
    """What stands over the columns of a function object's table."""
    table = next((Path(case) / "postProcessing" / folder).glob("*/*.dat"))
    return table.read_text().splitlines()[0].lstrip("# ").split()


def block_error(blocks):
    """Standard error of a mean, from blocks(n) = the means of n blocks."""
    return np.max(
        [blocks(n).std(axis=0, ddof=1) / np.sqrt(n) for n in BLOCKS], axis=0
    )


# The run itself


def seconds(case, kind="ClockTime"):
    """What the solver has taken, over all its starts: ClockTime as on the wall,
    ExecutionTime of the processor [s]."""
    text = (Path(case) / "log.cghsFoam").read_text()
    return sum(
        float(part.rsplit(f"{kind} = ", 1)[1].split()[0])
        for part in text.split("Starting time loop")[1:]
        if f"{kind} = " in part
    )


def clock_series(case, kind="ClockTime"):
    """Simulated times, and what the solver had taken up to them over all its
    starts, as above [s]."""
    text = (Path(case) / "log.cghsFoam").read_text()
    steps = re.findall(
        rf"^Time = (\S+)$(?:(?!^Time =).*\n)*?.*\b{kind} = (\S+)", text, re.M)
    time, spent = np.array(steps, float).reshape(-1, 2).T
    again = np.diff(spent, prepend=0)
    again[again < 0] = spent[again < 0]
    return time, np.cumsum(again)


def ranks(case):
    text = (Path(case) / "log.cghsFoam").read_text()
    return int(re.search(r"nProcs\s*:\s*(\d+)", text)[1])
