/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "cokeCombustion.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(cokeCombustion, 0);
    addToRunTimeSelectionTable(kineticLaw, cokeCombustion, dictionary);
    describeModel(kineticLaw, cokeCombustion, "carbon to CO and CO2");


// r = intrinsic exp(intrinsicT/T)
static const scalar intrinsic = 5.28e-3;
static const scalar intrinsicT = 34860/molarR;

} // End namespace cghs
} // End namespace Foam


Foam::cghs::cokeCombustion::cokeCombustion
(
    const dictionary& dict,
    const reactionEquation& equation
)
:
    massAction(dict, equation),
    toCO2_(false),
    ratio_(0),
    temperatureAt_(-1)
{
    readProduct(dict, equation);
    readRatio(dict);
}


void Foam::cghs::cokeCombustion::readProduct
(
    const dictionary& dict,
    const reactionEquation& equation
)
{
    const word product(dict.get<word>("product"));

    if (product != "CO" && product != "CO2")
    {
        FatalIOErrorInFunction(dict)
            << "Entry product is " << product << nl
            << "Valid choices: CO CO2" << nl
            << exit(FatalIOError);
    }
    toCO2_ = product == "CO2";

    const label k = fluidIndex(dict, "product", product, equation);
    if (mag(equation.fluidGain()[k] - 1) > SMALL)
    {
        FatalIOErrorInFunction(dict)
            << "The equation " << dict.get<string>("equation") << " makes "
            << equation.fluidGain()[k] << ' ' << product
            << ", but cokeCombustion counts by one mol of its product" << nl
            << "Write it as "
            << (toCO2_ ? "\"C + O2 = CO2\"" : "\"C + 0.5 O2 = CO\"") << nl
            << exit(FatalIOError);
    }
}


void Foam::cghs::cokeCombustion::readRatio(const dictionary& dict)
{
    const token t(dict.lookup("ratio"));

    if (t.isNumber())
    {
        ratio_ = t.number();
        checkPositive(dict, "ratio", ratio_);
    }
    else if (t.isWord() && t.wordToken() == "intrinsic")
    {
        temperatureAt_ = need(dict, rateArgument::temperature);
    }
    else
    {
        FatalIOErrorInFunction(dict)
            << "Entry ratio is " << t << nl
            << "Valid choices: intrinsic, or the moles of CO2 to one of CO"
            << nl << exit(FatalIOError);
    }
}


Foam::wordList Foam::cghs::cokeCombustion::entries() const
{
    wordList names(massAction::entries());
    names.append(wordList({"product", "ratio"}));
    return names;
}


Foam::scalar Foam::cghs::cokeCombustion::share
(
    const scalar* x,
    scalar& slope
) const
{
    // u = 1/r: it goes to zero with T
    scalar u = 1/ratio_;
    slope = 0;
    if (temperatureAt_ >= 0)
    {
        const scalar T = x[temperatureAt_];
        u = std::exp(-intrinsicT/T)/intrinsic;
        slope = u*intrinsicT/sqr(T)/sqr(1 + u)*(toCO2_ ? -1 : 1);
    }
    return (toCO2_ ? 1 : u)/(1 + u);
}


Foam::scalar Foam::cghs::cokeCombustion::rate(const scalar* x) const
{
    scalar ignored;
    return massAction::rate(x)*share(x, ignored);
}


Foam::scalar Foam::cghs::cokeCombustion::rate
(
    const scalar* x,
    scalar* derivatives
) const
{
    scalar slope;
    const scalar part = share(x, slope);
    const scalar all = massAction::rate(x, derivatives);

    forAll(arguments(), a)
    {
        derivatives[a] *= part;
    }
    if (temperatureAt_ >= 0)
    {
        derivatives[temperatureAt_] += all*slope;
    }
    return all*part;
}
