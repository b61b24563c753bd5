/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "SyamlalOBrien.H"
#include "sphereDrag.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(SyamlalOBrien, 0);
    addToRunTimeSelectionTable(dragModel, SyamlalOBrien, dictionary);
}
}


Foam::cghs::SyamlalOBrien::SyamlalOBrien(const dictionary& dict)
:
    C1_(positiveScalar(dict, "C1")),
    C2_(positiveScalar(dict, "C2")),
    voidageInRe_(dict.get<bool>("voidageInRe"))
{}

Foam::scalar Foam::cghs::SyamlalOBrien::D
(
    const scalar e,
    const scalar u,
    const scalar d,
    const scalar rho,
    const scalar mu
) const
{
    const scalar Re = reynolds(voidageInRe_ ? e : 1, u, d, rho, mu);

    const scalar A = pow(e, 4.14);
    const scalar B = e <= 0.85 ? C2_*pow(e, 1.28) : pow(e, C1_);
    const scalar a = 0.06*Re;
    const scalar vr = 0.5*(A - a + sqrt(sqr(a) + 2*a*(2*B - A) + sqr(A)));

    const scalar CsoRe = sqr(0.63*sqrt(Re)/vr + 4.8/sqrt(vr));

    // e rho u/d = Re mu/d^2, where Re carries the voidage
    return 0.75*CsoRe*mu/sqr(d)*(voidageInRe_ ? 1 : e);
}
