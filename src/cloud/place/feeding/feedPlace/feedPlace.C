/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "feedPlace.H"
#include "selectModel.H"
#include "modelList.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(feedPlace, 0);
    defineRunTimeSelectionTable(feedPlace, dictionary);
    describeFamily
    (
        feedPlace,
        "where parcels come in: type of an entry of feeding"
    );
}
}


Foam::autoPtr<Foam::cghs::feedPlace> Foam::cghs::feedPlace::New
(
    const dictionary& dict,
    const polyMesh& mesh
)
{
    return selectModel<feedPlace>
    (
        dict,
        *dictionaryConstructorTablePtr_,
        mesh
    );
}
