/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "WenYu.H"
#include "sphereDrag.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(WenYu, 0);
    addToRunTimeSelectionTable(dragModel, WenYu, dictionary);
    addToRunTimeSelectionTable(dragModel, WenYu, published);
    describeModel
    (
        dragModel,
        WenYu,
        "a single sphere's, times a power of the voidage"
    );
}
}


Foam::scalar Foam::cghs::WenYu::D(const slipFlow& f) const
{
    return wenYuD(f);
}
