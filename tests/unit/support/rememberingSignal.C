/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "rememberingSignal.H"

#include <cmath>

Foam::scalar Foam::cghs::gaussian(sampler& random)
{
    const scalar u = 1 - random.between(0, 1);
    return std::sqrt(-2*std::log(u))*std::cos(2*M_PI*random.between(0, 1));
}


Foam::cghs::rememberingSignal::rememberingSignal
(
    sampler& random,
    const scalar a
)
:
    random_(random),
    a_(a),
    x_(gaussian(random))
{}


Foam::scalar Foam::cghs::rememberingSignal::next()
{
    const scalar now = x_;
    x_ = a_*x_ + std::sqrt(1 - a_*a_)*gaussian(random_);
    return now;
}


Foam::scalar Foam::cghs::meanVariance(const scalar a, const scalar n)
{
    return
    (
        (1 + a)/(1 - a) - 2*a*(1 - std::pow(a, n))/(n*(1 - a)*(1 - a))
    )/n;
}
