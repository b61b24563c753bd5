/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "splittingError.H"
#include "surfaceFields.H"
#include "PstreamReduceOps.H"
#include <cmath>

Foam::cghs::splittingError::splittingError
(
    const surfaceScalarField& massFlux,
    const scalarField& content,
    const scalar deltaT
)
:
    passed_(content.size(), Zero),
    taken_(0),
    missed_(0)
{
    const fvMesh& mesh = massFlux.mesh();
    forAll(massFlux, facei)
    {
        const scalar flux = massFlux[facei];
        const label from =
            flux > 0 ? mesh.owner()[facei] : mesh.neighbour()[facei];
        passed_[from] += mag(flux);
    }
    for (const fvsPatchScalarField& flux : massFlux.boundaryField())
    {
        const labelUList& cells = flux.patch().faceCells();
        forAll(flux, i)
        {
            passed_[cells[i]] += max(flux[i], scalar(0));
        }
    }

    passed_ *= deltaT/max(content, VSMALL);
}


Foam::scalar Foam::cghs::splittingError::of(const scalar r, const scalar q)
{
    // All of it is taken at a rate that is beyond all numbers
    const scalar most = 1 - SMALL;
    const scalar x = -std::log1p(-min(r, most));

    // x - r is lost to rounding where both are small
    const scalar curved = r < 1e-4 ? sqr(r)*(0.5 + r/3) : x - r;

    return r > 0 && q > 0 ? q*curved/(x*(r + q)) : 0;
}


void Foam::cghs::splittingError::note
(
    const scalarField& held,
    const scalarField& taken
)
{
    forAll(taken, celli)
    {
        if (taken[celli] > 0)
        {
            const scalar r = taken[celli]/max(held[celli], taken[celli]);
            taken_ += taken[celli];
            missed_ += taken[celli]*of(r, passed_[celli]);
        }
    }
}


Foam::scalar Foam::cghs::splittingError::mean() const
{
    const scalar taken = returnReduce(taken_, sumOp<scalar>());

    return returnReduce(missed_, sumOp<scalar>())/max(taken, VSMALL);
}
