/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "cloudProperties.H"
#include "checkedEntry.H"
#include "constantDictionary.H"

Foam::IOdictionary Foam::cghs::readCloudProperties
(
    const objectRegistry& db,
    const word& cloudName
)
{
    return constantDictionary(db, cloudName + "Properties");
}


Foam::wordList Foam::cghs::transportedQuantitiesOf
(
    const dictionary& cloudProperties
)
{
    return
        cloudProperties.subOrEmptyDict("solution")
       .getOrDefault("transported", wordList());
}


//- The constantProperties, but for what another dictionary has instead
static Foam::dictionary propertiesWith
(
    const Foam::dictionary& cloudProperties,
    const Foam::dictionary& instead
)
{
    Foam::dictionary dict(cloudProperties.subDict("constantProperties"));

    for (const char* entry : {"diameter", "density", "parcelWeight"})
    {
        if (instead.found(entry))
        {
            dict.set(instead.lookupEntry(entry, Foam::keyType::LITERAL));
        }
    }

    return dict;
}


Foam::cghs::particleProperties::particleProperties
(
    const dictionary& cloudProperties,
    const dictionary& instead
)
:
    dict(propertiesWith(cloudProperties, instead)),
    density(positiveScalar(dict, "density")),
    weight(scalarInRange(dict, "parcelWeight", 1, GREAT))
{}


Foam::scalar Foam::cghs::particleProperties::diameter() const
{
    return positiveScalar(dict, "diameter");
}
