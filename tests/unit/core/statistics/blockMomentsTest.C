/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    Standard errors of means, against those of signals whose memory is known.

\*---------------------------------------------------------------------------*/

#include "blockMoments.H"
#include "rememberingSignal.H"
#include "claim.H"

#include <catch2/catch.hpp>

#include <cmath>

namespace Foam
{
namespace cghs
{

namespace
{

//- The mean of the first quantity
blockMoments::derived itself(const blockMoments& series)
{
    return {series.mean(0), scalarField(1, 1)};
}


//- Mean over many series of the squared error, over the exact one
scalar varianceRatio(const scalar a, const label n, const label nSeries)
{
    sampler random(7);
    scalar sum = 0;

    for (label s = 0; s < nSeries; ++s)
    {
        rememberingSignal signal(random, a);
        blockMoments series(1);
        for (label i = 0; i < n; ++i)
        {
            series.add(scalarField(1, signal.next()));
        }
        const blockMoments::estimate e = series.judge(itself(series));
        REQUIRE(e.longEnough);
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
    const blockMoments::estimate speed = series.judge(series.ratio(1, 0));

    claim value("blockMoments.ratio", 5);   // in standard errors
    value.see(mag(speed.value - 3)/(0.1/std::sqrt(scalar(n))));
    value.settle();

    claim error("blockMoments.ratioError", 0.1);
    error.see(mag(speed.error*std::sqrt(scalar(n))/0.1 - 1));
    error.settle();
}


TEST_CASE("what does not vary has no error, what is too short is said so",
    "[statistics]")
{
    claim limits("blockMoments.limits", 0);

    blockMoments constant(1);
    limits.count(std::isnan(constant.judge(constant.ratio(0, 0)).error));
    for (label i = 0; i < 1000; ++i)
    {
        constant.add(scalarField(1, 0.1));
    }
    const blockMoments::estimate none = constant.judge(itself(constant));
    limits.count(none.error == 0 && none.longEnough);

    // In steps of unequal length, where round-off is left of it
    sampler random(5);
    blockMoments uneven(2);
    for (label i = 0; i < 1000; ++i)
    {
        scalarField sample(2, random.between(0.5, 1.5));
        sample[1] *= 0.1;
        uneven.add(sample);
    }
    const blockMoments::estimate same = uneven.judge(uneven.ratio(1, 0));
    limits.count(same.error == 0 && same.longEnough);

    blockMoments ramp(1);
    for (label i = 0; i < 1000; ++i)
    {
        ramp.add(scalarField(1, scalar(i)));
    }
    limits.count(!ramp.judge(itself(ramp)).longEnough);
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
    same.count
    (
        second.judge(second.ratio(0, 1)).independent
     == whole.judge(whole.ratio(0, 1)).independent
    );
    same.count(!blockMoments(3).setState(List<scalar>(5, 0.0)));
    same.settle();
}

} // End namespace cghs
} // End namespace Foam
