/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    Distributions by mass: of x drawn from exp(-x), with masses 1 + x, so that
    by mass the density is f = (1 + x) exp(-x)/2 with the mean 3/2, the variance
    7/4, and F = 1 - (1 + x/2) exp(-x).

\*---------------------------------------------------------------------------*/

#include "histogramMeans.H"
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

const label nEach = 50;


void addSamples(histogramMeans& h, sampler& random, const label n)
{
    for (label s = 0; s < n; ++s)
    {
        scalarField sums(h.nSums(), Zero);
        for (label i = 0; i < nEach; ++i)
        {
            const scalar x = -std::log(1 - random.between(0, 1));
            h.count(sums, x, 1 + x);
        }
        h.add(sums, 0.5);
    }
}


scalar F(const scalar x)
{
    return 1 - (1 + x/2)*std::exp(-x);
}


//- Where F is q
scalar exactQuantile(const scalar q)
{
    scalar low = 0;
    scalar high = 50;
    for (label k = 0; k < 100; ++k)
    {
        const scalar x = 0.5*(low + high);
        (F(x) < q ? low : high) = x;
    }
    return low;
}


//- Standard error of <m g>/<m> for one x, with the integral over all of them
template<class Function>
scalar errorOfOne(const Function& g)
{
    const label n = 200000;
    const scalar h = 50.0/n;
    scalar sum = 0;
    for (label i = 0; i < n; ++i)
    {
        const scalar x = (i + 0.5)*h;
        sum += h*std::exp(-x)*sqr((1 + x)*g(x));
    }
    return std::sqrt(sum)/2;
}

}


TEST_CASE("mean, deviation and quantiles are those by mass, with their errors",
    "[statistics]")
{
    sampler random(3);
    histogramMeans h(0, 20, 1000);
    const label n = 8192;
    addSamples(h, random, n);

    claim values("histogramMeans.values", 4);   // in standard errors
    claim errors("histogramMeans.errors", 0.1);

    const auto see = [&]
    (
        const blockMoments::estimate& e,
        const scalar value,
        const scalar ofOne
    )
    {
        const scalar error = ofOne/std::sqrt(scalar(n)*nEach);
        values.see(mag(e.value - value)/error);
        errors.see(mag(e.error/error - 1));
    };

    see(h.mean(), 1.5, errorOfOne([](scalar x) { return x - 1.5; }));
    see
    (
        h.deviation(),
        std::sqrt(1.75),
        errorOfOne
        (
            [](scalar x) { return (sqr(x - 1.5) - 1.75)/2/std::sqrt(1.75); }
        )
    );
    for (const scalar q : {0.1, 0.5, 0.9})
    {
        const scalar xq = exactQuantile(q);
        const scalar f = (1 + xq)*std::exp(-xq)/2;
        see
        (
            h.quantile(q),
            xq,
            errorOfOne([=](scalar x) { return ((x < xq) - q)/f; })
        );
    }
    values.settle();
    errors.settle();

    claim shares("histogramMeans.shares", 5);   // in standard errors
    const List<blockMoments::estimate> below(h.cumulative());
    for (label bin = 10; bin < 400; bin += 10)
    {
        shares.see
        (
            mag(below[bin].value - F(0.02*(bin + 1)))/below[bin].error
        );
    }
    shares.settle();

    claim sums("histogramMeans.sums", 1e-12);
    scalar all = h.lost() + h.lostAbove();
    for (const blockMoments::estimate& e : h.shares())
    {
        all += e.value;
    }
    sums.see(mag(all - 1));
    sums.see(mag(h.massByWeight().value/(2*nEach)/2 - 1) > 0.02);
    sums.settle();
}


TEST_CASE("what is beyond the bins is said so, and counts in the mean",
    "[statistics]")
{
    claim beyond("histogramMeans.beyond", 1e-12);

    histogramMeans h(1, 2, 4);
    scalarField sums(h.nSums(), Zero);
    h.count(sums, 0.5, 2);
    h.count(sums, 1.3, 1);
    h.count(sums, 7, 1);
    h.add(sums, 1);
    beyond.see(mag(h.lost() - 0.5));
    beyond.see(mag(h.lostAbove() - 0.25));
    beyond.see(mag(h.mean().value - (1 + 1.3 + 7)/4));
    beyond.see(mag(h.quantile(0.6).value - 1.35));
    beyond.see(!std::isnan(h.quantile(0.4).value));
    beyond.see(!std::isnan(h.quantile(0.8).value));
    beyond.settle();
}


TEST_CASE("one value has no deviation and no error", "[statistics]")
{
    claim one("histogramMeans.oneValue", 1e-12);

    histogramMeans h(300, 1200, 60);
    for (label s = 0; s < 64; ++s)
    {
        scalarField sums(h.nSums(), Zero);
        h.count(sums, 912.3, 1 + 0.1*s);
        h.add(sums, 1);
    }
    one.see(mag(h.mean().value/912.3 - 1));
    one.see(h.mean().error);
    one.see(h.deviation().value);
    one.see(h.deviation().error);
    one.settle();
}


TEST_CASE("a distribution goes on from its state", "[statistics]")
{
    claim same("histogramMeans.restart", 0);

    sampler random(5);
    histogramMeans whole(0, 5, 20);
    addSamples(whole, random, 100);
    histogramMeans second(0, 5, 20);
    same.count(second.setState(whole.state()));

    sampler again(random);
    addSamples(whole, random, 77);
    addSamples(second, again, 77);
    same.count(second.state() == whole.state());
    same.count(second.quantile(0.3).error == whole.quantile(0.3).error);
    same.count(!histogramMeans(0, 5, 21).setState(whole.state()));
    same.settle();
}

} // End namespace cghs
} // End namespace Foam
