/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "feeding.H"
#include "meshFreedom.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * * * Construction  * * * * * * * * * * * * * * * //

Foam::cghs::feeding::feeding
(
    const dictionary& cloudProperties,
    const arena& parcels,
    const polyMesh& mesh
)
:
    feeders_(),
    periods_(periods(mesh)),
    nextId_(-1)
{
    for (const entry& e : cloudProperties.subOrEmptyDict("feeding"))
    {
        feeders_.append
        (
            new feeder
            (
                e.keyword(),
                e.dict(),
                cloudProperties,
                parcels,
                mesh
            )
        );
    }
}


bool Foam::cghs::feeding::recycling() const
{
    for (const feeder& f : feeders_)
    {
        if (f.recycling())
        {
            return true;
        }
    }
    return false;
}


Foam::scalar Foam::cghs::feeding::largestDiameter() const
{
    scalar d = 0;
    for (const feeder& f : feeders_)
    {
        d = max(d, f.largestDiameter());
    }
    return d;
}

// * * * * * * * * * * * * * * * * The step  * * * * * * * * * * * * * * * * //

void Foam::cghs::feeding::recycle(transport& cells)
{
    if (!recycling())
    {
        return;
    }

    for (const departure& parcel : cells.gone().collect())
    {
        for (feeder& f : feeders_)
        {
            if (f.takes(parcel.patch))
            {
                f.take(parcel);
                break;
            }
        }
    }
}


void Foam::cghs::feeding::findNextId(const arena& parcels)
{
    if (nextId_ < 0)
    {
        for (label i = 0; i < parcels.size(); ++i)
        {
            nextId_ = max(nextId_, parcels.ids[i]);
        }
        nextId_ = returnReduce(nextId_, maxOp<label>()) + 1;
    }
}


Foam::DynamicList<Foam::cghs::feeder::arrival> Foam::cghs::feeding::find
(
    const arena& parcels,
    const scalar time,
    const scalar deltaT,
    transport& cells,
    contactStage& contacts
)
{
    findNextId(parcels);

    recycle(cells);

    vacancies room(parcels, contacts, periods_);
    DynamicList<feeder::arrival> arrivals;

    for (feeder& f : feeders_)
    {
        f.feed(time, deltaT, cells, contacts, room, arrivals);
    }

    return arrivals;
}


void Foam::cghs::feeding::append
(
    const feeder::arrival& newcomer,
    const label id,
    arena& parcels
)
{
    const departure& it = newcomer.parcel;
    const label i = parcels.append(1);

    parcels.setSize(i, it.d, it.weight, it.density);
    parcels.spheres[i].x = newcomer.x;
    parcels.motions[i].v = newcomer.v;
    parcels.cells[i] = newcomer.cell;
    parcels.ids[i] = id;

    parcels.freshen(i, *newcomer.fresh);

    if (it.row.size())
    {
        parcels.setRow(i, it.row);
    }
    parcels.noteIn(i);
}


void Foam::cghs::feeding::append
(
    const UList<feeder::arrival>& arrivals,
    arena& parcels
)
{
    for (const feeder::arrival& newcomer : arrivals)
    {
        // All ranks count
        const label id =
            newcomer.parcel.id == -1 ? nextId_++ : newcomer.parcel.id;

        if (newcomer.owner == Pstream::myProcNo())
        {
            append(newcomer, id, parcels);
        }
    }
}

// * * * * * * * * * * * * * * * * The state * * * * * * * * * * * * * * * * //

void Foam::cghs::feeding::report(Ostream& os) const
{
    for (const feeder& f : feeders_)
    {
        f.report(os);
    }
}


void Foam::cghs::feeding::state(dictionary& state) const
{
    state.add("nextId", nextId_);

    dictionary all;
    for (const feeder& f : feeders_)
    {
        all.add(f.name(), f.state());
    }
    state.add("feeders", all);
}


void Foam::cghs::feeding::setState(const dictionary& state)
{
    state.readIfPresent("nextId", nextId_);

    const dictionary all(state.subOrEmptyDict("feeders"));
    for (feeder& f : feeders_)
    {
        if (all.found(f.name()))
        {
            f.setState(all.subDict(f.name()));
        }
    }
}
