/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "contactModel.H"
#include "selectModel.H"
#include "modelList.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(contactModel, 0);
    defineRunTimeSelectionTable(contactModel, dictionary);
    describeFamily(contactModel, "how parcels collide: subModels");
}
}


Foam::autoPtr<Foam::cghs::contactModel> Foam::cghs::contactModel::New
(
    const dictionary& subModels,
    const scalar parcelWeight
)
{
    return selectModel<contactModel>
    (
        subModels,
        *dictionaryConstructorTablePtr_,
        parcelWeight
    );
}
