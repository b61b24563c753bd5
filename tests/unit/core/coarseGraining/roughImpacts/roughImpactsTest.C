/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    What impacts take from a gas of spheres that rub: closed formulae against
    impacts of pairs drawn from Maxwell's distribution.

\*---------------------------------------------------------------------------*/

#include "roughImpacts.H"
#include "twoBodies.H"
#include "claim.H"
#include "mathematicalConstants.H"

#include <catch2/catch.hpp>

namespace Foam
{
namespace cghs
{

namespace
{

constexpr label nImpacts = 20000;


//- A vector whose components have the variance 1
vector maxwellian(sampler& random)
{
    using constant::mathematical::twoPi;

    vector v;
    for (direction i = 0; i < 3; ++i)
    {
        v[i] =
            sqrt(-2*log(1 - random.between(0, 1)))
           *cos(twoPi*random.between(0, 1));
    }
    return v;
}


//- Two spheres of mass and radius 1 that are about to meet. Fast ones meet more
//  often, so that the speed of approach is Rayleigh's
twoBodies aboutToMeet(const scalar theta, sampler& random)
{
    twoBodies pair;
    for (label i = 0; i < 2; ++i)
    {
        pair.spheres[i] = sphere(vector(2*i, 0, 0), 1);
        pair.motions[i] = motion(maxwellian(random), 1);
        pair.spins[i] = sqrt(theta/inertiaFactor)*maxwellian(random);
    }
    pair.setContact();

    const scalar approach = 2*sqrt(-log(1 - random.between(0, 1)));
    pair.motions[0].v.x() = 0.5*approach;
    pair.motions[1].v.x() = -0.5*approach;
    return pair;
}


scalar ofVelocities(const twoBodies& pair)
{
    return 0.5*(magSqr(pair.motions[0].v) + magSqr(pair.motions[1].v));
}


scalar ofSpins(const twoBodies& pair)
{
    return
        0.5*inertiaFactor*(magSqr(pair.spins[0]) + magSqr(pair.spins[1]));
}


//- Mean and standard error
struct meanOfMany
{
    scalar sum = 0, squares = 0;

    void see(const scalar x)
    {
        sum += x;
        squares += x*x;
    }

    scalar mean() const { return sum/nImpacts; }

    scalar error() const
    {
        return sqrt((squares/nImpacts - sqr(mean()))/nImpacts);
    }

    //- By how many errors it is off, to 2 in a million
    scalar off(const scalar expected) const
    {
        return mag(mean() - expected)/(error() + 1e-6);
    }
};

}


TEST_CASE("Impacts take what the formulae for rough spheres say",
    "[coarseGraining]")
{
    // Of 72 means one is off by 4 errors with a probability of 0.005
    claim translation("roughImpacts.translation", 4);
    claim rotation("roughImpacts.rotation", 4);
    sampler random(5);

    for (const scalar e : {0.0, 0.8, 1.0})
    {
        for (const scalar et : {0.0, 0.9})
        {
            for (const scalar mu : {0.05, 0.3, 5.0})
            {
                for (const scalar theta : {0.1, 1.5})
                {
                    meanOfMany ofV, ofW;
                    for (label i = 0; i < nImpacts; ++i)
                    {
                        const twoBodies before(aboutToMeet(theta, random));
                        const twoBodies after
                        (
                            afterImpact(before, impactCoeffs{e, et, mu})
                        );
                        // m_e Theta_n = 1/2 2
                        ofV.see(ofVelocities(before) - ofVelocities(after));
                        ofW.see(ofSpins(before) - ofSpins(after));
                    }

                    const roughImpacts formulae(e, et, mu);
                    const scalar lambda = sqrt(1 + theta/inertiaFactor);
                    translation.see(ofV.off(formulae.ofTranslation(lambda)));
                    rotation.see(ofW.off(formulae.ofRotation(lambda)));
                }
            }
        }
    }

    translation.settle();
    rotation.settle();
}


TEST_CASE("Rotation that is steady neither gains nor loses",
    "[coarseGraining]")
{
    claim steady("roughImpacts.steady", 1e-12);
    claim smooth("roughImpacts.withoutFriction", 1e-15);

    for (const scalar e : {0.0, 0.5, 1.0})
    {
        smooth.see(mag(roughImpacts(e, 0.5, 0).dissipation() - (1 - e*e)));

        for (const scalar mu : {1e-6, 0.1, 1.0, 100.0})
        {
            const roughImpacts gas(e, 0.33, mu);
            steady.see(mag(gas.ofRotation(gas.steady())));
        }
    }

    steady.settle();
    smooth.settle();
}


TEST_CASE("Little friction acts as Jenkins and Zhang's restitution",
    "[coarseGraining]")
{
    claim effective("roughImpacts.JenkinsAndZhang", 0.01);

    for (const scalar e : {0.8, 0.9, 0.97})
    {
        const scalar mu = 0.01;
        const scalar eff =
            e - constant::mathematical::piByTwo*mu + 4.5*sqr(mu);

        effective.see
        (
            mag(roughImpacts(e, 0.33, mu).dissipation()/(1 - sqr(eff)) - 1)
        );
    }
    effective.settle();
}

} // End namespace cghs
} // End namespace Foam
