/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "deactivating.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(deactivating, 0);
    addToRunTimeSelectionTable(kineticLaw, deactivating, dictionary);
    describeModel
    (
        kineticLaw,
        deactivating,
        "lumped, over a catalyst that cokes: methanol to olefins"
    );


// 1/(1 + steep exp(rise (w - middle))), w in g/100 g
class lateLoss
{
    static constexpr scalar steep = 9;
    static constexpr scalar rise = 2;
    static constexpr scalar middle = 7.8;

    scalar w_ = -1;

public:

    scalar value = 1;

    //- Of its logarithm
    scalar logSlope = 0;

    //- All reactions of a particle ask for the same w, one after the other
    void move(const scalar w)
    {
        if (w != w_)
        {
            const scalar lost = steep*std::exp(rise*(w - middle));
            w_ = w;
            value = 1/(1 + lost);
            logSlope = -rise*lost*value;
        }
    }
};

static lateLoss& lateLossAt(const scalar w)
{
    static thread_local lateLoss last;

    last.move(w);
    return last;
}


// There is nothing left of it [g/100 g]
static const scalar most = 100;

// A catalyst has some mass [kg]
static const scalar least = 1e-100;

} // End namespace cghs
} // End namespace Foam


Foam::cghs::deactivating::deactivating
(
    const dictionary& dict,
    const reactionEquation& equation
)
:
    arrhenius_(dict),
    driving_(dict),
    alpha_(scalarInRange(dict, "alpha", 0, 1e3)),
    upTo_(dict.getOrDefault<scalar>("upTo", 9)),
    catalystM_(0),
    cokeM_(0),
    solids_(equation.solids()),
    catalyst_(-1),
    coke_(-1),
    reactantAt_(-1),
    catalystAt_(-1),
    cokeAt_(-1),
    massAt_(-1),
    temperatureAt_(-1),
    fluidTemperatureAt_(-1)
{
    checkPositive(dict, "upTo", upTo_);

    const label k = fluidReactant(dict, "reactant", equation);
    reactantAt_ = need(dict, rateArgument::fluid, k);

    const auto solid = [&](const char* entry, label& s, scalar& M)
    {
        s = solidIndex(dict, entry, dict.get<word>(entry), equation);
        M = equation.solids()[s].M();
        return need(dict, rateArgument::solid, s);
    };
    catalystAt_ = solid("catalyst", catalyst_, catalystM_);
    cokeAt_ = solid("coke", coke_, cokeM_);

    const word whole(dict.getOrDefault<word>("cokeOf", "catalyst"));
    if (whole == "particle")
    {
        massAt_ = need(dict, rateArgument::mass);
    }
    else if (whole != "catalyst")
    {
        FatalIOErrorInFunction(dict)
            << "Entry cokeOf is " << whole << nl
            << "Valid choices: catalyst (without its coke), particle" << nl
            << exit(FatalIOError);
    }

    if (arrhenius_.varies())
    {
        temperatureAt_ = need(dict, rateArgument::temperature);
    }
    if (driving_.isPressure())
    {
        fluidTemperatureAt_ = need(dict, rateArgument::fluidTemperature);
    }
}


Foam::wordList Foam::cghs::deactivating::entries() const
{
    wordList names(arrhenius::entries());
    names.append
    (
        wordList
        ({
            "reactant", "catalyst", "coke", "cokeOf", "alpha", "driving", "upTo"
        })
    );
    return names;
}


bool Foam::cghs::deactivating::follows(const rateArgument& reactant) const
{
    return
        isArgument(reactantAt_, reactant) || isArgument(catalystAt_, reactant);
}


Foam::scalar Foam::cghs::deactivating::asked(const UList<scalar>& solids) const
{
    // A particle without catalyst makes nothing
    const scalar m = solids[catalyst_]*catalystM_;
    const scalar whole = massAt_ < 0 ? m : solids_.massOf(solids);

    return m > 0 ? 100*cokeM_*solids[coke_]/whole : 0;
}


template<class Number>
Number Foam::cghs::deactivating::activity(const Number& w) const
{
    const scalar at = valueOf(w);
    const lateLoss& late = lateLossAt(at);
    const scalar phi = std::exp(-alpha_*at)*late.value;
    return withSlope(phi, phi*(late.logSlope - alpha_), w);
}


template<class Number>
Number Foam::cghs::deactivating::law(const Number* x) const
{
    const Number m(x[catalystAt_]*catalystM_);
    const Number whole(massAt_ < 0 ? m : x[massAt_]);
    const Number w
    (
        100*cokeM_*atLeastZero(x[cokeAt_])/(atLeastZero(whole) + least)
    );

    const Number T(argumentOr(x, temperatureAt_, 300));
    const Number fluidT(argumentOr(x, fluidTemperatureAt_, 1));

    return
        m*arrhenius_(T)
       *activity(valueOf(w) < most ? w : Number(most))
       *driving_(x[reactantAt_], fluidT);
}
