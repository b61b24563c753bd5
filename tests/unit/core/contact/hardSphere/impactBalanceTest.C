/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    What no impact may break: linear and angular momentum, the energy that is
    there, and the peace of pairs that part.

\*---------------------------------------------------------------------------*/

#include "twoBodies.H"
#include "balance.H"
#include "claim.H"

#include <catch2/catch.hpp>

namespace Foam
{
namespace cghs
{

TEST_CASE("An impact keeps linear and angular momentum", "[contact]")
{
    claim linear("contact.linearMomentum", 1e-14);
    claim angular("contact.angularMomentum", 1e-14);

    forEachImpact(21, [&](twoBodies before, const impactCoeffs& k)
    {
        if (before.hasWall())
        {
            return;
        }

        twoBodies after(afterImpact(before, k));
        const bodies b(before.view());
        const bodies a(after.view());

        linear.see
        (
            mag(linearMomentum(a) - linearMomentum(b))/momentumScale(b)
        );
        angular.see
        (
            mag(angularMomentum(a) - angularMomentum(b))
           /angularMomentumScale(b)
        );
    });

    linear.settle();
    angular.settle();
}


TEST_CASE("An impact on a wall keeps its angular momentum about the foot",
    "[contact]")
{
    claim angular("contact.wallAngularMomentum", 1e-14);
    claim unmoved("contact.wallUnmoved", 0);

    forEachImpact(22, [&](twoBodies before, const impactCoeffs& k)
    {
        if (!before.hasWall())
        {
            return;
        }

        twoBodies after(afterImpact(before, k));
        const bodies b(before.view());
        const bodies a(after.view());
        const label wall = before.motions[0].invMass == 0 ? 0 : 1;
        const vector foot(before.spheres[wall].x);

        // All that the wall does to the parcel it does at the foot
        angular.see
        (
            mag(angularMomentum(a, foot) - angularMomentum(b, foot))
           /angularMomentumScale(b, foot)
        );
        unmoved.count
        (
            after.motions[wall].v == before.motions[wall].v
         && after.spins[wall] == before.spins[wall]
        );
    });

    angular.settle();
    unmoved.settle();
}


TEST_CASE("An impact never raises the kinetic energy", "[contact]")
{
    claim pairs("contact.energyRiseOfPairs", 1e-14);
    claim walls("contact.energyRiseAtWalls", 1e-14);

    forEachImpact(23, [&](twoBodies before, const impactCoeffs& k)
    {
        twoBodies after(afterImpact(before, k));
        const label wall = before.motions[0].invMass == 0 ? 0 : 1;

        // A wall that moves does work, but not as seen from itself
        const vector frame
        (
            before.hasWall() ? before.motions[wall].v : vector(Zero)
        );
        const scalar was = kineticEnergy(before.view(), frame);
        const scalar is = kineticEnergy(after.view(), frame);

        (before.hasWall() ? walls : pairs).see(max((is - was)/was, scalar(0)));
    });

    pairs.settle();
    walls.settle();
}


TEST_CASE("Perfectly elastic and rough spheres keep all energy", "[contact]")
{
    claim kept("contact.elasticEnergy", 1e-14);
    const impactCoeffs elasticRough{1, 1, GREAT};
    sampler random(24);

    for (label i = 0; i < 2000; ++i)
    {
        twoBodies before(randomPair(random));
        twoBodies after(afterImpact(before, elasticRough));
        const scalar was = kineticEnergy(before.view());
        const scalar is = kineticEnergy(after.view());

        kept.see(mag(is - was)/was);
    }

    kept.settle();
}


TEST_CASE("A pair that parts is left alone", "[contact]")
{
    claim alone("contact.partingUntouched", 0);

    forEachImpact(25, [&](twoBodies before, const impactCoeffs& k)
    {
        before.setNormalSpeed(mag(before.normalSpeed()));
        const twoBodies after(afterImpact(before, k));

        alone.count
        (
            after.motions[0].v == before.motions[0].v
         && after.motions[1].v == before.motions[1].v
         && after.spins == before.spins
        );
    });

    alone.settle();
}


TEST_CASE("An impact moves nobody and changes no mass", "[contact]")
{
    claim inPlace("contact.positionsUntouched", 0);

    forEachImpact(26, [&](twoBodies before, const impactCoeffs& k)
    {
        const twoBodies after(afterImpact(before, k));

        forAll(before.spheres, i)
        {
            inPlace.count
            (
                after.spheres[i].x == before.spheres[i].x
             && after.spheres[i].r == before.spheres[i].r
             && after.motions[i].invMass == before.motions[i].invMass
            );
        }
    });

    inPlace.settle();
}

} // End namespace cghs
} // End namespace Foam
