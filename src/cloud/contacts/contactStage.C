/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "contactStage.H"
#include "PstreamReduceOps.H"
#include "profiling.H"

Foam::cghs::contactStage::contactStage
(
    autoPtr<contactModel>&& model,
    const scalar skinShare,
    const polyMesh& mesh,
    const UList<label>& wallPatches,
    const List<vector>& periods,
    const vector& g
)
:
    model_(std::move(model)),
    magG_(mag(g)),
    margin_(model_->margin()),
    skinShare_(skinShare),
    walls_(mesh, wallPatches),
    ranks_(periods),
    search_(layerAxis(g)),
    travelled_(GREAT),
    allowed_(0),
    wallBody_(0),
    nBuilds_(0),
    maxOverlap_(0)
{}


Foam::direction Foam::cghs::contactStage::layerAxis(const vector& g)
{
    direction axis = 2;

    for (const direction d : {0, 1})
    {
        if (mag(g[d]) > mag(g[axis]))
        {
            axis = d;
        }
    }

    return axis;
}


void Foam::cghs::contactStage::rebuild(arena& parcels)
{
    addProfiling(list, "cghs::contactList");

    parcels.dismissGuests();

    scalar maxRadius = 0;
    for (label i = 0; i < parcels.size(); ++i)
    {
        maxRadius = max(maxRadius, parcels.spheres[i].r);
    }
    reduce(maxRadius, maxOp<scalar>());

    const scalar skin = skinShare_*2*maxRadius;
    const scalar reach = 2*maxRadius + skin;

    parcels.reorder(search_.order(parcels.spheres, parcels.ids, reach));
    ranks_.invite(parcels, reach);
    search_.build(parcels.spheres, parcels.size(), skin);
    walls_.find(parcels.spheres, parcels.size(), skin);

    const label formerWall = wallBody_;
    wallBody_ = parcels.addGuests(1);

    if (model_->needsMemory())
    {
        relabel(parcels, formerWall);
    }

    // Two parcels that run at each other use up the skin together
    travelled_ = 0;
    allowed_ = 0.5*skin;
    ++nBuilds_;
}


inline void Foam::cghs::contactStage::appendIfTouching
(
    const arena& parcels,
    const label i,
    const label j,
    const label slot,
    DynamicList<contact>& contacts
)
{
    const sphere& a = parcels.spheres[i];
    const sphere& b = parcels.spheres[j];

    const vector d(b.x - a.x);
    const scalar sumOfRadii = a.r + b.r;

    if (magSqr(d) < sqr(sumOfRadii + 2*margin_*min(a.r, b.r)))
    {
        const contact c
        (
            makeContact(i, j, contact::parcelParcel, slot, d, sumOfRadii)
        );

        maxOverlap_ = max(maxOverlap_, 0.5*c.overlap/min(a.r, b.r));
        contacts.append(c);
    }
}


void Foam::cghs::contactStage::findContacts(arena& parcels)
{
    // Slots: walls by parcel, then pairs, then pairs with guests
    label slot = parcels.size();

    previous_.swap(contacts_);
    contacts_.clear();
    ranks_.clearContacts();

    walls_.touch(parcels.spheres, wallBody_, margin_, contacts_);

    for (const contact& c : contacts_)
    {
        maxOverlap_ = max(maxOverlap_, 0.5*c.overlap/parcels.spheres[c.a].r);
    }

    search_.forOwnPairs
    (
        [&](const label i, const label j)
        {
            appendIfTouching(parcels, i, j, slot++, contacts_);
        }
    );

    for (const labelPair& pair : search_.guestPairs())
    {
        const label guest = pair.second();
        DynamicList<contact>& contacts =
            ranks_.listFor(guest, parcels.size(), contacts_);

        const label before = contacts.size();
        appendIfTouching(parcels, pair.first(), guest, slot++, contacts);

        if (contacts.size() > before)
        {
            contacts.last().b = ranks_.bodyOf(guest);
        }
    }

    if (model_->needsMemory())
    {
        recall(contacts_, previous_);
        ranks_.forMeetings(&contactStage::recall);

    }

    model_->tally().nContacts = contacts_.size() + ranks_.nContacts();
}


void Foam::cghs::contactStage::recall
(
    DynamicList<contact>& contacts,
    const UList<contact>& previous
)
{
    // A parcel may touch several walls, all under one slot: the normals tell
    // which is which
    constexpr scalar sameNormal = 0.9;

    label from = 0;

    for (contact& c : contacts)
    {
        while (from < previous.size() && previous[from].slot < c.slot)
        {
            ++from;
        }

        for
        (
            label k = from;
            k < previous.size() && previous[k].slot == c.slot;
            ++k
        )
        {
            if ((previous[k].n & c.n) > sameNormal)
            {
                c.load = previous[k].load;
                c.held = previous[k].held;
                c.rubbing = previous[k].rubbing;
                break;
            }
        }
    }

    // A gap is only a contact if it bore load
    label n = 0;
    for (const contact& c : contacts)
    {
        if (c.overlap > 0 || c.load > 0)
        {
            contacts[n++] = c;
        }
    }
    contacts.resize(n);
}


void Foam::cghs::contactStage::noteIndices(arena& parcels)
{
    forAll(former_, i)
    {
        former_[i] = i;
    }
}


void Foam::cghs::contactStage::relabel
(
    const arena& parcels,
    const label formerWall
)
{
    const label nOwn = parcels.size();

    label nFormer = 0;
    for (const label i : former_)
    {
        nFormer = max(nFormer, i + 1);
    }

    labelList now(nFormer, -1);
    forAll(former_, i)
    {
        if (former_[i] != -1)
        {
            now[former_[i]] = i;
        }
    }

    // By first body, to be found from the list of partners
    DynamicList<contact> kept(contacts_.size());
    labelList start(nOwn + 1, Zero);

    for (contact c : contacts_)
    {
        const bool atWall = c.b == formerWall;

        if (c.a >= nFormer || (!atWall && c.b >= nFormer))
        {
            continue;
        }

        c.a = now[c.a];
        c.b = atWall ? wallBody_ : now[c.b];

        if (c.a == -1 || c.b == -1)
        {
            continue;
        }

        if (!atWall && c.a > c.b)
        {
            std::swap(c.a, c.b);
            c.n = -c.n;
            c.rubbing = -c.rubbing;
        }

        // Walls have the parcel as slot; pairs are given theirs below
        c.slot = atWall ? c.a : -1;
        kept.append(c);
        ++start[c.a + 1];
    }

    for (label i = 0; i < nOwn; ++i)
    {
        start[i + 1] += start[i];
    }

    labelList byBody(kept.size());
    labelList next(SubList<label>(start, nOwn));
    forAll(kept, k)
    {
        byBody[next[kept[k].a]++] = k;
    }

    // In the order of slots: walls first, then pairs
    contacts_.clear();

    for (const label k : byBody)
    {
        if (kept[k].slot != -1)
        {
            contacts_.append(kept[k]);
        }
    }

    label slot = nOwn;
    search_.forOwnPairs
    (
        [&](const label i, const label j)
        {
            for (label k = start[i]; k < start[i + 1]; ++k)
            {
                contact& c = kept[byBody[k]];

                if (c.b == j && c.slot == -1)
                {
                    c.slot = slot;
                    contacts_.append(c);
                }
            }
            ++slot;
        }
    );
}


void Foam::cghs::contactStage::resolve(arena& parcels, const scalar deltaT)
{
    addProfiling(contact, "cghs::contact");

    if (ranks_.active())
    {
        ranks_.refreshPositions(parcels);
    }

    parcels.clearShifts();
    findContacts(parcels);

    const stepScales step{deltaT, magG_*deltaT};
    bodies b(parcels.contactBodies());

    for (label sweepi = 0; sweepi < model_->nSweeps(); ++sweepi)
    {
        model_->sweep(sweepi, contacts_, b, step);

        ranks_.sweep
        (
            parcels,
            [&](UList<contact>& contacts)
            {
                model_->sweep(sweepi, contacts, b, step);
            }
        );
    }
}


void Foam::cghs::contactStage::resetLog()
{
    maxOverlap_ = 0;
    nBuilds_ = 0;
    model_->tally() = contactTally();
}


std::size_t Foam::cghs::contactStage::bytes() const
{
    return
        search_.bytes() + walls_.bytes()
      + contacts_.capacity()*sizeof(contact);
}
