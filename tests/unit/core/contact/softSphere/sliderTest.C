/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    The slider of softSphere: a spring across the normal that remembers, and
    gives where Coulomb's law says so.

        F = -k_t xi - eta_t v_t,   |F| <= mu F_n
        k_t = 2/7 k_n,   eta_t = eta_n/2

\*---------------------------------------------------------------------------*/

#include "springs.H"
#include "claim.H"

#include <catch2/catch.hpp>

namespace Foam
{
namespace cghs
{

namespace
{

//- A contact that is held at its overlap while one of its bodies is dragged
//  aside: too heavy to mind, and without loss along the normal
class shearTest
{
    springs springs_;
    autoPtr<contactModel> model_;
    twoBodies pair_;
    const vector aside_;
    const scalar deltaT_;


public:

    static constexpr scalar overlap = 1e-5;
    static constexpr scalar step = 1e-8;    // of displacement

    shearTest(const springs& s)
    :
        springs_(s),
        model_(s.model()),
        aside_(0, 0.6, 0.8),
        deltaT_(1e-6)
    {
        const scalar r = 1e-3, heavy = 1e9;
        pair_.spheres[0] = sphere(Zero, r);
        pair_.spheres[1] = sphere(vector(2*r - overlap, 0, 0), r);
        pair_.motions[0] = motion(Zero, 1/heavy);
        pair_.motions[1] = motion(Zero, 1/heavy);
        pair_.setContact();
        pair_.memories.append(contactMemory());
    }

    scalar kt() const { return 2.0/7.0*springs_.k; }

    //- The most that friction bears [N]
    scalar limit() const { return springs_.mu*springs_.k*overlap; }

    //- Drag by n steps, forwards (1) or backwards (-1). Returns the force on the
    //  body that is dragged, along the way
    scalar drag(const label n, const scalar sign)
    {
        for (label i = 0; i < n; ++i)
        {
            pair_.motions[1].v = (sign*step/deltaT_)*aside_;
            sweepAll(*model_, pair_, deltaT_);
        }
        return (pair_.impulses[0] & aside_)/deltaT_;
    }
};

constexpr scalar shearTest::overlap;
constexpr scalar shearTest::step;


//- A contact with some history, about to make a step. The slip is moderate, or
//  all would slide
twoBodies withHistory(const springs& s, sampler& random)
{
    twoBodies pair(random.below(2) ? randomPair(random) : randomWall(random));
    const scalar deltaT = s.contactTime(pair)/50;
    const scalar speed = pair.touch().overlap/deltaT;

    forAll(pair.motions, i)
    {
        const scalar r = pair.spheres[i].r;
        pair.motions[i].v = Zero;
        pair.spins[i] =
            r > 0 ? (random.between(0, 1)*speed/r)*random.direction() : vector(Zero);
    }
    pair.setContactVelocity
    (
        speed
       *(
            random.between(-1, 1)*pair.touch().n
          + random.between(0, 1)*random.direction()
        )
    );
    contactMemory memory;
    memory.rubbing =
        random.between(0, 2)*s.mu*pair.touch().overlap*random.direction();
    pair.memories.append(memory);
    return pair;
}

}


TEST_CASE("Friction grows with the way of the slip, up to mu F_n", "[contact]")
{
    claim sticks("softSphere.stickingForce", 1e-12);
    claim slides("softSphere.slidingForce", 1e-12);
    claim returns("softSphere.reversal", 1e-12);

    springs s;
    s.mu = 0.3;
    shearTest shear(s);

    const scalar spring = shear.kt()*shearTest::step;
    const label toSlide = label(shear.limit()/spring);

    // It holds ...
    const label half = toSlide/2;
    sticks.see(mag(shear.drag(half, 1) + half*spring)/shear.limit());

    // ... gives ...
    slides.see(mag(shear.drag(5*toSlide, 1) + shear.limit())/shear.limit());

    // ... and when the slip turns, unloads from where it was
    returns.see
    (
        mag(shear.drag(half, -1) + shear.limit() - half*spring)
       /shear.limit()
    );
    slides.see(mag(shear.drag(5*toSlide, -1) - shear.limit())/shear.limit());

    sticks.settle();
    slides.settle();
    returns.settle();
}


TEST_CASE("No friction exceeds mu F_n, and none is lost below it", "[contact]")
{
    claim limit("softSphere.coulombLimit", 1e-13);
    claim force("softSphere.springAndDashpotAcross", 1e-12);
    claim memory("softSphere.displacementAfterSliding", 1e-12);
    sampler random(71);
    label nStick = 0, nSlide = 0;

    for (label i = 0; i < 4000; ++i)
    {
        springs s;
        s.e = s.eWall = random.between(0.2, 1);
        s.mu = random.acrossDecades(0.05, 5);
        twoBodies pair(withHistory(s, random));
        const scalar deltaT = s.contactTime(pair)/50;
        const scalar me = pair.normalMass();
        const scalar kt = 2.0/7.0*s.k;
        const scalar etat = me*s.dampingRate(pair);
        const vector n(pair.touch().n);
        const vector slip(pair.slip());
        const vector former(pair.memories[0].rubbing);
        const vector xi(former - (former & n)*n + deltaT*slip);
        const vector trial(-kt*xi - etat*slip);
        const scalar Fn = max
        (
            scalar(0),
            s.k*pair.touch().overlap
          - 2*me*s.dampingRate(pair)*pair.normalSpeed()
        );
        const scalar scale = mag(trial) + s.mu*Fn;
        const scalar radii = pair.spheres[0].r + pair.spheres[1].r;

        // Those that barely touch have nothing but rounding to rub with
        if (pair.touch().overlap < 1e-6*radii)
        {
            continue;
        }

        const bool slides = mag(trial) > s.mu*Fn;
        const vector expected
        (
            slides ? (s.mu*Fn/mag(trial))*trial : trial
        );
        sweepAll(*s.model(), pair, deltaT);
        const vector F(pair.impulses[0]/deltaT);
        const vector now(pair.memories[0].rubbing);

        limit.see(max(mag(F) - s.mu*Fn, scalar(0))/scale);
        force.see(mag(F - expected)/scale);

        // The spring alone bears what the dashpot does not
        memory.see(mag(-kt*now - etat*slip - expected)/scale);
        ++(slides ? nSlide : nStick);
    }

    limit.settle();
    force.settle();
    memory.settle();
    CHECK(min(nStick, nSlide) > 500);
}


TEST_CASE("The spring across turns with its contact", "[contact]")
{
    claim plane("softSphere.displacementInPlane", 1e-13);
    sampler random(72);

    for (label i = 0; i < 1000; ++i)
    {
        springs s;
        s.mu = 0.5;
        twoBodies pair(withHistory(s, random));
        sweepAll(*s.model(), pair, s.contactTime(pair)/50);
        const contactMemory& memory = pair.memories[0];
        const vector n(pair.touch().n);

        plane.see(mag(memory.rubbing & n)/max(mag(memory.rubbing), VSMALL));
        plane.see
        (
            mag(pair.impulses[0] & n)/max(mag(pair.impulses[0]), VSMALL)
        );
    }

    plane.settle();
}


TEST_CASE("Lossless spheres that stick turn their slip back, and those that "
    "slide lose mu times the normal impulse", "[contact]")
{
    // The two springs swing in phase: e_t = 1. Sliding turns the normal by 2 pi
    // thousandths, which over mu is 3 % of the friction
    claim stuck("softSphere.stickingSlip", 0.03);
    claim slid("softSphere.slidingImpulse", 0.03);
    sampler random(73);

    for (label i = 0; i < 200; ++i)
    {
        springs s;
        s.mu = 0.2;
        const bool slides = i % 2;
        const scalar share = slides ? 10*s.mu : 3*s.mu;
        const twoBodies before(touching(s, random, share));
        twoBodies after(before);
        meet(s, after, s.contactTime(before)/400);

        const vector J(impulseBetween(before, after));
        const vector n(before.touch().n);
        const scalar speed = mag(before.normalSpeed());

        if (slides)
        {
            const vector along(before.slip()/mag(before.slip()));
            const scalar Jn = 2*before.normalMass()*speed;
            slid.see(mag((J & along) + s.mu*Jn)/(s.mu*Jn));
        }
        else
        {
            const vector slip(after.slip() - (after.slip() & n)*n);
            stuck.see(mag(slip + before.slip())/mag(before.slip()));
        }
    }

    stuck.settle();
    slid.settle();
}

} // End namespace cghs
} // End namespace Foam
