/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "rankContacts.H"
#include "periodicShifts.H"
#include "PstreamReduceOps.H"
#include "boolList.H"
#include "ListOps.H"

namespace Foam
{
namespace cghs
{

static boundBox widened(const boundBox& box, const scalar by)
{
    const vector margin(vector::uniform(by));
    return boundBox(box.min() - margin, box.max() + margin);
}


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

// * * * * * * * * * * * * * * * * The wire  * * * * * * * * * * * * * * * * //

void Foam::cghs::rankContacts::send(const label rank) const
{
    if (buffer_.size())
    {
        UOPstream::write
        (
            Pstream::commsTypes::scheduled,
            rank,
            reinterpret_cast<const char*>(buffer_.cdata()),
            buffer_.byteSize()
        );
    }
}


void Foam::cghs::rankContacts::receive(const label rank, const label n)
{
    buffer_.resize(n);

    if (n)
    {
        UIPstream::read
        (
            Pstream::commsTypes::scheduled,
            rank,
            reinterpret_cast<char*>(buffer_.data()),
            buffer_.byteSize()
        );
    }
}


void Foam::cghs::rankContacts::append(const vector& v)
{
    buffer_.append(v.x());
    buffer_.append(v.y());
    buffer_.append(v.z());
}


void Foam::cghs::rankContacts::packMotions
(
    const arena& parcels,
    const UList<label>& which
)
{
    buffer_.clear();

    for (const label i : which)
    {
        append(parcels.motions[i].v);

        if (parcels.spinning())
        {
            append(parcels.spins[i]);
        }
        if (parcels.shifting())
        {
            append(parcels.shifts[i]);
        }
    }
}


void Foam::cghs::rankContacts::unpackMotions
(
    arena& parcels,
    const UList<label>& which
) const
{
    const scalar* from = buffer_.cdata();

    const auto next = [&]()
    {
        const vector v(from[0], from[1], from[2]);
        from += 3;
        return v;
    };

    for (const label i : which)
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

void Foam::cghs::rankContacts::schedule
(
    const List<boundBox>& boxes,
    const scalar reach
)
{
    const label nRanks = Pstream::nProcs();
    const label me = Pstream::myProcNo();
    const List<vector> shifts(periodicShifts(periods_, false));

    const auto meet = [&](const label p, const label q)
    {
        if (boxes[p].empty() || boxes[q].empty())
        {
            return false;
        }

        const boundBox near(widened(boxes[p], reach));
        bool found = near.overlaps(boxes[q]);

        for (const vector& s : shifts)
        {
            found =
                found
             || near.overlaps(boundBox(boxes[q].min() + s, boxes[q].max() + s));
        }

        return found;
    };

    // Each pair takes the first round in which neither of the two is busy.
    // All ranks work out the same rounds
    List<DynamicList<label>> busy(nRanks);
    DynamicList<labelPair> mine;

    for (label p = 0; p < nRanks; ++p)
    {
        for (label q = p + 1; q < nRanks; ++q)
        {
            if (!meet(p, q))
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
    meetings_.resize(mine.size());

    forAll(mine, i)
    {
        meeting& m = meetings_[i];
        m.rank = mine[i].second();
        m.resolver = me < m.rank;
        m.guests.clear();
        m.log.clear();
    }
}


void Foam::cghs::rankContacts::borrow
(
    arena& parcels,
    const List<boundBox>& boxes,
    const scalar reach
)
{
    const List<vector> shifts(periodicShifts(periods_, false));
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
                const vector& x = parcels.spheres[i].x;
                const boundBox near
                (
                    widened(boxes[m.rank], parcels.spheres[i].r + reach)
                );
                bool wanted = near.contains(x);

                for (const vector& s : shifts)
                {
                    wanted = wanted || near.contains(x + s);
                }

                if (wanted)
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


void Foam::cghs::rankContacts::addImages
(
    arena& parcels,
    const boundBox& box,
    const scalar reach
)
{
    images_.clear();

    if (periods_.empty() || box.empty())
    {
        firstImage_ = parcels.spheres.size();
        return;
    }

    // A pair of own parcels would be met from both its sides: half of the
    // shifts will do. A borrowed guest is seen from this side only
    const List<vector> ownShifts(periodicShifts(periods_, true));
    const List<vector> guestShifts(periodicShifts(periods_, false));

    forAll(parcels.spheres, i)
    {
        const sphere& body = parcels.spheres[i];
        const boundBox near(widened(box, body.r + reach));

        for (const vector& s : i < parcels.size() ? ownShifts : guestShifts)
        {
            if (near.contains(body.x + s))
            {
                images_.append(image{i, s});
            }
        }
    }

    firstImage_ = parcels.addGuests(images_.size());
    placeImages(parcels);
}


void Foam::cghs::rankContacts::placeImages(arena& parcels) const
{
    forAll(images_, k)
    {
        const sphere& s = parcels.spheres[images_[k].body];

        parcels.spheres[firstImage_ + k] = sphere(s.x + images_[k].shift, s.r);
    }
}

// * * * * * * * * * * * * * * * * * Public  * * * * * * * * * * * * * * * * //

Foam::cghs::rankContacts::rankContacts(const List<vector>& periods)
:
    periods_(periods),
    firstImage_(0)
{}


bool Foam::cghs::rankContacts::active() const
{
    return meetings_.size() || images_.size();
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

    const boundBox box(boxOf(parcels));

    if (Pstream::parRun())
    {
        List<boundBox> boxes(Pstream::nProcs());
        boxes[Pstream::myProcNo()] = box;
        Pstream::gatherList(boxes);
        Pstream::scatterList(boxes);

        schedule(boxes, 2*largest + skin);
        borrow(parcels, boxes, largest + skin);
    }

    addImages(parcels, box, largest + skin);
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
            receive(m.rank, n*m.guests.size());

            const scalar* from = buffer_.cdata();
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
            buffer_.clear();
            for (const label i : m.guests)
            {
                append(parcels.spheres[i].x);
                if (velocities)
                {
                    append(parcels.motions[i].v);
                }
            }
            send(m.rank);
        }
    }

    placeImages(parcels);
}


void Foam::cghs::rankContacts::refreshSizes(arena& parcels)
{
    for (const meeting& m : meetings_)
    {
        if (m.resolver)
        {
            receive(m.rank, 2*m.guests.size());

            const scalar* size = buffer_.cdata();
            for (const label g : m.guests)
            {
                parcels.spheres[g].r = size[0];
                parcels.motions[g].invMass = size[1];
                size += 2;
            }
        }
        else
        {
            buffer_.clear();
            for (const label i : m.guests)
            {
                buffer_.append(parcels.spheres[i].r);
                buffer_.append(parcels.motions[i].invMass);
            }
            send(m.rank);
        }
    }
}


Foam::label Foam::cghs::rankContacts::bodyOf(const label guest) const
{
    return guest < firstImage_ ? guest : images_[guest - firstImage_].body;
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


Foam::cghs::contactLog& Foam::cghs::rankContacts::logFor
(
    const label guest,
    const label nOwn,
    contactLog& own
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
    packMotions(parcels, m.guests);
    send(m.rank);

    receive(m.rank, m.guests.size()*motionSize(parcels));
    unpackMotions(parcels, m.guests);
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
