/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "restingPressure.H"
#include "fixedFluxPressureFvPatchScalarField.H"

bool Foam::cghs::restingPressure::isToFind() const
{
    return
        p_.time().timeIndex() == 0
     && gMax(p_.primitiveField()) == gMin(p_.primitiveField());
}


Foam::scalar Foam::cghs::restingPressure::mean() const
{
    scalar sumP = 0;
    scalar area = 0;

    for (const fvPatchScalarField& p : p_.boundaryField())
    {
        if (p.fixesValue() && !p.coupled())
        {
            sumP += sum(p.patch().magSf()*p);
            area += sum(p.patch().magSf());
        }
    }
    reduce(sumP, sumOp<scalar>());
    reduce(area, sumOp<scalar>());

    return area > 0 ? sumP/area : gAverage(p_.primitiveField());
}


void Foam::cghs::restingPressure::set
(
    const scalarField& p,
    const volScalarField& density
)
{
    p_.primitiveFieldRef() = p;

    for (fvPatchScalarField& pp : p_.boundaryFieldRef())
    {
        const label patchi = pp.patch().index();

        if (faceGravity::balances(pp))
        {
            refCast<fixedFluxPressureFvPatchScalarField>(pp).updateSnGrad
            (
                density.boundaryField()[patchi]
               *gravity_.potential().boundaryField()[patchi].snGrad()
            );
        }
    }
    p_.correctBoundaryConditions();
}
