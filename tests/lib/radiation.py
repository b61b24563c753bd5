# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Radiation in a case of cghsCase whose fluid has energy and whose parcels
#     have heat: by OpenFOAM's P1 or fvDOM, between black walls and mirrors.
#
#         radiate(case, {"yMin": 1200.0}, emissivity=0.8)
# ------------------------------------------------------------------------------
"""Radiation between the parcels and walls of a test's case."""

from cghsCase import _HEADER

WALLS = ("xMin", "xMax", "yMin", "yMax", "zMin", "zMax")

GAS = """binaryAbsorptionEmission;
binaryAbsorptionEmissionCoeffs
{{
    model1 {{ absorptionEmissionModel parcels; }}
    model2
    {{
        absorptionEmissionModel constantAbsorptionEmission;
        constantAbsorptionEmissionCoeffs
        {{
            absorptivity    a [0 -1 0 0 0 0 0] {0};
            emissivity      e [0 -1 0 0 0 0 0] {0};
            E               E [1 -1 -3 0 0 0 0] 0;
        }}
    }}
}}
"""


def write(case, path, cls, text):
    file = case.folder/path
    file.write_text(_HEADER.format(cls=cls, name=file.name) + text)


def radiate(case, walls, model="P1", gas=0, emissivity=0.8):
    """walls: temperature of each black wall, by patch; others are mirrors. gas:
    what it absorbs [1/m]."""
    case.append("constant/parcelsProperties", f"""
solution {{ energyCoeffs {{ radiation yes; }} }}
subModels {{ heatCoeffs {{ radiation {{ emissivity {emissivity}; }} }} }}""")
    write(case, "constant/radiationProperties", "dictionary", f"""
radiation on;
radiationModel {model};
fvDOMCoeffs {{ nPhi 4; nTheta 8; maxIter 50; tolerance 1e-10; }}
absorptionEmissionModel {GAS.format(gas) if gas else 'parcels;'}
scatterModel parcels;
parcelsCoeffs {{ background 1e-3; }}
sootModel none;
transmissivityModel none;
""")
    grey = " ".join(
        f"{p} {{ type lookup; emissivity {1 if p in walls else 0};"
        f" absorptivity {1 if p in walls else 0}; transmissivity 0; }}"
        for p in WALLS)
    write(case, "constant/boundaryRadiationProperties", "dictionary", grey)
    marshak = " ".join(
        f"{p} {{ type MarshakRadiation; value uniform 0; }}" if p in walls
        else f"{p} {{ type zeroGradient; }}" for p in WALLS)
    write(case, "0/G", "volScalarField", f"""
dimensions [1 0 -3 0 0 0 0];
internalField uniform 0;
boundaryField {{ {marshak} }}""")
    write(case, "0/IDefault", "volScalarField", """
dimensions [1 0 -3 0 0 0 0];
internalField uniform 0;
boundaryField { ".*" { type greyDiffusiveRadiation; T T; value uniform 0; } }
""")
    case.append("system/fvSolution", """
solvers
{
    G { solver PCG; preconditioner DIC; tolerance 1e-14; relTol 0; }
    Ii { solver PBiCGStab; preconditioner DILU; tolerance 1e-12; relTol 0; }
}""")
    case.append("system/fvSchemes", """
divSchemes { div(Ji,Ii_h) Gauss upwind; }""")
    case.patches("T", **{p: f"type fixedValue; value uniform {t};"
                         for p, t in walls.items()})
