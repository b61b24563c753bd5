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
    away_.clear();
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
    away_ = away;
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


Foam::labelList Foam::cghs::visits::hostedCells() const
{
    DynamicList<label> cells;
    for (const labelList& ofRank : hosted_)
    {
        cells.append(ofRank);
    }
    return labelList(std::move(cells));
}


Foam::labelList Foam::cghs::visits::nHosted(const label width) const
{
    return ListOps::create<label>
    (
        hosted_,
        [=](const labelList& cells) { return width*cells.size(); }
    );
}


Foam::scalarField Foam::cghs::visits::toHosts
(
    const UList<scalar>& rows,
    const label width
) const
{
    if (!any_)
    {
        return scalarField();
    }

    List<List<scalar>> out(away_.size());
    forAll(away_, rank)
    {
        out[rank].setSize(width*away_[rank].size());
        forAll(away_[rank], k)
        {
            for (label c = 0; c < width; ++c)
            {
                out[rank][width*k + c] = rows[width*away_[rank][k] + c];
            }
        }
    }

    const labelList n(nHosted(width));
    scalarField guests(sum(n));
    pass(out, n, guests);
    return guests;
}


void Foam::cghs::visits::fromHosts
(
    const UList<scalar>& guests,
    const label width,
    UList<scalar>& rows
) const
{
    if (!any_)
    {
        return;
    }

    scalarField received(width*nAllAway_);
    pass
    (
        shares(guests, nHosted(width)),
        ListOps::create<label>
        (
            nAway_,
            [=](const label parcels) { return width*parcels; }
        ),
        received
    );

    label at = 0;
    for (const labelList& ofRank : away_)
    {
        for (const label i : ofRank)
        {
            for (label c = 0; c < width; ++c)
            {
                rows[width*i + c] = received[at++];
            }
        }
    }
}
