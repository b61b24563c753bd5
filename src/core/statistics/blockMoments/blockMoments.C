/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "blockMoments.H"

#include <cmath>
#include <limits>

// * * * * * * * * * * * * * * * * One level * * * * * * * * * * * * * * * * //

Foam::cghs::blockMoments::level::level(const label nMoments)
:
    mean(nMoments, Zero),
    products((nMoments*(nMoments + 1))/2, Zero),
    waiting(nMoments, Zero)
{}


void Foam::cghs::blockMoments::level::add(const UList<scalar>& block)
{
    // As deviations from the running mean, so that what does not vary leaves
    // exactly nothing
    ++nBlocks;
    const scalar share = (nBlocks - 1)/nBlocks;

    label entry = 0;
    for (label k = 0; k < mean.size(); ++k)
    {
        const scalar deviation = share*(block[k] - mean[k]);

        for (label l = k; l < mean.size(); ++l)
        {
            products[entry++] += deviation*(block[l] - mean[l]);
        }
    }

    for (label k = 0; k < mean.size(); ++k)
    {
        mean[k] += (block[k] - mean[k])/nBlocks;
    }
}


Foam::scalar Foam::cghs::blockMoments::level::squaredError
(
    const UList<scalar>& gradient
) const
{
    scalar sum = 0;

    label entry = 0;
    for (label k = 0; k < gradient.size(); ++k)
    {
        sum += sqr(gradient[k])*products[entry++];

        for (label l = k + 1; l < gradient.size(); ++l)
        {
            sum += 2*gradient[k]*gradient[l]*products[entry++];
        }
    }

    return max(sum, scalar(0))/(nBlocks*(nBlocks - 1));
}

// * * * * * * * * * * * * * * * * The series  * * * * * * * * * * * * * * * //

Foam::cghs::blockMoments::blockMoments(const label nMoments)
:
    nMoments_(nMoments),
    levels_()
{}


Foam::scalar Foam::cghs::blockMoments::nSamples() const
{
    return levels_.empty() ? 0 : levels_[0].nBlocks;
}


void Foam::cghs::blockMoments::add(const UList<scalar>& sample)
{
    scalarField block(sample);

    for (label l = 0; ; ++l)
    {
        if (l == levels_.size())
        {
            levels_.append(level(nMoments_));
        }
        level& here = levels_[l];
        here.add(block);

        here.anyWaiting = !here.anyWaiting;
        if (here.anyWaiting)
        {
            here.waiting = block;
            return;
        }
        block = 0.5*(block + here.waiting);
    }
}


Foam::scalar Foam::cghs::blockMoments::mean(const label k) const
{
    return levels_.empty() ? 0 : levels_[0].mean[k];
}


Foam::cghs::blockMoments::estimate Foam::cghs::blockMoments::function
(
    const scalar value,
    const UList<scalar>& gradient
) const
{
    if (nSamples() < 2)
    {
        return {value, std::numeric_limits<scalar>::quiet_NaN(), false};
    }

    const scalar single = levels_[0].squaredError(gradient);
    if (!(single > 0))
    {
        return {value, 0, true};
    }

    scalar largest = single;
    for
    (
        label l = 1;
        l < levels_.size() && levels_[l].nBlocks >= minBlocks;
        ++l
    )
    {
        const scalar joined = levels_[l].squaredError(gradient);

        if (std::pow(8.0, l) > 2*nSamples()*sqr(joined/single))
        {
            return {value, std::sqrt(joined), true};
        }
        largest = max(largest, joined);
    }

    return {value, std::sqrt(largest), false};
}


Foam::cghs::blockMoments::estimate Foam::cghs::blockMoments::ratio
(
    const label k,
    const label l
) const
{
    scalarField gradient(nMoments_, Zero);
    const scalar below = mean(l);

    if (below == 0)
    {
        return function(0, gradient);
    }

    const scalar value = mean(k)/below;
    gradient[k] = 1/below;
    gradient[l] -= value/below;

    return function(value, gradient);
}

// * * * * * * * * * * * * * * * Across a restart  * * * * * * * * * * * * * //

Foam::label Foam::cghs::blockMoments::stateSize() const
{
    return 2 + 2*nMoments_ + (nMoments_*(nMoments_ + 1))/2;
}


Foam::List<Foam::scalar> Foam::cghs::blockMoments::state() const
{
    DynamicList<scalar> numbers(levels_.size()*stateSize());

    for (const level& l : levels_)
    {
        numbers.append(l.nBlocks);
        numbers.append(l.anyWaiting ? 1 : 0);
        numbers.append(l.mean);
        numbers.append(l.products);
        numbers.append(l.waiting);
    }

    return List<scalar>(std::move(numbers));
}


bool Foam::cghs::blockMoments::setState(const UList<scalar>& state)
{
    if (state.size() % stateSize())
    {
        return false;
    }

    levels_.clear();
    label at = 0;

    while (at < state.size())
    {
        level l(nMoments_);
        l.nBlocks = state[at++];
        l.anyWaiting = state[at++] > 0.5;

        for (scalarField* part : {&l.mean, &l.products, &l.waiting})
        {
            for (scalar& number : *part)
            {
                number = state[at++];
            }
        }
        levels_.append(l);
    }

    return true;
}
