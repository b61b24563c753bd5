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
{
    const dictionary& dict = cloudProperties.subDict("constantProperties");

    diameter = positiveScalar(dict, "diameter");
    density = positiveScalar(dict, "density");
    parcelWeight = scalarInRange(dict, "parcelWeight", 1, GREAT);
}


Foam::scalar Foam::cghs::particleProperties::parcelDiameter() const
{
    return diameter*Foam::cbrt(parcelWeight);
}
