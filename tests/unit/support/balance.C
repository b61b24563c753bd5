/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "balance.H"

namespace Foam
{
namespace cghs
{

static scalar finiteMass(const motion& m)
{
    return m.invMass > 0 ? 1/m.invMass : 0;
}


static vector spinOf(const bodies& b, const label i)
{
    return b.spinning() ? b.spins[i] : vector(Zero);
}


static scalar inertia(const bodies& b, const label i)
{
    return 0.4*finiteMass(b.motions[i])*sqr(b.spheres[i].r);
}


//- Speed of centre and surface
static scalar liveliness(const bodies& b, const label i)
{
    return mag(b.motions[i].v) + b.spheres[i].r*mag(spinOf(b, i));
}

}
}


Foam::vector Foam::cghs::linearMomentum(const bodies& b, const vector& frame)
{
    vector total(Zero);
    for (const motion& m : b.motions)
    {
        total += finiteMass(m)*(m.v - frame);
    }
    return total;
}


Foam::vector Foam::cghs::angularMomentum
(
    const bodies& b,
    const vector& about,
    const vector& frame
)
{
    vector total(Zero);
    forAll(b.motions, i)
    {
        const motion& m = b.motions[i];
        const vector arm(b.spheres[i].x - about);
        total += finiteMass(m)*(arm ^ (m.v - frame));
        total += inertia(b, i)*spinOf(b, i);
    }
    return total;
}


Foam::scalar Foam::cghs::kineticEnergy(const bodies& b, const vector& frame)
{
    scalar total = 0;
    forAll(b.motions, i)
    {
        const motion& m = b.motions[i];
        total += 0.5*finiteMass(m)*magSqr(m.v - frame);
        total += 0.5*inertia(b, i)*magSqr(spinOf(b, i));
    }
    return total;
}


Foam::scalar Foam::cghs::momentumScale(const bodies& b)
{
    scalar total = 0;
    forAll(b.motions, i)
    {
        total += finiteMass(b.motions[i])*liveliness(b, i);
    }
    return total;
}


Foam::scalar Foam::cghs::angularMomentumScale
(
    const bodies& b,
    const vector& about
)
{
    scalar total = 0;
    forAll(b.motions, i)
    {
        const sphere& s = b.spheres[i];
        total +=
            finiteMass(b.motions[i])*(mag(s.x - about) + s.r)*liveliness(b, i);
    }
    return total;
}
