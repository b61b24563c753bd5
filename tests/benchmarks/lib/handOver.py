#!/usr/bin/python3
# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
# ------------------------------------------------------------------------------
"""handOver.py SOURCE TIME CASE...: let DPMFoam and MPPICFoam start from the
state that cghsFoam has reached: parcels with their velocities, gas velocity
and pressure. All that the two want to read for their parcels is written, most
of it zero: contacts have no history."""

import os
import re
import sys
from pathlib import Path

root = os.environ["PROJECT_DIR"] + "/tests"
sys.path += [root + "/lib", root + "/benchmarks/lib"]
import cghsTest as of
import cloudFiles as cf

ZERO = (0.0, 0.0, 0.0)

# KinematicParcel, then MPPICParcel, then CollidingParcel
FIELDS = {
    "labelField": {"active": 1, "typeId": 1},
    "scalarField": {
        "nParticle": 1.0, "d": 2.5e-3, "dTarget": 2.5e-3, "rho": 2526.0,
        "age": 0.0, "tTurb": 0.0,
    },
    "vectorField": {
        "UTurb": ZERO, "UCorrect": ZERO,
        "f": ZERO, "angularMomentum": ZERO, "torque": ZERO,
    },
    "labelFieldField": {
        "collisionRecordsPairAccessed": "0()",
        "collisionRecordsPairOrigProcOfOther": "0()",
        "collisionRecordsPairOrigIdOfOther": "0()",
        "collisionRecordsWallAccessed": "0()",
    },
    "vectorFieldField": {
        "collisionRecordsPairData": "0()",
        "collisionRecordsWallPRel": "0()",
        "collisionRecordsWallData": "0()",
    },
}


def write_cloud(folder, block, x, v):
    folder.mkdir(parents=True, exist_ok=True)
    n = len(x)
    cf.write_positions(folder, "kinematicCloud", x, block.cell(x))
    cf.write_ids(folder, n)
    cf.write_field(folder, "U", "vectorField", v, n)
    for kind, fields in FIELDS.items():
        for name, value in fields.items():
            cf.write_field(folder, name, kind, value, n)


def set_internal(path, kind, values):
    """Replace the cell values in a field file; boundary values that refer to
    them are those of the tutorials, zero."""
    rows = "\n".join(map(cf.text_of, values))
    text = path.read_text().replace("binary", "ascii")
    text = text.replace("$internalField", "uniform 0")
    path.write_text(
        re.sub(
            r"internalField[^;]*;",
            f"internalField nonuniform List<{kind}>\n{len(values)}\n"
            f"(\n{rows}\n)\n;",
            text,
            count=1,
        )
    )


source, time, *cases = sys.argv[1:]
block = cf.Block((-0.0075, -0.075, 0), (0.0075, 0.075, 0.45), (2, 30, 90))
x = of.cloud_field(source, time, "parcels", "position")
v = of.cloud_field(source, time, "parcels", "U")

for case in map(Path, cases):
    write_cloud(case / "0/lagrangian/kinematicCloud", block, x, v)
    set_internal(case / "0/U.air", "vector", of.field(source, time, "U"))
    set_internal(case / "0/p", "scalar", of.field(source, time, "p"))
