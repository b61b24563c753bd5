/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    Added mass: the coefficients that its authors give, what it takes of the
    turning of the fluid, and what is refused.

\*---------------------------------------------------------------------------*/

#include "addedMass.H"
#include "complaint.H"
#include "claim.H"

#include <catch2/catch.hpp>

namespace Foam
{
namespace cghs
{

static addedMass massOf(const char* entries)
{
    return addedMass(dictionaryOf(entries));
}


TEST_CASE("Added mass has the coefficients of its authors", "[forces]")
{
    const addedMass alone(massOf("C 0.5; crowding none;"));
    const addedMass crowded(massOf("C 0.5; crowding Zuber;"));

    claim coefficient("addedMass.coefficient", 1e-15);
    coefficient.see(mag(alone.coefficient(0.4) - 0.5));
    coefficient.see(mag(crowded.coefficient(1) - 0.5));
    coefficient.see(mag(crowded.coefficient(0.5) - 2));
    coefficient.see(mag(crowded.coefficient(0.8) - 0.875));
    coefficient.settle();
}


TEST_CASE("Added mass takes the fluid's density and turning", "[forces]")
{
    const addedMass mass(massOf("C 0.5; crowding none;"));
    const List<ambientFlow> flows(1, ambientFlow{0.6, 1000, vector(0, 2, 0)});
    List<forceTerms> terms(1, forceTerms{10, vector(1, 0, 0)});
    mass.add(flows, terms);

    claim added("addedMass.added", 1e-12);
    added.see(mag(terms[0].inertia - 510));
    added.see(mag(terms[0].push - vector(1, 1000, 0)));
    added.settle();
}


TEST_CASE("Forces that are not known or named twice are refused", "[forces]")
{
    const auto made = [](const char* entries)
    {
        forceModel::New(dictionaryOf(entries));
    };

    settleComplaint
    (
        "forces.unknown",
        {"lift", "addedMass"},
        [&]{ made("forces (lift);"); }
    );
    settleComplaint
    (
        "forces.twice",
        {"forces", "addedMass twice"},
        [&]{ made("forces (addedMass addedMass);"); }
    );
    settleComplaint
    (
        "addedMass.crowding",
        {"crowding is many", "none, Zuber"},
        [&]{ massOf("C 0.5; crowding many;"); }
    );
    settleComplaint
    (
        "addedMass.negative",
        {"Entry C is -1", "[0, 10]"},
        [&]{ massOf("C -1; crowding none;"); }
    );
}

} // End namespace cghs
} // End namespace Foam
