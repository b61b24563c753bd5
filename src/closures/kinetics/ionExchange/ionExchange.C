/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "ionExchange.H"
#include "unreactedCore.H"
#include "mathematicalConstants.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(ionExchange, 0);
    addToRunTimeSelectionTable(kineticLaw, ionExchange, dictionary);
    describeModel
    (
        kineticLaw,
        ionExchange,
        "rare earths leached from ore by ammonium"
    );


// Thickness of the leached layer at the start, over the radius
static const scalar leastLayer = 1e-5;


//- As published, where the user does not say otherwise
static dictionary published(const dictionary& dict)
{
    dictionary k;
    k.add("A", dict.getOrDefault<scalar>("A", 0.011));
    k.add("Ea", dict.getOrDefault<scalar>("Ea", 9480));
    return k;
}

} // End namespace cghs
} // End namespace Foam


Foam::cghs::ionExchange::ionExchange
(
    const dictionary& dict,
    const reactionEquation& equation
)
:
    arrhenius_(published(dict)),
    power_(dict.getOrDefault<scalar>("power", 1.217)),
    coefficient_(0),
    fresh_(0),
    experiment_(0),
    diameterAt_(need(dict, rateArgument::diameter)),
    temperatureAt_(need(dict, rateArgument::temperature)),
    solidAt_(-1),
    cationAt_(-1)
{
    const label s = solidReactant(dict, "solid", equation);
    coefficient_ = equation.solidReactants()[s];
    fresh_ = positiveScalar(dict, "fresh")/equation.solids()[s].M();
    solidAt_ = need(dict, rateArgument::solid, s);

    readCation(dict, equation);
}


void Foam::cghs::ionExchange::readCation
(
    const dictionary& dict,
    const reactionEquation& equation
)
{
    if (dict.found("cation") != dict.found("experiment"))
    {
        FatalIOErrorInFunction(dict)
            << "Of the entries cation and experiment there is only one" << nl
            << "Give both, the cation and its concentration in the experiment"
            << " [mol/m^3]; or neither, if they are the same" << nl
            << exit(FatalIOError);
    }

    if (dict.found("cation"))
    {
        const word name(dict.get<word>("cation"));
        const label k = fluidIndex(dict, "cation", name, equation);
        cationAt_ = need(dict, rateArgument::fluid, k);
        experiment_ = positiveScalar(dict, "experiment");
    }
}


Foam::wordList Foam::cghs::ionExchange::entries() const
{
    return
        wordList
        ({
            "solid", "fresh", "cation", "experiment", "A", "Ea", "power"
        });
}


bool Foam::cghs::ionExchange::follows(const rateArgument& reactant) const
{
    return
        isArgument(solidAt_, reactant) || isArgument(cationAt_, reactant);
}


template<class Number>
Number Foam::cghs::ionExchange::law(const Number* x) const
{
    using std::pow;
    using constant::mathematical::pi;

    const Number& d = x[diameterAt_];
    const unreactedCore<Number> core(x[solidAt_], d, fresh_);

    // Of the radius in mm
    Number k
    (
        arrhenius_(x[temperatureAt_])*pow(Number(500*d), -power_)
    );
    if (cationAt_ >= 0)
    {
        k = k*x[cationAt_]/experiment_;
    }

    return
        (1.5*fresh_*pi/6/coefficient_)*d*d*d
       *k*core.radius/(core.layer() + leastLayer);
}
