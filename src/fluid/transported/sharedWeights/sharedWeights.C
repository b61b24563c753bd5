/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "sharedWeights.H"
#include "limitedSurfaceInterpolationScheme.H"
#include "gaussConvectionScheme.H"
#include "surfaceInterpolation.H"
#include "syncTools.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(sharedWeights, 0);


//- Where it matters what is chosen: where the field changes across the face
static void lower
(
    scalarField& limiter,
    const scalarField& own,
    const scalarField& jump,
    const scalar rounding
)
{
    forAll(jump, facei)
    {
        if (mag(jump[facei]) > rounding)
        {
            limiter[facei] = min(limiter[facei], own[facei]);
        }
    }
}


static scalarField jumpWithin(const volScalarField& field)
{
    const fvMesh& mesh = field.mesh();

    return
        scalarField(field.primitiveField(), mesh.neighbour())
      - scalarField
        (
            field.primitiveField(),
            SubList<label>(mesh.owner(), mesh.nInternalFaces())
        );
}


static void lower
(
    surfaceScalarField& limiter,
    const volScalarField& field,
    const surfaceScalarField& own
)
{
    const scalar rounding =
        1e-12*max(scalar(1), gMax(mag(field.primitiveField())()));

    lower
    (
        limiter.primitiveFieldRef(),
        own.primitiveField(),
        jumpWithin(field),
        rounding
    );

    for (const fvPatchScalarField& values : field.boundaryField())
    {
        if (values.coupled())
        {
            const label patchi = values.patch().index();

            lower
            (
                limiter.boundaryFieldRef()[patchi],
                own.boundaryField()[patchi],
                values.patchNeighbourField() - values.patchInternalField(),
                rounding
            );
        }
    }
}


//- Make both sides of coupled faces choose the same value
static void joinSides(surfaceScalarField& weights)
{
    const fvMesh& mesh = weights.mesh();
    scalarField other(mesh.nFaces() - mesh.nInternalFaces(), Zero);

    const auto sideOf = [&](const fvPatch& patch)
    {
        return SubField<scalar>
        (
            other,
            patch.size(),
            patch.start() - mesh.nInternalFaces()
        );
    };

    for (const fvPatch& patch : mesh.boundary())
    {
        if (pairsFaces(patch))
        {
            sideOf(patch) = weights.boundaryField()[patch.index()];
        }
    }

    syncTools::swapBoundaryFaceList(mesh, other);

    for (const fvPatch& patch : mesh.boundary())
    {
        if (pairsFaces(patch))
        {
            scalarField& here = weights.boundaryFieldRef()[patch.index()];
            here = 0.5*(here + (1 - sideOf(patch)));
        }
    }
}


//- The scheme's limiter. Only limited schemes have one
static tmp<limitedSurfaceInterpolationScheme<scalar>> limitedScheme
(
    const surfaceScalarField& flux,
    const word& schemeName
)
{
    const fvMesh& mesh = flux.mesh();
    ITstream& scheme = mesh.divScheme(schemeName);
    const word method(scheme);

    if (method != "Gauss")
    {
        FatalIOErrorInFunction(scheme)
            << "Entry " << schemeName << " begins with " << method
            << " but species and energy share a limiter: only Gauss has it"
            << nl
            << "Choose e.g. Gauss limitedLinear 1, Gauss vanLeer or Gauss"
            << " upwind" << nl
            << exit(FatalIOError);
    }

    tmp<limitedSurfaceInterpolationScheme<scalar>> limited
    (
        limitedSurfaceInterpolationScheme<scalar>::New(mesh, flux, scheme)
    );

    if (limited().corrected())
    {
        FatalIOErrorInFunction(scheme)
            << "Entry " << schemeName << " is " << limited().type()
            << ", whose values are more than a mean of two cells: it has no"
            << " limiter that species and energy could share" << nl
            << "Choose e.g. Gauss limitedLinear 1, Gauss vanLeer or Gauss"
            << " upwind" << nl
            << exit(FatalIOError);
    }

    return limited;
}

} // End namespace cghs
} // End namespace Foam


Foam::cghs::sharedWeights::sharedWeights(const surfaceScalarField& weights)
:
    surfaceInterpolationScheme<scalar>(weights.mesh()),
    weights_(weights)
{}


Foam::tmp<Foam::surfaceScalarField> Foam::cghs::sharedWeights::ofFields
(
    const UList<const volScalarField*>& fields,
    const surfaceScalarField& flux,
    const word& schemeName
)
{
    const fvMesh& mesh = flux.mesh();
    const tmp<limitedSurfaceInterpolationScheme<scalar>> scheme
    (
        limitedScheme(flux, schemeName)
    );

    surfaceScalarField limiter
    (
        IOobject("limiter", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("largest", dimless, GREAT)
    );

    for (const volScalarField* field : fields)
    {
        lower(limiter, *field, scheme().limiter(*field)());
    }

    // Upwind where nobody was asked
    limiter *= neg(limiter - 0.5*GREAT);

    tmp<surfaceScalarField> weights
    (
        limiter*mesh.surfaceInterpolation::weights()
      + (scalar(1) - limiter)*pos0(flux)
    );
    joinSides(weights.ref());

    return weights;
}


Foam::tmp<Foam::fvScalarMatrix> Foam::cghs::sharedWeights::convection
(
    const surfaceScalarField& flux,
    const volScalarField& field,
    const surfaceScalarField& weights
)
{
    return fv::gaussConvectionScheme<scalar>
    (
        flux.mesh(),
        flux,
        tmp<surfaceInterpolationScheme<scalar>>(new sharedWeights(weights))
    ).fvmDiv(flux, field);
}


Foam::tmp<Foam::surfaceScalarField> Foam::cghs::sharedWeights::weights
(
    const volScalarField&
) const
{
    return weights_;
}
