/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "exchangeList.H"
#include "contactStage.H"

Foam::cghs::exchangeList::exchangeList
(
    const dictionary& subModels,
    const fvMesh& mesh,
    arena& parcels
)
:
    PtrList<exchange>(exchange::New(subModels, mesh, parcels))
{}


void Foam::cghs::exchangeList::startLending(contactStage& contacts)
{
    for (exchange& e : *this)
    {
        if (e.looksAtContacts())
        {
            contacts.startLending(e.needs());
            e.setWalls(contacts.wallPatches());
        }
    }
}

// * * * * * * * * * * * * * * * * The step  * * * * * * * * * * * * * * * * //

bool Foam::cghs::exchangeList::consumes() const
{
    for (const exchange& e : *this)
    {
        if (e.consumes())
        {
            return true;
        }
    }

    return false;
}


void Foam::cghs::exchangeList::markGone
(
    const arena& parcels,
    labelUList& exits,
    const label exit
)
{
    boolList gone(parcels.size(), false);

    for (exchange& e : *this)
    {
        e.markGone(parcels, gone);
    }
    forAll(gone, i)
    {
        if (gone[i])
        {
            exits[i] = exit;
        }
    }
}


void Foam::cghs::exchangeList::meet(const arena& parcels, carrierFluid& fluid)
{
    for (exchange& e : *this)
    {
        e.meet(parcels, fluid);
    }
}


bool Foam::cghs::exchangeList::kick(arena& parcels, const scalar halfDeltaT)
{
    bool changed = false;

    for (exchange& e : *this)
    {
        changed = e.kick(parcels, halfDeltaT) || changed;
    }

    return changed;
}


bool Foam::cghs::exchangeList::kickAgain
(
    arena& parcels,
    const scalar halfDeltaT
)
{
    bool changed = false;

    for (exchange& e : *this)
    {
        changed = e.kickAgain(parcels, halfDeltaT) || changed;
    }

    return changed;
}


void Foam::cghs::exchangeList::settle
(
    arena& parcels,
    const scalar halfDeltaT,
    const bool last,
    const scalar fluidDeltaT
)
{
    for (exchange& e : *this)
    {
        e.settle(parcels, halfDeltaT, last, fluidDeltaT);
    }
}


void Foam::cghs::exchangeList::lendContacts
(
    contactStage& contacts,
    arena& parcels,
    const scalar deltaT
)
{
    for (exchange& e : *this)
    {
        const UList<exchange::lookRound>& rounds = e.contactRounds();

        forAll(rounds, k)
        {
            contacts.lend
            (
                parcels,
                rounds[k].shown,
                rounds[k].collected,
                &contactLists::now,
                [&](const contactList& list)
                {
                    k == 0
                  ? e.touch(list, parcels, deltaT)
                  : e.touchAgain(list, parcels, deltaT);
                }
            );
        }

        if (rounds.size())
        {
            e.touched(parcels);
        }
    }
}


void Foam::cghs::exchangeList::lendNeighbours
(
    contactStage& contacts,
    arena& parcels,
    const scalar fluidDeltaT
)
{
    bool found = false;

    for (exchange& e : *this)
    {
        const UList<exchange::lookRound>& rounds = e.neighbourRounds();

        if (rounds.empty())
        {
            continue;
        }
        if (!found)
        {
            contacts.findNeighbours(parcels);
            found = true;
        }

        forAll(rounds, k)
        {
            contacts.lend
            (
                parcels,
                rounds[k].shown,
                rounds[k].collected,
                &contactLists::near,
                [&](const contactList& list)
                {
                    k == 0
                  ? e.near(list, parcels, fluidDeltaT)
                  : e.nearAgain(list, parcels, fluidDeltaT);
                }
            );
        }
        e.wereNear(parcels);
    }
}


void Foam::cghs::exchangeList::evolve(arena& parcels, const scalar deltaT)
{
    for (exchange& e : *this)
    {
        e.evolve(parcels, deltaT);
    }
}


Foam::scalar Foam::cghs::exchangeList::growth() const
{
    scalar most = -1;

    for (const exchange& e : *this)
    {
        most = max(most, e.growth());
    }

    return most;
}


void Foam::cghs::exchangeList::leave
(
    const arena& parcels,
    const scalar deltaT
)
{
    for (exchange& e : *this)
    {
        e.leave(parcels, deltaT);
    }
}


Foam::cghs::exchangeTerms
Foam::cghs::exchangeList::terms(const word& quantity) const
{
    exchangeTerms sum;

    for (const exchange& e : *this)
    {
        sum.add(e.terms(quantity));
    }

    return sum;
}


Foam::cghs::massTerms Foam::cghs::exchangeList::massGiven() const
{
    massTerms sum;

    for (const exchange& e : *this)
    {
        sum.add(e.massGiven());
    }

    return sum;
}


void Foam::cghs::exchangeList::complete
(
    arena& parcels,
    const carrierFluid& fluid,
    const scalar deltaT
)
{
    for (exchange& e : *this)
    {
        e.complete(parcels, fluid, deltaT);
    }
}

// * * * * * * * * * * * * * * * * Reports * * * * * * * * * * * * * * * * * //

Foam::List<Foam::cghs::figure> Foam::cghs::exchangeList::errors() const
{
    List<figure> list;
    for (const exchange& e : *this)
    {
        list.append(e.errors());
    }
    return list;
}


void Foam::cghs::exchangeList::report(const arena& parcels, Ostream& os) const
{
    for (const exchange& e : *this)
    {
        e.report(parcels, os);
    }
}


Foam::dictionary Foam::cghs::exchangeList::state() const
{
    dictionary states;

    for (const exchange& e : *this)
    {
        dictionary own;
        e.state(own);

        if (!own.empty())
        {
            states.add(e.type(), own);
        }
    }

    return states;
}


void Foam::cghs::exchangeList::setState(const dictionary& states)
{
    for (exchange& e : *this)
    {
        e.setState(states.subOrEmptyDict(e.type()));
    }
}
