/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "diffusion.H"
#include "checkedEntry.H"
#include "fvcSurfaceIntegrate.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(diffusion, 0);
    addToRunTimeSelectionTable(mappingModel, diffusion, dictionary);

    //- More steps than this are not taken: they would cost more than the flow
    constexpr label maxSteps = 30;

    //- Share of a cell's content that may leave it in a step
    constexpr scalar maxShare = 0.9;
}
}


Foam::cghs::diffusion::diffusion
(
    const dictionary& dict,
    const fvMesh& mesh,
    const scalar parcelDiameter
)
:
    mesh_(mesh),
    nSteps_(0),
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
    )
{
    const scalar width = scalarInRange(dict, "width", 0, GREAT);

    setSteps(sqr(width*parcelDiameter)/4);
}


void Foam::cghs::diffusion::setSteps(const scalar time)
{
    // Conductance per unit of pseudo-time: only faces with cells on both
    // sides pass anything
    conductance_ == mesh_.magSf()*mesh_.nonOrthDeltaCoeffs()
       *dimensionedScalar("area", dimArea, 1);

    for (fvsPatchScalarField& patch : conductance_.boundaryFieldRef())
    {
        if (!patch.coupled())
        {
            patch = 0;
        }
    }

    // What a cell can stand: the pseudo-time in which maxShare of it leaves
    volScalarField limit
    (
        IOobject("limit", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("limit", dimless, GREAT)
    );

    const tmp<volScalarField> toutflow(fvc::surfaceSum(conductance_));
    const scalarField& outflow = toutflow().primitiveField();

    forAll(outflow, c)
    {
        limit[c] = maxShare*mesh_.V()[c]/max(outflow[c], VSMALL);
    }
    limit.correctBoundaryConditions();

    const scalar needed = time/gMin(limit.primitiveField());

    nSteps_ = time > 0 ? min(label(min(needed, scalar(1e6))) + 1, maxSteps) : 0;

    if (nSteps_ == maxSteps)
    {
        WarningInFunction
            << "Spreading over a pseudo-time of " << time << " m^2 would need "
            << needed << " steps because of small cells; " << maxSteps
            << " are taken, and those cells spread less" << endl;
    }

    const scalar step = time/max(nSteps_, 1);
    const labelUList& owner = mesh_.owner();
    const labelUList& neighbour = mesh_.neighbour();

    forAll(owner, facei)
    {
        conductance_[facei] *=
            min(step, min(limit[owner[facei]], limit[neighbour[facei]]));
    }

    forAll(conductance_.boundaryField(), patchi)
    {
        fvsPatchScalarField& patch = conductance_.boundaryFieldRef()[patchi];

        if (patch.coupled())
        {
            const fvPatchScalarField& l = limit.boundaryField()[patchi];

            patch *=
                min
                (
                    step,
                    min(l.patchInternalField(), l.patchNeighbourField())
                );
        }
    }
}


template<class Type>
void Foam::cghs::diffusion::spreadType
(
    GeometricField<Type, fvPatchField, volMesh>& field
) const
{
    const labelUList& owner = mesh_.owner();
    const labelUList& neighbour = mesh_.neighbour();
    Field<Type> change(mesh_.nCells());

    for (label step = 0; step < nSteps_; ++step)
    {
        change = Zero;

        forAll(owner, facei)
        {
            const Type flow =
                conductance_[facei]
               *(field[neighbour[facei]] - field[owner[facei]]);

            change[owner[facei]] += flow;
            change[neighbour[facei]] -= flow;
        }

        forAll(field.boundaryField(), patchi)
        {
            const fvPatchField<Type>& patch = field.boundaryField()[patchi];

            if (patch.coupled())
            {
                const labelUList& cells = patch.patch().faceCells();
                const Field<Type> flow
                (
                    conductance_.boundaryField()[patchi]
                   *(patch.patchNeighbourField() - patch.patchInternalField())
                );

                forAll(cells, i)
                {
                    change[cells[i]] += flow[i];
                }
            }
        }

        field.primitiveFieldRef() += change/mesh_.V();
        field.correctBoundaryConditions();
    }
}


void Foam::cghs::diffusion::spread(volScalarField& field) const
{
    spreadType(field);
}


void Foam::cghs::diffusion::spread(volVectorField& field) const
{
    spreadType(field);
}
