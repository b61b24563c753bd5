/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    Nature has no preferred frame, direction or unit, and does not number its
    spheres: neither has the impact.

\*---------------------------------------------------------------------------*/

#include "twoBodies.H"
#include "claim.H"
#include "transform.H"

#include <catch2/catch.hpp>

namespace Foam
{
namespace cghs
{

namespace
{

twoBodies inFrame(const twoBodies& pair, const vector& V)
{
    twoBodies p(pair);
    for (motion& m : p.motions)
    {
        m.v += V;
    }
    return p;
}


twoBodies rotated(const twoBodies& pair, const tensor& R)
{
    twoBodies p(pair);
    forAll(p.motions, i)
    {
        p.spheres[i].x = R & p.spheres[i].x;
        p.motions[i].v = R & p.motions[i].v;
        p.spins[i] = R & p.spins[i];
    }
    p.contacts[0].n = R & p.touch().n;
    return p;
}


twoBodies renumbered(const twoBodies& pair)
{
    twoBodies p(pair);
    Swap(p.spheres[0], p.spheres[1]);
    Swap(p.motions[0], p.motions[1]);
    Swap(p.spins[0], p.spins[1]);
    p.contacts[0].n = -p.touch().n;
    return p;
}


//- The same scene in other units of length, time and mass
twoBodies inUnits
(
    const twoBodies& pair,
    const scalar length,
    const scalar time,
    const scalar mass
)
{
    twoBodies p(pair);
    forAll(p.motions, i)
    {
        p.spheres[i].x *= length;
        p.spheres[i].r *= length;
        p.motions[i].v *= length/time;
        p.motions[i].invMass /= mass;
        p.spins[i] /= time;
    }
    p.contacts[0].overlap *= length;
    return p;
}

}


TEST_CASE("An impact is the same in every uniformly moving frame", "[contact]")
{
    claim same("contact.galileanInvariance", 1e-13);
    sampler random(41);

    forEachImpact(42, [&](const twoBodies& p, const impactCoeffs& k)
    {
        const scalar speed = p.speedScale();
        const vector V(random.between(0, speed)*random.direction());
        const twoBodies there(afterImpact(inFrame(p, V), k));
        const twoBodies here(inFrame(afterImpact(p, k), V));

        // Rounding can turn the least of approaches into a parting
        if (mag(p.normalSpeed()) < 1e-12*speed)
        {
            return;
        }

        same.see(largestDifference(there, here)/speed);
    });

    same.settle();
}


TEST_CASE("An impact is the same in every direction", "[contact]")
{
    claim same("contact.rotationInvariance", 1e-13);
    sampler random(43);

    forEachImpact(44, [&](const twoBodies& p, const impactCoeffs& k)
    {
        const tensor R(random.rotation());
        const twoBodies there(afterImpact(rotated(p, R), k));
        const twoBodies here(rotated(afterImpact(p, k), R));

        same.see(largestDifference(there, here)/p.speedScale());
    });

    same.settle();
}


TEST_CASE("An impact does not depend on who is called the first", "[contact]")
{
    claim same("contact.exchangeSymmetry", 1e-13);

    forEachImpact(45, [&](const twoBodies& p, const impactCoeffs& k)
    {
        const twoBodies there(afterImpact(renumbered(p), k));
        const twoBodies here(renumbered(afterImpact(p, k)));

        same.see(largestDifference(there, here)/p.speedScale());
    });

    same.settle();
}


TEST_CASE("An impact does not depend on the units", "[contact]")
{
    claim same("contact.unitInvariance", 1e-13);
    sampler random(46);

    forEachImpact(47, [&](const twoBodies& p, const impactCoeffs& k)
    {
        const scalar L = random.acrossDecades(1e-6, 1e6);
        const scalar T = random.acrossDecades(1e-6, 1e6);
        const scalar M = random.acrossDecades(1e-6, 1e6);
        const twoBodies there(afterImpact(inUnits(p, L, T, M), k));
        const twoBodies here(inUnits(afterImpact(p, k), L, T, M));

        same.see(largestDifference(there, here)/(p.speedScale()*L/T));
    });

    same.settle();
}

} // End namespace cghs
} // End namespace Foam
