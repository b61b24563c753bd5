/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    OpenFOAM's turbulence models for a fluid in the voidage of parcels,
    incompressible or a gas of variable density, selected as usual by
    constant/turbulenceProperties.

\*---------------------------------------------------------------------------*/

#include "PhaseIncompressibleTurbulenceModel.H"
#include "PhaseCompressibleTurbulenceModel.H"
#include "singlePhaseTransportModel.H"
#include "fluidThermo.H"
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

#define makeVoidageModels(Base)                                                \
    makeTemplatedTurbulenceModel(Base, laminar, Stokes);                       \
    makeTemplatedTurbulenceModel(Base, RAS, kEpsilon);                         \
    makeTemplatedTurbulenceModel(Base, RAS, kOmegaSST);                        \
    makeTemplatedTurbulenceModel(Base, LES, kEqn);                             \
    makeTemplatedTurbulenceModel(Base, LES, Smagorinsky)


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

makeVoidageModels
(
    singlePhaseTransportModelPhaseIncompressibleTurbulenceModel
);


makeTurbulenceModelTypes
(
    volScalarField,
    volScalarField,
    compressibleTurbulenceModel,
    PhaseCompressibleTurbulenceModel,
    fluidThermo
);

makeBaseTurbulenceModel
(
    volScalarField,
    volScalarField,
    compressibleTurbulenceModel,
    PhaseCompressibleTurbulenceModel,
    fluidThermo
);

makeVoidageModels(fluidThermoPhaseCompressibleTurbulenceModel);
