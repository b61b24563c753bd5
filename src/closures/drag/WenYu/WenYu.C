/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "WenYu.H"
#include "sphereDrag.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(WenYu, 0);
    addToRunTimeSelectionTable(dragModel, WenYu, dictionary);
    addToRunTimeSelectionTable(dragModel, WenYu, published);
}
}


Foam::scalar Foam::cghs::WenYu::D
(
    const scalar e,
    const scalar u,
    const scalar d,
    const scalar rho,
    const scalar mu
) const
{
    return wenYuD(e, u, d, rho, mu);
}
