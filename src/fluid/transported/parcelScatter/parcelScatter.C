/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "parcelScatter.H"
#include "parcelRadiation.H"
#include "checkedEntry.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace radiation
{
    defineTypeNameAndDebug(parcelScatter, 0);
    addToRunTimeSelectionTable(scatterModel, parcelScatter, dictionary);
    describeModel
    (
        scatterModel,
        parcelScatter,
        "beside parcels of a long step (OpenFOAM's radiation)"
    );
}
}


Foam::radiation::parcelScatter::parcelScatter
(
    const dictionary& dict,
    const fvMesh& mesh
)
:
    scatterModel(dict, mesh),
    background_
    (
        cghs::positiveScalar(dict.subDict("parcelsCoeffs"), "background")
    )
{}


Foam::tmp<Foam::volScalarField>
Foam::radiation::parcelScatter::sigmaEff() const
{
    auto sum = volScalarField::New
    (
        "sigmaEff",
        mesh_,
        dimensionedScalar("background", dimless/dimLength, background_)
    );

    const auto* again =
        mesh_.findObject<volScalarField>(cghs::parcelRadiation::scatterName());

    if (again)
    {
        sum.ref() += 3**again;
    }

    return sum;
}
