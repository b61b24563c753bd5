/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "Gidaspow.H"
#include "sphereDrag.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(Gidaspow, 0);
    addToRunTimeSelectionTable(dragModel, Gidaspow, dictionary);
}
}


Foam::cghs::Gidaspow::Gidaspow(const dictionary& dict)
:
    blendWidth_(scalarInRange(dict, "blendWidth", 0, 0.4))
{}

Foam::scalar Foam::cghs::Gidaspow::D
(
    const scalar e,
    const scalar u,
    const scalar d,
    const scalar rho,
    const scalar mu
) const
{
    const scalar low = 0.8 - 0.5*blendWidth_;
    const scalar high = 0.8 + 0.5*blendWidth_;

    if (e <= low)
    {
        return ergunD(e, u, d, rho, mu);
    }
    else if (e >= high)
    {
        return wenYuD(e, u, d, rho, mu);
    }

    const scalar dilute = (e - low)/blendWidth_;

    return
        (1 - dilute)*ergunD(e, u, d, rho, mu)
      + dilute*wenYuD(e, u, d, rho, mu);
}
