/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "cellDrag.H"

namespace Foam
{
namespace cghs
{
    //- Pseudo-time of T over what a cell can stand, which is 0.15 h^2 in cubes
    constexpr scalar shareOfLimit = 0.68;

    //- What may be left of (A + L) w = A u + G, over its right side
    constexpr scalar tolerance = 1e-4;

    constexpr label maxIterations = 100;


//- Sum of V a.b over the mesh
static scalar product(const volVectorField& a, const volVectorField& b)
{
    return gSum
    (
        a.mesh().V().field()*(a.primitiveField() & b.primitiveField())
    );
}

}
}


Foam::cghs::cellDrag::cellDrag
(
    const fvMesh& mesh,
    const mappingModel& mapping,
    const labelUList& plates
)
:
    mapping_(mapping),
    shares_(mesh, plates)
{
    shares_.setLocalStep(shareOfLimit);

    IOobject file(forcesIO(mesh, IOobject::MUST_READ));

    if (file.typeHeaderOk<volVectorField>(true))
    {
        forces_.reset(new volVectorField(file, mesh));
    }
}


Foam::IOobject Foam::cghs::cellDrag::forcesIO
(
    const fvMesh& mesh,
    const IOobject::readOption read
)
{
    return
        IOobject
        (
            "cellDragForces",
            mesh.time().timeName(),
            mesh,
            read,
            IOobject::AUTO_WRITE
        );
}


Foam::tmp<Foam::volVectorField> Foam::cghs::cellDrag::smooth
(
    const volVectorField& w
) const
{
    auto tw = tmp<volVectorField>::New("smooth", w);
    mapping_.spread(tw.ref());

    return tw;
}


Foam::tmp<Foam::volVectorField> Foam::cghs::cellDrag::ofShares
(
    const volVectorField& smoothed,
    const volScalarField& b
) const
{
    auto tf = tmp<volVectorField>::New("cellDrag", smoothed);
    volVectorField& f = tf.ref();

    shares_.step(f);

    // In the cells alone: what stands on patches means nothing, and b would
    // make it grow from iteration to iteration until it overflows
    f.primitiveFieldRef() *= b.primitiveField();
    f.dimensions().reset(f.dimensions()*b.dimensions());
    f.correctBoundaryConditions();
    shares_.step(f);

    return tf;
}


Foam::tmp<Foam::volVectorField> Foam::cghs::cellDrag::force
(
    const volVectorField& w,
    const volScalarField& b,
    const volScalarField& B
) const
{
    return B*w - smooth(ofShares(smooth(w), b));
}


Foam::tmp<Foam::volVectorField> Foam::cghs::cellDrag::otherForces
(
    const volVectorField& F
) const
{
    return forces_.valid() ? forces_() - smooth(F) : 0*F;
}


void Foam::cghs::cellDrag::solve
(
    volVectorField& w,
    const volVectorField& G,
    const volScalarField& b,
    const volScalarField& B
) const
{
    const volScalarField& A = inertia_();
    const volScalarField D(A + B);
    const volVectorField source(A*w + G);
    const scalar enough = sqr(tolerance)*product(source, (source/D)());

    volVectorField r(G - force(w, b, B));
    volVectorField z(r/D);
    volVectorField p("direction", w);
    p == z;
    scalar rz = product(r, z);

    for (label i = 0; i < maxIterations && rz > enough; ++i)
    {
        const volVectorField q(A*p + force(p, b, B));
        const dimensionedScalar step("step", dimless, rz/product(p, q));

        w += step*p;
        r -= step*q;
        z = r/D;

        const scalar before = rz;
        rz = product(r, z);
        p == z + (rz/before)*p;
        p.correctBoundaryConditions();
    }

    w.correctBoundaryConditions();
}


void Foam::cghs::cellDrag::spread
(
    volVectorField& F,
    const volVectorField& U,
    const volVectorField& smoothU,
    const volScalarField& b,
    const tmp<volScalarField>& A
)
{
    volScalarField B("cellDrag", b);
    shares_.step(B);
    mapping_.spread(B);

    const bool stiff = gMax((B - A())().primitiveField()) > 0;
    tmp<volVectorField> felt(U);
    tmp<volVectorField> smoothed(smoothU);

    if (stiff || forces_.valid())
    {
        inertia_ = A;
    }
    if (stiff)
    {
        auto w = tmp<volVectorField>::New("felt", smoothU);
        w.ref() == U;
        solve(w.ref(), otherForces(F), b, B);

        felt = w;
        smoothed = smooth(felt());
    }

    F -= ofShares(smoothed(), b);
    F.correctBoundaryConditions();
    mapping_.spread(F);
    F += B*felt();

    if (stiff && !forces_.valid())
    {
        const fvMesh& mesh = F.mesh();
        forces_.reset
        (
            new volVectorField(forcesIO(mesh, IOobject::NO_READ), F)
        );
    }
    if (forces_.valid())
    {
        forces_().primitiveFieldRef() = F.primitiveField();
        forces_().correctBoundaryConditions();
    }
}


void Foam::cghs::cellDrag::finish(const volVectorField& dU)
{
    if (forces_.valid())
    {
        forces_().primitiveFieldRef() +=
            inertia_().primitiveField()*dU.primitiveField();
        forces_().correctBoundaryConditions();
        inertia_.clear();
    }
}
