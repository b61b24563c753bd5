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
    autoPtr<wallDistance>&& distance,
    const scalar skinShare,
    const polyMesh& mesh,
    const UList<labelPair>& wallPatches,
    const List<vector>& periods,
    const vector& g
)
:
    model_(std::move(model)),
    magG_(mag(g)),
    margin_(model_->margin()),
    lends_(false),
    remember_(model_->needsMemory()),
    anticipate_(model_->anticipates()),
    skinShare_(skinShare),
    wallDistance_(std::move(distance)),
    walls_(mesh, wallPatches, periods),
    ranks_(periods),
    search_(layerAxis(g)),
    travelled_(GREAT),
    allowed_(0),
    resized_(false),
    previousDeltaT_(0),
    maxSpeed_(0),
    wallBody_(0),
    firstGuestSlot_(0),
    nBuilds_(0)
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


Foam::scalar Foam::cghs::contactStage::meanRadius
(
    const arena& parcels,
    const scalar largest
)
{
    // A sum of whole numbers is exact: it depends on no order
    constexpr scalar unit = 1024;

    // Nobody counts as smaller than that, so that dust does not shrink the skin
    constexpr scalar smallest = 0.01;

    scalar sum = 0;
    for (label i = 0; i < parcels.size(); ++i)
    {
        sum +=
            floor(unit*largest/max(parcels.spheres[i].r, smallest*largest));
    }

    const scalar n = returnReduce(parcels.size(), sumOp<label>());
    reduce(sum, sumOp<scalar>());

    return n > 0 ? largest*(n*unit/sum) : 0;
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

    // Neighbours are within reach while parcels use up the rest of the skin
    const scalar reach = 2*needs_.layer*maxRadius;
    const scalar rest = skinShare_*2*meanRadius(parcels, maxRadius);
    const scalar skin = rest + reach;

    parcels.reorder(search_.order(parcels.spheres, parcels.ids, skin));
    ranks_.invite(parcels, maxRadius, skin);
    search_.build(parcels.spheres, parcels.size(), skin);
    walls_.find(parcels.spheres, parcels.size(), skin);

    const label formerWall = wallBody_;
    addWalls(parcels);

    if (remember_)
    {
        memories_.end
        (
            parcels, search_, formerWall, wallBody_, ranks_, contacts_
        );
    }

    firstGuestSlot_ = parcels.size() + search_.nOwnPairs();

    // Two parcels that run or grow at each other use up the skin together
    travelled_ = 0;
    resized_ = false;
    allowed_ = 0.5*rest;
    ++nBuilds_;
}


void Foam::cghs::contactStage::addWalls(arena& parcels)
{
    wallBody_ = parcels.addGuests(1 + walls_.nMoving());

    for (label k = 0; k < walls_.nMoving(); ++k)
    {
        parcels.motions[wallBody_ + 1 + k].v = walls_.movingVelocity(k);
    }
}


void Foam::cghs::contactStage::moveWalls(const UList<vectorField>& byPatch)
{
    if (walls_.setVelocities(byPatch))
    {
        // Who has a body of his own is found anew with the list of partners
        travelled_ = GREAT;
    }
}


inline Foam::scalar Foam::cghs::contactStage::overlapSoon
(
    const contact& c,
    const arena& parcels,
    const scalar deltaT
)
{
    const vector& va = parcels.motions[c.a].v;
    const vector& vb = parcels.motions[c.b].v;

    return c.overlap - 0.5*deltaT*((vb - va) & c.n);
}


inline void Foam::cghs::contactStage::appendIfMeeting
(
    const contact& c,
    const arena& parcels,
    const scalar deltaT,
    contactLists& log
)
{
    log.append
    (
        c,
        c.overlap > 0
     || (anticipate_ && overlapSoon(c, parcels, deltaT) > 0),
        remember_
    );
}


bool Foam::cghs::contactStage::apart
(
    const arena& parcels,
    const label i,
    const label j
) const
{
    const UList<sphere>& spheres = parcels.spheres;

    return walls_.between(i, spheres[i].x, spheres[j].x);
}


inline bool Foam::cghs::contactStage::near
(
    const sphere& a,
    const sphere& b,
    const scalar gapByRadius,
    const scalar horizon
)
{
    const scalar gap = max(gapByRadius*min(a.r, b.r), horizon);

    return magSqr(b.x - a.x) < sqr(a.r + b.r + gap);
}


inline Foam::label Foam::cghs::contactStage::pairSurface
(
    const arena& parcels,
    const label i,
    const label j
)
{
    return contact::surfaceOf
    (
        contact::parcelParcel,
        parcels.materialOf(i),
        parcels.materialOf(j),
        parcels.nMaterials()
    );
}


void Foam::cghs::contactStage::appendPair
(
    const arena& parcels,
    const label i,
    const label j,
    const label bodyOfJ,
    const label slot,
    const scalar deltaT,
    contactLists& log
)
{
    const sphere& a = parcels.spheres[i];
    const sphere& b = parcels.spheres[j];

    const contact c
    (
        makeContact
        (
            i,
            bodyOfJ,
            pairSurface(parcels, i, bodyOfJ),
            slot,
            b.x - a.x,
            a.r + b.r
        )
    );

    overlaps_.note(c.overlap, min(a.r, b.r));
    appendIfMeeting(c, parcels, deltaT, log);
}


void Foam::cghs::contactStage::setSurface(contact& c, const arena& parcels)
{
    const label material = parcels.materialOf(c.a);

    c.surface = contact::surfaceOf
    (
        contact::surfaceType(c.surface),
        material,
        material,
        parcels.nMaterials()
    );
}


void Foam::cghs::contactStage::noteApproaches(const arena& parcels)
{
    if (!needs_.approaches)
    {
        return;
    }

    forLogs
    (
        [&](contactLists& log)
        {
            contactList& list = log.now;
            list.approaches.clear();

            for (const contact& c : list.contacts)
            {
                list.approaches.append
                (
                    (parcels.motions[c.a].v - parcels.motions[c.b].v) & c.n
                );
            }
        }
    );
}


void Foam::cghs::contactStage::findAtWalls
(
    const arena& parcels,
    const scalar deltaT,
    const scalar horizon
)
{
    const UList<sphere>& spheres = parcels.spheres;

    walls_.touch
    (
        spheres,
        [&](const label i) { return distanceOf(parcels, i); },
        wallBody_,
        margin_,
        horizon,
        [&](contact& c, const label face)
        {
            setSurface(c, parcels);
            overlaps_.note(c.overlap, spheres[c.a].r);
            appendIfMeeting(c, parcels, deltaT, contacts_);

            if (needs_.wallFaces)
            {
                contacts_.now.wallFaces.resize
                (
                    contacts_.now.contacts.size(), face
                );
            }
        }
    );
}


void Foam::cghs::contactStage::findPairs
(
    const arena& parcels,
    const scalar deltaT,
    const scalar horizon
)
{
    const sphere* const spheres = parcels.spheres.cdata();
    const scalar gapByRadius = 2*margin_;
    const bool thin = walls_.anyThin();
    label slot = parcels.size();

    search_.forOwnPairs
    (
        [&](const label i, const label j)
        {
            if
            (
                near(spheres[i], spheres[j], gapByRadius, horizon)
             && !(thin && apart(parcels, i, j))
            )
            {
                appendPair(parcels, i, j, j, slot, deltaT, contacts_);
            }
            ++slot;
        }
    );

    for (const labelPair& pair : search_.guestPairs())
    {
        const label i = pair.first();
        const label guest = pair.second();

        if
        (
            near(spheres[i], spheres[guest], gapByRadius, horizon)
         && !(thin && apart(parcels, i, guest))
        )
        {
            appendPair
            (
                parcels,
                i,
                guest,
                ranks_.bodyOf(guest),
                slot,
                deltaT,
                ranks_.logFor(guest, parcels.size(), contacts_)
            );
        }
        ++slot;
    }
}


void Foam::cghs::contactStage::findContacts
(
    const arena& parcels,
    const scalar deltaT
)
{
    contacts_.turnOver(remember_);
    ranks_.clearContacts(remember_);

    // By rising slot: walls by parcel, then pairs, then pairs with guests
    const scalar horizon = this->horizon(deltaT);
    findAtWalls(parcels, deltaT, horizon);
    findPairs(parcels, deltaT, horizon);

    model_->tally().nContacts =
        contacts_.now.contacts.size() + ranks_.nContacts();
}


void Foam::cghs::contactStage::findNeighbours(const arena& parcels)
{
    if (needs_.layer <= 0)
    {
        return;
    }

    const bool thin = walls_.anyThin();
    const UList<sphere>& spheres = parcels.spheres;

    forLogs([](contactLists& log) { log.near.clear(); });

    walls_.touch
    (
        spheres,
        [&](const label i) { return distanceOf(parcels, i); },
        wallBody_,
        0.5*needs_.layer,
        0,
        [&](contact& c, const label face)
        {
            setSurface(c, parcels);
            contacts_.near.contacts.append(c);
            contacts_.near.wallFaces.append(face);
        }
    );

    const auto look = [&](const label i, const label j, contactLists& log)
    {
        const vector d(spheres[j].x - spheres[i].x);
        const scalar radii = spheres[i].r + spheres[j].r;
        const label body = j < parcels.size() ? j : ranks_.bodyOf(j);

        if
        (
            magSqr(d) < sqr((1 + needs_.layer)*radii)
         && !(thin && apart(parcels, i, j))
        )
        {
            log.near.contacts.append
            (
                makeContact
                (
                    i,
                    body,
                    pairSurface(parcels, i, body),
                    -1,
                    d,
                    radii
                )
            );
        }
    };

    search_.forOwnPairs
    (
        [&](const label i, const label j) { look(i, j, contacts_); }
    );

    for (const labelPair& pair : search_.guestPairs())
    {
        look
        (
            pair.first(),
            pair.second(),
            ranks_.logFor(pair.second(), parcels.size(), contacts_)
        );
    }
}


void Foam::cghs::contactStage::noteIndices(const arena& parcels)
{
    if (remember_)
    {
        memories_.begin(parcels, contacts_.now, ranks_, firstGuestSlot_);
    }
}


void Foam::cghs::contactStage::sweep
(
    arena& parcels,
    const label sweepi,
    const scalar deltaT
)
{
    const stepScales step{deltaT, magG_*deltaT, previousDeltaT_};
    bodies b(parcels.contactBodies());

    model_->sweep(sweepi, contacts_.now, b, step);

    ranks_.sweep
    (
        parcels,
        [&](contactList& contacts)
        {
            model_->sweep(sweepi, contacts, b, step);
        }
    );
}


void Foam::cghs::contactStage::refreshSizes(arena& parcels)
{
    if (resized_ && ranks_.active())
    {
        ranks_.refreshSizes(parcels);
    }
    resized_ = false;
}


void Foam::cghs::contactStage::impacts(arena& parcels, const scalar deltaT)
{
    if (!needed())
    {
        return;
    }

    addProfiling(contact, "cghs::contact");

    refreshSizes(parcels);

    if (ranks_.active())
    {
        ranks_.refreshPositions(parcels, anticipate_ || needs_.approaches);
    }

    parcels.clearShifts();
    findContacts(parcels, deltaT);
    noteApproaches(parcels);

    for (label sweepi = 0; sweepi < model_->nImpactSweeps(); ++sweepi)
    {
        sweep(parcels, sweepi, deltaT);
    }
}


void Foam::cghs::contactStage::correct(arena& parcels, const scalar deltaT)
{
    if (!needed())
    {
        return;
    }

    addProfiling(contact, "cghs::contact");

    // Who has made parcels heavier makes them as they were again
    const bool again = resized_;
    refreshSizes(parcels);
    resized_ = again;

    for
    (
        label sweepi = model_->nImpactSweeps();
        sweepi < model_->nSweeps();
        ++sweepi
    )
    {
        sweep(parcels, sweepi, deltaT);
    }

    previousDeltaT_ = deltaT;
}


Foam::dictionary Foam::cghs::contactStage::state() const
{
    dictionary state;
    state.add("previousDeltaT", previousDeltaT_);
    state.add("maxSpeed", maxSpeed_);
    if (remember_)
    {
        state.add("memoriesOf", model_->type());
    }
    return state;
}


bool Foam::cghs::contactStage::understands(const dictionary& state) const
{
    return
        remember_
     && state.getOrDefault<word>("memoriesOf", word::null) == model_->type();
}


void Foam::cghs::contactStage::setState(const dictionary& state)
{
    state.readIfPresent("previousDeltaT", previousDeltaT_);
    state.readIfPresent("maxSpeed", maxSpeed_);
}


void Foam::cghs::contactStage::resetLog()
{
    overlaps_ = overlapStatistics();
    nBuilds_ = 0;
    model_->tally() = contactTally();
}


std::size_t Foam::cghs::contactStage::bytes() const
{
    return
        search_.bytes() + walls_.bytes()
      + contacts_.bytes();
}
