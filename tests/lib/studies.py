# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What the tests of cghsStudy share: its modules on the path; a case whose
#     solver is a script that takes no time, writes and fails as it is told.
#
#         case = toy_case("case", knobs="W { file constant/toy; ... }")
#         status, text = study(case, "-report")
# ------------------------------------------------------------------------------
"""Studies of a toy."""

import os
import subprocess
import sys
from pathlib import Path

PROJECT = Path(os.environ["PROJECT_DIR"])
PROGRAM = PROJECT / "applications" / "utilities" / "cghsStudy" / "cghsStudy"
sys.path[:0] = [str(PROGRAM.parent), str(PROJECT / "etc" / "python")]

# Writes every 'every' s. A value is bias plus noise by the seed. At the time
# 'crash' it ends as OpenFOAM does, with the seed 'unlucky' at 0.5; at 'hang' it
# waits to be killed. With 'loop 0' its log is as that of cghsReactor.
SOLVER = r'''#!/usr/bin/python3
import random
import re
import sys
import time
from pathlib import Path


def entry(path, name):
    return float(re.search(rf"^\s*{name}\s+(\S+);", Path(path).read_text(),
                           re.M)[1])


def toy(name):
    return entry("constant/toy", name)


end, every, bias = entry("system/controlDict", "endTime"), 0.1, toy("bias")
random.seed(f"{toy('seed')} {bias}")
start = max([float(p.name) for p in Path(".").glob("[0-9]*")], default=0)
print("nProcs : 1\nCreate time")
if toy("loop"):
    print("Starting time loop")


def opened(group, names):
    folder = Path(f"postProcessing/{group}/{start:g}")
    folder.mkdir(parents=True, exist_ok=True)
    file = open(folder / "parcels.dat", "w", buffering=1)
    file.write(f"# {names}\n")
    return file


table = opened("parcels", "time height")
indicators = opened("errorIndicators", "time deltaT maxOverlap")
step, n = 0.01, round(start/0.01)
while n < round(end/step):
    n += 1
    t = round(n*step, 6)
    print(f"Time = {t:g}\n\nspeed 3 of {bias}", flush=True)
    if t >= toy("crash") or (t >= 0.5 and toy("seed") == toy("unlucky")):
        print("\n--> FOAM FATAL ERROR: \nthe parcels have gone\n\n"
              "    From nowhere\n", flush=True)
        sys.exit(1)
    value = 1 + bias + toy("noise")*random.gauss(0, 1)
    table.write(f"{t:g} {float('nan') if t > toy('nan') else value}\n")
    indicators.write(f"{t:g} {step} 0.02\n")
    if n % round(every/step) == 0:
        place = Path(f"{t:g}")
        place.mkdir(exist_ok=True)
        for name in ("U", "p"):
            (place / name).write_text("a field\n// ****** //\n")
        if Path("stop").exists():
            print("USER REQUESTED ABORT")
            break
    if abs(t - toy("hang")) < 1e-9 and not Path("hung").exists():
        Path("hung").touch()
        time.sleep(60)
    time.sleep(toy("sleep"))
    print(f"ExecutionTime = {n*step*toy('cost'):g} s"
          f"  ClockTime = {2*n*step*toy('cost'):g} s\n", flush=True)
print("End")
'''

TOY = """
bias    0;
noise   0;
seed    1;
cost    100;
crash   1e9;
nan     1e9;
hang    1e9;
unlucky 0;
loop    1;
sleep   0;
"""

CONTROL = """
startFrom   startTime;
endTime     1;
"""

STUDY = """
knobs
{{
    {knobs}
}}
variants        {variants}
reference       {reference}
replicas        {replicas}
prepare         {prepare}
run             "./solver";
copy            (solver);
quantities
{{
    {quantities}
}}
{more}
"""

HEIGHT = "height { table parcels; column height; window (0 1); }"


def toy_case(name, knobs, variants="each;", reference="default;",
             replicas="1;", prepare="(true);", quantities=HEIGHT, more="",
             toy=TOY):
    """A new case in the folder of this name."""
    case = Path(name)
    for folder in ("0", "constant", "system"):
        (case / folder).mkdir(parents=True, exist_ok=True)
    (case / "constant/toy").write_text(toy)
    (case / "system/controlDict").write_text(CONTROL)
    (case / "solver").write_text(SOLVER)
    (case / "solver").chmod(0o755)
    write_study(case, knobs, variants, reference, replicas, prepare,
                quantities, more)
    return case


def write_study(case, knobs, variants="each;", reference="default;",
                replicas="1;", prepare="(true);", quantities=HEIGHT, more=""):
    (case / "system/studyDict").write_text(STUDY.format(
        knobs=knobs, variants=variants, reference=reference,
        replicas=replicas, prepare=prepare, quantities=quantities, more=more))


def plain_knob(name, entry, values):
    """One that sets an entry of the toy."""
    return (f'{name} {{ file "constant/toy"; entry {entry};'
            f" values ({values}); }}")


def study(case, *options):
    """Exit status, and all that is said."""
    done = subprocess.run([PROGRAM, "-case", case, *options], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          check=False)
    print(done.stdout)
    return done.returncode, done.stdout


def starts(case, run):
    """How often the solver of a run has been started."""
    log = case / "study" / run / "log.solver"
    return log.read_text().count("Starting time loop") if log.exists() else 0


def missing(text, *parts):
    """How many of the parts the text has not, which is said."""
    lost = [part for part in parts if part not in text]
    for part in lost:
        print(f"missing: {part}")
    return len(lost)
