/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    All rate laws: derivatives, and that they are finite where nothing is left
    or nothing has happened. Coke burning and methanol to olefins against
    numbers computed by hand.

\*---------------------------------------------------------------------------*/

#include "reactionScheme.H"
#include "complaint.H"
#include "claim.H"
#include "StringStream.H"

#include <catch2/catch.hpp>

#include <cmath>

namespace Foam
{
namespace cghs
{

namespace
{

const char* const gas =
    "species (O2 CO2 CO N2 MeOH C2H4 H2O);"
    "O2 { elements { O 2; } }"
    "CO2 { elements { C 1; O 2; } }"
    "CO { elements { C 1; O 1; } }"
    "N2 { elements { N 2; } }"
    "MeOH { elements { C 1; H 4; O 1; } }"
    "C2H4 { elements { C 2; H 4; } }"
    "H2O { elements { H 2; O 1; } }";

const char* const solids =
    "solids"
    "{"
    "    C { elements { C 1; } }"
    "    catalyst { specie { molWeight 60; } }"
    "}";

//- An example of a law: its name and a reaction of it
struct example
{
    const char* law;
    const char* text;
};

#define burn "equation \"C + O2 = CO2\"; "
#define half "equation \"C + 0.5 O2 = CO\"; "
#define fast "of moles C; driving bar; orders { O2 1; } A 2.78e8; Ea 161200; "
#define core "rate shrinkingCore; reactant O2; "
#define leach "rate ionExchange; solid C; fresh 100; "
#define crack                                                                  \
    "equation \"MeOH = 0.5 C2H4\"; lumped yes; remainder H2O;"                 \
    "rate deactivating; reactant MeOH; catalyst catalyst; coke C;"             \
    "alpha 0.1008; A 0.12463; "

const example examples[] =
{
    {"massAction", burn "rate massAction; " fast},
    {
        "massAction",
        burn "rate massAction; of particleSurface; driving Pa;"
        "orders { O2 0.5; C 2; } A 3; Ea 5e4; beta 0.5; cutOff { C 1e-4; }"
    },
    {
        "massAction",
        "equation \"CO + 0.5 O2 = CO2\"; rate massAction; of fluidVolume;"
        "driving \"mol/m3\"; orders { CO 1; O2 0.5; } A 1e8; Ta 15105;"
    },
    {"cokeCombustion", burn "rate cokeCombustion; product CO2;"
        "ratio intrinsic; " fast},
    {"cokeCombustion", half "rate cokeCombustion; product CO;"
        "ratio intrinsic; " fast},
    {"cokeCombustion", half "rate cokeCombustion; product CO;"
        "ratio 17.9; " fast},
    {"shrinkingCore", burn core "film yes;"},
    {"shrinkingCore", burn core "film yes; layer { solid C; fresh 100; }"},
    {"shrinkingCore", burn core "film 0.2; surface { A 12; Ea 1e4; }"},
    {
        "shrinkingCore",
        burn core "film no; layer { solid C; fresh 100; D 1e-5; }"
    },
    {
        "shrinkingCore",
        burn core "film yes; layer { solid C; fresh 100; D 1e-5; }"
    },
    {
        "shrinkingCore",
        burn core "film no; layer { solid C; fresh 100; }"
        "surface { A 12; Ea 1e4; }"
    },
    {
        "shrinkingCore",
        burn core "film yes; layer { solid C; fresh 100; D 1e-5; }"
        "surface { A 12; Ea 1e4; }"
    },
    {"ionExchange", burn leach},
    {"ionExchange", burn leach "cation O2; experiment 2;"},
    {"deactivating", crack "driving \"mol/m3\";"},
    {"deactivating", crack "driving bar; Ea 4e4;"},
    {"deactivating", crack "driving bar; Ea 4e4; cokeOf particle;"}
};


//- A law as users have it
class lawOf
{
    const reactionScheme scheme_;

    static dictionary with(const std::string& text)
    {
        return dictionaryOf
        (
            (solids + ("reactions { r { " + text + "} }")).c_str()
        );
    }

public:

    lawOf(const char* text)
    :
        scheme_(with(text), dictionaryOf(gas), false)
    {}

    const kineticLaw& operator()() const
    {
        return
            scheme_.inFluid().size()
          ? scheme_.inFluid()[0].law()
          : scheme_.inParticles()[0].law();
    }
};


const scalar d = 60e-6;

//- What 100 kg/m^3 of carbon are in a particle [mol]
const scalar fresh = 100/0.012011*3.14159265358979/6*d*d*d;

//- Where laws are tried
struct place
{
    scalar reactant;
    scalar solid;
    scalar T;

    //- Is there a catalyst?
    bool catalyst = true;

    place(const scalar c, const scalar n, const scalar t)
    :
        reactant(c),
        solid(n),
        T(t)
    {}
};


scalar valueAt(const place& at, const rateArgument& a)
{
    switch (a.what)
    {
        case rateArgument::temperature: return at.T;
        case rateArgument::fluidTemperature: return 1.02*at.T;
        case rateArgument::diameter: return d;
        case rateArgument::mass: return 1500*3.14159265/6*d*d*d;
        case rateArgument::film: return 0.4;
        case rateArgument::fluid: return at.reactant*(1 + 0.1*a.index);
        case rateArgument::solid:
        {
            return a.index && !at.catalyst ? 0 : at.solid*(1 + 7*a.index);
        }
    }
    return 0;
}


scalarField valuesAt(const place& at, const kineticLaw& law)
{
    scalarField x(kineticLaw::maxArguments, 0);
    forAll(law.arguments(), a)
    {
        x[a] = valueAt(at, law.arguments()[a]);
    }
    return x;
}

}


TEST_CASE("Derivatives of all rate laws", "[kinetics]")
{
    claim covered("kineticLaw.covered", 0);
    claim right("kineticLaw.derivatives", 1e-7);
    claim same("kineticLaw.derivatives.value", 1e-14);

    for
    (
        const word& name
      : kineticLaw::dictionaryConstructorTablePtr_->sortedToc()
    )
    {
        label n = 0;
        for (const example& e : examples)
        {
            n += name == e.law;
        }
        covered.count(n > 0);
    }

    for (const example& e : examples)
    {
        const lawOf made(e.text);
        const kineticLaw& law = made();

        for (const scalar left : {0.9, 0.3, 0.01})
        {
            const scalarField x(valuesAt({3, left*fresh, 900}, law));
            scalarField dx(kineticLaw::maxArguments, 0);
            const scalar r = law.rate(x.cdata(), dx.data());
            REQUIRE(r > 0);
            same.see(mag(law.rate(x.cdata())/r - 1));

            forAll(law.arguments(), a)
            {
                // Of order 4, in short steps
                const scalar h = 1e-4*x[a];
                const auto at = [&](const scalar steps)
                {
                    scalarField y(x);
                    y[a] += steps*h;
                    return law.rate(y.cdata());
                };
                const scalar slope =
                    (8*(at(1) - at(-1)) - (at(2) - at(-2)))/(12*h);
                right.see(mag(dx[a] - slope)*x[a]/r);
            }
        }
    }

    covered.settle();
    right.settle();
    same.settle();
}


TEST_CASE("Rate laws where nothing is left or has happened", "[kinetics]")
{
    claim finite("kineticLaw.finite", 0);
    claim nothing("kineticLaw.nothing", 0);

    const auto see = [&](const kineticLaw& law, const place& at)
    {
        const scalarField x(valuesAt(at, law));
        scalarField dx(kineticLaw::maxArguments, 0);
        const scalar r = law.rate(x.cdata(), dx.data());

        finite.count(std::isfinite(r));
        finite.count(std::isfinite(law.rate(x.cdata())));
        for (const scalar slope : dx)
        {
            finite.count(std::isfinite(slope));
        }

        // Without what it says it follows there is no rate
        for (const rateArgument& a : law.arguments())
        {
            if (law.follows(a) && valueAt(at, a) == 0)
            {
                nothing.count(r == 0);
            }
        }
    };

    for (const example& e : examples)
    {
        const lawOf made(e.text);
        const kineticLaw& law = made();

        for (const scalar c : {0.0, 1e-300, 3.0})
        {
            for (const scalar left : {-1e-14, 0.0, 1e-300, 1.0, 1.1})
            {
                for (const scalar T : {1.0, 900.0, 2e4})
                {
                    for (const bool catalyst : {true, false})
                    {
                        place at(c, left*fresh, T);
                        at.catalyst = catalyst;
                        see(law, at);
                    }
                }
            }
        }
    }

    finite.settle();
    nothing.settle();
}


TEST_CASE("Coke burns to CO and CO2", "[kinetics]")
{
    claim shares("cokeCombustion.shares", 1e-10);
    claim intrinsic("cokeCombustion.intrinsic", 1e-3);

    const lawOf all(burn "rate massAction; " fast);
    const lawOf toCO2
    (
        burn "rate cokeCombustion; product CO2; ratio intrinsic; " fast
    );
    const lawOf toCO
    (
        half "rate cokeCombustion; product CO; ratio intrinsic; " fast
    );
    const lawOf given
    (
        half "rate cokeCombustion; product CO; ratio 17.9; " fast
    );

    for (const scalar T : {300.0, 912.0, 2000.0})
    {
        const scalarField x(valuesAt({3, fresh, T}, all()));
        const scalar whole = all().rate(x.cdata());
        const scalar CO2 =
            toCO2().rate(valuesAt({3, fresh, T}, toCO2()).cdata());
        const scalar CO =
            toCO().rate(valuesAt({3, fresh, T}, toCO()).cdata());

        shares.see(mag((CO + CO2)/whole - 1));
        shares.see
        (
            mag
            (
                CO2/CO
               /(5.28e-3*std::exp(34860/(8.31446261815324*T)))
              - 1
            )
        );
        shares.see(mag(given().rate(x.cdata())*18.9/whole - 1));

        if (T == 912)
        {
            // As the chapter's formula gives it
            intrinsic.see(mag(CO2/CO/0.524 - 1));
        }
    }

    shares.settle();
    intrinsic.settle();
}


TEST_CASE("Methanol over a catalyst that cokes", "[kinetics]")
{
    claim rates("deactivating.rates", 1e-9);
    claim mass("deactivating.mass", 1e-14);

    // phi of ethylene by coke in g/100 g, by hand
    const struct
    {
        scalar w;
        scalar phi;
    }
    by[] =
    {
        {0, 0.9999984891},
        {2, 0.8173544038},
        {5.9, 0.4592525241},
        {7.8, 0.04555544639},
        {12, 7.453330621e-06}
    };

    const reactionScheme scheme
    (
        dictionaryOf
        (
            (
                std::string(solids)
              + "reactions"
                "{"
                "    r { " crack "driving \"mol/L\"; A 124.63; }"
                "    s { " crack "driving \"mol/L\"; A 124.63;"
                "        cokeOf particle; }"
                "}"
            ).c_str()
        ),
        dictionaryOf(gas),
        false
    );
    const reaction& r = scheme.inParticles()[0];

    // 1 mg of catalyst in 0.01 mol/L: 0.12463 L/g/s times 1e-5 g mol/L. Of so
    // many g/100 g of the particle there are w/(1 - w/100) of the catalyst
    for (const auto& at : by)
    {
        for (const label k : {0, 1})
        {
            const kineticLaw& law = scheme.inParticles()[k].law();
            const scalar coke = 1e-6*at.w/(k ? 100 - at.w : 100);
            scalarField x(kineticLaw::maxArguments, 0);
            scalarField n(scheme.solids().size(), 0);
            forAll(n, s)
            {
                n[s] =
                    scheme.solids()[s].name() == "C"
                  ? coke/scheme.solids()[s].M()
                  : 1e-6/0.06;
            }
            forAll(law.arguments(), a)
            {
                const rateArgument& which = law.arguments()[a];
                x[a] =
                    which.what == rateArgument::fluid ? 10
                  : which.what == rateArgument::mass ? 1e-6 + coke
                  : n[which.index];
            }
            rates.see(mag(law.rate(x.cdata())/(0.12463e-5*at.phi) - 1));
            rates.see(mag(law.asked(n) - at.w)/100);
        }
    }

    scalar made = 0;
    forAll(scheme.fluid(), k)
    {
        made += r.equation().fluidGain()[k]*scheme.fluid()[k].M();
    }
    mass.see(mag(made)/0.032);
    rates.settle();
    mass.settle();
}


TEST_CASE("Lumped reactions say what they miss", "[kinetics]")
{
    claim defects("lumped.defects", 1e-5);
    claim said("lumped.said", 0);

    // Water closes the mass: 0.888098 of it. By hand, over what is turned
    const reactionScheme scheme
    (
        dictionaryOf
        (
            "solids { catalyst { specie { molWeight 60; } } }"
            "reactions"
            "{"
            "    r"
            "    {"
            "        equation \"MeOH = CH4 + H2O\";"
            "        lumped yes; remainder H2O;"
            "        rate massAction; of mass catalyst; A 1;"
            "        driving bar; orders { MeOH 1; }"
            "    }"
            "}"
        ),
        dictionaryOf
        (
            "species (MeOH CH4 H2O);"
            "MeOH { elements { C 1; H 4; O 1; } }"
            "CH4 { elements { C 1; H 4; } }"
            "H2O { elements { H 2; O 1; } }"
        ),
        false
    );
    const HashTable<scalar>& found =
        scheme.inParticles()[0].equation().defects();

    defects.see(mag(found.lookup("H", 0) - 0.363372));
    defects.see(mag(found.lookup("O", 0) + 0.118534));
    defects.see(found.found("C") ? 1 : 0);

    OStringStream text;
    scheme.report(text);
    for (const char* word : {"lumped", "36.337", "of its H", "of its O"})
    {
        said.see(text.str().find(word) == std::string::npos);
    }

    defects.settle();
    said.settle();
}


TEST_CASE("Rate laws that cannot be", "[kinetics]")
{
    const auto of = [](const char* text)
    {
        return [=] { lawOf made(text); };
    };

    settleComplaint
    (
        "shrinkingCore.nothingResists",
        {"infinite", "film", "surface"},
        of(burn core "film no; layer { solid C; fresh 100; }")
    );
    settleComplaint
    (
        "shrinkingCore.noReactant",
        {"reactant is CO2", "not a reactant", "left side"},
        of(burn "rate shrinkingCore; reactant CO2; film yes;")
    );
    settleComplaint
    (
        "shrinkingCore.noSolid",
        {"solid is catalyst", "not a reactant", "C + O2 = CO2"},
        of(burn core "film yes; layer { solid catalyst; fresh 100; }")
    );
    settleComplaint
    (
        "cokeCombustion.product",
        {"product is O2", "CO CO2"},
        of(burn "rate cokeCombustion; product O2; ratio 1; " fast)
    );
    settleComplaint
    (
        "cokeCombustion.wrongProduct",
        {"makes 0 CO", "C + 0.5 O2 = CO"},
        of(burn "rate cokeCombustion; product CO; ratio 1; " fast)
    );
    settleComplaint
    (
        "cokeCombustion.ratio",
        {"ratio is", "intrinsic", "moles of CO2"},
        of(burn "rate cokeCombustion; product CO2; ratio some; " fast)
    );
    settleComplaint
    (
        "ionExchange.halfACation",
        {"cation", "experiment", "only one"},
        of(burn leach "cation O2;")
    );
    settleComplaint
    (
        "kineticLaw.unknown",
        {"magic", "shrinkingCore", "massAction"},
        of(burn "rate magic;")
    );
}

} // End namespace cghs
} // End namespace Foam
