/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    What no force between soft spheres may break: linear and angular momentum,
    and the energy that is there.

\*---------------------------------------------------------------------------*/

#include "springs.H"
#include "heap.H"
#include "balance.H"
#include "claim.H"

#include <catch2/catch.hpp>

namespace Foam
{
namespace cghs
{

namespace
{

//- A heap whose contacts have been rubbing for a while
bodyScene rubbedHeap(sampler& random)
{
    bodyScene heap(randomHeap(random));

    for (const contact& c : heap.contacts)
    {
        contactMemory memory;
        memory.rubbing = random.between(0, 1)*c.overlap*random.direction();
        heap.memories.append(memory);
    }
    return heap;
}


springs roughSprings(const scalar e, const scalar mu)
{
    springs s;
    s.e = s.eWall = e;
    s.mu = mu;
    return s;
}

}


TEST_CASE("A step of soft spheres keeps linear and angular momentum",
    "[contact]")
{
    claim linear("softSphere.linearMomentum", 1e-14);
    claim angular("softSphere.angularMomentum", 1e-14);
    sampler random(81);

    for (const scalar mu : {0.0, 0.1, 2.0})
    {
        for (label i = 0; i < 40; ++i)
        {
            bodyScene before(rubbedHeap(random));
            bodyScene after(before);
            sweepAll(*roughSprings(0.8, mu).model(), after, 1e-6);

            const bodies b(before.view());
            const bodies a(after.view());
            const scalar momentum = max(momentumScale(a), momentumScale(b));
            const scalar moment =
                max(angularMomentumScale(a), angularMomentumScale(b));

            linear.see(mag(linearMomentum(a) - linearMomentum(b))/momentum);
            angular.see(mag(angularMomentum(a) - angularMomentum(b))/moment);
        }
    }

    linear.settle();
    angular.settle();
}


TEST_CASE("The order of contacts changes nothing but rounding", "[contact]")
{
    claim same("softSphere.orderOfContacts", 1e-13);
    sampler random(82);

    for (label i = 0; i < 40; ++i)
    {
        const bodyScene heap(rubbedHeap(random));
        const labelList order(random.shuffled(heap.contacts.size()));
        bodyScene one(heap), other(heap);

        forAll(order, k)
        {
            other.contacts[k] = heap.contacts[order[k]];
            other.memories[k] = heap.memories[order[k]];
        }
        auto model = roughSprings(0.8, 0.3).model();
        sweepAll(*model, one, 1e-6);
        sweepAll(*model, other, 1e-6);

        forAll(one.motions, k)
        {
            const vector change(one.motions[k].v - heap.motions[k].v);
            const scalar scale = mag(change) + mag(heap.motions[k].v);
            same.see(mag(one.motions[k].v - other.motions[k].v)/scale);
        }
    }

    same.settle();
}


TEST_CASE("A collision of soft spheres never raises the energy", "[contact]")
{
    // Forces are those of the start of a step: at t_c/400 the springs may give
    // back half a step more than they took, (pi/400)^2/2
    claim rise("softSphere.energyRise", 1e-4);
    claim kept("softSphere.elasticEnergy", 1e-4);
    sampler random(83);

    for (const scalar e : {1.0, 0.9, 0.5})
    {
        for (const scalar mu : {0.0, 0.1, 0.5})
        {
            for (const scalar share : {0.0, 0.5, 2.0})
            {
                for (label i = 0; i < 20; ++i)
                {
                    const springs s(roughSprings(e, mu));
                    twoBodies before(touching(s, random, share));
                    twoBodies after(before);
                    const encounter met
                    (
                        meet(s, after, s.contactTime(before)/400)
                    );
                    const scalar was = kineticEnergy(before.view());
                    const scalar is = kineticEnergy(after.view());

                    CHECK(met.rubbing <= 1 + 1e-12);
                    rise.see(max((is - was)/was, scalar(0)));
                    if (e == 1 && mu == 0)
                    {
                        kept.see(mag(is - was)/was);
                    }
                }
            }
        }
    }

    rise.settle();
    kept.settle();
}

} // End namespace cghs
} // End namespace Foam
