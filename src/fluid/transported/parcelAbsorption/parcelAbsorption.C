/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "parcelAbsorption.H"
#include "parcelRadiation.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace radiation
{
    defineTypeNameAndDebug(parcelAbsorption, 0);
    addToRunTimeSelectionTable
    (
        absorptionEmissionModel,
        parcelAbsorption,
        dictionary
    );
    describeModel
    (
        absorptionEmissionModel,
        parcelAbsorption,
        "absorption and emission of parcels (OpenFOAM's radiation)"
    );
}
}


Foam::radiation::parcelAbsorption::parcelAbsorption
(
    const dictionary& dict,
    const fvMesh& mesh
)
:
    absorptionEmissionModel(dict, mesh)
{}


Foam::tmp<Foam::volScalarField>
Foam::radiation::parcelAbsorption::ofParcels
(
    const word& name,
    const dimensionSet& dimensions
) const
{
    const auto* field = mesh_.findObject<volScalarField>(name);

    if (field)
    {
        return *field;
    }

    return volScalarField::New
    (
        "no:" + name,
        mesh_,
        dimensionedScalar(dimensions, Zero)
    );
}


Foam::tmp<Foam::volScalarField>
Foam::radiation::parcelAbsorption::aDisp(const label) const
{
    return ofParcels
    (
        cghs::parcelRadiation::absorptionName(),
        dimless/dimLength
    );
}


Foam::tmp<Foam::volScalarField>
Foam::radiation::parcelAbsorption::EDisp(const label) const
{
    return ofParcels
    (
        cghs::parcelRadiation::emissionName(),
        dimPower/dimVolume
    );
}
