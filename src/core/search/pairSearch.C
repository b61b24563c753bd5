/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "pairSearch.H"
#include "ListOps.H"

#include <algorithm>

// * * * * * * * * * * * * * * * * The grid  * * * * * * * * * * * * * * * * //

Foam::scalar Foam::cghs::pairSearch::nCells(const vector& span) const
{
    scalar n = 1;

    for (direction d = 0; d < 3; ++d)
    {
        n *= floor(span[d]/width_) + 1;
    }

    return n;
}


void Foam::cghs::pairSearch::bulkOf
(
    const UList<sphere>& own,
    vector& low,
    vector& high
)
{
    // So many in a hundred, at each end of each direction, are not the bulk
    constexpr label strays = 1;

    const label cut = strays*own.size()/100;
    List<scalar> x(own.size());

    for (direction d = 0; d < 3; ++d)
    {
        forAll(own, i)
        {
            x[i] = own[i].x[d];
        }

        std::nth_element(x.begin(), x.begin() + cut, x.end());
        low[d] = x[cut];

        const label top = x.size() - 1 - cut;
        std::nth_element(x.begin(), x.begin() + top, x.end());
        high[d] = x[top];
    }
}


void Foam::cghs::pairSearch::layGrid
(
    const UList<sphere>& own,
    const scalar reach
)
{
    vector low(GREAT, GREAT, GREAT);
    vector high(-GREAT, -GREAT, -GREAT);

    for (const sphere& s : own)
    {
        low = min(low, s.x);
        high = max(high, s.x);
    }

    if (own.empty())
    {
        low = high = Zero;
    }

    const scalar maxCells = 4.0*own.size() + 64;
    width_ = max(reach, VSMALL);

    // A few strays far from the rest would make a grid of empty cells: they
    // are counted to the outermost cells instead
    if (nCells(high - low) > maxCells)
    {
        bulkOf(own, low, high);
    }

    // What is sparse all over gets wider cells
    while (nCells(high - low) > maxCells)
    {
        width_ *= 1.3;
    }

    origin_ = low;
    const vector span(high - low);

    for (direction d = 0; d < 3; ++d)
    {
        n_[d] = label(span[d]/width_) + 1;
    }
}


inline Foam::label Foam::cghs::pairSearch::gridCell
(
    const vector& x,
    const direction d
) const
{
    const scalar cell = (x[d] - origin_[d])/width_;

    return cell < 0 ? 0 : cell < n_[d] ? label(cell) : n_[d] - 1;
}


inline Foam::label Foam::cghs::pairSearch::row
(
    const label i1,
    const label i2
) const
{
    return (i2*n_[axes_[1]] + i1)*n_[axes_[0]];
}


inline Foam::label Foam::cghs::pairSearch::gridIndex(const vector& x) const
{
    return
        row(gridCell(x, axes_[1]), gridCell(x, axes_[2]))
      + gridCell(x, axes_[0]);
}

// * * * * * * * * * * * * * * * * The pairs * * * * * * * * * * * * * * * * //

inline void Foam::cghs::pairSearch::appendPartners
(
    const UList<sphere>& spheres,
    const sphere& s,
    const label from,
    const label to,
    const scalar skin
)
{
    for (label j = from; j < to; ++j)
    {
        const sphere& t = spheres[j];

        if (magSqr(t.x - s.x) < sqr(s.r + t.r + skin))
        {
            partners_.append(j);
        }
    }
}


void Foam::cghs::pairSearch::findOwnPairs
(
    const UList<sphere>& spheres,
    const label nOwn,
    const scalar skin
)
{
    const label nRow = n_[axes_[0]];
    const label n1 = n_[axes_[1]];
    const label n2 = n_[axes_[2]];

    for (label i = 0; i < nOwn; ++i)
    {
        start_[i] = partners_.size();

        const sphere& s = spheres[i];
        const label i0 = gridCell(s.x, axes_[0]);
        const label i1 = gridCell(s.x, axes_[1]);
        const label i2 = gridCell(s.x, axes_[2]);
        const label lo = max(i0 - 1, 0);
        const label hi = min(i0 + 1, nRow - 1);

        // The rest of its own row, then each row that comes later in memory:
        // so every pair is met once
        appendPartners
        (
            spheres, s, i + 1, cellStart_[row(i1, i2) + hi + 1], skin
        );

        for (label k2 = i2; k2 <= min(i2 + 1, n2 - 1); ++k2)
        {
            const label first = k2 == i2 ? i1 + 1 : max(i1 - 1, 0);

            for (label k1 = first; k1 <= min(i1 + 1, n1 - 1); ++k1)
            {
                const label start = row(k1, k2);

                appendPartners
                (
                    spheres,
                    s,
                    cellStart_[start + lo],
                    cellStart_[start + hi + 1],
                    skin
                );
            }
        }
    }

    start_[nOwn] = partners_.size();
}


void Foam::cghs::pairSearch::findGuestPairs
(
    const UList<sphere>& spheres,
    const label nOwn,
    const scalar skin
)
{
    for (label g = nOwn; g < spheres.size(); ++g)
    {
        const sphere& s = spheres[g];
        const vector reach(vector::uniform(width_));
        const vector from(s.x - reach);
        const vector to(s.x + reach);

        const label lo = gridCell(from, axes_[0]);
        const label hi = gridCell(to, axes_[0]);

        for
        (
            label k2 = gridCell(from, axes_[2]);
            k2 <= gridCell(to, axes_[2]);
            ++k2
        )
        {
            for
            (
                label k1 = gridCell(from, axes_[1]);
                k1 <= gridCell(to, axes_[1]);
                ++k1
            )
            {
                const label start = row(k1, k2);

                for
                (
                    label i = cellStart_[start + lo];
                    i < cellStart_[start + hi + 1];
                    ++i
                )
                {
                    const sphere& t = spheres[i];

                    if (magSqr(t.x - s.x) < sqr(s.r + t.r + skin))
                    {
                        guestPairs_.append(labelPair(i, g));
                    }
                }
            }
        }
    }
}

// * * * * * * * * * * * * * * * * * Public  * * * * * * * * * * * * * * * * //

Foam::cghs::pairSearch::pairSearch(const direction layerAxis)
:
    axes_((layerAxis + 1) % 3, (layerAxis + 2) % 3, layerAxis),
    origin_(Zero),
    width_(1),
    n_(1, 1, 1),
    start_(1, Zero)
{}


Foam::labelList Foam::cghs::pairSearch::order
(
    const UList<sphere>& own,
    const UList<label>& ids,
    const scalar reach
)
{
    const label nOwn = own.size();

    layGrid(own, reach);

    // Counting sort by grid cell
    labelList cells(nOwn);
    cellStart_.resize(n_.x()*n_.y()*n_.z() + 1);
    cellStart_ = 0;

    forAll(own, i)
    {
        cells[i] = gridIndex(own[i].x);
        ++cellStart_[cells[i] + 1];
    }

    for (label c = 1; c < cellStart_.size(); ++c)
    {
        cellStart_[c] += cellStart_[c - 1];
    }

    labelList next(SubList<label>(cellStart_, cellStart_.size() - 1));
    labelList order(nOwn);

    forAll(own, i)
    {
        order[next[cells[i]]++] = i;
    }

    for (label c = 0; c < cellStart_.size() - 1; ++c)
    {
        std::sort
        (
            order.begin() + cellStart_[c],
            order.begin() + cellStart_[c + 1],
            [&](const label a, const label b) { return ids[a] < ids[b]; }
        );
    }

    return order;
}


void Foam::cghs::pairSearch::build
(
    const UList<sphere>& spheres,
    const label nOwn,
    const scalar skin
)
{
    partners_.clear();
    guestPairs_.clear();
    start_.resize(nOwn + 1);

    findOwnPairs(spheres, nOwn, skin);
    findGuestPairs(spheres, nOwn, skin);
}


std::size_t Foam::cghs::pairSearch::bytes() const
{
    return
        sizeof(label)*
        (
            cellStart_.size() + start_.size() + partners_.capacity()
          + 2*guestPairs_.capacity()
        );
}
