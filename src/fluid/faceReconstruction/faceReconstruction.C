/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "faceReconstruction.H"
#include "extrapolatedCalculatedFvPatchFields.H"

namespace Foam
{
namespace cghs
{

//- Adds f(facei, patchi or -1) of each face to the cells that it bounds
template<class Type, class Face>
static void addFaces(const fvMesh& mesh, Field<Type>& sums, const Face& f)
{
    const labelUList& owner = mesh.owner();
    const labelUList& neighbour = mesh.neighbour();

    forAll(owner, facei)
    {
        const Type value(f(facei, -1));

        sums[owner[facei]] += value;
        sums[neighbour[facei]] += value;
    }

    forAll(mesh.boundary(), patchi)
    {
        const labelUList& cells = mesh.boundary()[patchi].faceCells();

        forAll(cells, i)
        {
            sums[cells[i]] += f(i, patchi);
        }
    }
}


//- The value of a face, or of a face of a patch
template<class Type>
static inline const Type& at
(
    const GeometricField<Type, fvsPatchField, surfaceMesh>& field,
    const label facei,
    const label patchi
)
{
    return
        patchi < 0
      ? field.primitiveField()[facei]
      : field.boundaryField()[patchi][facei];
}

} // End namespace cghs
} // End namespace Foam

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

Foam::cghs::faceReconstruction::faceReconstruction(const fvMesh& mesh)
:
    mesh_(mesh),
    n_(mesh.Sf()/mesh.magSf()),
    inverse_(mesh.nCells(), Zero)
{
    addFaces
    (
        mesh,
        inverse_,
        [&](const label facei, const label patchi)
        {
            return at(mesh.magSf(), facei, patchi)*sqr(at(n_, facei, patchi));
        }
    );

    for (symmTensor& areas : inverse_)
    {
        areas = inv(symmTensor(areas));
    }
}


Foam::tmp<Foam::volVectorField> Foam::cghs::faceReconstruction::operator()
(
    const surfaceScalarField& flux
) const
{
    auto result = tmp<volVectorField>::New
    (
        IOobject
        (
            "reconstruct(" + flux.name() + ')',
            mesh_.time().timeName(),
            mesh_,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh_,
        dimensionedVector(flux.dimensions()/dimArea, Zero),
        extrapolatedCalculatedFvPatchVectorField::typeName
    );
    vectorField& v = result.ref().primitiveFieldRef();

    addFaces
    (
        mesh_,
        v,
        [&](const label facei, const label patchi)
        {
            return at(flux, facei, patchi)*at(n_, facei, patchi);
        }
    );

    forAll(v, celli)
    {
        v[celli] = inverse_[celli] & vector(v[celli]);
    }

    result.ref().correctBoundaryConditions();

    return result;
}


Foam::tmp<Foam::volVectorField> Foam::cghs::faceReconstruction::operator()
(
    const tmp<surfaceScalarField>& tflux
) const
{
    return operator()(tflux());
}
