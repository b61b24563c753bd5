/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "correctionModel.H"
#include "selectModel.H"
#include "modelList.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(correctionModel, 0);
    defineRunTimeSelectionTable(correctionModel, dictionary);
    describeFamily
    (
        correctionModel,
        "what parts hard spheres that overlap: hardSphereCoeffs"
    );
}
}


Foam::autoPtr<Foam::cghs::correctionModel> Foam::cghs::correctionModel::New
(
    const dictionary& dict
)
{
    return selectModel<correctionModel>(dict, *dictionaryConstructorTablePtr_);
}
