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

    const label first = UPstream::nRequests();
    List<scalarField> sent(away_.size());
    scalarField guests(width*hostedCells().size());
    label at = 0;

    forAll(hosted_, rank)
    {
        if (hosted_[rank].size())
        {
            const label n = width*hosted_[rank].size();
            UIPstream::read
            (
                UPstream::commsTypes::nonBlocking,
                rank,
                reinterpret_cast<char*>(&guests[at]),
                n*sizeof(scalar)
            );
            at += n;
        }
        if (away_[rank].size())
        {
            scalarField& out = sent[rank];
            out.setSize(width*away_[rank].size());
            forAll(away_[rank], k)
            {
                for (label c = 0; c < width; ++c)
                {
                    out[width*k + c] = rows[width*away_[rank][k] + c];
                }
            }
            UOPstream::write
            (
                UPstream::commsTypes::nonBlocking,
                rank,
                reinterpret_cast<const char*>(out.cdata()),
                out.byteSize()
            );
        }
    }
    UPstream::waitRequests(first);
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

    const label first = UPstream::nRequests();
    List<scalarField> received(away_.size());
    label at = 0;

    forAll(hosted_, rank)
    {
        if (away_[rank].size())
        {
            received[rank].setSize(width*away_[rank].size());
            UIPstream::read
            (
                UPstream::commsTypes::nonBlocking,
                rank,
                reinterpret_cast<char*>(received[rank].data()),
                received[rank].byteSize()
            );
        }
        if (hosted_[rank].size())
        {
            const label n = width*hosted_[rank].size();
            UOPstream::write
            (
                UPstream::commsTypes::nonBlocking,
                rank,
                reinterpret_cast<const char*>(&guests[at]),
                n*sizeof(scalar)
            );
            at += n;
        }
    }
    UPstream::waitRequests(first);

    forAll(away_, rank)
    {
        forAll(away_[rank], k)
        {
            for (label c = 0; c < width; ++c)
            {
                rows[width*away_[rank][k] + c] = received[rank][width*k + c];
            }
        }
    }
}
