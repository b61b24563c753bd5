/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    Integrals of what feed rates are like: constant, smooth, with kinks and with
    jumps, over many steps that do not know where these are.

\*---------------------------------------------------------------------------*/

#include "integral.H"
#include "claim.H"

#include <catch2/catch.hpp>

#include <cmath>

namespace Foam
{
namespace cghs
{

//- Error of the sum over n steps from 0 to 1, over the integral
template<class Function>
static scalar errorOfSteps(const Function& f, const label n, const scalar exact)
{
    scalar sum = 0;
    for (label i = 0; i < n; ++i)
    {
        sum += integral(f, scalar(i)/n, scalar(i + 1)/n);
    }
    return mag(sum/exact - 1);
}


TEST_CASE("Integrals of rates, over few steps and many", "[numerics]")
{
    claim constant("integral.constant", 0);
    claim smooth("integral.smooth", 1e-12);
    claim kinked("integral.kinked", 1e-12);
    claim jumping("integral.jumping", 1e-11);

    constant.see
    (
        mag(integral([](const scalar) { return 0.02; }, 3, 3.001)
      - 0.02*(3.001 - 3.0))
    );

    for (const label n : {1, 7, 1000})
    {
        smooth.see
        (
            errorOfSteps
            (
                [](const scalar t) { return std::exp(t); },
                n,
                std::exp(scalar(1)) - 1
            )
        );
        kinked.see
        (
            errorOfSteps
            (
                [](const scalar t) { return min(3*t, scalar(1)); },
                n,
                scalar(5)/6
            )
        );
        jumping.see
        (
            errorOfSteps
            (
                [](const scalar t) { return t < M_SQRT1_2 ? 2 : 0.5; },
                n,
                2*M_SQRT1_2 + 0.5*(1 - M_SQRT1_2)
            )
        );
    }

    constant.settle();
    smooth.settle();
    kinked.settle();
    jumping.settle();
}

} // End namespace cghs
} // End namespace Foam
