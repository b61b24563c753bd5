/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "faceDiffusion.H"
#include "fvcSurfaceIntegrate.H"

namespace Foam
{
namespace cghs
{
    //- Share of a cell's content that may leave it in a step
    constexpr scalar maxShare = 0.9;
}
}


Foam::cghs::faceDiffusion::faceDiffusion
(
    const fvMesh& mesh,
    const labelUList& plates
)
:
    mesh_(mesh),
    conductance_
    (
        IOobject
        (
            "diffusionConductance",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh,
        dimensionedScalar(dimVolume, Zero)
    ),
    limit_
    (
        IOobject
        (
            "diffusionLimit",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh,
        dimensionedScalar("limit", dimless, GREAT)
    )
{
    // Conductance per unit of pseudo-time, until the step is known
    conductance_ == mesh.magSf()*mesh.nonOrthDeltaCoeffs()
       *dimensionedScalar("area", dimArea, 1);

    for (fvsPatchScalarField& patch : conductance_.boundaryFieldRef())
    {
        if (!patch.coupled())
        {
            patch = 0;
        }
    }
    for (const label patchi : plates)
    {
        conductance_.boundaryFieldRef()[patchi] = 0;
    }

    const tmp<volScalarField> toutflow(fvc::surfaceSum(conductance_));
    const scalarField& outflow = toutflow().primitiveField();

    forAll(outflow, c)
    {
        limit_[c] = maxShare*mesh.V()[c]/max(outflow[c], VSMALL);
    }
    limit_.correctBoundaryConditions();
}


Foam::scalar Foam::cghs::faceDiffusion::limit() const
{
    return gMin(limit_.primitiveField());
}


template<class Step>
void Foam::cghs::faceDiffusion::setConductance(const Step& stepOf)
{
    const labelUList& owner = mesh_.owner();
    const labelUList& neighbour = mesh_.neighbour();

    forAll(owner, facei)
    {
        conductance_[facei] *=
            stepOf(min(limit_[owner[facei]], limit_[neighbour[facei]]));
    }

    forAll(conductance_.boundaryField(), patchi)
    {
        fvsPatchScalarField& patch = conductance_.boundaryFieldRef()[patchi];

        if (patch.coupled())
        {
            const fvPatchScalarField& l = limit_.boundaryField()[patchi];
            const scalarField limits
            (
                min(l.patchInternalField(), l.patchNeighbourField())
            );

            forAll(limits, k)
            {
                patch[k] *= stepOf(limits[k]);
            }
        }
    }
}


void Foam::cghs::faceDiffusion::setStep(const scalar time)
{
    setConductance([=](const scalar limit) { return min(time, limit); });
}


void Foam::cghs::faceDiffusion::setLocalStep(const scalar share)
{
    setConductance([=](const scalar limit) { return share*limit; });
}
