/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "histogramMeans.H"
#include "SubList.H"

#include <cmath>
#include <limits>

Foam::cghs::histogramMeans::histogramMeans
(
    const scalar from,
    const scalar to,
    const label nBins
)
:
    from_(from),
    width_((to - from)/nBins),
    nBins_(nBins),
    origin_(0.5*(from + to)),
    moments_(N_MOMENTS),
    bins_(nBins + 1, blockMoments(N_BIN_MOMENTS))
{}

// * * * * * * * * * * * * * * * * A sample  * * * * * * * * * * * * * * * * //

void Foam::cghs::histogramMeans::count
(
    UList<scalar>& sums,
    const scalar x,
    const scalar mass
) const
{
    const scalar y = x - origin_;
    const scalar place = (x - from_)/width_;

    sums[0] += mass;
    sums[1] += mass*y;
    sums[2] += mass*sqr(y);

    if (place < nBins_)
    {
        sums[3 + (place < 0 ? 0 : 1 + label(place))] += mass;
    }
}


void Foam::cghs::histogramMeans::add
(
    const UList<scalar>& sums,
    const scalar weight
)
{
    scalarField sample(N_MOMENTS, weight);
    for (label k = 0; k < 3; ++k)
    {
        sample[MASS + k] = sums[k];
    }
    moments_.add(sample);

    scalarField ofBin(N_BIN_MOMENTS, Zero);
    ofBin[ALL] = sums[0];

    forAll(bins_, k)
    {
        ofBin[WITHIN] = sums[3 + k];
        ofBin[BELOW] += sums[3 + k];
        bins_[k].add(ofBin);
    }
}

// * * * * * * * * * * * * * * * * The means * * * * * * * * * * * * * * * * //

Foam::cghs::blockMoments::estimate Foam::cghs::histogramMeans::mean() const
{
    blockMoments::derived f(moments_.ratio(CONTENT, MASS));

    blockMoments::estimate result(moments_.judge(f));
    result.value += moments_.mean(MASS) > 0 ? origin_ : 0;

    return result;
}


Foam::cghs::blockMoments::estimate
Foam::cghs::histogramMeans::deviation() const
{
    const blockMoments::derived A(moments_.ratio(CONTENT, MASS));
    const blockMoments::derived B(moments_.ratio(SQUARE, MASS));
    const scalar variance = B.value - sqr(A.value);

    blockMoments::derived f{0, scalarField(N_MOMENTS, Zero)};

    // More than what rounding leaves
    if (variance > 1e-14*B.value)
    {
        f.value = std::sqrt(variance);
        f.gradient = (B.gradient - 2*A.value*A.gradient)/(2*f.value);
    }

    return moments_.judge(f);
}


Foam::cghs::blockMoments::derived Foam::cghs::histogramMeans::below
(
    const label k,
    const scalar share
) const
{
    const blockMoments::derived F(bins_[k].ratio(BELOW, ALL));
    const blockMoments::derived P(within(k));

    return blockMoments::derived
    {
        F.value - (1 - share)*P.value,
        F.gradient - (1 - share)*P.gradient
    };
}


Foam::cghs::blockMoments::estimate Foam::cghs::histogramMeans::beyond()
{
    const scalar nan = std::numeric_limits<scalar>::quiet_NaN();

    return {nan, nan, GREAT, true};
}


Foam::cghs::blockMoments::estimate Foam::cghs::histogramMeans::quantile
(
    const scalar q
) const
{
    scalar before = bins_[0].ratio(BELOW, ALL).value;

    for (label k = 1; before < q && k < bins_.size(); ++k)
    {
        const scalar F = bins_[k].ratio(BELOW, ALL).value;

        if (F >= q)
        {
            const scalar density = within(k).value/width_;
            const scalar share = (q - before)/(F - before);

            blockMoments::derived f(below(k, share));
            f.value = from_ + (k - 1 + share)*width_;
            f.gradient /= density;

            return bins_[k].judge(f);
        }
        before = F;
    }

    return beyond();
}


Foam::scalar Foam::cghs::histogramMeans::lostAbove() const
{
    const blockMoments& last = bins_.last();

    return last.mean(ALL) > 0 ? 1 - last.ratio(BELOW, ALL).value : 0;
}


Foam::List<Foam::cghs::blockMoments::estimate>
Foam::cghs::histogramMeans::shares() const
{
    blockErrors together;
    for (label k = 1; k <= nBins_; ++k)
    {
        together.join(bins_[k].errors(within(k).gradient));
    }

    List<blockMoments::estimate> result(nBins_);
    forAll(result, bin)
    {
        result[bin] = bins_[bin + 1].judge(within(bin + 1), together.choose());
    }

    return result;
}


Foam::List<Foam::cghs::blockMoments::estimate>
Foam::cghs::histogramMeans::cumulative() const
{
    blockErrors together;
    for (label k = 1; k <= nBins_; ++k)
    {
        together.join(bins_[k].errors(below(k, 1).gradient));
    }

    List<blockMoments::estimate> result(nBins_);
    forAll(result, bin)
    {
        const blockMoments::derived F(below(bin + 1, 1));
        result[bin] = bins_[bin + 1].judge(F, together.choose());
    }

    return result;
}

// * * * * * * * * * * * * * * * Across a restart  * * * * * * * * * * * * * //

Foam::List<Foam::scalar> Foam::cghs::histogramMeans::state() const
{
    DynamicList<scalar> numbers(moments_.state());

    numbers.append(blockMoments::stateOf(bins_));

    return List<scalar>(std::move(numbers));
}


bool Foam::cghs::histogramMeans::setState(const UList<scalar>& state)
{
    // All have seen as many samples, and so have as many levels
    const label nLevels =
        state.size()
       /(
            N_MOMENTS*(N_MOMENTS + 3) + 2
          + bins_.size()*(N_BIN_MOMENTS*(N_BIN_MOMENTS + 3) + 2)
        );
    const label size = nLevels*(N_MOMENTS*(N_MOMENTS + 3) + 2);
    const label each = nLevels*(N_BIN_MOMENTS*(N_BIN_MOMENTS + 3) + 2);

    const label ofBins = bins_.size()*each;

    return
        state.size() == size + ofBins
     && moments_.setState(SubList<scalar>(state, size))
     && blockMoments::setStateOf
        (
            bins_,
            SubList<scalar>(state, ofBins, size)
        );
}
