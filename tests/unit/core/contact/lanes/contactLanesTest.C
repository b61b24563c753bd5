/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    Contacts side by side: each is visited once, those abreast share no body
    that moves, and several at a time come to the same as one by one.

\*---------------------------------------------------------------------------*/

#include "contactLanes.H"
#include "correctionModel.H"
#include "complaint.H"
#include "twoBodies.H"
#include "sampler.H"
#include "claim.H"

#include <catch2/catch.hpp>

#include <set>

namespace Foam
{
namespace cghs
{

namespace
{

//- Contacts among few bodies, so that many share one; some with a wall, which
//  has the index after the last
DynamicList<contact> crowdedContacts(sampler& random, const label n)
{
    const label nBodies = 6 + random.below(200);
    DynamicList<contact> contacts;

    for (label i = 0; i < n; ++i)
    {
        contact c;
        const bool wall = random.below(4) == 0;
        c.a = random.below(nBodies);
        c.b = wall ? nBodies : (c.a + 1 + random.below(nBodies - 1)) % nBodies;
        c.surface = wall ? contact::parcelWall : contact::parcelParcel;
        c.slot = i;
        c.n = random.direction();
        c.overlap = 0;
        contacts.append(c);
    }

    return contacts;
}


//- Notes which contacts are visited, one after the other or together
struct journal
:
    public contactKernel
{
    const contactLanes& lanes;
    labelList order;

    explicit journal(const contactLanes& l): lanes(l) {}

    template<int N>
    void visit(const label blocki, const label lane)
    {
        for (label l = lane; l < lane + N; ++l)
        {
            order.append(lanes.contactOf(blocki, l));
        }
    }
};


labelList visited(const contactLanes& lanes, const bool backwards)
{
    journal notes(lanes);
    lanes.sweep(backwards, notes);
    return notes.order;
}


//- The bodies of a block that move
std::multiset<label> movers
(
    const contactLanes& lanes,
    const label blocki,
    const UList<contact>& contacts
)
{
    std::multiset<label> bodies;

    for (label l = 0; l < lanes[blocki].size; ++l)
    {
        const contact& c = contacts[lanes.contactOf(blocki, l)];
        bodies.insert(c.a);
        if (c.surface == contact::parcelParcel)
        {
            bodies.insert(c.b);
        }
    }

    return bodies;
}


void correct(const correctionModel& model, bodyScene& scene, const scalar mu)
{
    const impactTable coeffs(contact::nSurfaces, impactCoeffs(1, 0, mu));
    const stepScales step{1e-3, 9.81e-3, 1e-3};
    bodies b(scene.view());

    model.begin(scene, b, coeffs, step);
    for (label sweepi = 0; sweepi < model.nSweeps(); ++sweepi)
    {
        model.sweep(sweepi, scene, b, coeffs, step);
    }
}

}


TEST_CASE("A sweep visits each contact once, there and back", "[contact]")
{
    claim once("lanes.visitsEachOnce", 0);
    sampler random(61);

    for (label n = 0; n < 60; ++n)
    {
        contactLanes lanes;
        lanes.arrange(crowdedContacts(random, n));

        for (const bool backwards : {false, true})
        {
            labelList times(n, Zero);
            for (const label i : visited(lanes, backwards))
            {
                ++times[i];
            }
            once.count(times == labelList(n, 1));
        }
    }

    once.settle();
}


TEST_CASE("Contacts abreast share no body that moves", "[contact]")
{
    claim disjoint("lanes.abreastShareNoBody", 0);
    claim used("lanes.abreastWherePossible", 0);
    sampler random(62);

    for (label trial = 0; trial < 300; ++trial)
    {
        const DynamicList<contact> contacts(crowdedContacts(random, 120));
        contactLanes lanes;
        lanes.arrange(contacts);

        for (label k = 0; k < lanes.size(); ++k)
        {
            const auto bodies = movers(lanes, k, contacts);
            const std::set<label> different(bodies.begin(), bodies.end());
            const bool full = lanes[k].size == laneCount;
            const bool apart = different.size() == bodies.size();

            disjoint.count(apart || !lanes[k].abreast);
            used.count(lanes[k].abreast == (full && apart));
        }
    }

    disjoint.settle();
    used.settle();
}


TEST_CASE("Four contacts at a time come to the same as one by one",
    "[contact]")
{
    claim velocity("lanes.velocityAbreast", 1e-15);
    claim turning("lanes.spinAbreast", 1e-14);
    claim place("lanes.shiftAbreast", 1e-14);
    auto model = correctionModel::New
    (
        dictionaryOf
        (
            "correctionModel accumulatedImpulse;"
            "accumulatedImpulseCoeffs { nSweeps 3; overlapShare 0.2;"
            " overlapAllowed 0.005; restingSteps 2; }"
        )
    );
    sampler random(63);

    for (label trial = 0; trial < 500; ++trial)
    {
        const scalar mu = random.below(2) ? 0.3 : 0;
        bodyScene together;
        List<bodyScene> alone(laneCount);

        for (bodyScene& scene : alone)
        {
            scene = random.below(3) ? randomPair(random) : randomWall(random);
            contactMemory memory;
            memory.load = random.below(2)*random.acrossDecades(1e-9, 1e-5);
            memory.held = memory.load;
            scene.memories.append(memory);

            together.add(scene);
            together.memories.append(memory);
        }

        correct(*model, together, mu);

        label i = 0;
        for (bodyScene& scene : alone)
        {
            correct(*model, scene, mu);

            for (label k = 0; k < scene.size(); ++k, ++i)
            {
                const vector& v = scene.motions[k].v;
                const vector& w = scene.spins[k];
                const vector& s = scene.shifts[k];

                velocity.see(mag(together.motions[i].v - v)/(mag(v) + VSMALL));
                turning.see(mag(together.spins[i] - w)/(mag(w) + VSMALL));
                place.see(mag(together.shifts[i] - s)/(mag(s) + VSMALL));
            }
        }
    }

    velocity.settle();
    turning.settle();
    place.settle();
}

} // End namespace cghs
} // End namespace Foam
