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
    blocks(nMoments),
    waiting(nMoments, Zero)
{}

// * * * * * * * * * * * * * * * * The series  * * * * * * * * * * * * * * * //

Foam::cghs::blockMoments::blockMoments(const label nMoments)
:
    nMoments_(nMoments),
    levels_()
{}


Foam::scalar Foam::cghs::blockMoments::nSamples() const
{
    return levels_.empty() ? 0 : levels_[0].blocks.nSamples();
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
        here.blocks.add(block);

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
    return levels_.empty() ? 0 : levels_[0].blocks.mean(k);
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

    const scalar single = levels_[0].blocks.squaredError(gradient);
    if (!(single > 0))
    {
        return {value, 0, true};
    }

    scalar largest = single;
    for
    (
        label l = 1;
        l < levels_.size() && levels_[l].blocks.nSamples() >= minBlocks;
        ++l
    )
    {
        const scalar joined = levels_[l].blocks.squaredError(gradient);

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
    return 2 + covariances(nMoments_).stateSize() + nMoments_;
}


Foam::List<Foam::scalar> Foam::cghs::blockMoments::state() const
{
    DynamicList<scalar> numbers(levels_.size()*stateSize());

    for (const level& l : levels_)
    {
        scalarList known(l.blocks.stateSize());
        l.blocks.getState(0, known);

        numbers.append(l.blocks.nSamples());
        numbers.append(l.anyWaiting ? 1 : 0);
        numbers.append(known);
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
        l.blocks.setSamples(state[at++]);
        l.anyWaiting = state[at++] > 0.5;

        const label nKnown = l.blocks.stateSize();
        l.blocks.setState(0, SubList<scalar>(state, nKnown, at));
        at += nKnown;

        l.waiting = SubList<scalar>(state, nMoments_, at);
        at += nMoments_;
        levels_.append(l);
    }

    return true;
}
