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
    const direction layerAxis
)
:
    model_(std::move(model)),
    skinShare_(skinShare),
    walls_(mesh, wallPatches),
    ranks_(periods),
    search_(layerAxis),
    travelled_(GREAT),
    allowed_(0),
    wallBody_(0),
    nBuilds_(0),
    maxOverlap_(0)
{}


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

    wallBody_ = parcels.addGuests(1);

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
    DynamicList<contact>& contacts
)
{
    const sphere& a = parcels.spheres[i];
    const sphere& b = parcels.spheres[j];

    const vector d(b.x - a.x);
    const scalar sumOfRadii = a.r + b.r;

    if (magSqr(d) < sqr(sumOfRadii))
    {
        contact c = makeContact(i, j, contact::parcelParcel, d, sumOfRadii);

        maxOverlap_ = max(maxOverlap_, 0.5*c.overlap/min(a.r, b.r));
        contacts.append(c);
    }
}


void Foam::cghs::contactStage::findContacts(arena& parcels)
{
    contacts_.clear();
    ranks_.clearContacts();

    walls_.touch(parcels.spheres, wallBody_, contacts_);

    for (const contact& c : contacts_)
    {
        maxOverlap_ = max(maxOverlap_, 0.5*c.overlap/parcels.spheres[c.a].r);
    }

    search_.forOwnPairs
    (
        [&](const label i, const label j)
        {
            appendIfTouching(parcels, i, j, contacts_);
        }
    );

    for (const labelPair& pair : search_.guestPairs())
    {
        const label guest = pair.second();
        DynamicList<contact>& contacts =
            ranks_.listFor(guest, parcels.size(), contacts_);

        const label before = contacts.size();
        appendIfTouching(parcels, pair.first(), guest, contacts);

        if (contacts.size() > before)
        {
            contacts.last().b = ranks_.bodyOf(guest);
        }
    }

    model_->tally().nContacts = contacts_.size() + ranks_.nContacts();
}


void Foam::cghs::contactStage::resolve(arena& parcels, const scalar deltaT)
{
    addProfiling(contact, "cghs::contact");

    if (ranks_.active())
    {
        ranks_.refreshPositions(parcels);
    }

    findContacts(parcels);

    bodies b(parcels.contactBodies());

    for (label sweepi = 0; sweepi < model_->nSweeps(); ++sweepi)
    {
        model_->sweep(sweepi, contacts_, b, deltaT);

        ranks_.sweep
        (
            parcels,
            [&](const UList<contact>& contacts)
            {
                model_->sweep(sweepi, contacts, b, deltaT);
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
