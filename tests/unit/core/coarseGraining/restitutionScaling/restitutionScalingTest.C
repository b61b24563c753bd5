/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    The restitution coefficient of parcels of W particles.

\*---------------------------------------------------------------------------*/

#include "restitutionScaling.H"
#include "roughImpacts.H"
#include "complaint.H"
#include "claim.H"

#include <catch2/catch.hpp>

#include <cstdlib>

namespace Foam
{
namespace cghs
{

namespace
{

scalar scaled
(
    const char* law,
    const scalar e,
    const scalar W,
    const scalar mu = 0,
    const scalar et = 0.5
)
{
    const std::string text(std::string("restitutionScaling ") + law + ';');
    const dictionary dict(dictionaryOf(text.c_str()));
    return restitutionScaling::New(dict)
        ->ofParcel(dict, restitution{e, et, mu}, W);
}


//- The number that follows these words
scalar numberAfter(const std::string& text, const char* words)
{
    const auto where = text.find(words);
    return
        where == std::string::npos
      ? -1
      : std::strtod(text.c_str() + where + std::strlen(words), nullptr);
}

const char* const limitWords = "largest parcelWeight it allows here is ";

}


TEST_CASE("logarithmic gives the chapter's parcel restitutions",
    "[coarseGraining]")
{
    claim table("restitution.logarithmicTable5", 5e-5);
    table.see(mag(scaled("logarithmic", 0.94, 125) - 0.5007));
    table.see(mag(scaled("logarithmic", 0.94, 1000) - 0.1413));
    table.settle();

    claim formula("restitution.logarithmic", 1e-12);
    for (const scalar e : {0.1, 0.5, 0.9, 0.999})
    {
        for (const scalar W : {2.0, 8.0, 1e3})
        {
            const scalar expected = pow(e, sqrt(W));
            formula.see
            (
                mag(scaled("logarithmic", e, W) - expected)/expected
            );
        }
    }
    formula.settle();
}


TEST_CASE("logarithmic takes any e and W", "[coarseGraining]")
{
    claim bounded("restitution.logarithmicBounded", 0);
    for (const scalar e : {0.0, 1e-300, 1e-6, 0.5, 1.0})
    {
        for (const scalar W : {1.0, 1e3, 1e9, 1e15})
        {
            const scalar parcel = scaled("logarithmic", e, W);
            bounded.count(parcel >= 0 && parcel <= e*(1 + 1e-12));
        }
    }
    bounded.count(scaled("logarithmic", 0, 8) == 0);
    bounded.count(scaled("logarithmic", 1, 1e9) == 1);
    bounded.settle();
}


TEST_CASE("kineticTheory keeps the dissipation of W particles",
    "[coarseGraining]")
{
    // Haff's cooling goes with (1 - e^2) over the diameter
    claim cooling("restitution.kineticTheory", 1e-14);
    for (const scalar e : {0.82, 0.9, 0.94, 0.99, 1.0})
    {
        for (const scalar k : {1.0, 1.5, 2.0, 3.0})
        {
            const scalar parcel = scaled("kineticTheory", e, pow3(k));
            cooling.see(mag((1 - sqr(parcel))/k - (1 - sqr(e))));
        }
    }
    cooling.settle();
}


TEST_CASE("kineticTheory says how large W may be", "[coarseGraining]")
{
    claim limit("restitution.kineticTheoryLimit", 1e-4);
    claim allowed("restitution.kineticTheoryWithinLimit", 0);
    claim honest("restitution.kineticTheoryTakesItsOwnLimit", 0);

    for (const scalar e : {0.0, 0.3, 0.5, 0.82, 0.9, 0.94, 0.97, 0.99})
    {
        const scalar largest = pow(1 - sqr(e), -3);
        const std::string text
        (
            complaintOf([&]{ scaled("kineticTheory", e, 1.001*largest); })
        );
        const scalar told = numberAfter(text, limitWords);

        limit.see(mag(told - largest)/largest);
        allowed.count
        (
            complaintOf([&]{ scaled("kineticTheory", e, 0.999*largest); })
         == ""
        );

        // Whoever types what the message says must not meet it again
        honest.count
        (
            complaintOf([&]{ scaled("kineticTheory", e, told); }) == ""
        );
    }

    limit.settle();
    allowed.settle();
    honest.settle();

    settleComplaint
    (
        "restitution.kineticTheoryComplaint",
        {
            "bedProperties", "kineticTheory", "restitutionCoefficient",
            "0.94", "parcelWeight", "1000", "634", "logarithmic"
        },
        []{ scaled("kineticTheory", 0.94, 1000); }
    );
}


TEST_CASE("roughKineticTheory is kineticTheory where nothing rubs",
    "[coarseGraining]")
{
    claim same("restitution.roughWithoutFriction", 1e-9);
    for (const scalar e : {0.9, 0.94, 0.99})
    {
        for (const scalar W : {2.0, 8.0, 27.0})
        {
            same.see
            (
                mag
                (
                    scaled("roughKineticTheory", e, W)
                  - scaled("kineticTheory", e, W)
                )
            );
        }
    }
    same.settle();
}


TEST_CASE("roughKineticTheory gives the table of doc/theory.md",
    "[coarseGraining]")
{
    // By a quadrature over the speeds of impacts, in another language
    claim table("restitution.roughKineticTheoryTable", 1e-3);
    const auto parcel = [](const scalar e, const scalar mu, const scalar W)
    {
        return scaled("roughKineticTheory", e, W, mu, 0.33);
    };
    table.see(mag(parcel(0.97, 0.01, 8) - 0.9225));
    table.see(mag(parcel(0.97, 0.01, 27) - 0.8724));
    table.see(mag(parcel(0.97, 0.1, 8) - 0.7984));
    table.see(mag(parcel(0.97, 0.1, 27) - 0.5727));
    table.see(mag(parcel(0.97, 0.3, 8) - 0.6779));
    table.see(mag(parcel(0.9, 0.1, 8) - 0.6084));
    table.settle();
}


TEST_CASE("roughKineticTheory keeps what impacts with friction take",
    "[coarseGraining]")
{
    claim kept("restitution.roughKineticTheory", 1e-9);
    claim bounded("restitution.roughKineticTheoryBounded", 0);

    for (const scalar mu : {0.01, 0.1, 0.3, 1.0, 10.0})
    {
        for (const scalar et : {0.0, 0.33, 1.0})
        {
            const auto loss = [&](const scalar e)
            {
                return roughImpacts(e, et, mu).dissipation();
            };

            for (const scalar W : {1.5, 8.0, 1e3, 1e9})
            {
                const scalar asked = cbrt(W)*loss(0.97);
                const scalar e = scaled("roughKineticTheory", 0.97, W, mu, et);

                bounded.count(e >= 0 && e <= 0.97);
                if (loss(e) < asked*(1 - 1e-6))
                {
                    // No other takes more
                    for (label i = 0; i <= 100; ++i)
                    {
                        bounded.count(loss(e) >= loss(0.01*i)*(1 - 1e-9));
                    }
                }
                else
                {
                    kept.see(mag(loss(e)/asked - 1));
                }
            }
        }
    }

    kept.settle();
    bounded.settle();
}


TEST_CASE("unscaled leaves e as it is", "[coarseGraining]")
{
    claim same("restitution.unscaled", 0);
    for (const scalar e : {0.0, 0.3, 0.94, 1.0})
    {
        same.see(mag(scaled("unscaled", e, 1000) - e));
    }
    same.settle();
}


TEST_CASE("Parcels of one particle are particles", "[coarseGraining]")
{
    claim same("restitution.identityAtOne", 1e-15);
    for
    (
        const char* law
      : {"unscaled", "logarithmic", "kineticTheory", "roughKineticTheory"}
    )
    {
        for (const scalar e : {0.0, 0.1, 0.5, 0.94, 1.0})
        {
            same.see(mag(scaled(law, e, 1) - e));
            same.see(mag(scaled(law, e, 1, 0.3) - e));
        }
    }
    same.settle();
}


TEST_CASE("An unknown scaling law gets the list of those there are",
    "[coarseGraining]")
{
    settleComplaint
    (
        "restitution.unknownLaw",
        {
            "bedProperties", "restitutionScaling", "logaritmic",
            "unscaled", "logarithmic", "kineticTheory",
            "roughKineticTheory"
        },
        []{ scaled("logaritmic", 0.9, 8); }
    );
}

} // End namespace cghs
} // End namespace Foam
