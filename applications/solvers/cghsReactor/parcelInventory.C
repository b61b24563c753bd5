/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "parcelInventory.H"
#include "massFractions.H"
#include "checkedEntry.H"
#include "filmTransfer.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace cghs
{

//- Of the entry massTransfer, by which no flow can go here [m/s]
static scalar constantFilm
(
    const dictionary& dict,
    const reactionScheme& scheme
)
{
    const filmTransfer film(dict, scheme.askingForFilm());

    if (film.varies())
    {
        FatalIOErrorInFunction(dict)
            << "Entry massTransfer is a law of the flow, but nothing flows past"
            << " particles in a stirred vessel" << nl
            << "Write it as a number [m/s], e.g. massTransfer 0.1;" << nl
            << exit(FatalIOError);
    }
    return film.constant();
}

} // End namespace cghs
} // End namespace Foam


Foam::cghs::parcelInventory::parcelInventory(const reactionScheme& scheme)
:
    solids_(scheme.solids()),
    inventory_(0),
    fresh_(0),
    d_(0),
    rho_(0),
    heatTransfer_(0),
    massTransfer_(0),
    feedRate_(0),
    feedT_(0),
    due_(0),
    random_(1),
    in_(solids_.size(), 0),
    out_(solids_.size(), 0),
    enthalpyIn_(0),
    enthalpyOut_(0)
{}


Foam::cghs::parcelInventory::parcelInventory
(
    const dictionary& dict,
    const reactionScheme& scheme
)
:
    solids_(scheme.solids()),
    inventory_(positiveScalar(dict, "inventory")),
    fresh_(inventory_/labelFrom(dict, "nParcels", 1)),
    d_(positiveScalar(dict, "d")),
    rho_(positiveScalar(dict, "rho")),
    heatTransfer_
    (
        scheme.energetic() ? positiveScalar(dict, "heatTransfer") : 0
    ),
    massTransfer_(constantFilm(dict, scheme)),
    feedRate_(0),
    feedT_(0),
    due_(0),
    random_(dict.getOrDefault<label>("seed", 1)),
    in_(solids_.size(), 0),
    out_(solids_.size(), 0),
    enthalpyIn_(0),
    enthalpyOut_(0)
{
    const scalarField amounts(amountsPerMass(dict, solids_));
    const label n = dict.get<label>("nParcels");
    const scalar T = positiveScalar(dict, "T");

    for (label i = 0; i < n; ++i)
    {
        append(amounts, T);
    }

    if (dict.found("feed"))
    {
        const dictionary& feed = dict.subDict("feed");
        feedRate_ = positiveScalar(feed, "massFlowRate");
        feedAmounts_ = amountsPerMass(feed, solids_);
        feedT_ = positiveScalar(feed, "T");
    }
}


void Foam::cghs::parcelInventory::append
(
    const scalarField& amountsPerMass,
    const scalar T
)
{
    parcels_.append({fresh_*amountsPerMass, T, 0});
}


Foam::scalar Foam::cghs::parcelInventory::massOf(const parcel& p) const
{
    return solids_.massOf(p.n);
}


Foam::scalar Foam::cghs::parcelInventory::enthalpyOf(const parcel& p) const
{
    return heatTransfer_ > 0 ? solids_.enthalpyOf(p.n, p.T) : 0;
}


void Foam::cghs::parcelInventory::feed(const scalar deltaT)
{
    due_ += feedRate_*deltaT;

    while (feedRate_ > 0 && due_ >= fresh_)
    {
        due_ -= fresh_;
        append(feedAmounts_, feedT_);
        in_ += parcels_.last().n;
        enthalpyIn_ += enthalpyOf(parcels_.last());
    }

    scalar there = mass();
    while (there > inventory_*(1 + SMALL) && parcels_.size() > 1)
    {
        const label i = random_.position<label>(0, parcels_.size() - 1);
        const scalar m = massOf(parcels_[i]);

        // As near to it as whole parcels come
        if (there - inventory_ < 0.5*m)
        {
            break;
        }
        there -= m;
        out_ += parcels_[i].n;
        enthalpyOut_ += enthalpyOf(parcels_[i]);
        parcels_[i] = parcels_.last();
        parcels_.remove();
    }
}


void Foam::cghs::parcelInventory::give(reactingCell& cell) const
{
    using constant::mathematical::pi;

    for (const parcel& p : parcels_)
    {
        reactingCell::body body;
        body.W = fresh_/(rho_*pi/6*pow3(d_));
        body.d = d_;
        body.T = p.T;
        body.conductance = body.W*heatTransfer_*pi*sqr(d_);
        body.film = massTransfer_;
        cell.add(body, p.n);
    }
}


void Foam::cghs::parcelInventory::take
(
    const reactingCell& cell,
    const scalar deltaT
)
{
    forAll(parcels_, i)
    {
        parcels_[i].n = cell.amounts(i);
        parcels_[i].T = cell.temperature(i);
        parcels_[i].age += deltaT;
    }
}


Foam::scalar Foam::cghs::parcelInventory::mass() const
{
    scalar m = 0;
    for (const parcel& p : parcels_)
    {
        m += massOf(p);
    }
    return m;
}


Foam::scalarField Foam::cghs::parcelInventory::amounts() const
{
    scalarField n(solids_.size(), 0);
    for (const parcel& p : parcels_)
    {
        n += p.n;
    }
    return n;
}


Foam::scalar Foam::cghs::parcelInventory::enthalpy() const
{
    scalar H = 0;
    for (const parcel& p : parcels_)
    {
        H += enthalpyOf(p);
    }
    return H;
}


Foam::scalar Foam::cghs::parcelInventory::meanT() const
{
    scalar sum = 0;
    for (const parcel& p : parcels_)
    {
        sum += massOf(p)*p.T;
    }
    return sum/max(mass(), VSMALL);
}


Foam::scalar Foam::cghs::parcelInventory::meanAge() const
{
    scalar sum = 0;
    for (const parcel& p : parcels_)
    {
        sum += massOf(p)*p.age;
    }
    return sum/max(mass(), VSMALL);
}


void Foam::cghs::parcelInventory::write(Ostream& os) const
{
    os  << "age,T";
    for (const word& name : solids_.names())
    {
        os  << ',' << name.c_str();
    }
    os  << nl;

    for (const parcel& p : parcels_)
    {
        const scalar m = massOf(p);
        os  << p.age << ',' << p.T;
        forAll(solids_, s)
        {
            os  << ',' << p.n[s]*solids_[s].M()/m;
        }
        os  << nl;
    }
}
