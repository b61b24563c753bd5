/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "blockErrors.H"

#include <cmath>

// * * * * * * * * * * * * * * * *  Likeness * * * * * * * * * * * * * * * * //

bool Foam::cghs::blockErrors::alike
(
    const scalar n,
    const scalar correlation
)
{
    return correlation > 1.3*std::sqrt((n - 2)/(sqr(n) - 1));
}


Foam::scalar Foam::cghs::blockErrors::stretch(const scalar correlation)
{
    // Of few blocks it can be all but 1 by chance
    const scalar r = max(scalar(0), min(correlation, scalar(0.9)));

    return (1 + r)/(1 - r);
}


Foam::scalar Foam::cghs::blockErrors::level::correlation() const
{
    return squaredError > 0 ? 1 - differences/squaredError : 0;
}

// * * * * * * * * * * * * * * * * The levels  * * * * * * * * * * * * * * * //

void Foam::cghs::blockErrors::append
(
    const scalar nBlocks,
    const scalar squaredError,
    const scalar differences
)
{
    levels_.append(level{nBlocks, squaredError, differences});
}


bool Foam::cghs::blockErrors::varies() const
{
    return levels_.size() && levels_[0].squaredError > 0;
}


void Foam::cghs::blockErrors::join(const blockErrors& other)
{
    if (!other.varies())
    {
        return;
    }

    const scalar single = other.levels_[0].squaredError;

    forAll(other.levels_, l)
    {
        const level& from = other.levels_[l];

        if (l == levels_.size())
        {
            append(from.nBlocks, 0, 0);
        }
        levels_[l].squaredError += from.squaredError/single;
        levels_[l].differences += from.differences/single;
    }
}


Foam::label Foam::cghs::blockErrors::last() const
{
    label l = levels_.size() - 1;
    while (l > 0 && levels_[l].nBlocks < minBlocks)
    {
        --l;
    }
    return l;
}


bool Foam::cghs::blockErrors::isLong(const label l) const
{
    const scalar growth = levels_[l].squaredError/levels_[0].squaredError;

    return std::pow(8.0, l) > 2*levels_[0].nBlocks*sqr(growth);
}


Foam::scalar Foam::cghs::blockErrors::largestSquaredError() const
{
    scalar largest = 0;
    for (label l = 0; l <= last(); ++l)
    {
        largest = max(largest, levels_[l].squaredError);
    }
    return largest;
}

// * * * * * * * * * * * * * * * The judgement * * * * * * * * * * * * * * * //

Foam::cghs::blockErrors::choice Foam::cghs::blockErrors::choose() const
{
    if (!varies())
    {
        return {0, false, 1, 0};
    }

    const label end = last();

    for (label l = 0; l <= end && levels_[l].nBlocks >= minBlocks; ++l)
    {
        const scalar n = levels_[l].nBlocks;
        const scalar r = levels_[l].correlation();

        if ((isLong(l) || l == end) && !alike(n, r))
        {
            return {l, true, isLong(l) ? 1 : stretch(r), levels_[0].nBlocks};
        }
    }

    const scalar shared = stretch(levels_[end].correlation());

    return {end, false, 1, levels_[end].nBlocks/shared};
}


Foam::scalar Foam::cghs::blockErrors::squaredError(const choice& chosen) const
{
    return
        !varies() ? 0
      : chosen.settled ? levels_[chosen.level].squaredError*chosen.stretch
      : largestSquaredError();
}


Foam::scalar Foam::cghs::blockErrors::independent(const choice& chosen) const
{
    const scalar n = levels_.size() ? levels_[0].nBlocks : 0;
    const scalar error = squaredError(chosen);

    return
        error > 0
      ? min(chosen.limit, n*levels_[0].squaredError/error)
      : n;
}


bool Foam::cghs::blockErrors::longEnough(const choice& chosen) const
{
    return
        (chosen.settled || !varies())
     && independent(chosen) >= leastIndependent;
}
