/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    What velocity corrections make of a column of spheres at rest.

    Each step adds n m g dt of momentum to a column of n spheres, and a
    correction passes it on to the floor. The lowest contact has to give way
    until a push carries the column,

        m overlapShare overlap/dt = n m g dt

    Besides, an impact with restitution e that meets the velocity after the
    kick of gravity throws a sphere back by e g dt too much, so that it hops
    at up to v = g dt/(1 - e), and sinks in by as much as v dt. Hence at rest

        overlap <= g dt^2 (n/overlapShare + 1/(1 - e))

    if each push of a step counts in full. Of a single sweep, part is undone
    by the neighbours that are swept later: up to twice that, and twice again
    while the column, loaded all at once, swings in.

\*---------------------------------------------------------------------------*/

#include "column.H"
#include "claim.H"

#include <catch2/catch.hpp>

namespace Foam
{
namespace cghs
{

namespace
{

//- Largest overlap over the diameter within so many steps
scalar largestOverlap
(
    const label n,
    const column::settings& s,
    const label nSteps
)
{
    column spheres(n, s);
    scalar largest = 0;
    for (label i = 0; i < nSteps; ++i)
    {
        spheres.step();
        largest = max(largest, spheres.overlap());
    }
    return largest;
}


//- Mean height of the topmost sphere over so many steps
scalar meanHeight(column& spheres, const label nSteps)
{
    scalar sum = 0;
    for (label i = 0; i < nSteps; ++i)
    {
        spheres.step();
        sum += spheres.height();
    }
    return sum/nSteps;
}


//- Largest overlap over that which the pushes need at least
scalar shareOfBound
(
    const label n,
    const scalar e,
    const label nSweeps,
    const scalar overlapShare
)
{
    column::settings s;
    s.e = e;
    s.correction = velocityCorrectionEntries(nSweeps, overlapShare);
    s.topDown = n % 2;

    const scalar atRest =
        column::g*sqr(column::deltaT)*(n/overlapShare + 1/(1 - e))/column::d;

    return largestOverlap(n, s, 3000)/atRest;
}

}


TEST_CASE("A column under gravity stays within the bound of its overlap",
    "[correction]")
{
    claim bounded("correction.stackOverlapOverBound", 1);

    for (const label n : {1, 3, 10, 30})
    {
        for (const scalar e : {0.5, 0.95})
        {
            for (const label nSweeps : {1, 3})
            {
                for (const scalar share : {0.1, 0.3})
                {
                    bounded.see(shareOfBound(n, e, nSweeps, share)/4);
                }
            }
        }
    }

    bounded.settle();
}


TEST_CASE("Ten spheres rest on each other with less than 2 % of overlap",
    "[correction]")
{
    claim three("correction.stackOfThree", 0.02);
    claim ten("correction.stackOfTen", 0.02);
    column::settings s;
    s.e = 0.95;
    s.correction = velocityCorrectionEntries(3, 0.1);

    for (const bool topDown : {false, true})
    {
        s.topDown = topDown;
        three.see(largestOverlap(3, s, 5000));
        ten.see(largestOverlap(10, s, 5000));
    }

    three.settle();
    ten.settle();
}


TEST_CASE("A column at rest does not creep", "[correction]")
{
    claim still("correction.stackCreep", 1e-3);
    column::settings s;
    s.e = 0.5;
    s.correction = velocityCorrectionEntries(3, 0.1);

    for (const bool topDown : {false, true})
    {
        s.topDown = topDown;
        column spheres(10, s);
        meanHeight(spheres, 5000);
        const scalar early = meanHeight(spheres, 5000);
        meanHeight(spheres, 20000);
        const scalar late = meanHeight(spheres, 5000);
        still.see(mag(late - early));
    }

    still.settle();
}


TEST_CASE("Without corrections a column collapses", "[correction]")
{
    // As in Fig 9: what holds the others up is the correction, not the impact
    claim collapses("correction.stackCollapsesWithout", 0);
    column::settings s;
    s.e = 0.95;
    s.correction = "correctionModel none;";
    collapses.count(largestOverlap(10, s, 3000) > 0.3);
    collapses.settle();
}


TEST_CASE("An elastic sphere bounces as high as it fell, if impacts meet the "
    "velocity halfway through the step", "[contact]")
{
    claim kept("contact.bounceHeight", 1e-3);
    column::settings s;
    s.e = 1;
    s.correction = velocityCorrectionEntries(3, 0.1);
    s.kickBefore = 0.5;
    column sphere(1, s, column::d);
    const scalar dropped = sphere.height();

    scalar highest = 0;
    for (label i = 0; i < 20000; ++i)
    {
        sphere.step();
        highest = i < 15000 ? 0 : max(highest, sphere.height());
    }

    kept.see(mag(highest - dropped)/dropped);
    kept.settle();
}

} // End namespace cghs
} // End namespace Foam
