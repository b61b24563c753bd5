# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What all parts of the matrix ask of a case: that no number in any file
#     that it has written is nan or infinite, whether it came to its end or not.
# ------------------------------------------------------------------------------
"""Judging the cases of the stability matrix."""

import gzip
import re

import numpy as np

import cghsTest as of
from cghsCase import CLOUD

# A word of its own, so not the 'inf' of a name
NO_NUMBER = re.compile(rb"(?<![\w.:/])[-+]?(?:nan|inf)(?:inity)?(?![\w.:/])",
                       re.IGNORECASE)


def result(name, error, tolerance):
    of.result(f"matrix.{name}", error, tolerance)


def written(case):
    """All files of times and reports."""
    for folder in [case.folder/t for t in of.times(case.folder)] \
            + [case.folder/"postProcessing"]:
        yield from (path for path in folder.rglob("*") if path.is_file())


def without_number(case):
    """How many files have what is no number."""
    files = list(written(case))
    assert files
    bad = []
    for path in files:
        data = path.read_bytes()
        if path.suffix == ".gz":
            data = gzip.decompress(data)
        if NO_NUMBER.search(data):
            bad.append(path)
    if bad:
        print(f"{case.folder}: no numbers in {bad[:5]}")
    return len(bad)


def finite(name, case):
    result(f"{name}.finite", without_number(case), 0)


def solve(name, case):
    """Run it to its end, and look at all that it has written."""
    case.solve()
    finite(name, case)
    return case


def refused(name, case, *texts):
    """It is to end with an error that has these texts, and to leave numbers."""
    result(f"{name}.refused", case.refused(*texts), 0)
    finite(name, case)


def momentum(case, time):
    """Of the parcels [kg m/s], of W particles each."""
    U = of.cloud_by_id(case.folder, time, CLOUD, "U")["U"]
    return (masses(case, time)[:, None]*U).sum(axis=0)


def masses(case, time):
    """Of the parcels, in the order in which they were given."""
    names = ("d", "rho", "nParticle")
    f = of.cloud_by_id(case.folder, time, CLOUD, *names)
    return f["nParticle"]*f["rho"]*np.pi/6*f["d"]**3


def spins(case, time):
    """Those of smooth parcels do not change, and are not written."""
    path = case.folder/time/"lagrangian"/CLOUD/"omega"
    return of.cloud_by_id(case.folder, time if of.has(path) else "0", CLOUD,
                          "omega")["omega"]


def energy(case, time):
    """Kinetic energy of the parcels, of translation and spin [J]. A parcel is
    a sphere of all its mass, d W^(1/3) wide."""
    names = ("d", "rho", "nParticle", "U")
    f = of.cloud_by_id(case.folder, time, CLOUD, *names)
    d2 = f["d"]**2*np.cbrt(f["nParticle"])**2
    speeds = (f["U"]**2).sum(axis=1) + d2/10*(spins(case, time)**2).sum(axis=1)
    return 0.5*(masses(case, time)*speeds).sum()
