/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "suspension.H"

Foam::cghs::suspension::suspension
(
    const dictionary& subModels,
    const vector& g,
    const label nCells
)
:
    g_(g),
    drag_(dragModel::New(subModels)),
    carriers_(nCells),
    impulse_(nCells, Zero),
    response_(nCells, Zero),
    e_(blockSize_),
    u_(blockSize_),
    d_(blockSize_),
    rho_(blockSize_),
    mu_(blockSize_),
    D_(blockSize_)
{}


void Foam::cghs::suspension::startFluidStep()
{
    impulse_ = Zero;
    response_ = Zero;
}


void Foam::cghs::suspension::findRates
(
    const arena& parcels,
    const label from,
    const label n
)
{
    for (label k = 0; k < n; ++k)
    {
        const label i = from + k;
        const carrier& c = carriers_[parcels.cells[i]];

        e_[k] = c.voidage;
        u_[k] = mag(c.u - parcels.motions[i].v);
        d_[k] = parcels.diameters[i];
        rho_[k] = c.rho;
        mu_[k] = c.mu;
    }

    SubList<scalar> D(D_, n);
    drag_->coefficients(e_, u_, d_, rho_, mu_, D);

    for (label k = 0; k < n; ++k)
    {
        const label i = from + k;

        rates_[i] = D_[k]*parcels.volume(i)*parcels.motions[i].invMass;
    }
}


inline void Foam::cghs::suspension::accelerate
(
    arena& parcels,
    const label i,
    const scalar time
)
{
    const label celli = parcels.cells[i];
    const carrier& c = carriers_[celli];
    motion& m = parcels.motions[i];

    const scalar K = rates_[i];
    const vector field(g_ - (parcels.volume(i)*m.invMass)*c.gradP);

    m.v = (m.v + time*(K*c.u + field))/(1 + time*K);

    impulse_[celli] += (time*K/m.invMass)*(c.u - m.v);
}


void Foam::cghs::suspension::kick(arena& parcels, const scalar halfDeltaT)
{
    const label nOwn = parcels.size();

    for (label from = 0; from < nOwn; from += blockSize_)
    {
        const label n = min(blockSize_, nOwn - from);

        findRates(parcels, from, n);

        for (label i = from; i < from + n; ++i)
        {
            accelerate(parcels, i, halfDeltaT);
        }
    }
}


void Foam::cghs::suspension::kickAgain
(
    arena& parcels,
    const scalar halfDeltaT,
    const bool last,
    const scalar fluidDeltaT
)
{
    if (last)
    {
        respondingCells_ = SubList<label>(parcels.cells, parcels.size());
    }

    for (label i = 0; i < parcels.size(); ++i)
    {
        accelerate(parcels, i, halfDeltaT);

        if (last)
        {
            const scalar K = rates_[i];

            response_[parcels.cells[i]] +=
                K/((1 + fluidDeltaT*K)*parcels.motions[i].invMass);
        }
    }
}


void Foam::cghs::suspension::complete
(
    arena& parcels,
    const UList<vector>& dU,
    const UList<vector>& dGradP,
    const scalar fluidDeltaT
) const
{
    for (label i = 0; i < parcels.size(); ++i)
    {
        const label celli = respondingCells_[i];
        motion& m = parcels.motions[i];
        const scalar K = rates_[i];

        m.v +=
            fluidDeltaT
           *(
                (K/(1 + fluidDeltaT*K))*dU[celli]
              - (parcels.volume(i)*m.invMass)*dGradP[celli]
            );
    }

    drag_->warnOutsideRange();
}
