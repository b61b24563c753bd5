/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    The law of the impact: what it does to the velocities along the normal and
    across it, held against first principles and the chapter's formulae as
    mended.

\*---------------------------------------------------------------------------*/

#include "twoBodies.H"
#include "balance.H"
#include "claim.H"

#include <catch2/catch.hpp>

namespace Foam
{
namespace cghs
{

namespace
{

const scalar roughest = GREAT;


//- The friction coefficient at which a pair just does not slide
scalar criticalFriction(const twoBodies& pair, const scalar en, const scalar et)
{
    return
        pair.tangentialMass()*(1 + et)*mag(pair.slip())
       /(pair.normalMass()*(1 + en)*mag(pair.normalSpeed()));
}


//- Method, section 1: the chapter's Eqs 86-97 as mended, word for word
twoBodies chapterImpact(const twoBodies& pair, const impactCoeffs& k)
{
    twoBodies p(pair);
    const scalar mi = p.motions[0].mass(), mj = p.motions[1].mass();
    const scalar ri = p.spheres[0].r, rj = p.spheres[1].r;
    const vector n(p.touch().n);

    const scalar me = mi*mj/(mi + mj);
    const vector vc
    (
        p.motions[1].v - p.motions[0].v
      - ((ri*p.spins[0] + rj*p.spins[1]) ^ n)
    );
    const vector vn((vc & n)*n);
    const vector vt(vc - vn);

    const scalar stick = 2.0/7.0*me*(1 + k.et)*mag(vt);
    const scalar slide = k.mu*me*(1 + k.en)*mag(vn);
    const vector Jt((-min(stick, slide)/max(mag(vt), VSMALL))*vt);
    const vector dP(-me*(1 + k.en)*vn + Jt);

    p.motions[0].v -= dP/mi;
    p.motions[1].v += dP/mj;
    p.spins[0] -= (ri/(mi*sqr(2*ri)/10))*(n ^ Jt);
    p.spins[1] -= (rj/(mj*sqr(2*rj)/10))*(n ^ Jt);

    return p;
}


}


TEST_CASE("The normal speed is reversed, times the restitution", "[contact]")
{
    claim reversed("contact.normalRestitution", 1e-13);

    forEachImpact(31, [&](const twoBodies& before, const impactCoeffs& k)
    {
        const twoBodies after(afterImpact(before, k));

        reversed.see
        (
            mag(after.normalSpeed() + k.en*before.normalSpeed())
           /before.speedScale()
        );
    });

    reversed.settle();
}


TEST_CASE("Equal elastic spheres exchange velocities head-on", "[contact]")
{
    claim exchanged("contact.headOnExchange", 1e-13);
    const impactCoeffs elastic{1, 0.33, 0.1};
    sampler random(32);

    for (label i = 0; i < 1000; ++i)
    {
        twoBodies p(randomPair(random));
        p.spins = Zero;
        p.motions[1].invMass = p.motions[0].invMass;
        p.motions[0].v = random.between(0.1, 1)*p.touch().n;
        p.motions[1].v = -random.between(0.1, 1)*p.touch().n;
        const twoBodies q(afterImpact(p, elastic));

        exchanged.see(mag(q.motions[0].v - p.motions[1].v)/p.speedScale());
        exchanged.see(mag(q.motions[1].v - p.motions[0].v)/p.speedScale());
    }

    exchanged.settle();
}


TEST_CASE("A rough pair sticks: the slip is reversed times e_t", "[contact]")
{
    claim stuck("contact.stickingSlip", 1e-13);

    forEachImpact(33, [&](const twoBodies& before, impactCoeffs k)
    {
        k.mu = roughest;
        const twoBodies after(afterImpact(before, k));

        stuck.see
        (
            mag(after.slip() + k.et*before.slip())/before.speedScale()
        );
    });

    stuck.settle();
}


TEST_CASE("A smooth pair slides: friction is mu times the normal impulse",
    "[contact]")
{
    claim slid("contact.slidingFriction", 1e-13);

    forEachImpact(34, [&](const twoBodies& before, impactCoeffs k)
    {
        k.mu = 0.5*criticalFriction(before, k.en, k.et);

        // Neither without slip nor mere grazing
        if (k.mu < 1e-3 || k.mu > 1e2)
        {
            return;
        }

        const twoBodies after(afterImpact(before, k));

        const vector n(before.touch().n);
        const vector J(impulseBetween(before, after));
        const vector friction((-k.mu*(J & n)/mag(before.slip()))*before.slip());

        slid.see
        (
            mag(J - (J & n)*n - friction)
           /(before.normalMass()*before.speedScale())
        );
    });

    slid.settle();
}


TEST_CASE("A pair without friction is not turned and feels no tangential pull",
    "[contact]")
{
    claim smooth("contact.noFriction", 1e-13);
    claim unturned("contact.noFrictionNoSpin", 0);

    forEachImpact(35, [&](const twoBodies& before, impactCoeffs k)
    {
        k.mu = 0;
        const twoBodies after(afterImpact(before, k));
        const vector J(impulseBetween(before, after));

        smooth.see
        (
            mag(J - (J & before.touch().n)*before.touch().n)
           /(before.normalMass()*before.speedScale())
        );
        unturned.count(after.spins == before.spins);
    });

    smooth.settle();
    unturned.settle();
}


TEST_CASE("Sticking turns into sliding at the chapter's angle", "[contact]")
{
    claim below("contact.crossoverSticks", 1e-12);
    claim above("contact.crossoverSlides", 1e-12);
    sampler random(36);

    for (label i = 0; i < 2000; ++i)
    {
        const twoBodies p
        (
            random.below(2) ? randomPair(random) : randomWall(random)
        );
        const scalar en = random.between(0, 1), et = random.between(0, 1);
        const scalar mu = criticalFriction(p, en, et);

        // Neither pure impact nor mere grazing
        if (mu < 1e-2 || mu > 1e2)
        {
            continue;
        }

        // Just enough friction to stick
        const twoBodies stuck
        (
            afterImpact(p, impactCoeffs{en, et, mu*(1 + 1e-9)})
        );
        below.see(mag(stuck.slip() + et*p.slip())/p.speedScale());

        // A little too little: mu is the measured ratio of the impulses
        const scalar less = mu*(1 - 1e-3);
        const twoBodies slid(afterImpact(p, impactCoeffs{en, et, less}));
        const vector J(impulseBetween(p, slid));
        const scalar Jn = J & p.touch().n;
        above.see
        (
            mag(mag(J - Jn*p.touch().n) - less*Jn)
           /(p.normalMass()*p.speedScale())
        );
    }

    below.settle();
    above.settle();
}


TEST_CASE("A normal impact loses 1/2 m_e (1 - e^2) v_n^2", "[contact]")
{
    claim loss("contact.normalEnergyLoss", 1e-13);

    forEachImpact(37, [&](twoBodies before, const impactCoeffs& k)
    {
        if (before.hasWall())
        {
            return;
        }

        before.setContactVelocity(before.normalSpeed()*before.touch().n);
        twoBodies after(afterImpact(before, k));
        const scalar was = kineticEnergy(before.view());
        const scalar is = kineticEnergy(after.view());
        const scalar expected =
            0.5*before.normalMass()*(1 - sqr(k.en))*sqr(before.normalSpeed());

        loss.see(mag(was - is - expected)/was);
    });

    loss.settle();
}


TEST_CASE("A sticking impact loses 1/2 m_t (1 - e_t^2) v_t^2 besides",
    "[contact]")
{
    claim loss("contact.stickingEnergyLoss", 1e-13);

    forEachImpact(38, [&](twoBodies before, impactCoeffs k)
    {
        if (before.hasWall())
        {
            return;
        }

        k.mu = roughest;
        twoBodies after(afterImpact(before, k));
        const scalar was = kineticEnergy(before.view());
        const scalar is = kineticEnergy(after.view());
        const scalar expected =
            0.5*before.normalMass()*(1 - sqr(k.en))*sqr(before.normalSpeed())
          + 0.5*before.tangentialMass()*(1 - sqr(k.et))*magSqr(before.slip());

        loss.see(mag(was - is - expected)/was);
    });

    loss.settle();
}


TEST_CASE("At touch the impact is the chapter's, as mended", "[contact]")
{
    claim same("contact.chapterFormulae", 1e-13);

    forEachImpact(39, [&](twoBodies before, const impactCoeffs& k)
    {
        if (before.hasWall())
        {
            return;
        }

        // Where the chapter's lever arms hold
        before.separateToTouch();

        if (before.normalSpeed() >= 0)
        {
            return;
        }

        const twoBodies after(afterImpact(before, k));
        same.see
        (
            largestDifference(after, chapterImpact(before, k))
           /before.speedScale()
        );
    });

    same.settle();
}

} // End namespace cghs
} // End namespace Foam
