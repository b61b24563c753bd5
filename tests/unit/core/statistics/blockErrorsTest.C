/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    Windows that are long enough, and that are not, on series whose correlation
    time is known.

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

//- Memory, and the correlation time in samples that it makes
constexpr scalar memory = 0.8;
constexpr scalar tau = (1 + memory)/(2*(1 - memory));


//- What many windows have said
struct verdicts
{
    label n = 0;

    //- Windows that are long enough
    label nLong = 0;

    //- Of these the true mean is within one, and within two errors
    label within1 = 0;
    label within2 = 0;

    //- Of these the squared error, and the correlation time
    scalar squaredError = 0;
    scalar correlationTime = 0;


    //- The true mean is zero
    void see(const blockMoments::estimate& e, const scalar length)
    {
        ++n;
        if (e.longEnough)
        {
            ++nLong;
            within1 += mag(e.value) < e.error;
            within2 += mag(e.value) < 2*e.error;
            squaredError += sqr(e.error);
            correlationTime += length/(2*e.independent);
        }
    }

    scalar share() const { return scalar(nLong)/n; }
};


blockMoments::derived itself(const blockMoments& series)
{
    return {series.mean(0), scalarField(1, 1)};
}


blockMoments remembered(sampler& random, const scalar nTaus)
{
    rememberingSignal signal(random, memory);
    blockMoments series(1);

    for (label i = 0; i < nTaus*tau; ++i)
    {
        series.add(scalarField(1, signal.next()));
    }
    return series;
}


//- Of windows of so many correlation times
verdicts windows(const scalar nTaus)
{
    sampler random(1);
    verdicts v;

    for (label i = 0; i < 1000; ++i)
    {
        const blockMoments series(remembered(random, nTaus));
        v.see(series.judge(itself(series)), series.nSamples());
    }
    return v;
}


//- Of many series, judged together
verdicts together(const List<blockMoments>& all)
{
    blockErrors sum;
    for (const blockMoments& series : all)
    {
        sum.join(series.errors(scalarField(1, 1)));
    }

    verdicts v;
    for (const blockMoments& series : all)
    {
        v.see(series.judge(itself(series), sum.choose()), series.nSamples());
    }
    return v;
}


//- Of profiles of 16 places in windows of so many correlation times
scalar shareOfProfiles(const scalar nTaus)
{
    sampler random(2);
    scalar sum = 0;

    for (label i = 0; i < 100; ++i)
    {
        List<blockMoments> places(16);
        for (blockMoments& place : places)
        {
            place = remembered(random, nTaus);
        }
        sum += together(places).share();
    }
    return sum/100;
}


//- A column of bubbles that changes sides once in 400 samples, at this one,
//  behind noise of twice its size: a place of its profile
blockMoments telegraph(sampler& random, const label change, const scalar size)
{
    blockMoments series(1);

    for (label i = 0; i < 400; ++i)
    {
        series.add
        (
            scalarField(1, (i < change ? size : -size) + 2*gaussian(random))
        );
    }
    return series;
}

}


TEST_CASE("errors and correlation times of windows that are long enough",
    "[statistics]")
{
    claim cover("blockErrors.coverage", 0.06);
    claim error("blockErrors.error", 0.1);
    claim time("blockErrors.correlationTime", 0.1);

    for (const scalar nTaus : {100.0, 200.0, 500.0})
    {
        const verdicts v(windows(nTaus));
        const scalar n = v.nLong;
        const scalar variance = meanVariance(memory, label(nTaus*tau));

        cover.see(mag(v.within1/n - 0.683));
        cover.see(mag(v.within2/n - 0.954));
        error.see(mag(std::sqrt(v.squaredError/n/variance) - 1));
        time.see(mag(v.correlationTime/n/tau - 1));
    }
    cover.settle();
    error.settle();
    time.settle();
}


TEST_CASE("short windows are said to be short, long ones are not",
    "[statistics]")
{
    settle("blockErrors.short4", windows(4).share(), 0.02);
    settle("blockErrors.short10", windows(10).share(), 0.06);
    settle("blockErrors.long100", 1 - windows(100).share(), 0.2);
    settle("blockErrors.long200", 1 - windows(200).share(), 0.15);
    settle("blockErrors.long1000", 1 - windows(1000).share(), 0.02);
}


TEST_CASE("profiles are judged by all their bins", "[statistics]")
{
    settle("blockErrors.profileShort10", shareOfProfiles(10), 0.01);
    settle("blockErrors.profileShort20", shareOfProfiles(20), 0.1);
    settle("blockErrors.profileLong100", 1 - shareOfProfiles(100), 0.03);
}


TEST_CASE("a slow change behind noise is seen", "[statistics]")
{
    sampler random(3);
    verdicts single;
    scalar profiles = 0;

    for (label i = 0; i < 200; ++i)
    {
        const label change = 60 + random.below(280);
        const blockMoments middle(telegraph(random, change, 1));
        single.see(middle.judge(itself(middle)), 400);

        List<blockMoments> places(20);
        forAll(places, k)
        {
            places[k] = telegraph(random, change, std::sin(M_PI*k/20));
        }
        profiles += together(places).share()/200;
    }
    settle("blockErrors.change", single.share(), 0.03);
    settle("blockErrors.changeInProfile", profiles, 0.01);
}


TEST_CASE("windows that are too short have fewer samples than needed",
    "[statistics]")
{
    // So that what is said of them makes sense
    sampler random(4);
    claim few("blockErrors.few", 0);

    for (const scalar nTaus : {2.0, 10.0, 40.0, 200.0})
    {
        for (label i = 0; i < 200; ++i)
        {
            const blockMoments series(remembered(random, nTaus));
            const blockMoments::estimate e = series.judge(itself(series));

            few.count
            (
                e.longEnough
             == (e.independent >= blockErrors::leastIndependent)
            );
        }
    }
    few.settle();
}

} // End namespace cghs
} // End namespace Foam
