/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "faceReconstruction.H"
#include "fvcSurfaceIntegrate.H"

Foam::cghs::faceReconstruction::faceReconstruction(const fvMesh& mesh)
:
    n_(mesh.Sf()/mesh.magSf()),
    inverse_(fvc::surfaceSum(mesh.magSf()*sqr(n_))().primitiveField())
{
    // No face looks in a direction that is not solved for
    const Vector<label>& solved = mesh.solutionD();
    const symmTensor absent
    (
        solved.x() < 0, 0, 0,
        solved.y() < 0, 0,
        solved.z() < 0
    );

    for (symmTensor& areas : inverse_)
    {
        areas = inv(areas + tr(areas)*absent);
    }
}


Foam::tmp<Foam::volVectorField> Foam::cghs::faceReconstruction::operator()
(
    const tmp<surfaceScalarField>& flux
) const
{
    tmp<volVectorField> tresult(fvc::surfaceSum(n_*flux));
    volVectorField& v = tresult.ref();

    v.dimensions() /= dimArea;
    v.primitiveFieldRef() = inverse_ & v.primitiveField();
    v.correctBoundaryConditions();

    return tresult;
}
