/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "arena.H"
#include "error.H"

#include <cmath>

Foam::cghs::arena::arena
(
    const bool spinning,
    const bool shifting,
    const label nMaterials
)
:
    size_(0),
    spinning_(spinning),
    shifting_(shifting),
    fading_(false),
    nMaterials_(nMaterials),
    spins("omega"),
    materials("typeId"),
    presences("presence"),
    exits("exitPatch")
{
    spins.lend();
    materials.allow(0, nMaterials_ - 1).readFrom("typeId").lend();

    // Who is not known to come in or go out is all there
    presences.allow(0, 1).givenAs(1).forget();
    exits.freshAs(-1).forget();

    add(spheres);
    add(motions);
    add(weights);
    add(diameters);
    add(cells);
    add(ids);

    if (spinning_)
    {
        add(spins);
    }
    if (nMaterials_ > 1)
    {
        add(materials);
    }
}


void Foam::cghs::arena::add(column& c)
{
    columns_.append(&c);
    c.resize(size_);
}


void Foam::cghs::arena::addProperty(property& p)
{
    const wordList taken
    ({
        "positions", "coordinates", "position", "U", "d", "rho", "nParticle",
        "dParcel", "origId", "origProcId", "contactPartners", "contactMemories"
    });

    if (taken.found(p.name()))
    {
        FatalErrorInFunction
            << "A property of the parcels cannot have the name " << p.name()
            << ": each has a file of that name. Others are " << taken << nl
            << exit(FatalError);
    }

    for (const property* other : properties_)
    {
        if (other->name() == p.name())
        {
            FatalErrorInFunction
                << "Two models want a property " << p.name() << " of the parcels"
                << nl << exit(FatalError);
        }
    }

    add(p.values());
    properties_.append(&p);
}


Foam::wordList Foam::cghs::arena::entryNames() const
{
    DynamicList<word> names;

    for (const property* p : properties_)
    {
        if (!p->entryName().empty())
        {
            names.append(p->entryName());
        }
    }

    return wordList(std::move(names));
}


void Foam::cghs::arena::freshen(const label i, const dictionary& dict)
{
    for (property* p : properties_)
    {
        p->freshen(i, dict);
    }
}


template<class Note>
void Foam::cghs::arena::tell(const Note& note) const
{
    for (passageWatch* w : watches_)
    {
        note(*w);
    }

    for (const std::weak_ptr<passageWatch>& weak : guestWatches_)
    {
        const std::shared_ptr<passageWatch> w(weak.lock());
        if (w)
        {
            note(*w);
        }
    }
}


void Foam::cghs::arena::noteIn(const label i) const
{
    const auto note = [&](passageWatch& w) { w.noteIn(*this, i); };
    tell(note);
}


void Foam::cghs::arena::noteOut(const label i, const label patchi) const
{
    const auto note = [&](passageWatch& w) { w.noteOut(*this, i, patchi); };
    tell(note);
}


Foam::label Foam::cghs::arena::rowWidth() const
{
    label n = 0;

    for (const property* p : properties_)
    {
        n += p->recycled() ? p->width() : 0;
    }
    return n;
}


Foam::scalarList Foam::cghs::arena::row(const label i) const
{
    scalarList numbers(rowWidth());
    label k = 0;

    for (const property* p : properties_)
    {
        if (p->recycled())
        {
            p->toRow(i, &numbers[k]);
            k += p->width();
        }
    }
    return numbers;
}


void Foam::cghs::arena::setRow(const label i, const UList<scalar>& numbers)
{
    if (numbers.size() != rowWidth())
    {
        return;
    }

    label k = 0;

    for (property* p : properties_)
    {
        if (p->recycled())
        {
            p->fromRow(i, &numbers[k]);
            k += p->width();
        }
    }
}


void Foam::cghs::arena::startFading()
{
    fading_ = true;
    add(presences);
    add(exits);
}


Foam::scalar Foam::cghs::arena::radiusOf(const scalar d, const scalar W)
{
    return 0.5*d*cbrt(W);
}


void Foam::cghs::arena::setSize
(
    const label i,
    const scalar d,
    const scalar W,
    const scalar rho
)
{
    diameters[i] = d;
    weights[i] = W;
    spheres[i].r = radiusOf(d, W);
    motions[i].invMass = 1/(rho*volume(i));
}


Foam::scalar Foam::cghs::arena::density(const label i) const
{
    const scalar invMass = motions[i].invMass;
    const scalar V = volume(i);
    const scalar rho = 1/(invMass*V);

    // Rounded twice, this may be some digits away from one that gives the mass
    constexpr label nDigits = 4;
    scalar below = rho;
    scalar above = rho;

    for (label n = 0; n <= nDigits; ++n)
    {
        for (const scalar candidate : {below, above})
        {
            if (1/(candidate*V) == invMass)
            {
                return candidate;
            }
        }
        below = std::nextafter(below, scalar(0));
        above = std::nextafter(above, GREAT);
    }

    return rho;
}


Foam::label Foam::cghs::arena::addGuests(const label n)
{
    const label first = spheres.size();

    spheres.resize(first + n, sphere(Zero, 0));
    motions.resize(first + n, motion(Zero, 0));

    for (property* p : properties_)
    {
        if (p->lent())
        {
            p->values().resize(first + n);
        }
    }

    return first;
}


void Foam::cghs::arena::lend(const UList<label>& which, Ostream& os) const
{
    for (const property* p : properties_)
    {
        if (p->lent())
        {
            p->values().pack(which, os);
        }
    }
}


void Foam::cghs::arena::borrow(const UList<label>& guests, Istream& is)
{
    for (property* p : properties_)
    {
        if (p->lent())
        {
            p->values().unpackTo(guests, is);
        }
    }
}


void Foam::cghs::arena::dismissGuests()
{
    spheres.resize(size_);
    motions.resize(size_);

    for (property* p : properties_)
    {
        if (p->lent())
        {
            p->values().resize(size_);
        }
    }
}


void Foam::cghs::arena::clearShifts()
{
    if (shifting_)
    {
        shifts.resize(spheres.size());
        shifts = Zero;
    }
}


Foam::label Foam::cghs::arena::append(const label n)
{
    const label first = size_;

    size_ += n;
    for (column* c : columns_)
    {
        c->resize(size_);
    }

    return first;
}


void Foam::cghs::arena::reorder(const UList<label>& order)
{
    size_ = order.size();
    for (column* c : columns_)
    {
        c->select(order);
    }
}


void Foam::cghs::arena::thin(const UList<bool>& keep)
{
    DynamicList<label> kept(size_);

    for (label i = 0; i < size_; ++i)
    {
        if (keep[i])
        {
            kept.append(i);
        }
    }

    reorder(kept);
}


void Foam::cghs::arena::pack(const UList<label>& which, Ostream& os) const
{
    for (const column* c : columns_)
    {
        c->pack(which, os);
    }
}


void Foam::cghs::arena::unpack(Istream& is)
{
    for (column* c : columns_)
    {
        c->unpack(is);
    }

    size_ = ids.size();
}


std::size_t Foam::cghs::arena::bytesPerParcel() const
{
    std::size_t bytes = 0;

    for (const column* c : columns_)
    {
        bytes += c->bytesPerEntry();
    }

    return bytes;
}
