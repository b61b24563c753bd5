/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "parcelNumber.H"
#include "FlatOutput.H"

//- Those that every parcel has
static const Foam::wordList& ownNumbers()
{
    static const Foam::wordList names({"d", "rho", "nParticle", "speed"});

    return names;
}


Foam::wordList Foam::cghs::parcelNumber::choices(const arena& parcels)
{
    wordList names(ownNumbers());

    for (const property* p : parcels.properties())
    {
        if (isA<propertyOf<scalar>>(*p))
        {
            names.append(p->name());
        }
    }

    return names;
}


Foam::cghs::parcelNumber::parcelNumber
(
    const word& name,
    const arena& parcels
)
:
    parcels_(parcels),
    name_(name),
    property_(nullptr)
{
    for (const property* p : parcels.properties())
    {
        if (p->name() == name && isA<propertyOf<scalar>>(*p))
        {
            property_ = isA<propertyOf<scalar>>(*p);
        }
    }

    if (!property_ && !ownNumbers().found(name))
    {
        FatalErrorInFunction
            << "The parcels have no number " << name << nl
            << "Valid choices: " << flatOutput(choices(parcels)) << nl
            << exit(FatalError);
    }
}


Foam::scalar Foam::cghs::parcelNumber::operator()(const label i) const
{
    if (property_)
    {
        return (*property_)[i];
    }

    switch (name_[0])
    {
        case 'd': return parcels_.diameters[i];
        case 'r': return parcels_.density(i);
        case 'n': return parcels_.weights[i];
        default: return mag(parcels_.motions[i].v);
    }
}
