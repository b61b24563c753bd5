/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    The sweeps that push apart what impacts leave overlapping.

\*---------------------------------------------------------------------------*/

#include "correctionModel.H"
#include "twoBodies.H"
#include "heap.H"
#include "balance.H"
#include "complaint.H"
#include "claim.H"
#include "StringStream.H"

#include <catch2/catch.hpp>

#include <algorithm>

namespace Foam
{
namespace cghs
{

namespace
{

autoPtr<correctionModel> velocityCorrectionOf
(
    const scalar overlapShare,
    const scalar velocityShare
)
{
    OStringStream text;
    text.precision(17);
    text<< "correctionModel velocity; velocityCoeffs { nSweeps 3; overlapShare "
        << overlapShare << "; velocityShare " << velocityShare << "; }";

    return correctionModel::New(dictionaryOf(text.str().c_str()));
}


//- Blows keep their energy, and turn nothing: what is seen is the correction
const scalar e = 1;
const impactTable coeffs(contact::nSurfaces, impactCoeffs(e, 0, 0));


//- All that friction can do
const impactTable rough(contact::nSurfaces, impactCoeffs(e, 0.5, 0.3, 0.1));


scalar sweep
(
    const correctionModel& model,
    const label sweepi,
    bodyScene& scene,
    const scalar deltaT,
    const impactTable& table = coeffs
)
{
    bodies b(scene.view());
    return
        model.sweep(sweepi, scene, b, table, stepScales{deltaT, 0});
}


const scalar deltaT = 1e-3;

//- Call visit(model, heap) for heaps under various strengths
template<class Visitor>
void forEachHeap(const label seed, const Visitor& visit)
{
    sampler random(seed);

    for (const scalar overlapShare : {0.0, 0.1, 1.0})
    {
        for (const scalar velocityShare : {0.0, 0.5, 1.0})
        {
            for (label i = 0; i < 20; ++i)
            {
                auto model = velocityCorrectionOf(overlapShare, velocityShare);
                visit(*model, randomHeap(random));
            }
        }
    }
}

}


TEST_CASE("Corrections keep momentum, and leave spins alone", "[correction]")
{
    claim linear("correction.linearMomentum", 1e-14);
    claim angular("correction.angularMomentum", 1e-14);
    claim unturned("correction.spinsUntouched", 0);

    forEachHeap(61, [&](const correctionModel& model, bodyScene h)
    {
        bodies b(h.view());
        const vector P(linearMomentum(b));
        const vector L(angularMomentum(b));
        const List<vector> spins(h.spins);

        for (label sweepi = 0; sweepi < model.nSweeps(); ++sweepi)
        {
            sweep(model, sweepi, h, deltaT);
        }

        linear.see(mag(linearMomentum(b) - P)/momentumScale(b));
        angular.see(mag(angularMomentum(b) - L)/angularMomentumScale(b));
        unturned.count(h.spins == spins);
    });

    linear.settle();
    angular.settle();
    unturned.settle();
}


TEST_CASE("Corrections that rub keep linear and angular momentum, and add no "
    "more energy than pushes do", "[correction]")
{
    claim linear("correction.linearMomentumWithFriction", 1e-14);
    claim angular("correction.angularMomentumWithFriction", 1e-14);
    claim lossy("correction.frictionAddsNoEnergy", 1e-13);

    forEachHeap(69, [&](const correctionModel& model, bodyScene h)
    {
        bodies b(h.view());
        const vector P(linearMomentum(b));
        const vector L(angularMomentum(b));

        for (label sweepi = 0; sweepi < model.nSweeps(); ++sweepi)
        {
            const scalar was = kineticEnergy(b);
            const scalar work = sweep(model, sweepi, h, deltaT, rough);
            const scalar is = kineticEnergy(b);

            lossy.see(max(is - was - work, scalar(0))/max(was, is));
        }

        linear.see(mag(linearMomentum(b) - P)/momentumScale(b));
        angular.see(mag(angularMomentum(b) - L)/angularMomentumScale(b));
    });

    linear.settle();
    angular.settle();
    lossy.settle();
}


TEST_CASE("A push rubs by mu times itself, or ends the slip, and never turns it "
    "round", "[correction]")
{
    claim law("correction.frictionOfPush", 1e-12);
    claim both("correction.slidesAndSticks", 0);
    sampler random(70);
    label nStuck = 0, nSlid = 0;

    for (label i = 0; i < 3000; ++i)
    {
        twoBodies p(random.below(2) ? randomPair(random) : randomWall(random));
        const scalar mu = random.acrossDecades(1e-2, 1e2);
        const impactTable table(contact::nSurfaces, impactCoeffs(e, 1, mu));

        // Slow enough to be no impact
        p.setNormalSpeed(-random.between(0, 0.9)*p.touch().overlap/deltaT);
        const twoBodies before(p);
        sweep(*velocityCorrectionOf(0.1, 1), 0, p, deltaT, table);

        const vector P(impulseBetween(before, p));
        const scalar Jn = P & p.touch().n;
        const vector stopping(-p.tangentialMass()*before.slip());
        const bool sticks = mag(stopping) <= mu*Jn;
        const vector Jt
        (
            sticks ? stopping : (mu*Jn/mag(stopping))*stopping
        );

        law.see
        (
            mag(P - Jn*p.touch().n - Jt)
           /(before.normalMass()*before.speedScale())
        );
        sticks ? ++nStuck : ++nSlid;
    }

    both.count(nStuck > 300 && nSlid > 300);
    law.settle();
    both.settle();
}


TEST_CASE("The work that a correction reports is the energy it adds",
    "[correction]")
{
    claim balanced("correction.work", 1e-13);

    forEachHeap(62, [&](const correctionModel& model, bodyScene h)
    {
        bodies b(h.view());

        for (label sweepi = 0; sweepi < model.nSweeps(); ++sweepi)
        {
            const scalar was = kineticEnergy(b);
            const scalar work = sweep(model, sweepi, h, deltaT);
            const scalar is = kineticEnergy(b);

            balanced.see(mag(is - was - work)/max(was, is));
        }
    });

    balanced.settle();
}


TEST_CASE("The push is the share of the overlap and that of the approach, unless "
    "the pair has just met: then it is an impact", "[correction]")
{
    claim law("correction.partingSpeed", 1e-14);
    claim room("correction.neverBeyondOverlap", 1e-14);
    claim line("correction.alongNormal", 1e-14);
    sampler random(63);

    for (label i = 0; i < 3000; ++i)
    {
        const scalar ko = random.between(0, 1), kv = random.between(0, 1);
        twoBodies p(random.below(2) ? randomPair(random) : randomWall(random));
        const vector before0(p.motions[0].v), before1(p.motions[1].v);

        // From slow overlaps that are far too deep to fast ones that graze
        const scalar radii = p.spheres[0].r + p.spheres[1].r;
        const scalar dt =
            random.acrossDecades(1e-3, 1e3)*radii/p.speedScale();

        const scalar vn = partingSpeed(p.touch(), p.view());
        sweep(*velocityCorrectionOf(ko, kv), 0, p, dt);
        const scalar after = partingSpeed(p.touch(), p.view());

        const scalar limit = p.touch().overlap/dt;
        const bool blow = vn < -limit;
        const scalar scale = mag(before0) + mag(before1) + limit;
        const vector change
        (
            (p.motions[1].v - before1) - (p.motions[0].v - before0)
        );
        law.see
        (
            mag(after - (blow ? -e*vn : ko*limit + (1 - kv)*vn))/scale
        );
        room.see(blow ? 0 : max(after - limit, scalar(0))/scale);
        line.see(mag(change - (change & p.touch().n)*p.touch().n)/scale);
    }

    law.settle();
    room.settle();
    line.settle();
}


TEST_CASE("velocityShare 1 alone stops an approach, and no more",
    "[correction]")
{
    claim stopped("correction.stopsApproach", 1e-14);
    auto model = velocityCorrectionOf(0, 1);
    sampler random(64);

    for (label i = 0; i < 2000; ++i)
    {
        twoBodies p(random.below(2) ? randomPair(random) : randomWall(random));
        const scalar before = p.speedScale();

        // Slow enough to be no impact
        const scalar room = max(p.touch().overlap, scalar(0))/deltaT;
        p.setNormalSpeed(-random.between(0, 1)*room);
        const scalar scale = before + p.speedScale();
        sweep(*model, 0, p, deltaT);

        stopped.see(mag(partingSpeed(p.touch(), p.view()))/scale);
    }

    stopped.settle();
}


TEST_CASE("Corrections leave parting pairs alone", "[correction]")
{
    claim alone("correction.partingUntouched", 0);
    auto model = velocityCorrectionOf(0.5, 1);
    sampler random(65);

    for (label i = 0; i < 2000; ++i)
    {
        twoBodies p(random.below(2) ? randomPair(random) : randomWall(random));
        p.setNormalSpeed(mag(p.normalSpeed()));
        const vector v0(p.motions[0].v), v1(p.motions[1].v);
        const scalar work = sweep(*model, 0, p, deltaT);

        alone.count
        (
            p.motions[0].v == v0 && p.motions[1].v == v1 && work == 0
        );
    }

    alone.settle();
}


TEST_CASE("Corrections do not depend on the units", "[correction]")
{
    claim same("correction.unitInvariance", 1e-12);
    sampler random(66);

    forEachHeap(67, [&](const correctionModel& model, bodyScene h)
    {
        const scalar L = random.acrossDecades(1e-6, 1e6);
        const scalar T = random.acrossDecades(1e-6, 1e6);
        const scalar M = random.acrossDecades(1e-6, 1e6);

        bodyScene scaled(h);
        forAll(scaled.motions, i)
        {
            scaled.motions[i].v *= L/T;
            scaled.motions[i].invMass /= M;
        }
        for (contact& c : scaled.contacts)
        {
            c.overlap *= L;
        }

        for (label sweepi = 0; sweepi < model.nSweeps(); ++sweepi)
        {
            sweep(model, sweepi, h, deltaT);
            sweep(model, sweepi, scaled, deltaT*T);
        }

        forAll(h.motions, i)
        {
            const vector& v = h.motions[i].v;
            same.see(mag(scaled.motions[i].v/(L/T) - v)/(mag(v) + 1e-3));
        }
    });

    same.settle();
}


TEST_CASE("Every other sweep runs through the list backwards", "[correction]")
{
    claim same("correction.alternatingOrder", 0);

    forEachHeap(68, [&](const correctionModel& model, bodyScene h)
    {
        bodyScene mirrored(h);
        std::reverse(mirrored.contacts.begin(), mirrored.contacts.end());
        sweep(model, 1, h, deltaT);
        sweep(model, 0, mirrored, deltaT);

        forAll(h.motions, i)
        {
            same.count(h.motions[i].v == mirrored.motions[i].v);
        }
    });

    same.settle();
}


TEST_CASE("The correction 'none' makes no sweeps", "[correction]")
{
    claim idle("correction.noneIsIdle", 0);
    auto model = correctionModel::New(dictionaryOf("correctionModel none;"));

    idle.see(model->nSweeps());
    idle.settle();
}

} // End namespace cghs
} // End namespace Foam
