/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "BVK.H"
#include "sphereDrag.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(BVK, 0);
    addToRunTimeSelectionTable(dragModel, BVK, dictionary);
    addToRunTimeSelectionTable(dragModel, BVK, published);
    describeModel
    (
        dragModel,
        BVK,
        "Beetstra, van der Hoef and Kuipers 2007: lattice-Boltzmann"
    );
}
}


Foam::scalar Foam::cghs::BVK::D(const slipFlow& f) const
{
    const scalar e = f.e;
    const scalar phi = solidsFraction(e);
    const scalar Re = superficialRe(f);

    const scalar viscous = 10*phi/sqr(e) + sqr(e)*(1 + 1.5*sqrt(phi));

    // Re^(0.5 + 2 phi), and Re times the numerator of the inertial part
    const scalar Ren = pow(Re, 0.5 + 2*phi);
    const scalar ReN = (1/e + 3*e*phi)*Re + 8.4*pow(Re, 0.657);

    const scalar inertial =
        0.413/(24*sqr(e))*ReN*Ren/(Ren + pow(scalar(10), 3*phi));

    return 18*f.mu*e/sqr(f.d)*(viscous + inertial);
}
