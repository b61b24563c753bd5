/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    OpenFOAM's turbulence models for an incompressible fluid in the voidage of
    parcels, selected as usual by constant/turbulenceProperties.

\*---------------------------------------------------------------------------*/

#include "PhaseIncompressibleTurbulenceModel.H"
#include "singlePhaseTransportModel.H"
#include "addToRunTimeSelectionTable.H"
#include "makeTurbulenceModel.H"

#include "laminarModel.H"
#include "RASModel.H"
#include "LESModel.H"

#include "Stokes.H"
#include "kEpsilon.H"
#include "kOmegaSST.H"
#include "kEqn.H"
#include "Smagorinsky.H"

makeTurbulenceModelTypes
(
    volScalarField,
    geometricOneField,
    incompressibleTurbulenceModel,
    PhaseIncompressibleTurbulenceModel,
    singlePhaseTransportModel
);

makeBaseTurbulenceModel
(
    volScalarField,
    geometricOneField,
    incompressibleTurbulenceModel,
    PhaseIncompressibleTurbulenceModel,
    singlePhaseTransportModel
);

#define makeModel(Family, Type)                                                \
    makeTemplatedTurbulenceModel                                               \
    (                                                                          \
        singlePhaseTransportModelPhaseIncompressibleTurbulenceModel,           \
        Family,                                                                \
        Type                                                                   \
    )

makeModel(laminar, Stokes);
makeModel(RAS, kEpsilon);
makeModel(RAS, kOmegaSST);
makeModel(LES, kEqn);
makeModel(LES, Smagorinsky);
