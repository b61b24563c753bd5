/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    The fluid of a cell and its reacting parcels: derivatives, balances of
    elements and enthalpy at any step and rate, and rates against analytic ones.

\*---------------------------------------------------------------------------*/

#include "stirredCell.H"
#include "denseArrow.H"
#include "regeneratorScheme.H"
#include "complaint.H"
#include "sampler.H"
#include "claim.H"
#include "mathematicalConstants.H"
#include "Polynomial.H"

#include <catch2/catch.hpp>

#include <cmath>

namespace Foam
{
namespace cghs
{

namespace
{

const reactingCell::tolerances usual = {1e-3, 1e-8};

const scalar bar = 1e5;


//- The regenerator's reactions with all rates times a factor
autoPtr<reactionScheme> burning
(
    const scalar factor = 1,
    const bool energetic = true
)
{
    dictionary reactions(dictionaryOf(regeneratorReactions));
    for (const entry& e : reactions.subDict("reactions"))
    {
        dictionary& r =
            reactions.subDict("reactions").subDict(e.keyword());

        r.set("A", factor*r.get<scalar>("A"));
    }
    return autoPtr<reactionScheme>
    (
        new reactionScheme
        (
            reactions,
            dictionaryOf(regeneratorGas),
            energetic
        )
    );
}


//- A litre of gas at 912 K and 1.4 bar: air that has burnt half
scalarField flueGas()
{
    const scalar all = 1.4*bar*1e-3/(8.314*912);
    return all*scalarField(List<scalar>({0.1, 0.08, 0.02, 0.05, 0.75}));
}


//- Add n parcels of W particles of spent catalyst
void addCatalyst(reactingCell& cell, const label n, const scalar conductance)
{
    sampler random(5);
    for (label i = 0; i < n; ++i)
    {
        reactingCell::body b;
        b.W = 5e4;
        b.d = 60e-6;
        b.T = random.between(700, 950);
        b.conductance = conductance;
        b.film = 1;

        const scalar m = b.W*1500*3.14159/6*pow3(b.d);
        cell.add
        (
            b,
            scalarField
            (
                List<scalar>
                ({
                    random.between(0, 0.02)*m/0.012,
                    random.between(0, 0.001)*m/0.001,
                    m/0.06
                })
            )
        );
    }
}


//- Atoms of each element, mass and enthalpy in all of the cell
struct contents
{
    HashTable<scalar> atoms;
    scalar mass = 0;
    scalar enthalpy = 0;

    contents(const reactionScheme& scheme, const reactingCell& cell)
    {
        add(scheme.fluid(), cell.fluidState());
        for (label i = 0; i < cell.nBodies(); ++i)
        {
            add(scheme.solids(), cell.amounts(i));
            enthalpy += cell.enthalpy(i);
        }
        if (scheme.energetic())
        {
            enthalpy += cell.fluidState().last();
        }
    }

    void add(const substances& list, const UList<scalar>& n)
    {
        forAll(list, k)
        {
            mass += n[k]*list[k].M();
            forAllConstIters(list[k].elements(), e)
            {
                if (!atoms.found(e.key()))
                {
                    atoms.insert(e.key(), 0);
                }
                atoms[e.key()] += n[k]*e.val();
            }
        }
    }
};


//- Derivatives of all bodies and of the fluid, by all extents and all of z,
//  against rates that are a little apart: amounts [mol], enthalpies [J]
void seeDerivatives
(
    claim& right,
    reactingCell& cell,
    const scalar byAmount,
    const scalar byEnthalpy
)
{
    const scalarField z(cell.fluidState());
    const denseArrow dense(cell, z);
    const label n = cell.nExtents();
    const label s = cell.nShared();
    const label o = cell.nOwn();
    scalarField x(n, 0);
    scalarField f(n), fx(n*n), fz(n*s), g(n), gBack(n);
    scalarField f0(o), f0z(o*s), g0(o), g0Back(o);

    // A column of derivatives against rates that are 2 d apart
    const auto compare = [&]
    (
        const scalarField& rates,
        const scalarField& forth,
        const scalarField& back,
        const scalar d,
        const scalarField& derivatives,
        const label width,
        const label c
    )
    {
        forAll(rates, r)
        {
            const scalar slope = (forth[r] - back[r])/(2*d);
            right.see
            (
                mag(slope - derivatives[r*width + c])
               /(mag(slope) + 1e-3*mag(rates[r])/d + VSMALL)
            );
        }
    };

    // The enthalpy is the last, where there is one
    const auto by = [&](const label c, const label size)
    {
        return byEnthalpy > 0 && c == size - 1 ? byEnthalpy : byAmount;
    };

    for (label i = 0; i < cell.nBodies(); ++i)
    {
        cell.share(z.cdata());
        dense.bodyDerivatives(i, x.cdata(), f, fx, fz);

        for (label c = 0; c < n; ++c)
        {
            const scalar d = by(c, n);
            scalarField at(x);
            at[c] = d;
            cell.rates(i, at.cdata(), g.data());
            at[c] = -d;
            cell.rates(i, at.cdata(), gBack.data());
            compare(f, g, gBack, d, fx, n, c);
        }
        for (label c = 0; c < s; ++c)
        {
            const scalar d = by(c, s);
            scalarField at(z);
            at[c] += d;
            cell.share(at.cdata());
            cell.rates(i, x.cdata(), g.data());
            cell.ownRates(g0.data());
            at[c] -= 2*d;
            cell.share(at.cdata());
            cell.rates(i, x.cdata(), gBack.data());
            cell.ownRates(g0Back.data());
            cell.share(z.cdata());
            dense.ownDerivatives(f0, f0z);

            compare(f, g, gBack, d, fz, s, c);
            compare(f0, g0, g0Back, d, f0z, s, c);
        }
    }
}


//- A catalyst that grows as it cokes: of three reactions in it two change it,
//  and one of these asks for a power of a species that vanishes
autoPtr<reactionScheme> coking(const bool energetic)
{
    return autoPtr<reactionScheme>
    (
        new reactionScheme
        (
            dictionaryOf
            (
                "size constantDensity;"
                "solids"
                "{"
                "    coke"
                "    {"
                "        elements { C 6; H 12; }"
                "        equationOfState { rho 1000; }"
                "        thermodynamics { Cp 1600; Hf 1e5; }"
                "    }"
                "    catalyst"
                "    {"
                "        specie { molWeight 60; }"
                "        equationOfState { rho 1500; }"
                "        thermodynamics { Cp 1000; Hf 0; }"
                "    }"
                "}"
                "law"
                "{"
                "    rate deactivating; reactant MeOH; catalyst catalyst;"
                "    coke coke; cokeOf particle; driving \"mol/m3\"; A 0.1;"
                "}"
                "reactions"
                "{"
                "    toC2H4"
                "    {"
                "        equation \"MeOH = 0.5 C2H4 + H2O\";"
                "        $:law; alpha 0.1;"
                "    }"
                "    toCoke"
                "    {"
                "        equation \"6 MeOH = coke + 6 H2O\";"
                "        $:law; alpha 0.4;"
                "    }"
                "    joinC2H4"
                "    {"
                "        equation \"3 C2H4 = coke\";"
                "        rate massAction; of particleSurface;"
                "        driving \"mol/m3\"; orders { H2O 0.5; } A 1e-3;"
                "    }"
                "}"
            ),
            dictionaryOf
            (
                "thermoType { thermo hConst; }"
                "species (MeOH C2H4 H2O);"
                "MeOH"
                "{"
                "    elements { C 1; H 4; O 1; }"
                "    thermodynamics { Cp 2000; Hf -6e6; }"
                "}"
                "C2H4"
                "{"
                "    elements { C 2; H 4; }"
                "    thermodynamics { Cp 2500; Hf 2e6; }"
                "}"
                "H2O"
                "{"
                "    elements { H 2; O 1; }"
                "    thermodynamics { Cp 2200; Hf -1.3e7; }"
                "}"
            ),
            energetic
        )
    );
}


//- A parcel of it, with 6 % of coke
void addCoking(reactingCell& cell)
{
    reactingCell::body b;
    b.W = 1e4;
    b.d = 97e-6;
    b.T = 700;
    b.conductance = 0.1;
    b.film = 1;
    const scalar m = b.W*1500*3.14159/6*pow3(b.d);
    cell.add(b, scalarField(List<scalar>({0.06*m/0.084, 0.94*m/0.06})));
}

}


TEST_CASE("Derivatives of a reacting cell", "[reaction]")
{
    claim right("reactingCell.derivatives", 2e-5);

    const scalar byAmount = 1e-6*sum(flueGas());
    for (const bool energetic : {true, false})
    {
        const autoPtr<reactionScheme> made(burning(1, energetic));
        reactingCell cell(made(), usual);
        cell.start(flueGas(), 890, 1.4*bar);
        addCatalyst(cell, 3, 0.3);
        seeDerivatives(right, cell, byAmount, energetic ? 1e-4 : 0);
    }

    right.settle();
}


TEST_CASE("Derivatives by what does not change a parcel", "[reaction]")
{
    claim right("reactingCell.inactiveDerivatives", 2e-5);
    claim few("reactingCell.active", 0);

    const scalarField gas(List<scalar>({3e-3, 3e-3, 4e-3}));
    for (const bool energetic : {true, false})
    {
        const autoPtr<reactionScheme> made(coking(energetic));
        reactingCell cell(made(), usual);
        cell.start(gas, 720, bar);
        addCoking(cell);
        seeDerivatives(right, cell, 1e-8, energetic ? 1e-3 : 0);

        few.count(cell.nExtents() == (energetic ? 4 : 3));
        few.count(cell.active().size() == (energetic ? 3 : 2));
        few.count(cell.active()[0] == 1);
    }

    right.settle();
    few.settle();
}


TEST_CASE("Derivatives of a vessel that is flown through", "[reaction]")
{
    claim right("stirredCell.derivatives", 2e-5);

    const scalar byAmount = 1e-6*sum(flueGas());
    for (const bool energetic : {true, false})
    {
        const autoPtr<reactionScheme> made(burning(1, energetic));
        stirredCell vessel(made(), usual);

        // It has a little less room than its gas takes
        vessel.start(flueGas(), 890, 1.4*bar);
        addCatalyst(vessel, 2, 0.3);
        vessel.flow(0.1*flueGas(), 800, 0.9e-3, 1e-4);
        vessel.walls(energetic ? 0.2 : 0, 600);
        seeDerivatives(right, vessel, byAmount, energetic ? 1e-4 : 0);
    }

    right.settle();
}


TEST_CASE("Elements, mass and enthalpy close at any step", "[reaction]")
{
    claim ends("reactingCell.ends", 0);
    claim atoms("reactingCell.elements", 1e-13);
    claim mass("reactingCell.mass", 1e-13);
    claim enthalpy("reactingCell.enthalpy", 1e-12);
    claim positive("reactingCell.positive", 0);
    claim bounded("reactingCell.temperatures", 0);

    for (const scalar factor : {1.0, 1e4, 1e8})
    {
        const autoPtr<reactionScheme> made(burning(factor));
        const reactionScheme& scheme = made();
        reactingCell cell(scheme, usual);

        for (const scalar dt : {1e-6, 1e-3, 1.0})
        {
            for (const label n : {1, 30})
            {
                cell.start(flueGas(), 890, 1.4*bar);
                addCatalyst(cell, n, 1);
                const contents before(scheme, cell);

                scalar h = dt;
                ends.count(cell.react(dt, h));

                const contents after(scheme, cell);
                forAllConstIters(before.atoms, e)
                {
                    atoms.see(mag(after.atoms[e.key()]/e.val() - 1));
                }
                mass.see(mag(after.mass/before.mass - 1));

                // Over what bodies hold between 0 K and theirs
                enthalpy.see
                (
                    mag(after.enthalpy - before.enthalpy)
                   /(before.mass*1100*900)
                );

                for (label k = 0; k < scheme.fluid().size(); ++k)
                {
                    positive.count(cell.fluidState()[k] >= 0);
                }
                for (label i = 0; i < n; ++i)
                {
                    positive.count(min(cell.amounts(i)) >= 0);
                    bounded.count
                    (
                        cell.temperature(i) > 690
                     && cell.temperature(i) < 3500
                    );
                }
            }
        }
    }

    ends.settle();
    atoms.settle();
    mass.settle();
    enthalpy.settle();
    positive.settle();
    bounded.settle();
}


TEST_CASE("Enthalpies as polynomials that are straight lines", "[reaction]")
{
    claim same("reactingCell.polynomials", 1e-9);

    // The same heat capacities, by which temperatures are searched for
    dictionary reactions(dictionaryOf(regeneratorReactions));
    dictionary gas(dictionaryOf(regeneratorGas));
    const auto bend = [](dictionary& substance)
    {
        dictionary& thermo = substance.subDict("thermodynamics");
        scalarList coefficients(8, scalar(0));
        coefficients[0] = thermo.get<scalar>("Cp");
        thermo.set("CpCoeffs<8>", Polynomial<8>(coefficients));
        thermo.set("Sf", 0);

        // Here at 298.15 K; hConst of v1912 has it at 0 K
        const scalar Hf = thermo.get<scalar>("Hf");
        thermo.remove("Hf");
        thermo.add("Hf", Hf + 298.15*coefficients[0]);  // all its digits
    };
    for (const word& name : wordList({"C", "H", "catalyst"}))
    {
        bend(reactions.subDict("solids").subDict(name));
    }
    for (const word& name : gas.get<wordList>("species"))
    {
        bend(gas.subDict(name));
    }
    reactions.set("solidThermo", word("hPolynomial"));
    gas.subDict("thermoType").set("thermo", word("hPolynomial"));

    const autoPtr<reactionScheme> straight(burning());
    const reactionScheme polynomial(reactions, gas, true);
    REQUIRE(straight->fluid().straight());
    REQUIRE(!polynomial.fluid().straight());

    reactingCell one(straight(), usual);
    reactingCell other(polynomial, usual);
    for (reactingCell* cell : {&one, &other})
    {
        cell->start(flueGas(), 890, 1.4*bar);
        addCatalyst(*cell, 7, 1);
        scalar h = 1e-3;
        for (label i = 0; i < 3; ++i)
        {
            REQUIRE(cell->react(0.1, h));
        }
    }

    same.see(mag(one.fluidTemperature()/other.fluidTemperature() - 1));
    for (label i = 0; i < one.nBodies(); ++i)
    {
        same.see(mag(one.temperature(i)/other.temperature(i) - 1));
        forAll(one.amounts(i), s)
        {
            same.see(mag(one.amounts(i)[s]/other.amounts(i)[s] - 1));
        }
    }

    same.settle();
}


TEST_CASE("Burning coke by first order", "[reaction]")
{
    claim burnt("reactingCell.firstOrder", 1e-4);

    // So much gas that it stays as it is, without CO, and one temperature
    const autoPtr<reactionScheme> made(burning(1, false));
    const reactionScheme& scheme = made();
    reactingCell cell(scheme, {1e-5, 1e-10});
    const scalar T = 912;
    scalarField air(1e6*flueGas());
    air[4] += air[2];
    air[2] = 0;
    cell.start(air, T, 1.4*bar);

    reactingCell::body b;
    b.W = 1;
    b.d = 60e-6;
    b.T = T;
    b.conductance = 0;
    b.film = 1;
    const scalarField coke(List<scalar>({1e-9, 0, 1e-7}));
    cell.add(b, coke);

    const scalar k =
        (2.78e8 + 1e8)*std::exp(-161200/(8.31446261815324*T))*0.1*1.4;
    scalar h = 1;
    for (label i = 0; i < 5; ++i)
    {
        REQUIRE(cell.react(40, h));
        burnt.see
        (
            mag(cell.amounts(0)[0]/coke[0]/std::exp(-k*40*(i + 1)) - 1)
        );
        const scalarField left(cell.amounts(0));
        const scalarField gas(cell.fluidState());
        cell.start(gas, T, 1.4*bar);
        cell.add(b, left);
    }

    burnt.settle();
}


TEST_CASE("A particle that turns at a constant rate", "[reaction]")
{
    // A + 2 B -> C + D at 3.927e-4 mol/s, A and C in the gas: MFiX's case
    claim mass("reactingCell.constantRate", 1e-3);
    claim ended("reactingCell.constantRate.end", 1e-3);

    const reactionScheme scheme
    (
        dictionaryOf
        (
            "solids"
            "{"
            "    B { specie { molWeight 15; } }"
            "    D { specie { molWeight 25; } }"
            "}"
            "reactions"
            "{"
            "    turn"
            "    {"
            "        equation \"A + 2 B = C + D\";"
            "        rate massAction; of particleVolume; A 1; Ea 0;"
            "    }"
            "}"
        ),
        dictionaryOf
        (
            "species (A C);"
            "A { specie { molWeight 25; } }"
            "C { specie { molWeight 30; } }"
        ),
        false
    );
    reactingCell cell(scheme, {1e-4, 1e-9});

    reactingCell::body b;
    b.W = 1;
    // A volume by which the rate is that of the case
    b.d = std::cbrt(6*3.927e-4/constant::mathematical::pi);
    b.T = 300;
    b.conductance = 0;
    b.film = 1;

    const scalar m = 35.343e-6;
    const scalarField start(List<scalar>({0.5*m/0.015, 0.5*m/0.025}));
    const auto massAfter = [&](const scalar t)
    {
        cell.start(scalarField(List<scalar>({1, 1})), 300, bar);
        cell.add(b, start);
        scalar h = 1e-3;
        REQUIRE(cell.react(t, h));
        return 0.015*cell.amounts(0)[0] + 0.025*cell.amounts(0)[1];
    };

    for (const scalar t : {0.3, 0.75, 1.2})
    {
        mass.see(mag(massAfter(t)/(m - 5e-3*3.927e-4*t) - 1));
    }
    ended.see(mag(massAfter(2)/32.398e-6 - 1));

    mass.settle();
    ended.settle();
}


TEST_CASE("What is used up entirely", "[reaction]")
{
    claim ends("reactingCell.usedUp", 0);
    claim left("reactingCell.usedUp.left", 1e-5);
    claim closes("reactingCell.usedUp.closes", 1e-13);

    // A gas of nothing else goes into a solid; from a liquid without solutes
    const auto solved = [&]
    (
        const char* text,
        const scalarField& fluid,
        const scalar p
    )
    {
        const reactionScheme scheme
        (
            dictionaryOf(text),
            dictionaryOf("species (A); A { specie { molWeight 32; } }"),
            false
        );
        reactingCell cell(scheme, usual);
        for (const scalar dt : {1e-3, 1.0, 1e3})
        {
            cell.start(fluid, 300, p, 1e-3);
            reactingCell::body b;
            b.W = 1e6;
            b.d = 1e-4;
            b.T = 300;
            b.conductance = 0;
            b.film = 1;
            cell.add(b, scalarField(List<scalar>({1, 0})));
            scalar h = dt;
            ends.count(cell.react(dt, h));

            const scalar gone = fluid[0] - cell.fluidState()[0];
            closes.see(mag(cell.amounts(0)[1] - gone));
            ends.count(cell.fluidState()[0] >= 0);
            if (dt > 100)
            {
                left.see(cell.fluidState()[0]);
            }
        }
    };

    const char* taken =
        "solids"
        "{"
        "    M { specie { molWeight 50; } }"
        "    MA { specie { molWeight 82; } }"
        "}"
        "reactions"
        "{"
        "    take"
        "    {"
        "        equation \"M + A = MA\"; rate massAction; of moles M;"
        "        driving bar; orders { A 1; } A 10;"
        "    }"
        "}";
    solved(taken, scalarField(1, 0.1), bar);

    const char* ofNothing =
        "solids"
        "{"
        "    M { specie { molWeight 50; } }"
        "    MA { specie { molWeight 82; } }"
        "}"
        "reactions"
        "{"
        "    take"
        "    {"
        "        equation \"M + A = MA\"; rate massAction; of moles M; A 1;"
        "    }"
        "}";
    solved(ofNothing, scalarField(1, 0), 0);
    solved(ofNothing, scalarField(1, 1e-3), 0);

    ends.settle();
    left.settle();
    closes.settle();
}


TEST_CASE("Reactions that cannot be", "[reaction]")
{
    const auto change = [](const char* name, const char* text)
    {
        return [=]
        {
            dictionary reactions(dictionaryOf(regeneratorReactions));
            reactions.subDict("reactions").subDict(name).merge
            (
                dictionaryOf(text)
            );
            reactionScheme
            (
                reactions,
                dictionaryOf(regeneratorGas),
                true
            );
        };
    };

    settleComplaint
    (
        "reactions.unbalanced",
        {"C + O2 = CO", "atoms of O", "right side", "lumped"},
        change("burnC", "equation \"C + O2 = CO\";")
    );
    settleComplaint
    (
        "reactions.unknownSpecies",
        {"SO2", "not known", "CO2", "catalyst"},
        change("burnC", "equation \"C + O2 = SO2\";")
    );
    settleComplaint
    (
        "reactions.noUnit",
        {"driving", "bar", "mol/L"},
        [=]
        {
            dictionary reactions(dictionaryOf(regeneratorReactions));
            reactions.subDict("reactions").subDict("burnC").remove("driving");
            reactionScheme(reactions, dictionaryOf(regeneratorGas), true);
        }
    );
    settleComplaint
    (
        "reactions.wrongUnit",
        {"psi", "Pa", "mol/m3"},
        change("burnC", "driving psi;")
    );
    settleComplaint
    (
        "reactions.negativeOrder",
        {"order of CO", "-1", "infinite"},
        change("burnCO", "orders { CO -1; }")
    );
    settleComplaint
    (
        "reactions.solidInFluid",
        {"happens in the fluid", "solids"},
        change("burnC", "of fluidVolume;")
    );
    settleComplaint
    (
        "reactions.particlesInFluid",
        {"burnCO happens in the fluid", "(mass solids) of particles"},
        change("burnCO", "orders { CO 1; O2 0.5; C 1; }")
    );
    settleComplaint
    (
        "reactions.basis",
        {"parcelMass", "particleMass", "fluidVolume"},
        change("burnC", "of parcelMass;")
    );
}

} // End namespace cghs
} // End namespace Foam
