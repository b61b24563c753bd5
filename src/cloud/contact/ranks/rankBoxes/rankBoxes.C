/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "rankBoxes.H"
#include "periodicShifts.H"
#include "labelPair.H"
#include "ListOps.H"

namespace Foam
{
namespace cghs
{

static boundBox boxOf(const arena& parcels)
{
    boundBox box(boundBox::invertedBox);

    for (label i = 0; i < parcels.size(); ++i)
    {
        box.min() = min(box.min(), parcels.spheres[i].x);
        box.max() = max(box.max(), parcels.spheres[i].x);
    }

    return box;
}

} // End namespace cghs
} // End namespace Foam


Foam::cghs::rankBoxes::rankBoxes
(
    const arena& parcels,
    const UList<vector>& periods
)
:
    shifts_(periodicShifts(periods, false)),
    boxes_(Pstream::nProcs())
{
    boxes_[Pstream::myProcNo()] = boxOf(parcels);

    if (Pstream::parRun())
    {
        Pstream::gatherList(boxes_);
        Pstream::scatterList(boxes_);
    }
}


bool Foam::cghs::rankBoxes::meet
(
    const label p,
    const label q,
    const scalar reach
) const
{
    const boundBox& other = boxes_[q];

    if (boxes_[p].empty() || other.empty())
    {
        return false;
    }

    const boundBox near(widened(boxes_[p], reach));
    bool found = near.overlaps(other);

    for (const vector& s : shifts_)
    {
        found =
            found
         || near.overlaps(boundBox(other.min() + s, other.max() + s));
    }

    return found;
}


bool Foam::cghs::rankBoxes::near
(
    const label rank,
    const vector& x,
    const scalar reach
) const
{
    const boundBox box(widened(boxes_[rank], reach));
    bool found = box.contains(x);

    for (const vector& s : shifts_)
    {
        found = found || box.contains(x + s);
    }

    return found;
}


Foam::labelList Foam::cghs::rankBoxes::partners(const scalar reach) const
{
    const label nRanks = boxes_.size();
    const label me = Pstream::myProcNo();

    // Each pair takes the first round in which neither of the two is busy.
    // All ranks work out the same rounds
    List<DynamicList<label>> busy(nRanks);
    DynamicList<labelPair> mine;

    for (label p = 0; p < nRanks; ++p)
    {
        for (label q = p + 1; q < nRanks; ++q)
        {
            if (!meet(p, q, reach))
            {
                continue;
            }

            label round = 0;
            while (busy[p].found(round) || busy[q].found(round))
            {
                ++round;
            }

            busy[p].append(round);
            busy[q].append(round);

            if (p == me || q == me)
            {
                mine.append(labelPair(round, p == me ? q : p));
            }
        }
    }

    Foam::sort(mine);
    labelList ranks(mine.size());

    forAll(mine, i)
    {
        ranks[i] = mine[i].second();
    }

    return ranks;
}
