#!/usr/bin/python3
# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
# ------------------------------------------------------------------------------
"""watch.py LOG COMMAND...: run a solver with its output in LOG, and write into
LOG.memory the memory [bytes] that is resident after its last step and the most
that ever was."""

import re
import subprocess
import sys
from pathlib import Path

log, *command = sys.argv[1:]


def resident(pid):
    status = Path(f"/proc/{pid}/status").read_text()
    return [
        1024 * int(re.search(rf"{name}:\s+(\d+) kB", status)[1])
        for name in ("VmRSS", "VmHWM")
    ]


with open(log, "w", encoding="utf-8") as out, subprocess.Popen(
    command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
) as solver:
    memory = None
    for line in solver.stdout:
        out.write(line)
        # The first lines of a step: the step before is done
        if line.startswith("Time = "):
            memory = resident(solver.pid)

if solver.returncode != 0 or memory is None:
    sys.exit(f"{' '.join(command)} ended with {solver.returncode}, see {log}")

Path(log + ".memory").write_text(f"{memory[0]} {memory[1]}\n")
