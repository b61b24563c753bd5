/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "solidsLimit.H"
#include "PstreamReduceOps.H"

namespace Foam
{
namespace cghs
{
    //- Half the width over which a cell begins to give
    constexpr scalar onset = 0.02;

    //- Passes that give smoothly. Always as many: where the last ends must not
    //  depend on how full the cells are
    constexpr label nSmoothPasses = 10;

    //- The other passes aim this much lower: what is left falls ever more slowly
    constexpr scalar margin = 0.005;

    //- Passes at most
    constexpr label patience = 200;
}
}


Foam::cghs::solidsLimit::solidsLimit
(
    const fvMesh& mesh,
    const scalar limit,
    const labelUList& plates
)
:
    mesh_(mesh),
    limit_(limit),
    plates_(plates)
{}


Foam::scalar Foam::cghs::solidsLimit::excess
(
    const scalar beyond,
    const scalar width
)
{
    if (beyond <= -width)
    {
        return 0;
    }

    return
        beyond < width
      ? pow3(beyond + width)*(3*width - beyond)/(16*pow3(width))
      : beyond;
}


void Foam::cghs::solidsLimit::pass
(
    volScalarField& theta,
    const scalar goal,
    const scalar width
) const
{
    auto excesses =
        volScalarField::New("excess", mesh_, dimensionedScalar(dimless, Zero));
    volScalarField& moved = excesses.ref();

    forAll(moved, celli)
    {
        moved[celli] = excess(theta[celli] - goal, width);
    }
    moved.correctBoundaryConditions();

    theta.primitiveFieldRef() -= moved.primitiveField();
    faces_->step(moved);
    theta.primitiveFieldRef() += moved.primitiveField();
}


Foam::label Foam::cghs::solidsLimit::bound(volScalarField& theta) const
{
    const auto fullest = [&]() { return gMax(theta.primitiveField()); };

    if (fullest() <= limit_ - onset)
    {
        return 0;
    }

    if (!faces_.valid())
    {
        faces_.reset(new faceDiffusion(mesh_, plates_));
        faces_->setStep(GREAT);
    }

    label nBeyond = 0;

    for (const scalar solids : theta.primitiveField())
    {
        nBeyond += solids > limit_;
    }
    reduce(nBeyond, sumOp<label>());

    for (label i = 0; i < nSmoothPasses; ++i)
    {
        pass(theta, limit_, onset);
    }
    for (label i = nSmoothPasses; i < patience && fullest() > limit_; ++i)
    {
        pass(theta, limit_ - margin, SMALL);
    }

    theta.correctBoundaryConditions();
    return nBeyond;
}
