/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "memoryTransfer.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * * * * Before  * * * * * * * * * * * * * * * * * //

void Foam::cghs::memoryTransfer::begin
(
    const arena& parcels,
    contactList& own,
    const rankContacts& ranks,
    const label firstGuestSlot
)
{
    forAll(former_, i)
    {
        former_[i] = i;
    }
    formerIds_ = SubList<label>(parcels.ids, parcels.size());

    const auto orphan = [&](const contact& c, const contactMemory& memory)
    {
        orphans_.append
        (
            remembered
            {
                ranks.idOf(parcels, c.a), ranks.idOf(parcels, c.b), c.n, memory
            }
        );
    };

    // They come last in the list
    label n = own.contacts.size();

    while (n > 0 && own.contacts[n - 1].slot >= firstGuestSlot)
    {
        --n;
        orphan(own.contacts[n], own.memories[n]);
    }
    own.contacts.resize(n);
    own.memories.resize(n);

    ranks.forMeetings
    (
        [&](const contactList& list)
        {
            forAll(list.contacts, i)
            {
                orphan(list.contacts[i], list.memories[i]);
            }
        }
    );
}

// * * * * * * * * * * * * * * * * After * * * * * * * * * * * * * * * * * * //

Foam::labelList Foam::cghs::memoryTransfer::indicesNow
(
    const arena& parcels
) const
{
    labelList now(formerIds_.size(), -1);

    for (label i = 0; i < parcels.size(); ++i)
    {
        const label k = former_[i];

        // A parcel that was fed has any number there, but an id of its own
        if (k < formerIds_.size() && formerIds_[k] == parcels.ids[i])
        {
            now[k] = i;
        }
    }

    return now;
}


void Foam::cghs::memoryTransfer::sort
(
    const contactList& contacts,
    const arena& parcels,
    const label formerWall,
    const label wallBody,
    contactList& kept
)
{
    const labelList now(indicesNow(parcels));

    forAll(contacts.contacts, i)
    {
        contact c = contacts.contacts[i];
        const contactMemory& memory = contacts.memories[i];
        // Bodies from there on are walls: those that move have one each
        const bool atWall = c.b >= formerWall;
        const label a = now[c.a];
        const label b = atWall ? wallBody : now[c.b];

        if (a == -1 || b == -1)
        {
            orphans_.append
            (
                remembered
                {
                    formerIds_[c.a],
                    atWall ? -1 : formerIds_[c.b],
                    c.n,
                    memory
                }
            );
            continue;
        }

        // Walls have the parcel as slot; pairs are given theirs later
        c.a = a;
        c.b = b;
        c.slot = atWall ? a : -1;
        kept.append(c, memory);
    }
}


void Foam::cghs::memoryTransfer::adoptOwn
(
    const arena& parcels,
    const label wallBody,
    contactList& kept
) const
{
    // Where the parcels of orphans are, if they are here
    Map<label> here(2*orphans_.size());

    for (const remembered& r : orphans_)
    {
        here.set(r.idA, -1);
        here.set(r.idB, -1);
    }

    for (label i = 0; i < parcels.size(); ++i)
    {
        auto place = here.find(parcels.ids[i]);

        if (place.found())
        {
            *place = i;
        }
    }

    for (const remembered& r : orphans_)
    {
        const bool atWall = r.idB == -1;
        contact c;

        c.a = here[r.idA];
        c.b = atWall ? wallBody : here[r.idB];

        if (c.a != -1 && c.b != -1)
        {
            c.surface = atWall ? contact::parcelWall : contact::parcelParcel;
            c.slot = atWall ? c.a : -1;
            c.n = r.n;
            c.overlap = 0;
            kept.append(c, r.memory);
        }
    }
}


void Foam::cghs::memoryTransfer::sortByIds()
{
    byIds_.clear();

    forAll(orphans_, k)
    {
        const remembered& r = orphans_[k];

        if (r.idB != -1)
        {
            byIds_(edge(r.idA, r.idB)).append(k);
        }
    }
}


const Foam::cghs::memoryTransfer::remembered*
Foam::cghs::memoryTransfer::find
(
    const label idA,
    const label idB,
    const vector& n
) const
{
    // A small periodic box may hold a pair twice
    constexpr scalar sameNormal = 0.9;

    const auto found = byIds_.cfind(edge(idA, idB));

    if (found.found())
    {
        for (const label k : *found)
        {
            const remembered& r = orphans_[k];
            const scalar sign = r.idA == idA ? 1 : -1;

            if (sign*(r.n & n) > sameNormal)
            {
                return &r;
            }
        }
    }

    return nullptr;
}


void Foam::cghs::memoryTransfer::list
(
    contactList& kept,
    const pairSearch& search,
    const label nOwn,
    contactList& contacts
)
{
    labelList start(nOwn + 1, Zero);

    forAll(kept.contacts, k)
    {
        contact& c = kept.contacts[k];

        if (c.slot == -1 && c.a > c.b)
        {
            std::swap(c.a, c.b);
            c.n = -c.n;
            kept.memories[k].rubbing = -kept.memories[k].rubbing;
        }
        ++start[c.a + 1];
    }

    for (label i = 0; i < nOwn; ++i)
    {
        start[i + 1] += start[i];
    }

    labelList byBody(kept.contacts.size());
    labelList next(SubList<label>(start, nOwn));
    forAll(kept.contacts, k)
    {
        byBody[next[kept.contacts[k].a]++] = k;
    }

    // In the order of slots: walls first, then pairs
    contacts.clear();

    for (const label k : byBody)
    {
        if (kept.contacts[k].slot != -1)
        {
            contacts.append(kept.contacts[k], kept.memories[k]);
        }
    }

    label slot = nOwn;
    search.forOwnPairs
    (
        [&](const label i, const label j)
        {
            for (label k = start[i]; k < start[i + 1]; ++k)
            {
                contact& c = kept.contacts[byBody[k]];

                if (c.b == j && c.slot == -1)
                {
                    c.slot = slot;
                    contacts.append(c, kept.memories[byBody[k]]);
                }
            }
            ++slot;
        }
    );
}


void Foam::cghs::memoryTransfer::adoptGuests
(
    const arena& parcels,
    const pairSearch& search,
    rankContacts& ranks,
    contactLists& own
) const
{
    label slot = parcels.size() + search.nOwnPairs();

    for (const labelPair& pair : search.guestPairs())
    {
        const label i = pair.first();
        const label guest = pair.second();
        const label body = ranks.bodyOf(guest);
        const label id = parcels.ids[i];
        const vector d(parcels.spheres[guest].x - parcels.spheres[i].x);
        const vector n(d/max(mag(d), ROOTVSMALL));
        const remembered* r = find(id, ranks.idOf(parcels, body), n);

        if (r)
        {
            contact c;
            c.a = i;
            c.b = body;
            c.surface = contact::parcelParcel;
            c.slot = slot;
            c.n = n;
            c.overlap = 0;

            contactMemory memory(r->memory);

            if (r->idA != id)
            {
                memory.rubbing = -memory.rubbing;
            }

            ranks.logFor(guest, parcels.size(), own).now.append(c, memory);
        }
        ++slot;
    }
}


void Foam::cghs::memoryTransfer::end
(
    const arena& parcels,
    const pairSearch& search,
    const label formerWall,
    const label wallBody,
    rankContacts& ranks,
    contactLists& own
)
{
    contactList kept;
    sort(own.now, parcels, formerWall, wallBody, kept);

    ranks.tell(orphans_);

    if (orphans_.size())
    {
        adoptOwn(parcels, wallBody, kept);
    }

    list(kept, search, parcels.size(), own.now);

    if (orphans_.size())
    {
        sortByIds();
        adoptGuests(parcels, search, ranks, own);
        orphans_.clear();
    }
}
