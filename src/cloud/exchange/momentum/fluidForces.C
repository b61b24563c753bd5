/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "fluidForces.H"

void Foam::cghs::fluidForces::addColumns(arena& parcels, const bool kept)
{
    parcels.add(added_);
    added_.UList<scalar>::operator=(Zero);

    if (kept)
    {
        parcels.add(met_);
    }
}


void Foam::cghs::fluidForces::start(const label nParcels)
{
    pushes_.resize(nParcels);
    invMasses_.resize(nParcels);
    velocities_.resize(nParcels);
}


Foam::vector Foam::cghs::fluidForces::release
(
    arena& parcels,
    const label i,
    const scalar deltaT
)
{
    motion& m = parcels.motions[i];
    m.invMass = invMasses_[i];

    return
        (deltaT*pushes_[i] - added_[i]*(m.v - velocities_[i]))/m.invMass;
}
