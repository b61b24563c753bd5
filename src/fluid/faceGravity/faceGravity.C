/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "faceGravity.H"
#include "meshFreedom.H"
#include "fvm.H"
#include "fvc.H"
#include "fixedValueFvPatchFields.H"
#include "fixedFluxPressureFvPatchScalarField.H"

namespace Foam
{
namespace cghs
{

//- Middle of the faces at which p has a value, or of the mesh if there are none
static vector datum(const volScalarField& p)
{
    const fvMesh& mesh = p.mesh();
    vector moment(Zero);
    scalar area = 0;

    for (const fvPatchScalarField& pp : p.boundaryField())
    {
        if (pp.fixesValue() && !pp.coupled())
        {
            moment += sum(pp.patch().magSf()*pp.patch().Cf());
            area += sum(pp.patch().magSf());
        }
    }
    reduce(moment, sumOp<vector>());
    reduce(area, sumOp<scalar>());

    return
        area > 0
      ? moment/area
      : gSum(mesh.V().field()*mesh.C().primitiveField())/gSum(mesh.V().field());
}

} // End namespace cghs
} // End namespace Foam


Foam::vector Foam::cghs::faceGravity::alongPeriods
(
    const fvMesh& mesh,
    const vector& g
)
{
    // Periods may be oblique to each other: one after the other, without what
    // those before have
    vector along(Zero);
    DynamicList<vector> directions;

    for (vector period : periods(mesh))
    {
        const scalar length = mag(period);

        for (const vector& e : directions)
        {
            period -= (period & e)*e;
        }
        if (mag(period) > 1e-6*length)
        {
            const vector e(period/mag(period));
            directions.append(e);
            along += (g & e)*e;
        }
    }

    // What is across all periods is so to the last digit
    return mag(along) > 1e-10*mag(g) ? along : vector(Zero);
}


Foam::volScalarField Foam::cghs::faceGravity::potentialOf
(
    const volScalarField& p,
    const dimensionedVector& g
)
{
    // Schemes go by the name of the field
    const fvMesh& mesh = p.mesh();
    volScalarField h
    (
        IOobject
        (
            p.name(),
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh,
        dimensionedScalar(g.dimensions()*dimLength, Zero),
        fixedValueFvPatchScalarField::typeName
    );

    const vector x0(datum(p));
    h.primitiveFieldRef() = g.value() & (mesh.C().primitiveField() - x0);

    for (fvPatchScalarField& hp : h.boundaryFieldRef())
    {
        if (isA<fixedValueFvPatchScalarField>(hp))
        {
            hp == (g.value() & (hp.patch().Cf() - x0));
        }
    }
    h.correctBoundaryConditions();

    return h;
}


bool Foam::cghs::faceGravity::balances(const fvPatchScalarField& p)
{
    return isA<fixedFluxPressureFvPatchScalarField>(p);
}


bool Foam::cghs::faceGravity::acts(const fvPatchScalarField& p)
{
    return p.coupled() || p.fixesValue() || balances(p);
}


void Foam::cghs::faceGravity::drop
(
    surfaceScalarField& gravity,
    const volScalarField& p
)
{
    forAll(p.boundaryField(), patchi)
    {
        if (!acts(p.boundaryField()[patchi]))
        {
            gravity.boundaryFieldRef()[patchi] = Zero;
        }
    }
}


Foam::cghs::faceGravity::faceGravity
(
    const volScalarField& p,
    const dimensionedVector& g
)
:
    periodic_(alongPeriods(p.mesh(), g.value())),
    potential_
    (
        potentialOf
        (
            p,
            g - dimensionedVector("g", g.dimensions(), periodic_)
        )
    ),
    inFluxes_
    (
        fvScalarMatrix
        (
            fvm::laplacian
            (
                dimensionedScalar("mobility", dimless, 1),
                potential_,
                "laplacian(mobility," + p.name() + ')'
            )
        ).flux()
    ),
    inGradients_(fvc::snGrad(potential_)*p.mesh().magSf())
{
    if (periodic_ != vector(Zero))
    {
        const surfaceScalarField along
        (
            dimensionedVector("g", g.dimensions(), periodic_) & p.mesh().Sf()
        );
        inFluxes_ += along;
        inGradients_ += along;
    }

    drop(inFluxes_, p);
    drop(inGradients_, p);
}
