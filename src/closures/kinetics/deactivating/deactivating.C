/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "deactivating.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(deactivating, 0);
    addToRunTimeSelectionTable(kineticLaw, deactivating, dictionary);


// Of the deactivation: 1 + steep exp(slope (w - middle)) [g/100 g]
static const scalar steep = 9;
static const scalar slope = 2;
static const scalar middle = 7.8;

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
    catalystM_(0),
    cokeM_(0),
    reactantAt_(-1),
    catalystAt_(-1),
    cokeAt_(-1),
    temperatureAt_(-1),
    fluidTemperatureAt_(-1)
{
    const label k = fluidReactant(dict, "reactant", equation);
    reactantAt_ = need(dict, rateArgument::fluid, k);

    const auto solid = [&](const char* entry, scalar& M)
    {
        const word name(dict.get<word>(entry));
        const label s = solidIndex(dict, entry, name, equation);
        M = equation.solids()[s].M();
        return need(dict, rateArgument::solid, s);
    };
    catalystAt_ = solid("catalyst", catalystM_);
    cokeAt_ = solid("coke", cokeM_);

    if (arrhenius_.varies())
    {
        temperatureAt_ = need(dict, rateArgument::temperature);
    }
    if (driving_.isPressure())
    {
        fluidTemperatureAt_ = need(dict, rateArgument::fluidTemperature);
    }
}


bool Foam::cghs::deactivating::follows(const rateArgument& reactant) const
{
    return
        isArgument(reactantAt_, reactant) || isArgument(catalystAt_, reactant);
}


template<class Number>
Number Foam::cghs::deactivating::activity(const Number& w) const
{
    using std::exp;

    return
        exp(Number(-alpha_*w))
       /(1 + steep*exp(Number(slope*(w - middle))));
}


template<class Number>
Number Foam::cghs::deactivating::law(const Number* x) const
{
    const Number m(x[catalystAt_]*catalystM_);
    const Number w
    (
        100*cokeM_*atLeastZero(x[cokeAt_])/(atLeastZero(m) + least)
    );

    const Number T(argumentOr(x, temperatureAt_, 300));
    const Number fluidT(argumentOr(x, fluidTemperatureAt_, 1));

    return
        m*arrhenius_(T)
       *activity(valueOf(w) < most ? w : Number(most))
       *driving_(x[reactantAt_], fluidT);
}
