/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    An exothermic reaction in a stirred fluid that loses heat to its parcels
    ignites where N. N. Semenov's theory says.

\*---------------------------------------------------------------------------*/

#include "reactingCell.H"
#include "complaint.H"
#include "claim.H"

#include <catch2/catch.hpp>

#include <cmath>

namespace Foam
{
namespace cghs
{

namespace
{

const scalar T0 = 300;

// Of the fluid, one mol of A in a cubic metre: [J/K], and what A has to give
// [J]: by that it would get 3000 K hotter
const scalar C = 30;
const scalar Q = 9e4;


//- Does one mol of A ignite? Ta: activation temperature; heat that the reaction
//  makes at T0 [W]; k: what all parcels take [W/K]
bool ignites(const scalar Ta, const scalar power, const scalar k)
{
    dictionary reactions
    (
        dictionaryOf
        (
            "solids"
            "{"
            "    sand"
            "    {"
            "        specie { molWeight 60; }"
            "        thermodynamics { Cp 800; Hf 0; }"
            "    }"
            "}"
            "reactions"
            "{"
            "    burn { equation \"A = B\"; rate massAction; of fluidVolume; }"
            "}"
        )
    );
    dictionary& burn = reactions.subDict("reactions").subDict("burn");
    burn.add("Ta", Ta);
    burn.add("A", power/Q*std::exp(Ta/T0));

    const reactionScheme scheme
    (
        reactions,
        dictionaryOf
        (
            "thermoType { thermo hConst; }"
            "species (A B);"
            "A"
            "{"
            "    specie { molWeight 30; }"
            "    thermodynamics { Cp 1000; Hf 3e6; }"
            "}"
            "B"
            "{"
            "    specie { molWeight 30; }"
            "    thermodynamics { Cp 1000; Hf 0; }"
            "}"
        ),
        true
    );

    // Parcels that nothing heats
    reactingCell cell(scheme, {1e-5, 1e-9});
    cell.start(scalarField(List<scalar>({1, 0})), T0, 0, 1);
    const label n = 4;
    for (label i = 0; i < n; ++i)
    {
        cell.add({1, 1, T0, k/n, 0, 0}, scalarField(1, 1e12));
    }

    // Near the limit it takes 4.4/sqrt(by how much it is beyond) C/k. Below it
    // T ends at T0 (1 + T0/Ta) or colder
    scalar h = 1e-3*C/k;
    for (label slice = 0; slice < 3000; ++slice)
    {
        REQUIRE(cell.react(0.1*C/k, h));
        if (cell.fluidTemperature() > T0*(1 + 2.5*T0/Ta))
        {
            return true;
        }
    }
    return false;
}

}


TEST_CASE("Semenov's limit of ignition", "[reaction]")
{
    claim exact("ignition.limit", 1e-3);
    claim limit("ignition.largeActivationEnergy", 1e-3);

    // Of Q rate Ta/(k T0^2), with Ta = T0/epsilon
    const auto critical = [](const scalar epsilon)
    {
        const scalar Ta = T0/epsilon;
        scalar cold = 0.2;
        scalar hot = 0.6;
        REQUIRE(!ignites(Ta, cold*C*sqr(T0)/Ta, C));
        REQUIRE(ignites(Ta, hot*C*sqr(T0)/Ta, C));

        while (hot/cold - 1 > 1e-4)
        {
            const scalar psi = std::sqrt(cold*hot);
            (ignites(Ta, psi*C*sqr(T0)/Ta, C) ? hot : cold) = psi;
        }
        return std::sqrt(cold*hot);
    };

    const auto found = [&](const scalar epsilon)
    {
        const scalar psi = critical(epsilon);

        // Where heat made and heat lost are tangent: T^2/Ta = T - T0
        const scalar T = 0.5*(1 - std::sqrt(1 - 4*epsilon))/epsilon*T0;
        exact.see
        (
            mag(psi/(sqr(T/T0)*std::exp((T0/T - 1)/epsilon)) - 1)
        );
        return psi;
    };

    // In the limit of large activation energies 1/e
    limit.see(mag(2*found(0.01) - found(0.02) - std::exp(-1.0))*std::exp(1.0));

    exact.settle();
    limit.settle();
}

} // End namespace cghs
} // End namespace Foam
