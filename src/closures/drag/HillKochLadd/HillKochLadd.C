/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "HillKochLadd.H"
#include "sphereDrag.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(HillKochLadd, 0);
    addToRunTimeSelectionTable(dragModel, HillKochLadd, dictionary);
    addToRunTimeSelectionTable(dragModel, HillKochLadd, published);
    describeModel
    (
        dragModel,
        HillKochLadd,
        "Hill, Koch and Ladd 2001, all Reynolds numbers"
    );
}
}

namespace Foam
{
namespace cghs
{

//- F0 and F2, which differ in c and in the denominator's last two terms
static scalar viscousForce
(
    const scalar phi,
    const scalar c,
    const scalar c2,
    const scalar c3
)
{
    const scalar packed = 10*phi/pow3(1 - phi);

    if (phi >= 0.4)
    {
        return packed;
    }

    // Both are finite at phi = 0, where they are 0
    const scalar some = max(phi, VSMALL);
    const scalar w = exp(-10*(0.4 - phi)/some);
    const scalar philnPhi = phi*log(some);

    return
        (1 - w)*(1 + 3*sqrt(phi/2) + 135.0/64.0*philnPhi + c*phi)
       /(1 + 0.681*phi + c2*sqr(phi) + c3*pow3(phi))
      + w*packed;
}


static scalar F0(const scalar phi)
{
    return viscousForce(phi, 17.14, -8.48, 8.16);
}


static scalar F1(const scalar phi)
{
    return
        phi <= 0.1
      ? sqrt(2/phi)/40
      : 0.11 + 5.1e-4*exp(11.6*phi);
}


static scalar F2(const scalar phi)
{
    return viscousForce(phi, 17.89, -11.03, 15.41);
}


static scalar F3(const scalar phi)
{
    return
        phi < 0.0953
      ? 0.9351*phi + 0.03667
      : 0.0673 + 0.212*phi + 0.0232/pow5(1 - phi);
}


//- Force of the flow on a sphere over that of Stokes [-]
static scalar force(const scalar phi, const scalar R)
{
    const scalar f2 = F2(phi);
    const scalar f3 = F3(phi);

    if (phi <= 0.01)
    {
        return R <= (f2 - 1)/(0.375 - f3) ? 1 + 0.375*R : f2 + f3*R;
    }

    const scalar f0 = F0(phi);
    const scalar f1 = F1(phi);
    const scalar R1 = (f3 + sqrt(sqr(f3) - 4*f1*(f0 - f2)))/(2*f1);

    return R <= R1 ? f0 + f1*sqr(R) : f2 + f3*R;
}

} // End namespace cghs
} // End namespace Foam


Foam::scalar Foam::cghs::HillKochLadd::D(const slipFlow& f) const
{
    const scalar R = 0.5*superficialRe(f);

    return 18*f.mu*sqr(f.e)/sqr(f.d)*force(solidsFraction(f.e), R);
}
