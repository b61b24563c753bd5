/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    Mass transfer through films: numbers worked out by hand, by D and by Sc; a
    sphere in fluid at rest; a constant; and what is refused.

\*---------------------------------------------------------------------------*/

#include "filmTransfer.H"
#include "complaint.H"
#include "scalarField.H"
#include "claim.H"

#include <catch2/catch.hpp>

#include <sstream>

namespace Foam
{
namespace cghs
{

static filmTransfer filmOf(const std::string& entries)
{
    return filmTransfer(dictionaryOf(entries.c_str()), wordList({"burn"}));
}


//- k_film in a flow, whose Cp and kappa it must not need
static scalar coefficient(const filmTransfer& film, const slipFlow& flow)
{
    List<heatedFlow> flows(1, heatedFlow(flow, -1, -1));
    scalarField k(1);

    film.coefficients(flows, k);
    return k[0];
}


TEST_CASE("Mass transfer coefficients are those worked out by hand", "[mass]")
{
    struct sample
    {
        const char* law;
        scalar e, Re, Sc;       // Re without voidage
        scalar Sh;
    };

    // As for heat: 1024^0.2 = 4, 1024^0.7 = 128, 32^0.6 = 8
    const sample samples[] =
    {
        {"Gunn", 1, 1, 1, 2*1.7 + 0.13},
        {"Gunn", 0.5, 2048, 1, 3.25*3.8 + 0.43*128},
        {"Gunn", 0.5, 2, 10, 3.25 + 2.705*2.1379620895},
        {"RanzMarshall", 1, 100, 8, 14},
        {"RanzMarshall", 0.5, 0, 8, 2},
        {"Wakao", 0.5, 64, 8, 19.6},
        {"Wakao", 0.4, 0, 1e3, 2}
    };
    const scalar d = 5e-4, rho = 0.3, mu = 4e-5;

    claim byD("filmTransfer.byD", 1e-10);
    claim bySc("filmTransfer.bySc", 1e-10);
    for (const sample& s : samples)
    {
        const scalar D = mu/(rho*s.Sc);
        const slipFlow flow{s.e, s.Re*mu/(rho*d), d, rho, mu};
        const auto error = [&](const char* entry, const scalar value)
        {
            std::ostringstream text;
            text.precision(17);
            text << "massTransfer { model " << s.law << "; "
                 << entry << ' ' << value << "; }";

            return mag(coefficient(filmOf(text.str()), flow)*d/(s.Sh*D) - 1);
        };

        byD.see(error("D", D));
        bySc.see(error("Sc", s.Sc));
    }
    byD.settle();
    bySc.settle();
}


TEST_CASE("A film that is a number is that number", "[mass]")
{
    const filmTransfer film(filmOf("massTransfer 0.125;"));
    settle
    (
        "filmTransfer.constant",
        film.varies() ? 1 : mag(film.constant() - 0.125),
        0
    );
}


TEST_CASE("A film that no law asks for costs nothing", "[mass]")
{
    const dictionary dict
    (
        dictionaryOf("massTransfer { model Gunn; D 1e-5; }")
    );
    settle
    (
        "filmTransfer.notAsked",
        filmTransfer(dict, wordList()).varies() || !filmOf
        (
            "massTransfer { model Gunn; D 1e-5; }"
        ).varies(),
        0
    );
}


TEST_CASE("Beyond its range a law of mass transfer says so", "[mass]")
{
    const filmTransfer film(filmOf("massTransfer { model Wakao; Sc 1; }"));

    coefficient(film, slipFlow{0.4, 1, 1e-3, 1, 1e-5});
    const bool within = film.warnOutsideRange();
    coefficient(film, slipFlow{0.7, 1, 1e-3, 1, 1e-5});

    settle("filmTransfer.warning", within || !film.warnOutsideRange(), 0);
}


TEST_CASE("What does not say how a reactant passes is refused", "[mass]")
{
    const auto refused = []
    (
        const char* name,
        const std::initializer_list<const char*>& words,
        const char* entries
    )
    {
        settleComplaint(name, words, [&]{ filmOf(entries); });
    };

    refused
    (
        "filmTransfer.missing",
        {"bedProperties", "massTransfer", "burn", "model Gunn", "film no"},
        ""
    );
    refused
    (
        "filmTransfer.negative",
        {"bedProperties", "massTransfer", "-0.1", "greater than zero"},
        "massTransfer -0.1;"
    );
    refused
    (
        "filmTransfer.unknownLaw",
        {
            "bedProperties", "massTransfer", "model", "Gun,", "Gunn",
            "RanzMarshall", "Wakao"
        },
        "massTransfer { model Gun; D 1e-5; }"
    );
    refused
    (
        "filmTransfer.noLaw",
        {"massTransfer", "model", "none", "(Gunn RanzMarshall Wakao)"},
        "massTransfer { model none; D 1e-5; }"
    );
    refused
    (
        "filmTransfer.noDiffusivity",
        {"massTransfer", "Neither D nor Sc", "2e-5", "mu/(rho D)"},
        "massTransfer { model Gunn; }"
    );
    refused
    (
        "filmTransfer.twoDiffusivities",
        {"massTransfer", "Both D and Sc", "2e-5", "mu/(rho D)"},
        "massTransfer { model Gunn; D 1e-5; Sc 0.7; }"
    );
    refused
    (
        "filmTransfer.negativeD",
        {"massTransfer", "Entry D is -1e-05", "greater than zero"},
        "massTransfer { model Gunn; D -1e-5; }"
    );
    refused
    (
        "filmTransfer.zeroSc",
        {"massTransfer", "Entry Sc is 0", "greater than zero"},
        "massTransfer { model Gunn; Sc 0; }"
    );
}

} // End namespace cghs
} // End namespace Foam
