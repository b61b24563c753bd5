/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "visits.H"
#include "labelField.H"
#include "ListOps.H"

Foam::cghs::visits::visits()
:
    nCells_(0),
    nAllAway_(0),
    any_(false)
{}


void Foam::cghs::visits::clear()
{
    places_.clear();
    nAway_.clear();
    hosted_.clear();
    nAllAway_ = 0;
    any_ = false;
}


void Foam::cghs::visits::set
(
    const UList<label>& cells,
    const label nCells,
    const labelListList& away,
    labelListList&& hosted
)
{
    nCells_ = nCells;
    nAway_ = ListOps::create<label>
    (
        away,
        [](const labelList& parcels) { return parcels.size(); }
    );
    hosted_ = std::move(hosted);
    nAllAway_ = sum(nAway_);
    any_ = nAllAway_ > 0;

    for (const labelList& ofRank : hosted_)
    {
        any_ = any_ || ofRank.size();
    }

    if (nAllAway_)
    {
        places_ = cells;
        label place = nCells;

        for (const labelList& ofRank : away)
        {
            for (const label i : ofRank)
            {
                places_[i] = place++;
            }
        }
    }
}
