/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    Conduction through the gas of a lens, against the integral of its lines.
    The integrals here know no branches: each line says for itself whether it
    is in contact, in the layer or neither.

\*---------------------------------------------------------------------------*/

#include "gasLens.H"
#include "integral.H"
#include "claim.H"

#include <catch2/catch.hpp>

#include <cmath>

namespace Foam
{
namespace cghs
{

//- Gaps in radii: beyond the layer, within it, nearer than s, touching, deep
static const scalar gaps[] =
{
    0.7, 0.1, 0.05, 0.0399, 0.03, 0.01, 0.0021, 0.0019, 0.001, 1e-5, 0,
    -1e-5, -0.001, -0.01, -0.1, -0.3
};


//- Height of a sphere's surface over its centre's plane; 0 beside it
static scalar height(const scalar R, const scalar r)
{
    return sqrt(max(sqr(R) - sqr(r), scalar(0)));
}


//- Integral over r, which is the sine of an angle: smooth up to the rim. In
//  parts, as lenses may be thin rings, which integral() may miss
template<class Function>
static scalar overRadius(const Function& f)
{
    const label nParts = 2000;
    const auto line = [&](const scalar a)
    {
        return f(std::sin(a))*std::cos(a);
    };

    scalar total = 0;
    for (label i = 0; i < nParts; ++i)
    {
        total += integral(line, M_PI_2*i/nParts, M_PI_2*(i + 1)/nParts);
    }
    return total;
}


static scalar lineAtWall
(
    const scalar r,
    const scalar gap,
    const scalar layer,
    const scalar s
)
{
    const scalar D = 1 + gap, l = D - height(1, r);
    const bool within = height(1 + layer, r) > D;

    return within && l > 0 ? r/max(l, s) : 0;
}


static scalar lineOfPair
(
    const scalar r,
    const scalar gap,
    const scalar R,
    const scalar layer,
    const scalar s
)
{
    const scalar D = 1 + R + gap, l = D - height(1, r) - height(R, r);
    const bool within = height(1 + layer, r) + height(R*(1 + layer), r) > D;

    return within && l > 0 ? r/max(l, s) : 0;
}


TEST_CASE("The lens at a wall is the integral of its lines", "[heat]")
{
    claim wall("gasLens.wall", 1e-8);
    for (const scalar gap : gaps)
    {
        for (const scalar layer : {0.001, 0.04, 0.2, 0.8})
        {
            for (const scalar s : {0.002, 0.01, 0.1})
            {
                const scalar exact = overRadius
                (
                    [&](const scalar r)
                    {
                        return lineAtWall(r, gap, layer, s);
                    }
                );
                const scalar I = wallLens(gap, layer, s);
                wall.see(mag(I - exact)/max(exact, scalar(1)));
            }
        }
    }
    wall.settle();
}


TEST_CASE("The lens of two particles is the integral of its lines", "[heat]")
{
    claim pair("gasLens.pair", 1e-8);
    for (const scalar gap : gaps)
    {
        for (const scalar R : {1.0, 1 + 1e-9, 1.3, 4.0, 30.0})
        {
            for (const scalar layer : {0.001, 0.04, 0.4})
            {
                for (const scalar s : {0.002, 0.1})
                {
                    const scalar exact = overRadius
                    (
                        [&](const scalar r)
                        {
                            return lineOfPair(r, gap, R, layer, s);
                        }
                    );
                    const scalar I = pairLens(gap, R, layer, R*layer, s);
                    pair.see(mag(I - exact)/max(exact, scalar(1)));
                }
            }
        }
    }
    pair.settle();
}


TEST_CASE("Pairs are like walls where they must be", "[heat]")
{
    claim half("gasLens.equalSpheres", 1e-13);
    claim large("gasLens.largeSphere", 1e-4);
    claim same("gasLens.order", 0);

    const scalar layer = 0.04, s = 0.002;
    for (const scalar gap : gaps)
    {
        // Two in series, each at the plane between
        const scalar atPlane = wallLens(gap/2, layer, s/2);
        half.see(mag(pairLens(gap, 1, layer, layer, s) - atPlane/2));

        // A sphere of no layer that is all but flat
        const scalar atWall = wallLens(gap, layer, s);
        large.see
        (
            mag(pairLens(gap, 1e6, layer, 0, s) - atWall)
           /max(atWall, scalar(1))
        );

        same.see
        (
            mag
            (
                particleFluidParticle(gap, 1, 2, layer, s, 1)
              - particleFluidParticle(gap, 2, 1, layer, s, 1)
            )
        );
    }
    half.settle();
    large.settle();
    same.settle();
}


// With everything in radii H grows as the radius; layers that do not reach have
// none
TEST_CASE("Conductances of lenses in metres", "[heat]")
{
    claim sizes("gasLens.sizes", 1e-12);
    const scalar r = 5e-4, kappa = 0.0257;

    for (const scalar gap : {0.01, 0.0, -0.01})
    {
        const scalar wall = particleFluidWall(gap*r, r, 0.04, 1e-6, kappa);
        const scalar I = wallLens(gap, 0.04, 0.002);
        sizes.see(mag(wall/(2*M_PI*kappa*r*I) - 1));

        const scalar pair =
            particleFluidParticle(gap*r, 3*r, r, 0.04, 1e-6, kappa);
        const scalar J = pairLens(gap, 3, 0.04, 0.12, 0.002);
        sizes.see(mag(pair/(2*M_PI*kappa*r*J) - 1));
    }
    sizes.see(particleFluidWall(0.041*r, r, 0.04, 1e-6, kappa));
    sizes.see(particleFluidParticle(0.081*r, r, r, 0.04, 1e-6, kappa));
    sizes.settle();
}

} // End namespace cghs
} // End namespace Foam
