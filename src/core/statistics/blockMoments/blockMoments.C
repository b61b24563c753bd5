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
    last(nMoments, Zero),
    differences((nMoments*(nMoments + 1))/2, Zero)
{}


void Foam::cghs::blockMoments::level::addDifferences
(
    const UList<scalar>& block
)
{
    label entry = 0;

    forAll(block, k)
    {
        for (label l = k; l < block.size(); ++l)
        {
            differences[entry++] += (block[k] - last[k])*(block[l] - last[l]);
        }
    }
}

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

        if (here.blocks.nSamples() > 0)
        {
            here.addDifferences(block);
        }
        here.blocks.add(block);
        here.last.swap(block);

        here.waiting = !here.waiting;
        if (here.waiting)
        {
            return;
        }
        block = 0.5*(block + here.last);
    }
}


Foam::scalar Foam::cghs::blockMoments::mean(const label k) const
{
    return levels_.empty() ? 0 : levels_[0].blocks.mean(k);
}


Foam::cghs::blockMoments::derived Foam::cghs::blockMoments::ratio
(
    const label k,
    const label l
) const
{
    derived f{0, scalarField(nMoments_, Zero)};
    const scalar below = mean(l);

    if (below != 0)
    {
        f.value = mean(k)/below;
        f.gradient[k] = 1/below;
        f.gradient[l] -= f.value/below;
    }

    return f;
}

// * * * * * * * * * * * * * * * *  Errors * * * * * * * * * * * * * * * * * //

bool Foam::cghs::blockMoments::varies(const UList<scalar>& gradient) const
{
    scalar size = 0;
    forAll(gradient, k)
    {
        size += mag(gradient[k]*mean(k));
    }

    const scalar variance =
        nSamples()*levels_[0].blocks.squaredError(gradient);

    return variance > sqr(1e-8*size);
}


Foam::cghs::blockErrors Foam::cghs::blockMoments::errors
(
    const UList<scalar>& gradient
) const
{
    blockErrors result;

    if (nSamples() < 2 || !varies(gradient))
    {
        result.append(nSamples(), 0, 0);
        return result;
    }

    for (const level& l : levels_)
    {
        const scalar n = l.blocks.nSamples();

        if (n > 1)
        {
            result.append
            (
                n,
                l.blocks.squaredError(gradient),
                covariances::form(gradient, l.differences)/(2*n*(n - 1))
            );
        }
    }

    return result;
}


Foam::cghs::blockMoments::estimate Foam::cghs::blockMoments::judge
(
    const derived& function
) const
{
    return judge(function, errors(function.gradient).choose());
}


Foam::cghs::blockMoments::estimate Foam::cghs::blockMoments::judge
(
    const derived& function,
    const blockErrors::choice& chosen
) const
{
    const blockErrors known(errors(function.gradient));

    return
    {
        function.value,
        nSamples() < 2
      ? std::numeric_limits<scalar>::quiet_NaN()
      : std::sqrt(known.squaredError(chosen)),
        known.independent(chosen),
        known.longEnough(chosen)
    };
}

// * * * * * * * * * * * * * * * Across a restart  * * * * * * * * * * * * * //

Foam::label Foam::cghs::blockMoments::stateSize() const
{
    return
        2 + covariances(nMoments_).stateSize()
      + nMoments_ + (nMoments_*(nMoments_ + 1))/2;
}


Foam::List<Foam::scalar> Foam::cghs::blockMoments::state() const
{
    DynamicList<scalar> numbers(levels_.size()*stateSize());

    for (const level& l : levels_)
    {
        scalarList known(l.blocks.stateSize());
        l.blocks.getState(0, known);

        numbers.append(l.blocks.nSamples());
        numbers.append(l.waiting ? 1 : 0);
        numbers.append(known);
        numbers.append(l.last);
        numbers.append(l.differences);
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
        l.waiting = state[at++] > 0.5;

        const label nKnown = l.blocks.stateSize();
        l.blocks.setState(0, SubList<scalar>(state, nKnown, at));
        at += nKnown;

        l.last = SubList<scalar>(state, l.last.size(), at);
        at += l.last.size();

        l.differences = SubList<scalar>(state, l.differences.size(), at);
        at += l.differences.size();
        levels_.append(l);
    }

    return true;
}


Foam::List<Foam::scalar>
Foam::cghs::blockMoments::stateOf(const UList<blockMoments>& all)
{
    DynamicList<scalar> numbers;

    for (const blockMoments& m : all)
    {
        numbers.append(m.state());
    }

    return List<scalar>(std::move(numbers));
}


bool Foam::cghs::blockMoments::setStateOf
(
    UList<blockMoments>& all,
    const UList<scalar>& state
)
{
    const label size = state.size()/max(all.size(), 1);
    bool good = size*all.size() == state.size();

    for (label k = 0; good && k < all.size(); ++k)
    {
        good = all[k].setState(SubList<scalar>(state, size, k*size));
    }

    return good;
}
