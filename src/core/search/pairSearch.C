/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "pairSearch.H"
#include "UIndirectList.H"
#include "ListOps.H"

#include <algorithm>
#include <cmath>

namespace Foam
{
namespace cghs
{

//- May two spheres meet before they have moved and grown by the skin?
static inline bool near(const sphere& s, const sphere& t, const scalar skin)
{
    return magSqr(t.x - s.x) < sqr(s.r + t.r + skin);
}

} // End namespace cghs
} // End namespace Foam

// * * * * * * * * * * * * * * * * The sizes * * * * * * * * * * * * * * * * //

Foam::cghs::pairSearch::level::level(const direction layerAxis)
:
    grid(layerAxis),
    largest(0)
{}


void Foam::cghs::pairSearch::level::sort
(
    const UList<sphere>& all,
    const scalar skin
)
{
    const List<sphere> unsorted(UIndirectList<sphere>(all, members));
    const labelList order(grid.sort(unsorted, 2*largest + skin));

    spheres = UIndirectList<sphere>(unsorted, order);
    members = labelList(UIndirectList<label>(members, order));
}


Foam::label Foam::cghs::pairSearch::sizeClass(const scalar radius) const
{
    const scalar largest = largestOf_[0];
    const label last = largestOf_.size() - 1;

    return
        radius > std::ldexp(largest, -last)
      ? std::ilogb(largest/radius)
      : last;
}


Foam::scalar Foam::cghs::pairSearch::classify(const UList<sphere>& own)
{
    // Whatever is smaller than the largest by more halvings is one class
    constexpr label maxClasses = 20;

    scalar smallest = GREAT;
    scalar largest = 0;

    for (const sphere& s : own)
    {
        smallest = min(smallest, s.r);
        largest = max(largest, s.r);
    }

    if (largest <= 2*smallest)
    {
        largestOf_ = List<scalar>(1, largest);
        return largest;
    }

    largestOf_ = List<scalar>(maxClasses, Zero);
    largestOf_[0] = largest;
    labelList count(maxClasses, Zero);

    for (const sphere& s : own)
    {
        const label c = sizeClass(s.r);
        largestOf_[c] = max(largestOf_[c], s.r);
        ++count[c];
    }

    return largestOf_[findMax(count)];
}


void Foam::cghs::pairSearch::fillLevels
(
    const UList<sphere>& spheres,
    const label nOwn,
    const scalar skin
)
{
    levels_.clear();

    if (largestOf_.size() == 1)
    {
        return;
    }

    List<DynamicList<label>> members(largestOf_.size());

    for (label i = 0; i < nOwn; ++i)
    {
        members[sizeClass(spheres[i].r)].append(i);
    }

    forAll(members, c)
    {
        if (members[c].size())
        {
            level* l = new level(layerAxis_);
            levels_.append(l);

            l->largest = largestOf_[c];
            l->members.transfer(members[c]);
            l->sort(spheres, skin);
        }
    }
}

// * * * * * * * * * * * * * * * * The walks * * * * * * * * * * * * * * * * //

template<class Visitor>
void Foam::cghs::pairSearch::forLevelRanges
(
    const scalar skin,
    const Visitor& visit
) const
{
    // All of one level look in the grid of another
    const auto look = [&](const level& a, const level& b)
    {
        forAll(a.spheres, p)
        {
            const sphere& s = a.spheres[p];

            b.grid.forWithin
            (
                s.x,
                s.r + b.largest + skin,
                [&](const label from, const label to)
                {
                    visit(a, p, b, from, to);
                }
            );
        }
    };

    const auto nRows = [&](const level& a, const level& b)
    {
        return
            a.spheres.size()*b.grid.nRows(a.largest + b.largest + skin);
    };

    forAll(levels_, li)
    {
        const level& a = levels_[li];

        forAll(a.spheres, p)
        {
            a.grid.forLater
            (
                a.spheres[p].x,
                p,
                [&](const label from, const label to)
                {
                    visit(a, p, a, from, to);
                }
            );
        }

        for (label lj = li + 1; lj < levels_.size(); ++lj)
        {
            const level& b = levels_[lj];

            nRows(a, b) < nRows(b, a) ? look(a, b) : look(b, a);
        }
    }
}


template<class Visitor>
void Foam::cghs::pairSearch::forGuestRanges
(
    const UList<sphere>& spheres,
    const label nOwn,
    const scalar skin,
    const Visitor& visit
) const
{
    for (label g = nOwn; g < spheres.size(); ++g)
    {
        const sphere& s = spheres[g];

        if (levels_.empty())
        {
            grid_.forWithin
            (
                s.x,
                s.r + largestOf_[0] + skin,
                [&](const label from, const label to)
                {
                    visit(g, spheres, labelUList(), from, to);
                }
            );
        }

        for (const level& b : levels_)
        {
            b.grid.forWithin
            (
                s.x,
                s.r + b.largest + skin,
                [&](const label from, const label to)
                {
                    visit(g, b.spheres, b.members, from, to);
                }
            );
        }
    }
}

// * * * * * * * * * * * * * * * * The pairs * * * * * * * * * * * * * * * * //

void Foam::cghs::pairSearch::findOwnPairs
(
    const UList<sphere>& spheres,
    const label nOwn,
    const scalar skin
)
{
    for (label i = 0; i < nOwn; ++i)
    {
        start_[i] = partners_.size();

        const sphere& s = spheres[i];

        grid_.forLater(s.x, i, [&](const label from, const label to)
        {
            for (label j = from; j < to; ++j)
            {
                if (near(s, spheres[j], skin))
                {
                    partners_.append(j);
                }
            }
        });
    }

    start_[nOwn] = partners_.size();
}


void Foam::cghs::pairSearch::findLevelPairs
(
    const label nOwn,
    const scalar skin
)
{
    found_.clear();

    forLevelRanges
    (
        skin,
        [&]
        (
            const level& a,
            const label p,
            const level& b,
            const label from,
            const label to
        )
        {
            const label i = a.members[p];

            for (label k = from; k < to; ++k)
            {
                if (near(a.spheres[p], b.spheres[k], skin))
                {
                    const label j = b.members[k];
                    found_.append(labelPair(min(i, j), max(i, j)));
                }
            }
        }
    );

    listFound(nOwn);
}


void Foam::cghs::pairSearch::listFound(const label nOwn)
{
    start_ = 0;

    for (const labelPair& pair : found_)
    {
        ++start_[pair.first() + 1];
    }

    for (label i = 0; i < nOwn; ++i)
    {
        start_[i + 1] += start_[i];
    }

    partners_.resize(found_.size());
    labelList next(SubList<label>(start_, nOwn));

    for (const labelPair& pair : found_)
    {
        partners_[next[pair.first()]++] = pair.second();
    }

    for (label i = 0; i < nOwn; ++i)
    {
        std::sort
        (
            partners_.begin() + start_[i],
            partners_.begin() + start_[i + 1]
        );
    }
}


void Foam::cghs::pairSearch::findGuestPairs
(
    const UList<sphere>& spheres,
    const label nOwn,
    const scalar skin
)
{
    forGuestRanges
    (
        spheres,
        nOwn,
        skin,
        [&]
        (
            const label g,
            const UList<sphere>& hosts,
            const labelUList& members,
            const label from,
            const label to
        )
        {
            for (label k = from; k < to; ++k)
            {
                if (near(spheres[g], hosts[k], skin))
                {
                    const label i = members.empty() ? k : members[k];
                    guestPairs_.append(labelPair(i, g));
                }
            }
        }
    );
}

// * * * * * * * * * * * * * * * * * Public  * * * * * * * * * * * * * * * * //

Foam::cghs::pairSearch::pairSearch(const direction layerAxis)
:
    layerAxis_(layerAxis),
    grid_(layerAxis),
    largestOf_(1, Zero),
    start_(1, Zero)
{}


Foam::labelList Foam::cghs::pairSearch::order
(
    const UList<sphere>& own,
    const UList<label>& ids,
    const scalar skin
)
{
    labelList order(grid_.sort(own, 2*classify(own) + skin));

    grid_.forCells([&](const label from, const label to)
    {
        std::sort
        (
            order.begin() + from,
            order.begin() + to,
            [&](const label a, const label b) { return ids[a] < ids[b]; }
        );
    });

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

    fillLevels(spheres, nOwn, skin);

    if (levels_.empty())
    {
        findOwnPairs(spheres, nOwn, skin);
    }
    else
    {
        findLevelPairs(nOwn, skin);
    }

    findGuestPairs(spheres, nOwn, skin);
}


Foam::label Foam::cghs::pairSearch::nChecks
(
    const UList<sphere>& spheres,
    const label nOwn,
    const scalar skin
) const
{
    label n = 0;

    if (levels_.empty())
    {
        for (label i = 0; i < nOwn; ++i)
        {
            grid_.forLater
            (
                spheres[i].x,
                i,
                [&](const label from, const label to) { n += to - from; }
            );
        }
    }

    forLevelRanges
    (
        skin,
        [&]
        (
            const level&, label, const level&, const label from, const label to
        )
        {
            n += to - from;
        }
    );

    forGuestRanges
    (
        spheres,
        nOwn,
        skin,
        [&]
        (
            label,
            const UList<sphere>&,
            const labelUList&,
            const label from,
            const label to
        )
        {
            n += to - from;
        }
    );

    return n;
}


std::size_t Foam::cghs::pairSearch::bytes() const
{
    std::size_t n =
        grid_.bytes()
      + sizeof(label)
       *(
            start_.size() + partners_.capacity()
          + 2*(found_.capacity() + guestPairs_.capacity())
        );

    for (const level& l : levels_)
    {
        n += l.grid.bytes() + l.spheres.byteSize() + l.members.byteSize();
    }

    return n;
}
