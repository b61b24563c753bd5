/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "fluidisation.H"
#include "turningPoint.H"

Foam::scalar Foam::cghs::particleInFluid::weight() const
{
    return mag(rhoP - rho)*g;
}


Foam::scalar Foam::cghs::particleInFluid::Ar() const
{
    return rho*weight()*pow3(d)/sqr(mu);
}


Foam::scalar Foam::cghs::particleInFluid::Re(const scalar U) const
{
    return superficialRe(flow(1, U));
}


Foam::cghs::slipFlow Foam::cghs::particleInFluid::flow
(
    const scalar e,
    const scalar u
) const
{
    return slipFlow{e, u, d, rho, mu};
}


Foam::scalar Foam::cghs::balancingD
(
    const particleInFluid& p,
    const scalar e,
    const scalar U
)
{
    return sqr(e)*p.weight()/U;
}


Foam::scalar Foam::cghs::carryingVelocity
(
    const dragModel& law,
    const particleInFluid& p,
    const scalar e
)
{
    const auto carries = [&](const scalar U)
    {
        return law.coefficient(p.flow(e, U/e))*U >= sqr(e)*p.weight();
    };

    // The drag grows with the slip: in no law is it below a part of Stokes'
    scalar high = p.weight()*sqr(p.d)/p.mu;
    while (!carries(high))
    {
        high *= 2;
    }

    return turningPoint(0, high, [&](const scalar U) { return !carries(U); });
}


Foam::scalar Foam::cghs::wenYuMinimumFluidisation(const particleInFluid& p)
{
    const scalar Re = sqrt(sqr(33.7) + 0.0408*p.Ar()) - 33.7;

    return Re*p.mu/(p.rho*p.d);
}
