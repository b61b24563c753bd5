/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "cloudProperties.H"
#include "checkedEntry.H"
#include "Time.H"

Foam::IOdictionary Foam::cghs::readCloudProperties
(
    const objectRegistry& db,
    const word& cloudName
)
{
    return IOdictionary
    (
        IOobject
        (
            cloudName + "Properties",
            db.time().constant(),
            db,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );
}


Foam::cghs::particleProperties::particleProperties
(
    const dictionary& cloudProperties
)
:
    dict(cloudProperties.subDict("constantProperties")),
    density(positiveScalar(dict, "density")),
    weight(scalarInRange(dict, "parcelWeight", 1, GREAT))
{}


Foam::scalar Foam::cghs::particleProperties::diameter() const
{
    return positiveScalar(dict, "diameter");
}
