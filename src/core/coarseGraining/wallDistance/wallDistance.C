/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "wallDistance.H"
#include "selectModel.H"
#include "modelList.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(wallDistance, 0);
    defineRunTimeSelectionTable(wallDistance, dictionary);
    describeFamily(wallDistance, "how near parcels come to walls: subModels");
}
}


Foam::autoPtr<Foam::cghs::wallDistance>
Foam::cghs::wallDistance::New(const dictionary& dict)
{
    return selectNamed<wallDistance>
    (
        dict.getOrDefault<word>(typeName, "parcelRadius"),
        dict,
        *dictionaryConstructorTablePtr_
    );
}
