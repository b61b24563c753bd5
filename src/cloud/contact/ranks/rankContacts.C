/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "rankContacts.H"

// * * * * * * * * * * * * * * * * The wire  * * * * * * * * * * * * * * * * //

void Foam::cghs::rankContacts::sendMotions
(
    const arena& parcels,
    const meeting& m
)
{
    wire_.clear();

    for (const label i : m.guests)
    {
        wire_.append(parcels.motions[i].v);

        if (parcels.spinning())
        {
            wire_.append(parcels.spins[i]);
        }
        if (parcels.shifting())
        {
            wire_.append(parcels.shifts[i]);
        }
    }

    wire_.send(m.rank);
}


void Foam::cghs::rankContacts::receiveMotions
(
    arena& parcels,
    const meeting& m
)
{
    const scalar* from =
        wire_.receive(m.rank, m.guests.size()*motionSize(parcels));

    const auto next = [&]()
    {
        const vector v(from[0], from[1], from[2]);
        from += 3;
        return v;
    };

    for (const label i : m.guests)
    {
        parcels.motions[i].v = next();

        if (parcels.spinning())
        {
            parcels.spins[i] = next();
        }
        if (parcels.shifting())
        {
            parcels.shifts[i] = next();
        }
    }
}

// * * * * * * * * * * * * * * * * Invitations * * * * * * * * * * * * * * * //

void Foam::cghs::rankContacts::schedule(const UList<label>& ranks)
{
    meetings_.resize(ranks.size());

    forAll(ranks, i)
    {
        meeting& m = meetings_[i];
        m.rank = ranks[i];
        m.resolver = Pstream::myProcNo() < m.rank;
        m.guests.clear();
        m.log.clear();
    }
}


void Foam::cghs::rankContacts::borrow
(
    arena& parcels,
    const rankBoxes& boxes,
    const scalar reach
)
{
    const label nOwn = parcels.size();

    forAll(meetings_, mi)
    {
        meeting& m = meetings_[mi];

        if (m.resolver)
        {
            IPstream is(Pstream::commsTypes::scheduled, m.rank);
            const List<sphere> spheres(is);
            const List<motion> motions(is);
            guestIds_.append(labelList(is));

            const label first = parcels.addGuests(spheres.size());
            m.guests = identity(spheres.size(), first);

            forAll(spheres, k)
            {
                parcels.spheres[first + k] = spheres[k];
                parcels.motions[first + k] = motions[k];
                meetingOfGuest_.append(mi);
            }
            parcels.borrow(m.guests, is);
        }
        else
        {
            DynamicList<label> lent;

            for (label i = 0; i < nOwn; ++i)
            {
                const sphere& s = parcels.spheres[i];

                if (boxes.near(m.rank, s.x, s.r + reach))
                {
                    lent.append(i);
                }
            }

            m.guests = lent;

            OPstream os(Pstream::commsTypes::scheduled, m.rank);
            os  << List<sphere>(UIndirectList<sphere>(parcels.spheres, lent))
                << List<motion>(UIndirectList<motion>(parcels.motions, lent))
                << labelList(UIndirectList<label>(parcels.ids, lent));
            parcels.lend(lent, os);
        }
    }
}

// * * * * * * * * * * * * * * * * * Public  * * * * * * * * * * * * * * * * //

Foam::cghs::rankContacts::rankContacts(const List<vector>& periods)
:
    images_(periods)
{}


bool Foam::cghs::rankContacts::active() const
{
    return meetings_.size() || !images_.empty();
}


void Foam::cghs::rankContacts::invite
(
    arena& parcels,
    const scalar largest,
    const scalar skin
)
{
    parcels.dismissGuests();
    meetingOfGuest_.clear();
    guestIds_.clear();
    meetings_.clear();

    const rankBoxes boxes(parcels, images_.periods());

    if (Pstream::parRun())
    {
        schedule(boxes.partners(2*largest + skin));
        borrow(parcels, boxes, largest + skin);
    }

    images_.add(parcels, boxes.own(), largest + skin);
}


void Foam::cghs::rankContacts::refreshPositions
(
    arena& parcels,
    const bool velocities
)
{
    const label n = velocities ? 6 : 3;

    for (const meeting& m : meetings_)
    {
        if (m.resolver)
        {
            const scalar* from = wire_.receive(m.rank, n*m.guests.size());

            for (const label g : m.guests)
            {
                parcels.spheres[g].x = vector(from[0], from[1], from[2]);
                if (velocities)
                {
                    parcels.motions[g].v = vector(from[3], from[4], from[5]);
                }
                from += n;
            }
        }
        else
        {
            wire_.clear();
            for (const label i : m.guests)
            {
                wire_.append(parcels.spheres[i].x);
                if (velocities)
                {
                    wire_.append(parcels.motions[i].v);
                }
            }
            wire_.send(m.rank);
        }
    }

    images_.place(parcels);
}


void Foam::cghs::rankContacts::refreshSizes(arena& parcels)
{
    for (const meeting& m : meetings_)
    {
        if (m.resolver)
        {
            const scalar* size = wire_.receive(m.rank, 2*m.guests.size());

            for (const label g : m.guests)
            {
                parcels.spheres[g].r = size[0];
                parcels.motions[g].invMass = size[1];
                size += 2;
            }
        }
        else
        {
            wire_.clear();
            for (const label i : m.guests)
            {
                wire_.append(parcels.spheres[i].r);
                wire_.append(parcels.motions[i].invMass);
            }
            wire_.send(m.rank);
        }
    }
}


Foam::label Foam::cghs::rankContacts::idOf
(
    const arena& parcels,
    const label body
) const
{
    const label nOwn = parcels.size();

    return body < nOwn ? parcels.ids[body] : guestIds_[body - nOwn];
}


Foam::cghs::contactLists& Foam::cghs::rankContacts::logFor
(
    const label guest,
    const label nOwn,
    contactLists& own
)
{
    const label body = bodyOf(guest);

    return
        body < nOwn
      ? own
      : meetings_[meetingOfGuest_[body - nOwn]].log;
}


void Foam::cghs::rankContacts::clearContacts(const bool keep)
{
    for (meeting& m : meetings_)
    {
        m.log.turnOver(keep);
    }
}


void Foam::cghs::rankContacts::lend(arena& parcels, const meeting& m)
{
    sendMotions(parcels, m);
    receiveMotions(parcels, m);
}


Foam::label Foam::cghs::rankContacts::nContacts() const
{
    label n = 0;
    for (const meeting& m : meetings_)
    {
        n += m.log.now.contacts.size();
    }
    return n;
}
