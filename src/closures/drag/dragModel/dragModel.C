/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "dragModel.H"
#include "selectModel.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(dragModel, 0);
    defineRunTimeSelectionTable(dragModel, dictionary);
}
}


Foam::autoPtr<Foam::cghs::dragModel> Foam::cghs::dragModel::New
(
    const dictionary& subModels
)
{
    return selectModel<dragModel>(subModels, *dictionaryConstructorTablePtr_);
}
