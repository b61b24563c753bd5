/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "massAction.H"
#include "mathematicalConstants.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(massAction, 0);
    addToRunTimeSelectionTable(kineticLaw, massAction, dictionary);
    describeModel
    (
        kineticLaw,
        massAction,
        "Arrhenius' law and powers of what reacts"
    );


//- x^n, linear where x is so small that its slope would be without bounds
template<class Number>
static Number power(const Number& x, const scalar n)
{
    using std::pow;

    static const scalar small = 1e-6;

    if (n == 1)
    {
        return x;
    }
    if (n == 2)
    {
        return x*x;
    }
    if (valueOf(x) > small)
    {
        return pow(x, n);
    }
    return n < 1 ? Number(x*std::pow(small, n - 1)) : Number(0*x);
}


//- 0 below cut, 1 from 1.01 of it on
template<class Number>
static Number above(const scalar cut, const Number& Y)
{
    const Number along((Y - cut)*(100/cut));
    const scalar at = valueOf(along);

    if (at <= 0)
    {
        return 0*Y;
    }
    if (at >= 1)
    {
        return 0*Y + 1;
    }
    return along*along*(3 - 2*along);
}

} // End namespace cghs
} // End namespace Foam


Foam::cghs::massAction::massAction
(
    const dictionary& dict,
    const reactionEquation& equation
)
:
    basisM_(0),
    basisAt_(-1),
    arrhenius_(dict),
    temperatureAt_(-1),
    fluidTemperatureAt_(-1),
    massAt_(-1)
{
    readBasis(dict, equation);
    if (arrhenius_.varies())
    {
        temperatureAt_ = need(dict, rateArgument::temperature);
    }
    readOrders(dict, equation);
    readCutOff(dict, equation);
}


void Foam::cghs::massAction::readBasis
(
    const dictionary& dict,
    const reactionEquation& equation
)
{
    ITstream& is = dict.lookup("of");
    const word what(is);

    const auto solid = [&]
    {
        const word name(is);
        const label s = solidIndex(dict, "of", name, equation);
        basisM_ = equation.solids()[s].M();
        basisAt_ = need(dict, rateArgument::solid, s);
    };

    if (what == "moles")
    {
        basis_ = basis::moles;
        solid();
    }
    else if (what == "mass")
    {
        basis_ = basis::mass;
        solid();
    }
    else if (what == "particleMass")
    {
        basis_ = basis::particleMass;
        basisAt_ = need(dict, rateArgument::mass);
    }
    else if (what == "particleSurface")
    {
        basis_ = basis::particleSurface;
        basisAt_ = need(dict, rateArgument::diameter);
    }
    else if (what == "particleVolume")
    {
        basis_ = basis::particleVolume;
        basisAt_ = need(dict, rateArgument::diameter);
    }
    else if (what == "fluidVolume")
    {
        basis_ = basis::fluidVolume;
    }
    else
    {
        FatalIOErrorInFunction(dict)
            << "Entry of is " << what << ", which no rate can be counted by"
            << nl << "Valid choices: moles <solid>, mass <solid>,"
            << " particleMass, particleSurface, particleVolume, fluidVolume"
            << nl << exit(FatalIOError);
    }
}


void Foam::cghs::massAction::readOrders
(
    const dictionary& dict,
    const reactionEquation& equation
)
{
    for (const entry& e : dict.subOrEmptyDict("orders"))
    {
        const word name(e.keyword());
        const scalar order = readScalar(e.stream());

        if (order < 0)
        {
            FatalIOErrorInFunction(dict)
                << "The order of " << name << " is " << order
                << ": the rate would be infinite where there is no " << name
                << nl << "Orders must be at least 0. Fit the rate by one that"
                << " stays finite" << nl
                << exit(FatalIOError);
        }

        const label k = equation.fluid().find(name);
        if (k >= 0)
        {
            if (!driving_.valid())
            {
                driving_.reset(new drivingUnit(dict));
                if (driving_->isPressure())
                {
                    fluidTemperatureAt_ =
                        need
                        (
                            dict,
                            inFluid()
                          ? rateArgument::temperature
                          : rateArgument::fluidTemperature
                        );
                }
            }
            fluid_.append({need(dict, rateArgument::fluid, k), order, 0, 0});
        }
        else
        {
            const label s = solidIndex(dict, "orders", name, equation);
            massAt_ = need(dict, rateArgument::mass);
            solid_.append
            ({
                need(dict, rateArgument::solid, s),
                order,
                equation.solids()[s].M(),
                0
            });
        }
    }
}


void Foam::cghs::massAction::readCutOff
(
    const dictionary& dict,
    const reactionEquation& equation
)
{
    for (const entry& e : dict.subOrEmptyDict("cutOff"))
    {
        const word name(e.keyword());
        const label s = solidIndex(dict, "cutOff", name, equation);
        massAt_ = need(dict, rateArgument::mass);
        cuts_.append
        ({
            need(dict, rateArgument::solid, s),
            0,
            equation.solids()[s].M(),
            readScalar(e.stream())
        });
        checkPositive(dict, "cutOff", cuts_.last().cutOff);
    }
}


Foam::wordList Foam::cghs::massAction::entries() const
{
    wordList names(arrhenius::entries());
    names.append(wordList({"of", "driving", "orders", "cutOff"}));
    return names;
}


bool Foam::cghs::massAction::follows(const rateArgument& reactant) const
{
    bool does =
        (basis_ == basis::moles || basis_ == basis::mass)
     && isArgument(basisAt_, reactant);

    for (const DynamicList<factor>* factors : {&fluid_, &solid_})
    {
        for (const factor& f : *factors)
        {
            // A power below 1 is linear where little is left
            does =
                does
             || (f.order > 0 && isArgument(f.argument, reactant));
        }
    }
    return does;
}


template<class Number>
Number Foam::cghs::massAction::law(const Number* x) const
{
    using constant::mathematical::pi;

    Number r(arrhenius_(argumentOr(x, temperatureAt_, 300)));

    switch (basis_)
    {
        case basis::moles:
        case basis::particleMass: r = r*x[basisAt_]; break;
        case basis::mass: r = r*x[basisAt_]*basisM_; break;
        case basis::particleSurface:
        {
            r = r*x[basisAt_]*x[basisAt_]*pi;
            break;
        }
        case basis::particleVolume:
        {
            r = r*x[basisAt_]*x[basisAt_]*x[basisAt_]*(pi/6);
            break;
        }
        case basis::fluidVolume: break;
    }

    const Number T(argumentOr(x, fluidTemperatureAt_, 1));
    for (const factor& f : fluid_)
    {
        r = r*power(driving_()(x[f.argument], T), f.order);
    }
    for (const factor& f : solid_)
    {
        r = r*power(Number(x[f.argument]*f.M/x[massAt_]), f.order);
    }
    for (const factor& f : cuts_)
    {
        r = r*above(f.cutOff, Number(x[f.argument]*f.M/x[massAt_]));
    }
    return r;
}
