/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    Particles that react from outside against Levenspiel's times for each
    control and their sum, a char particle that burns out, and leaching against
    Eq 103.

\*---------------------------------------------------------------------------*/

#include "reactingCell.H"
#include "complaint.H"
#include "claim.H"
#include "mathematicalConstants.H"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>

namespace Foam
{
namespace cghs
{

namespace
{

using constant::mathematical::pi;

// 1000 kg/m^3 of S in a fresh particle, at 10 mol/m^3 of A
const scalar d0 = 1e-3;
const scalar R = d0/2;
const scalar c = 10;
const scalar density = 1000/0.05;
const scalar bar = 1e5;

const char* const fluid =
    "species (A B C);"
    "A { specie { molWeight 20; } }"
    "B { specie { molWeight 20; } }"
    "C { specie { molWeight 45; } }";

const char* const withAsh = "equation \"2 A + S = 2 B + P\"; ";
const char* const withoutAsh = "equation \"2 A + S = 2 C\"; ";

const char* const layerFast = "layer { solid S; fresh 1000; } ";
const char* const layerSlow = "layer { solid S; fresh 1000; D 2e-6; } ";


//- A particle in so much fluid that it stays as it is
class turning
{
    const reactionScheme scheme_;

    reactingCell cell_;

    scalarField gas_;
    scalarField left_;

    scalar n0_;
    scalar T_;
    scalar h_;


    static dictionary reactions(const bool shrinks, const std::string& r)
    {
        return dictionaryOf
        (
            (
                "solids"
                "{"
                "    S"
                "    {"
                "        specie { molWeight 50; }"
                "        equationOfState { rho 1000; }"
                "    }"
                "    P"
                "    {"
                "        specie { molWeight 50; }"
                "        equationOfState { rho 1000; }"
                "    }"
                "}"
                "size "
              + std::string(shrinks ? "constantDensity" : "constantDiameter")
              + "; reactions { r { rate shrinkingCore; reactant A; "
              + r + "} }"
            ).c_str()
        );
    }


public:

    //- Mass transfer from now on [m/s]
    scalar film;

    turning(const bool shrinks, const std::string& text)
    :
        scheme_(reactions(shrinks, text), dictionaryOf(fluid), false),
        cell_(scheme_, {1e-6, 1e-12}),
        gas_(List<scalar>({1e6, 1e7, 0})),
        left_(2, 0),
        n0_(density*pi/6*pow3(d0)),
        T_(1000),
        h_(1e-3),
        film(0)
    {
        left_[0] = n0_;
    }

    //- A time passes. The particle is put into the cell anew, as in a restart
    void pass(const scalar deltaT)
    {
        cell_.start(gas_, T_, 0, gas_[0]/c);
        cell_.add({1, d0, T_, 0, film, 0}, left_);
        REQUIRE(cell_.react(deltaT, h_));
        left_ = cell_.amounts(0);
    }

    //- Of S
    scalar X() const { return 1 - left_[0]/n0_; }

    //- Of a particle that shrinks [m]
    scalar d() const { return d0*std::cbrt(left_[0]/n0_); }
};


//- Levenspiel's t/tau of X
scalar filmTime(const scalar X) { return X; }

scalar reactionTime(const scalar X) { return 1 - std::cbrt(1 - X); }

scalar ashTime(const scalar X)
{
    return 1 - 3*std::pow(1 - X, 2.0/3) + 2*(1 - X);
}

// Times of complete conversion: two A go to one S
const scalar kFilm = 0.03;
const scalar kSurface = 0.02;
const scalar D = 2e-6;
const scalar tauFilm = 2*density*R/(3*kFilm*c);
const scalar tauAsh = 2*density*sqr(R)/(6*D*c);
const scalar tauReaction = 2*density*R/(kSurface*c);
const scalar tauShrinking = 2*density*R/(kFilm*c);


//- See by how much a particle misses the time that X takes, over the whole
void follow
(
    claim& right,
    turning& particle,
    const scalar tau,
    const std::function<scalar(scalar)>& timeOf
)
{
    const label n = 9;
    for (label i = 1; i <= n; ++i)
    {
        particle.pass(0.1*tau);
        right.see(mag(timeOf(particle.X())/tau - 0.1*i));
    }
    particle.pass(0.1001*tau);
    right.see(1 - particle.X());
}

}


TEST_CASE("Shrinking core: a particle that keeps its size", "[kinetics]")
{
    const auto check = []
    (
        const char* name,
        const scalar tolerance,
        const std::string& text,
        const scalar byFilm,
        const scalar byAsh,
        const scalar byReaction
    )
    {
        claim right(name, tolerance);
        turning particle(false, withAsh + text);
        particle.film = kFilm;

        follow
        (
            right,
            particle,
            byFilm*tauFilm + byAsh*tauAsh + byReaction*tauReaction,
            [&](const scalar X)
            {
                return
                    byFilm*tauFilm*filmTime(X)
                  + byAsh*tauAsh*ashTime(X)
                  + byReaction*tauReaction*reactionTime(X);
            }
        );
        right.settle();
    };

    // An Arrhenius law that is 0.02 m/s at 1000 K
    const std::string surface("surface { A 3.3355e3; Ta 12024.40088; } ");

    check
    (
        "shrinkingCore.film", 2e-5,
        std::string("film yes; ") + layerFast, 1, 0, 0
    );
    check
    (
        "shrinkingCore.constantFilm", 2e-5,
        std::string("film 0.03; ") + layerFast, 1, 0, 0
    );
    check
    (
        "shrinkingCore.ash", 5e-5,
        std::string("film no; ") + layerSlow, 0, 1, 0
    );
    check
    (
        "shrinkingCore.reaction", 5e-5,
        "film no; " + surface + layerFast, 0, 0, 1
    );
    check
    (
        "shrinkingCore.filmAndAsh", 5e-5,
        std::string("film yes; ") + layerSlow, 1, 1, 0
    );
    check
    (
        "shrinkingCore.sum", 5e-5,
        "film yes; " + surface + layerSlow, 1, 1, 1
    );
}


TEST_CASE("Shrinking core: a particle that shrinks", "[kinetics]")
{
    claim film("shrinkingCore.shrinking.film", 2e-5);
    claim reaction("shrinkingCore.shrinking.reaction", 2e-5);
    claim sum("shrinkingCore.shrinking.sum", 2e-5);

    // With a constant film both controls are alike
    const auto check = [](claim& right, const char* text, const scalar tau)
    {
        turning particle(true, std::string(withoutAsh) + text);
        follow
        (
            right,
            particle,
            tau,
            [&](const scalar X) { return tau*reactionTime(X); }
        );
    };
    check(film, "film 0.03;", tauShrinking);
    check(reaction, "film no; surface { A 0.02; }", tauReaction);
    check
    (
        sum, "film 0.03; surface { A 0.02; }", tauShrinking + tauReaction
    );

    film.settle();
    reaction.settle();
    sum.settle();
}


TEST_CASE("A char particle burns out in air", "[kinetics]")
{
    claim along("char.diameter", 1e-3);
    claim over("char.burnout", 1e-3);

    const reactionScheme scheme
    (
        dictionaryOf
        (
            "solids"
            "{"
            "    C { elements { C 1; } equationOfState { rho 800; } }"
            "}"
            "size constantDensity;"
            "reactions"
            "{"
            "    burn"
            "    {"
            "        equation \"C + O2 = CO2\";"
            "        rate shrinkingCore; reactant O2; film yes;"
            "        surface { A 450; Ea 8e4; }"
            "    }"
            "}"
        ),
        dictionaryOf
        (
            "species (O2 N2 CO2);"
            "O2 { elements { O 2; } }"
            "N2 { elements { N 2; } }"
            "CO2 { elements { C 1; O 2; } }"
        ),
        false
    );
    reactingCell cell(scheme, {1e-6, 1e-12});

    // Sherwood's number is 2: dR/dt = -c/n/(R/D + 1/k_s)
    const scalar T = 1200;
    const scalar diffusivity = 2e-4;
    const scalar cO2 = 0.21*bar/(8.31446261815324*T);
    const scalar k = 450*std::exp(-8e4/(8.31446261815324*T));
    const scalar n = 800/scheme.solids()[0].M();
    const scalar R0 = 0.5e-3;
    const auto timeTo = [&](const scalar r)
    {
        return
            n/cO2*((sqr(R0) - sqr(r))/(2*diffusivity) + (R0 - r)/k);
    };

    const scalarField air(List<scalar>({2.1e5, 7.9e5, 0}));
    const scalar start = n*4*pi/3*pow3(R0);
    scalarField left(1, start);
    scalar h = 1e-3;
    scalar t = 0;
    const label steps = 2000;
    const scalar dt = timeTo(0)/steps;

    while (left[0] > 1e-11*start)
    {
        // The film that there is half a step later
        const scalar r = R0*std::cbrt(left[0]/start);
        const scalar half =
            max(r - 0.5*dt*cO2/n/(r/diffusivity + 1/k), 1e-3*R0);

        cell.start(air, T, bar);
        cell.add({1, 2*r, T, 0, diffusivity/half, 0}, left);
        REQUIRE(cell.react(dt, h));
        left = cell.amounts(0);
        t += dt;

        along.see
        (
            mag(t - timeTo(R0*std::cbrt(left[0]/start)))/timeTo(0)
        );
        REQUIRE(t < 2*timeTo(0));
    }
    over.see(mag(t/timeTo(0) - 1));

    along.settle();
    over.settle();
}


TEST_CASE("Rare earths are leached by Eq 103", "[kinetics]")
{
    claim leached("ionExchange.leached", 5e-5);
    claim concentrated("ionExchange.concentration", 5e-5);
    claim chapter("ionExchange.chapter", 0.1);

    const auto scheme = [](const char* more)
    {
        return autoPtr<reactionScheme>
        (
            new reactionScheme
            (
                dictionaryOf
                (
                    (
                        "solids"
                        "{"
                        "    REE { specie { molWeight 144; } }"
                        "    ash { specie { molWeight 60; } }"
                        "}"
                        "reactions"
                        "{"
                        "    leach"
                        "    {"
                        "        equation \"REE = REEaq\";"
                        "        rate ionExchange; solid REE; fresh 1.3668;"
                      + std::string(more)
                      + "    }"
                        "}"
                    ).c_str()
                ),
                dictionaryOf
                (
                    "species (REEaq NH4 H2O);"
                    "REEaq { specie { molWeight 144; } }"
                    "NH4 { specie { molWeight 18; } }"
                    "H2O { specie { molWeight 18; } }"
                ),
                false
            )
        );
    };
    const auto leach = [&](claim& right, const char* more, const scalar times)
    {
        const autoPtr<reactionScheme> made(scheme(more));
        reactingCell cell(made(), {1e-6, 1e-12});

        for (const scalar d : {0.45e-3, 0.6e-3})
        {
            const scalar volume = pi/6*pow3(d);
            const scalar all = 1.3668/0.144*volume;
            scalarField left(List<scalar>({all, 1340/0.06*volume}));
            const scalar k =
                times*0.011/std::pow(500*d, 1.217)
               *std::exp(-9480/(8.31446261815324*298));

            // A litre with 75 mol/m^3 of NH4
            scalar h = 1e-3;
            for (const label i : {1, 2, 3, 4, 5, 6, 7, 8, 9})
            {
                cell.start
                (
                    scalarField(List<scalar>({0, 0.075, 55})), 298, 0, 1e-3
                );
                cell.add({1, d, 298, 0, 1, 0}, left);
                REQUIRE(cell.react(0.1/(3*k), h));
                left = cell.amounts(0);

                // The a of this time, by bisection
                scalar low = 0;
                scalar high = 1;
                while (high - low > 1e-12)
                {
                    const scalar a = 0.5*(low + high);
                    const scalar kt = 1 - 2*a/3 - std::pow(1 - a, 2.0/3);
                    (kt < 0.1*i/3 ? low : high) = a;
                }
                right.see(mag(1 - left[0]/all - low));
            }

            // About 80 % in 80 s, as in its figure
            if (d == 0.45e-3 && times == 1)
            {
                const scalar a = 0.8;
                chapter.see
                (
                    mag((1 - 2*a/3 - std::pow(1 - a, 2.0/3))/k/80 - 1)
                );
            }
        }
    };

    leach(leached, "", 1);
    leach(concentrated, "cation NH4; experiment 150;", 0.5);

    leached.settle();
    concentrated.settle();
    chapter.settle();
}

} // End namespace cghs
} // End namespace Foam
