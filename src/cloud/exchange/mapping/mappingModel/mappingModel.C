/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "mappingModel.H"
#include "selectModel.H"
#include "modelList.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(mappingModel, 0);
    defineRunTimeSelectionTable(mappingModel, dictionary);
    describeFamily
    (
        mappingModel,
        "how parcels are spread over the mesh: subModels"
    );
}
}


Foam::autoPtr<Foam::cghs::mappingModel> Foam::cghs::mappingModel::New
(
    const dictionary& subModels,
    const fvMesh& mesh,
    const scalar parcelDiameter,
    const labelUList& plates
)
{
    return selectModel<mappingModel>
    (
        subModels,
        *dictionaryConstructorTablePtr_,
        mesh,
        parcelDiameter,
        plates
    );
}
