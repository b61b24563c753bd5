/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "solidsFlux.H"
#include "cghsCloud.H"
#include "zeroGradientFvPatchFields.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(solidsFlux, 0);
    addToRunTimeSelectionTable(functionObject, solidsFlux, dictionary);


//- An empty field that others find in the mesh
template<class Type>
static GeometricField<Type, fvPatchField, volMesh> cellField
(
    const word& name,
    const fvMesh& mesh,
    const dimensionSet& dimensions
)
{
    return GeometricField<Type, fvPatchField, volMesh>
    (
        IOobject
        (
            name,
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE
        ),
        mesh,
        dimensioned<Type>(dimensions, Zero),
        zeroGradientFvPatchField<Type>::typeName
    );
}

} // End namespace cghs
} // End namespace Foam


Foam::cghs::solidsFlux::solidsFlux
(
    const word& name,
    const Time& time,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, time, dict),
    cloudName_(),
    flux_(cellField<vector>("solidsFlux", mesh_, dimVelocity)),
    fraction_(cellField<scalar>("solidsFraction", mesh_, dimless))
{
    read(dict);
}


bool Foam::cghs::solidsFlux::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);

    dict.readEntry("cloud", cloudName_);

    if (!mesh_.foundObject<cghsCloud>(cloudName_))
    {
        FatalIOErrorInFunction(dict)
            << "There is no cghsCloud called " << cloudName_ << nl
            << "Valid choices: " << mesh_.sortedNames<cghsCloud>() << nl
            << exit(FatalIOError);
    }

    return true;
}


bool Foam::cghs::solidsFlux::execute()
{
    const arena& parcels =
        mesh_.lookupObject<cghsCloud>(cloudName_).parcels();

    vectorField& j = flux_.primitiveFieldRef();
    scalarField& phi = fraction_.primitiveFieldRef();

    j = Zero;
    phi = Zero;

    for (label i = 0; i < parcels.size(); ++i)
    {
        const label celli = parcels.cells[i];
        const scalar share = parcels.volume(i)/mesh_.V()[celli];

        j[celli] += share*parcels.motions[i].v;
        phi[celli] += share;
    }

    flux_.correctBoundaryConditions();
    fraction_.correctBoundaryConditions();

    return true;
}


bool Foam::cghs::solidsFlux::write()
{
    return flux_.write() && fraction_.write();
}
