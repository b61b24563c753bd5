/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "parcelFlows.H"

void Foam::cghs::parcelFlows::meet(const carrierFluid& fluid)
{
    const scalarField& alpha = fluid.alpha();
    const scalarField& rho = fluid.rho();
    const scalarField& mu = fluid.mu();

    U_ = fluid.U().primitiveField();
    fluid_.setSize(U_.size());

    forAll(fluid_, celli)
    {
        heatedFlow& f = fluid_[celli];

        f.e = alpha[celli];
        f.rho = rho[celli];
        f.mu = mu[celli];
    }
}


void Foam::cghs::parcelFlows::fetch(const arena& parcels)
{
    parcels.visiting.fetch(fluid_);
    parcels.visiting.fetch(U_);
    flows_.setSize(blockSize);
}


Foam::SubList<Foam::cghs::heatedFlow> Foam::cghs::parcelFlows::block
(
    const arena& parcels,
    const label from,
    const label n
)
{
    const UList<label>& places = parcels.places();

    for (label j = 0; j < n; ++j)
    {
        const label placei = places[from + j];

        flows_[j] = fluid_[placei];
        flows_[j].u = mag(U_[placei] - parcels.motions[from + j].v);
        flows_[j].d = parcels.diameters[from + j];
    }

    return SubList<heatedFlow>(flows_, n);
}
