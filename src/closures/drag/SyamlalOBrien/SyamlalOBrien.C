/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "SyamlalOBrien.H"
#include "checkedEntry.H"
#include "knownEntries.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(SyamlalOBrien, 0);
    addToRunTimeSelectionTable(dragModel, SyamlalOBrien, dictionary);
    addToRunTimeSelectionTable(dragModel, SyamlalOBrien, published);
    describeModel
    (
        dragModel,
        SyamlalOBrien,
        "from the terminal velocity of a suspension"
    );
}
}


Foam::cghs::SyamlalOBrien::SyamlalOBrien
(
    const scalar C1,
    const scalar C2,
    const bool voidageInRe
)
:
    C1_(C1),
    C2_(C2),
    voidageInRe_(voidageInRe)
{}


Foam::cghs::SyamlalOBrien::SyamlalOBrien()
:
    SyamlalOBrien(2.65, 0.8, false)
{}


Foam::cghs::SyamlalOBrien::SyamlalOBrien(const dictionary& dict)
:
    C1_(positiveScalar(dict, "C1")),
    C2_(positiveScalar(dict, "C2")),
    voidageInRe_(dict.get<bool>("voidageInRe"))
{
    warnUnknownEntries(dict, wordList({"C1", "C2", "voidageInRe"}));
}


Foam::cghs::SyamlalOBrien Foam::cghs::SyamlalOBrien::calibrated
(
    const scalar D,
    const slipFlow& f,
    const bool voidageInRe
)
{
    const scalar Re = reynolds(f, voidageInRe);

    // The v_r of this drag: C_so Re = s^2, quadratic in sqrt(v_r)
    const scalar s = sqrt(D*sqr(f.d)/(0.75*f.mu*(voidageInRe ? 1 : f.e)));
    const scalar vr = sqr((4.8 + sqrt(sqr(4.8) + 2.52*s*sqrt(Re)))/(2*s));

    // The B of this v_r, and the C1 that joins both branches of B
    const scalar a = 0.06*Re;
    const scalar B = vr*(vr - pow(f.e, 4.14) + a)/a;
    const scalar C2 = B/pow(f.e, 1.28);
    const scalar C1 = C2 > 0 ? 1.28 + log(C2)/log(0.85) : GREAT;

    return SyamlalOBrien(C1, C2, voidageInRe);
}


Foam::scalar Foam::cghs::SyamlalOBrien::D(const slipFlow& f) const
{
    const scalar e = f.e;
    const scalar Re = reynolds(f, voidageInRe_);

    const scalar A = pow(e, 4.14);
    const scalar B = e <= 0.85 ? C2_*pow(e, 1.28) : pow(e, C1_);
    const scalar a = 0.06*Re;

    // The same as in the header, without a difference of large numbers
    const scalar b = A - a;
    const scalar root = sqrt(sqr(b) + 4*a*B);
    const scalar vr = b > 0 ? 0.5*(b + root) : 2*a*B/(root - b);

    const scalar CsoRe = sqr(0.63*sqrt(Re)/vr + 4.8/sqrt(vr));

    // e rho u/d = Re mu/d^2, where Re carries the voidage
    return 0.75*CsoRe*f.mu/sqr(f.d)*(voidageInRe_ ? 1 : e);
}
