/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Application
    cghsUnitTests

Description
    Tests of the libraries that need no mesh and no case. Each claim that is
    put to the test prints one line

        RESULT <claim> <error> <tolerance> <seconds>

    Floating point traps are on, as they are in a solver.

Usage
    cghsUnitTests                   all tests
    cghsUnitTests --list-tests      their names
    cghsUnitTests "[contact]"       those with a tag

\*---------------------------------------------------------------------------*/

// Catch's own machinery: quick to compile matters more than quick to run
#pragma GCC optimize ("O0")

#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>

#include "error.H"

#include <cfenv>

#ifdef __GLIBC__
static const int trapped =
    feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);
#endif

// A FatalError fails the test in which it occurs, not all that follow
static const bool thrown[] =
{
    Foam::FatalError.throwExceptions(),
    Foam::FatalIOError.throwExceptions()
};


//- An error that nobody expected is reported with its message
CATCH_TRANSLATE_EXCEPTION(const Foam::error& e)
{
    return e.message();
}
