# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Cases of cghsCase whose fluid carries species: a gas of several, or a
#     liquid with some that are dilute.
#
#         case = Case("step", fluid="gas", transported=("species",), p=1e5, ...)
#         gas(case, {"A": (28, 1000), "B": (28, 1000)}, inert="B", D=1e-3)
#         fractions(case, A=Y, B=1 - Y)
# ------------------------------------------------------------------------------
"""Species in the fluid of a test's case."""

import re

import numpy as np

import cghsTest as of
from cghsCase import _HEADER, foam

THERMO = "constant/thermophysicalProperties"
CLOUD = "constant/parcelsProperties"


def scalar_field(case, name, values, patches=""):
    """A field without dimensions; patches: conditions but zeroGradient."""
    values = np.asarray(values, float)
    inner = (f"uniform {foam(float(values))}" if values.ndim == 0 else
             "nonuniform List<scalar> " + foam(values.ravel()))
    (case.folder/"0"/name).write_text(
        _HEADER.format(cls="volScalarField", name=name)
        + f"dimensions [0 0 0 0 0 0 0];\ninternalField {inner};\n"
        + 'boundaryField\n{\n    #includeEtc "caseDicts/setConstraintTypes"\n'
        + '    ".*" { type zeroGradient; }\n    ' + patches + "\n}\n")


def fractions(case, patches=None, **values):
    """Mass fractions at the start. patches: {species: conditions as text}."""
    for name, value in values.items():
        scalar_field(case, name, value, (patches or {}).get(name, ""))


def coefficients(D=None, **entries):
    """Entries of speciesCoeffs: diffusivities D [m2/s], one or by name."""
    by_name = D if isinstance(D, dict) else {"default": D}
    diffusion = "" if D is None else (
        "diffusivityModel constant; constantCoeffs { D { "
        + " ".join(f"{k} {foam(v)};" for k, v in by_name.items()) + " } }")
    return "solution { speciesCoeffs { " + diffusion + " ".join(
        f"{k} {foam(v)};" for k, v in entries.items()) + " } }"


def gas(case, species, inert, mu=1e-5, Pr=0.7, **entries):
    """Thermophysics of a gas of species, {name: (molar mass, Cp)}, or (molar
    mass, text of thermodynamics and transport)."""
    def properties(M, Cp):
        rest = Cp if isinstance(Cp, str) else (
            f"thermodynamics {{ Cp {Cp}; Hf 0; }}"
            f" transport {{ mu {mu}; Pr {Pr}; }}")
        return f"{{ specie {{ molWeight {M}; }} {rest} }}"

    case.append(THERMO, "thermoType { mixture multiComponentMixture; }\n"
                + f"species {foam(list(species))};\n" + "\n".join(
                    f"{name} {properties(*values)}"
                    for name, values in species.items()))
    case.append(CLOUD, coefficients(inertSpecie=inert, **entries))


def logged(case, name, what):
    """A number of the balance of a species, of each step."""
    lines = re.findall(rf"species {name}: (.*?\n.*?)\n",
                       (case.folder/"log.cghsFoam").read_text())
    return np.array([
        float(re.search(rf"{what} ({of.NUMBER})", text)[1]) for text in lines])


def largest_defect(case, *names):
    """Of all steps, over what flows."""
    return max(logged(case, name, "relative").max() for name in names)
