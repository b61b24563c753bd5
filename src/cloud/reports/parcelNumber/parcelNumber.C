/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "parcelNumber.H"
#include "FlatOutput.H"

Foam::wordList Foam::cghs::parcelNumber::choices(const arena& parcels)
{
    wordList names({"d", "rho", "nParticle", "speed"});

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

    const wordList valid(choices(parcels));

    if (!valid.found(name))
    {
        FatalErrorInFunction
            << "The parcels have no number " << name << nl
            << "Valid choices: " << flatOutput(valid) << nl
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
