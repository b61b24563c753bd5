/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    The spring and the dashpot of softSphere along the normal, against the
    damped oscillator that they are, until its force would pull:

        delta(t) = v/w' exp(-b t) sin(w' t),   w'^2 = w^2 - b^2,  t < t_1
        t_1      = (pi - 2 a)/w',              a = asin(b/w)
        e        = exp(-b t_1)
        t_c      = t_1 + sin(2 a)/w'

    Steps are of t_c/800. They are of first order, pi/800 = 0.4 % in phase, and
    more where the dashpot counts: what is asserted is 1 %.

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

const label stepsPerContact = 800;
const scalar firstOrder = 0.01;

//- Call visit(springs, before, after, encounter) for head-on collisions of all
//  sizes and masses, pairs and walls with coefficients of their own
template<class Visitor>
void forEachCollision(const label seed, const Visitor& visit)
{
    sampler random(seed);

    for (const scalar e : {1.0, 0.95, 0.8, 0.5, 0.2})
    {
        for (label i = 0; i < 40; ++i)
        {
            springs s;
            s.e = i % 2 ? e : 0.9;
            s.eWall = i % 2 ? 0.9 : e;
            s.k = random.acrossDecades(1, 1e5);

            const twoBodies before(touching(s, random));
            twoBodies after(before);
            const encounter met
            (
                meet(s, after, s.contactTime(before)/stepsPerContact)
            );
            visit(s, before, after, met);
        }
    }
}

//- Two that overlap and rest, and the load between them
scalar loadAtRest(const springs& s, twoBodies& pair, const scalar deltaT)
{
    for (motion& m : pair.motions)
    {
        m.v = Zero;
    }
    pair.memories.append(contactMemory());
    sweepAll(*s.model(), pair, deltaT);

    return pair.memories[0].load;
}

}

TEST_CASE("Soft spheres part with the restitution asked for", "[contact]")
{
    claim restitution("softSphere.restitution", firstOrder);

    forEachCollision(61, [&]
    (
        const springs& s,
        const twoBodies& before,
        const twoBodies& after,
        const encounter&
    )
    {
        const scalar e = -after.normalSpeed()/before.normalSpeed();
        restitution.see(mag(e - s.restitution(before)));
    });

    restitution.settle();
}

TEST_CASE("A contact lasts until the spheres have parted", "[contact]")
{
    claim duration("softSphere.contactTime", firstOrder);

    forEachCollision(62, [&]
    (
        const springs& s,
        const twoBodies& before,
        const twoBodies&,
        const encounter& met
    )
    {
        duration.see(mag(met.duration/s.contactTime(before) - 1));
    });

    duration.settle();
}

TEST_CASE("Spheres overlap as far as the oscillator swings", "[contact]")
{
    claim depth("softSphere.deepestOverlap", firstOrder);

    forEachCollision(63, [&]
    (
        const springs& s,
        const twoBodies& before,
        const twoBodies&,
        const encounter& met
    )
    {
        const scalar w = s.frequency(before), b = s.dampingRate(before);
        const scalar turn = atan2(sqrt(sqr(w) - sqr(b)), b);
        const scalar expected =
            mag(before.normalSpeed())/w
           *exp(-b*turn/sqrt(sqr(w) - sqr(b)));

        depth.see(mag(met.deepest/expected - 1));
    });

    depth.settle();
}

TEST_CASE("A contact never pulls, and no wall is moved", "[contact]")
{
    claim push("softSphere.neverPulls", 0);
    claim unmoved("softSphere.wallUnmoved", 0);

    forEachCollision(64, [&]
    (
        const springs&,
        const twoBodies& before,
        const twoBodies& after,
        const encounter& met
    )
    {
        push.see(-met.pull);
        forAll(before.motions, i)
        {
            unmoved.count
            (
                before.motions[i].invMass > 0
             || after.motions[i].v == before.motions[i].v
            );
        }
    });

    push.settle();
    unmoved.settle();
}

TEST_CASE("At rest the spring bears k delta, whatever the sizes", "[contact]")
{
    claim linear("softSphere.linearSpring", 1e-14);
    sampler random(65);

    for (label i = 0; i < 500; ++i)
    {
        springs s;
        s.e = random.between(0.1, 1);
        s.eWall = random.between(0.1, 1);
        s.k = random.acrossDecades(1, 1e5);
        twoBodies pair(i % 2 ? randomPair(random) : randomWall(random));
        const scalar deltaT = s.contactTime(pair)/50;
        const scalar expected = s.k*pair.touch().overlap*deltaT;

        // Those that barely touch bear nothing
        const scalar load = loadAtRest(s, pair, deltaT);
        linear.see(mag(load - expected)/max(expected, VSMALL));
    }

    linear.settle();
}

TEST_CASE("The spring of a parcel follows from its scaling law", "[contact]")
{
    claim scaled("softSphere.stiffnessScaling", 1e-14);
    sampler random(66);
    const scalar W = 27;

    for
    (
        const auto& law
      : {
            std::make_pair("unscaled", 1.0),
            std::make_pair("proportional", 27.0),
            std::make_pair("energyDensity", 3.0)
        }
    )
    {
        springs s;
        s.stiffnessScaling = law.first;
        s.W = W;
        twoBodies pair(randomPair(random));
        const scalar deltaT = s.contactTime(pair)/200;
        const scalar expected = law.second*s.k*pair.touch().overlap*deltaT;

        scaled.see(mag(loadAtRest(s, pair, deltaT)/expected - 1));
    }

    scaled.settle();
}

TEST_CASE("Parcels part with the restitution of their law, at walls with that "
    "of particles", "[contact]")
{
    claim scaled("softSphere.scaledRestitution", firstOrder);
    sampler random(67);

    for (label i = 0; i < 40; ++i)
    {
        springs s;
        s.e = 0.98;
        s.eWall = 0.98;
        s.restitutionScaling = "logarithmic";
        s.W = 8;
        twoBodies pair(touching(s, random));
        const scalar was = pair.normalSpeed();
        meet(s, pair, s.contactTime(pair)/stepsPerContact);
        const scalar e = pair.hasWall() ? s.eWall : pow(s.e, sqrt(s.W));

        scaled.see(mag(-pair.normalSpeed()/was - e));
    }

    scaled.settle();
}

TEST_CASE("Soft spheres turn only if they rub, and always remember",
    "[contact]")
{
    claim needed("softSphere.needs", 0);
    springs smooth, rough;
    rough.mu = 0.1;

    needed.count(!smooth.model()->needsSpin());
    needed.count(rough.model()->needsSpin());
    needed.count(smooth.model()->needsMemory());
    needed.count(smooth.model()->needsContacts());
    needed.count(!smooth.model()->needsShifts());

    // Without friction there are no spins to touch
    sampler random(68);
    twoBodies pair(touching(smooth, random));
    pair.spins.clear();
    pair.memories.append(contactMemory());
    sweepAll(*smooth.model(), pair, 1e-6);
    needed.count(pair.spins.empty());

    needed.settle();
}

} // End namespace cghs
} // End namespace Foam
