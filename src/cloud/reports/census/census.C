/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "census.H"
#include "PstreamReduceOps.H"

Foam::cghs::census::census(const arena& parcels)
{
    for (label i = 0; i < parcels.size(); ++i)
    {
        const motion& m = parcels.motions[i];
        const scalar mi = m.mass();

        ++nParcels;
        mass += mi;
        volume += parcels.volume(i);
        momentum += mi*m.v;
        massMoment += mi*parcels.spheres[i].x;
        kineticEnergy += 0.5*mi*magSqr(m.v);
        meanVelocity += m.v;
        meanSquare += cmptMultiply(m.v, m.v);

        if (parcels.spinning())
        {
            rotationalEnergy +=
                0.5*inertiaFactor*mi*sqr(parcels.spheres[i].r)
               *magSqr(parcels.spins[i]);
        }
    }

    reduce(nParcels, sumOp<label>());

    for (scalar* s : {&mass, &volume, &kineticEnergy, &rotationalEnergy})
    {
        reduce(*s, sumOp<scalar>());
    }
    for (vector* v : {&momentum, &massMoment, &meanVelocity, &meanSquare})
    {
        reduce(*v, sumOp<vector>());
    }

    meanVelocity /= max(nParcels, 1);
    meanSquare /= max(nParcels, 1);
}


Foam::scalar Foam::cghs::census::granularTemperature() const
{
    return
    (
        cmptSum(meanSquare) - magSqr(meanVelocity)
    )/3;
}
