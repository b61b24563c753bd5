/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "roughImpacts.H"
#include "turningPoint.H"
#include "mathematicalConstants.H"

#include <cmath>

Foam::cghs::roughImpacts::roughImpacts
(
    const scalar e,
    const scalar et,
    const scalar mu
)
:
    // From there on no impact slides, and differences of large numbers are lost
    slide_(Foam::min(mu, scalar(1e6))*(1 + e)),
    stick_((1 + et)*2/7),
    normal_(1 - e*e)
{}


void Foam::cghs::roughImpacts::impulses
(
    const scalar lambda,
    scalar& Jg,
    scalar& J2
) const
{
    using constant::mathematical::piByTwo;

    const scalar f = std::atan2(slide_, stick_*lambda);
    const scalar sticking = 2*std::pow(lambda*std::sin(f)*std::sin(f), 2);
    const scalar sliding = 2*std::pow(std::cos(f), 4);
    const scalar rubbing = lambda*(piByTwo - f + 0.25*std::sin(4*f));

    Jg = stick_*sticking + slide_*rubbing;
    J2 = stick_*stick_*sticking + slide_*slide_*sliding;
}


Foam::scalar Foam::cghs::roughImpacts::ofTranslation(const scalar lambda) const
{
    scalar Jg, J2;
    impulses(lambda, Jg, J2);

    return normal_ + Jg/(lambda*lambda) - 0.5*J2;
}


Foam::scalar Foam::cghs::roughImpacts::ofRotation(const scalar lambda) const
{
    scalar Jg, J2;
    impulses(lambda, Jg, J2);

    return (1 - 1/(lambda*lambda))*Jg - 1.25*J2;
}


Foam::scalar Foam::cghs::roughImpacts::steady() const
{
    if (slide_ <= 0)
    {
        return 1;
    }

    // Without spins rotation gains; with 3.5 times the energy it loses, as an
    // impact that sticks passes it on
    const auto gains = [&](const scalar lambda)
    {
        return ofRotation(lambda) < 0;
    };

    scalar high = 2;
    while (gains(high))
    {
        high *= 2;
    }

    return turningPoint(1, high, gains);
}
