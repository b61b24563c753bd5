/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    Standard errors of means, against those of signals whose memory is known.

\*---------------------------------------------------------------------------*/

#include "blockMoments.H"
#include "sampler.H"
#include "claim.H"

#include <catch2/catch.hpp>

#include <cmath>

namespace Foam
{
namespace cghs
{

namespace
{

//- Gaussian of variance 1
scalar gaussian(sampler& random)
{
    const scalar u = 1 - random.between(0, 1);
    return std::sqrt(-2*std::log(u))*std::cos(2*M_PI*random.between(0, 1));
}


//- x' = a x + noise, of variance 1
struct remembering
{
    sampler& random;
    const scalar a;
    scalar x = 0;

    remembering(sampler& r, const scalar memory)
    :
        random(r),
        a(memory),
        x(gaussian(r))
    {}

    scalar next()
    {
        const scalar now = x;
        x = a*x + std::sqrt(1 - a*a)*gaussian(random);
        return now;
    }
};


//- Exact variance of the mean of n of them
scalar meanVariance(const scalar a, const scalar n)
{
    return
    (
        (1 + a)/(1 - a) - 2*a*(1 - std::pow(a, n))/(n*(1 - a)*(1 - a))
    )/n;
}


//- Mean over many series of the squared error, over the exact one
scalar varianceRatio(const scalar a, const label n, const label nSeries)
{
    sampler random(7);
    scalar sum = 0;

    for (label s = 0; s < nSeries; ++s)
    {
        remembering signal(random, a);
        blockMoments series(1);
        for (label i = 0; i < n; ++i)
        {
            series.add(scalarField(1, signal.next()));
        }
        const blockMoments::estimate e =
            series.function(series.mean(0), scalarField(1, 1.0));
        REQUIRE(e.certain);
        sum += sqr(e.error);
    }

    return sum/nSeries/meanVariance(a, n);
}

}


TEST_CASE("the error of a mean is that of a signal with memory",
    "[statistics]")
{
    claim white("blockMoments.noMemory", 0.05);
    white.see(mag(varianceRatio(0, 4096, 64) - 1));
    white.settle();

    // The blocks chosen are long, not infinitely so: a memory of 2a/(1 - a^2)
    // over their length is left out
    claim remembered("blockMoments.memory", 0.06);
    for (const scalar a : {0.5, 0.9, 0.97})
    {
        remembered.see(mag(varianceRatio(a, 65536, 60) - 1));
    }
    remembered.settle();
}


TEST_CASE("the error of a ratio knows that its parts vary together",
    "[statistics]")
{
    // A mass that varies by half, and a momentum of 3 masses and some noise of
    // its own: only that noise is in the error
    sampler random(11);
    blockMoments series(2);
    const label n = 65536;
    for (label i = 0; i < n; ++i)
    {
        const scalar m = random.between(0.5, 1.5);
        scalarField sample(2, m);
        sample[1] = 3*m + 0.1*gaussian(random);
        series.add(sample);
    }
    const blockMoments::estimate speed = series.ratio(1, 0);

    claim value("blockMoments.ratio", 5);   // in standard errors
    value.see(mag(speed.value - 3)/(0.1/std::sqrt(scalar(n))));
    value.settle();

    claim error("blockMoments.ratioError", 0.1);
    error.see(mag(speed.error*std::sqrt(scalar(n))/0.1 - 1));
    error.settle();
}


TEST_CASE("what does not vary has no error, what is too short no certain one",
    "[statistics]")
{
    claim limits("blockMoments.limits", 0);

    blockMoments constant(1);
    limits.count(std::isnan(constant.ratio(0, 0).error));
    for (label i = 0; i < 1000; ++i)
    {
        constant.add(scalarField(1, 0.1));
    }
    const blockMoments::estimate none = constant.function(0, scalarField(1, 1));
    limits.count(none.error == 0 && none.certain);

    blockMoments ramp(1);
    for (label i = 0; i < 1000; ++i)
    {
        ramp.add(scalarField(1, scalar(i)));
    }
    limits.count(!ramp.function(0, scalarField(1, 1)).certain);
    limits.settle();
}


TEST_CASE("a series goes on from its state", "[statistics]")
{
    sampler random(3);
    blockMoments whole(2);
    blockMoments second(2);
    claim same("blockMoments.restart", 0);

    for (label i = 0; i < 777; ++i)
    {
        if (i == 333)
        {
            same.count(second.setState(whole.state()));
        }
        scalarField sample(2);
        sample[0] = random.between(0, 1);
        sample[1] = random.between(0, 1);
        whole.add(sample);
        if (i >= 333)
        {
            second.add(sample);
        }
    }
    same.count(second.state() == whole.state());
    same.count(second.ratio(0, 1).error == whole.ratio(0, 1).error);
    same.count(!blockMoments(3).setState(List<scalar>(5, 0.0)));
    same.settle();
}

} // End namespace cghs
} // End namespace Foam
