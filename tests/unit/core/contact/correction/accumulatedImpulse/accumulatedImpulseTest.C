/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    Contacts that remember their load: what no such correction may break, and
    the column of spheres that it has to hold still.

\*---------------------------------------------------------------------------*/

#include "correctionModel.H"
#include "twoBodies.H"
#include "heap.H"
#include "column.H"
#include "balance.H"
#include "complaint.H"
#include "claim.H"

#include <catch2/catch.hpp>

namespace Foam
{
namespace cghs
{

namespace
{

const char* const entries =
    "correctionModel accumulatedImpulse;"
    "accumulatedImpulseCoeffs"
    "{"
    "    nSweeps 3; overlapShare 0.2; overlapAllowed 0.005; restingSteps 2;"
    "}";

const scalar deltaT = 1e-3;


impactTable coeffsOf(const scalar mu)
{
    return impactTable(contact::nSurfaces, impactCoeffs(0.9, 0.3, mu));
}


stepScales stepOf(const scalar dt)
{
    return stepScales{dt, 9.81*dt};
}


//- Loads and rubbing as a former step might have left them
void press(bodyScene& heap, const scalar mu, sampler& random)
{
    for (const contact& c : heap.contacts)
    {
        const bool loaded = random.below(4);
        contactMemory memory;
        memory.load = loaded ? random.acrossDecades(1e-9, 1e-5) : 0;
        memory.held = memory.load;

        // The contact has turned a little since
        const vector aside(random.direction() ^ c.n);
        const vector tilted(aside/mag(aside) + 0.1*c.n);
        memory.rubbing = (mu*memory.load*random.between(0, 1))*tilted;
        heap.memories.append(memory);
    }
}


void sweep
(
    const correctionModel& model,
    const label sweepi,
    bodyScene& scene,
    const scalar mu
)
{
    bodies b(scene.view());
    model.sweep(sweepi, scene, b, coeffsOf(mu), stepOf(deltaT));
}


//- One sweep of contacts that all remember the same
void sweepWith
(
    const contactMemory& memory,
    const correctionModel& model,
    const label sweepi,
    bodyScene& scene,
    const scalar mu
)
{
    bodies b(scene.view());
    scene.memories.resize(scene.contacts.size());
    scene.memories = memory;
    model.begin(scene, b, coeffsOf(mu), stepOf(deltaT));
    sweep(model, sweepi, scene, mu);
}


//- One sweep of contacts that remember nothing
void sweepAfresh
(
    const correctionModel& model,
    const label sweepi,
    bodyScene& scene,
    const scalar mu
)
{
    sweepWith(contactMemory(), model, sweepi, scene, mu);
}


//- One sweep of contacts that bear next to nothing, but bear
void sweepBearing
(
    const correctionModel& model,
    const label sweepi,
    bodyScene& scene,
    const scalar mu
)
{
    contactMemory memory;
    memory.load = memory.held = SMALL*SMALL*scene.motions[0].mass();
    sweepWith(memory, model, sweepi, scene, mu);
}


//- The start and all sweeps of a step
void correct(const correctionModel& model, bodyScene& scene, const scalar mu)
{
    bodies b(scene.view());
    model.begin(scene, b, coeffsOf(mu), stepOf(deltaT));

    for (label sweepi = 0; sweepi < model.nSweeps(); ++sweepi)
    {
        sweep(model, sweepi, scene, mu);
    }
}


//- Call visit(model, heap, mu) for loaded heaps
template<class Visitor>
void forEachHeap(const label seed, const Visitor& visit)
{
    sampler random(seed);
    auto model = correctionModel::New(dictionaryOf(entries));

    for (const scalar mu : {0.0, 0.1, 2.0})
    {
        for (label i = 0; i < 40; ++i)
        {
            bodyScene heap(randomHeap(random));
            press(heap, mu, random);
            visit(*model, heap, mu);
        }
    }
}

}


TEST_CASE("Loads and rubbing keep linear and angular momentum",
    "[correction]")
{
    claim linear("accumulated.linearMomentum", 1e-14);
    claim angular("accumulated.angularMomentum", 1e-14);

    forEachHeap(101, [&](const correctionModel& m, bodyScene h, const scalar mu)
    {
        bodies b(h.view());
        const vector P(linearMomentum(b)), L(angularMomentum(b));
        scalar sizeP = momentumScale(b), sizeL = angularMomentumScale(b);

        correct(m, h, mu);

        sizeP += momentumScale(b);
        sizeL += angularMomentumScale(b);
        linear.see(mag(linearMomentum(b) - P)/sizeP);
        angular.see(mag(angularMomentum(b) - L)/sizeL);
    });

    linear.settle();
    angular.settle();
}


TEST_CASE("No contact pulls, or rubs harder than friction lets it",
    "[correction]")
{
    claim pulls("accumulated.loadBelowZero", 0);
    claim rubs("accumulated.rubbingBeyondFriction", 1e-14);
    claim across("accumulated.rubbingAlongNormal", 1e-13);

    forEachHeap(102, [&](const correctionModel& m, bodyScene h, const scalar mu)
    {
        correct(m, h, mu);

        scalar largest = VSMALL;
        for (const contactMemory& memory : h.memories)
        {
            largest = max(largest, memory.load);
        }
        forAll(h.contacts, i)
        {
            const contactMemory& memory = h.memories[i];
            const scalar excess = mag(memory.rubbing) - mu*memory.load;
            pulls.see(max(-memory.load, scalar(0)));
            rubs.see(max(excess, scalar(0))/largest);
            across.see(mag(memory.rubbing & h.contacts[i].n)/largest);
        }
    });

    pulls.settle();
    rubs.settle();
    across.settle();
}


TEST_CASE("A single contact that bears load is brought to rest, with enough "
    "friction also across", "[correction]")
{
    claim stopped("accumulated.stopsApproach", 1e-14);
    claim held("accumulated.stopsSlip", 1e-13);
    auto model = correctionModel::New(dictionaryOf(entries));
    sampler random(103);

    for (label i = 0; i < 2000; ++i)
    {
        twoBodies p(random.below(2) ? randomPair(random) : randomWall(random));
        const scalar scale = p.speedScale();

        // Without friction no spin is stored
        twoBodies smooth(p);
        sweepBearing(*model, 0, smooth, 0);
        const scalar vn = partingSpeed(smooth.touch(), smooth.view());
        stopped.see(mag(vn)/scale);

        sweepBearing(*model, model->nSweeps() - 2, p, GREAT);
        held.see(mag(p.contactVelocity())/scale);
    }

    stopped.settle();
    held.settle();
}


TEST_CASE("A blow that reaches a contact in a later sweep is an impact",
    "[correction]")
{
    claim impact("accumulated.lateBlowIsImpact", 0);
    claim forgotten("accumulated.lateBlowIsNoLoad", 0);
    auto model = correctionModel::New(dictionaryOf(entries));
    sampler random(107);

    for (label i = 0; i < 2000; ++i)
    {
        twoBodies p(random.below(2) ? randomPair(random) : randomWall(random));
        p.setNormalSpeed
        (
          - p.speedScale() - 4*stepOf(deltaT).speed
          - p.touch().overlap/deltaT
        );

        twoBodies hit(p);
        bodies b(hit.view());
        const scalar mu = 0.5;
        collide(hit.touch(), b, coeffsOf(mu)[hit.touch().surface], deltaT);

        for (label sweepi = 0; sweepi < model->nSweeps() - 1; ++sweepi)
        {
            twoBodies late(p);
            sweepAfresh(*model, sweepi, late, mu);
            impact.count(late.movesLike(hit));
            forgotten.see(late.memories[0].load);
        }
    }

    impact.settle();
    forgotten.settle();
}


TEST_CASE("A pair that parts and bears no load is left alone", "[correction]")
{
    claim alone("accumulated.partingUntouched", 0);
    auto model = correctionModel::New(dictionaryOf(entries));
    sampler random(104);

    for (label i = 0; i < 2000; ++i)
    {
        twoBodies p(random.below(2) ? randomPair(random) : randomWall(random));
        p.setNormalSpeed(p.speedScale());
        const twoBodies before(p);

        for (label sweepi = 0; sweepi < model->nSweeps() - 1; ++sweepi)
        {
            sweepAfresh(*model, sweepi, p, 0.5);
        }
        alone.count(p.movesLike(before));
    }

    alone.settle();
}


TEST_CASE("Shifts keep the centre of mass and leave no velocity behind",
    "[correction]")
{
    claim centre("accumulated.centreOfMass", 1e-14);
    claim still("accumulated.shiftsWithoutVelocity", 0);

    forEachHeap(105, [&](const correctionModel& m, bodyScene h, const scalar mu)
    {
        const bodyScene before(h);
        sweepAfresh(m, m.nSweeps() - 1, h, mu);

        vector moved(Zero);
        scalar scale = 0;
        forAll(h.shifts, i)
        {
            moved += h.motions[i].mass()*h.shifts[i];
            scale += h.motions[i].mass()*mag(h.shifts[i]);
            still.count(h.motions[i].v == before.motions[i].v);
        }
        centre.see(mag(moved)/scale);
        still.count(h.spins == before.spins);
    });

    centre.settle();
    still.settle();
}


TEST_CASE("A shift takes no more than the overlap", "[correction]")
{
    claim within("accumulated.shiftWithinOverlap", 1e-14);
    claim apart("accumulated.shiftParts", 0);
    auto model = correctionModel::New(dictionaryOf(entries));
    sampler random(106);

    for (label i = 0; i < 2000; ++i)
    {
        twoBodies p(random.below(2) ? randomPair(random) : randomWall(random));
        p.setNormalSpeed(0);
        sweepAfresh(*model, model->nSweeps() - 1, p, 0);

        const scalar parted = (p.shifts[1] - p.shifts[0]) & p.touch().n;
        const scalar radii = p.spheres[0].r + p.spheres[1].r;
        within.see(max(parted - p.touch().overlap, scalar(0))/radii);
        apart.count(parted >= 0);
    }

    within.settle();
    apart.settle();
}


TEST_CASE("A column of remembering contacts comes to rest", "[correction]")
{
    claim shallow("accumulated.stackOverlap", 0.02);
    claim restless("accumulated.stackRestlessness", 1e-2);
    claim creep("accumulated.stackCreep", 1e-3);
    column::settings s;
    s.correction = entries;

    for (const scalar e : {0.5, 0.95})
    {
        for (const label n : {1, 3, 10, 30})
        {
            for (const bool topDown : {false, true})
            {
                s.e = e;
                s.topDown = topDown;
                column spheres(n, s);

                for (label i = 0; i < 4000; ++i)
                {
                    spheres.step();
                }
                const scalar height = spheres.height();
                for (label i = 0; i < 1000; ++i)
                {
                    spheres.step();
                    shallow.see(spheres.overlap());
                    restless.see(spheres.restlessness());
                }
                creep.see(mag(spheres.height() - height));
            }
        }
    }

    shallow.settle();
    restless.settle();
    creep.settle();
}


TEST_CASE("A sphere that was dropped comes to rest, if impacts meet the "
    "velocity halfway through the step", "[correction]")
{
    claim rests("accumulated.droppedSphereRests", 1e-2);
    column::settings s;
    s.correction = entries;
    s.kickBefore = 0.5;

    for (const scalar e : {0.5, 0.95})
    {
        s.e = e;
        column sphere(1, s, column::d);
        for (label i = 0; i < 20000; ++i)
        {
            sphere.step();
        }
        rests.see(sphere.restlessness());
    }

    rests.settle();
}

} // End namespace cghs
} // End namespace Foam
