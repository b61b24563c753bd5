/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "claim.H"

#include <catch2/catch.hpp>

#include <cstdio>

namespace Foam
{
namespace cghs
{

static const scalar nothingSeen = -1;
static const scalar hopeless = 1e300;

}
}


Foam::cghs::claim::claim(const char* name, const scalar tolerance)
:
    name_(name),
    tolerance_(tolerance),
    begin_(std::chrono::steady_clock::now()),
    worst_(nothingSeen),
    settled_(false)
{}


Foam::cghs::claim::~claim()
{
    if (!settled_)
    {
        worst_ = hopeless;
        report();
    }
}


void Foam::cghs::claim::report() const
{
    const std::chrono::duration<double> age =
        std::chrono::steady_clock::now() - begin_;

    std::printf
    (
        "RESULT %s %.3g %.3g %.3f\n",
        name_,
        worst_,
        tolerance_,
        age.count()
    );
    std::fflush(stdout);
}


void Foam::cghs::claim::see(const scalar error)
{
    // A nan fails each comparison, hence the roundabout way
    if (!(error <= worst_))
    {
        worst_ = error < hopeless ? error : hopeless;
    }
}


void Foam::cghs::claim::count(const bool right)
{
    worst_ = max(worst_, scalar(0)) + (right ? 0 : 1);
}


void Foam::cghs::claim::settle()
{
    if (worst_ == nothingSeen)
    {
        worst_ = hopeless;
    }

    settled_ = true;
    report();

    INFO(name_);
    CHECK(worst_ <= tolerance_);
}


void Foam::cghs::settle
(
    const char* name,
    const scalar error,
    const scalar tolerance
)
{
    claim single(name, tolerance);
    single.see(error);
    single.settle();
}
