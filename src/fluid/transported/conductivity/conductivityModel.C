/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "conductivityModel.H"
#include "selectModel.H"
#include "modelList.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(conductivityModel, 0);
    defineRunTimeSelectionTable(conductivityModel, dictionary);
    describeFamily
    (
        conductivityModel,
        "how the fluid conducts heat in its voidage: energyCoeffs"
    );
}
}


Foam::autoPtr<Foam::cghs::conductivityModel>
Foam::cghs::conductivityModel::New(const dictionary& dict)
{
    return
        selectModel<conductivityModel>(dict, *dictionaryConstructorTablePtr_);
}
