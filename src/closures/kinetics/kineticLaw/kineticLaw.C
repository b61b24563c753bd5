/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "FlatOutput.H"
#include "kineticLaw.H"
#include "selectModel.H"
#include "modelList.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(kineticLaw, 0);
    defineRunTimeSelectionTable(kineticLaw, dictionary);
    describeFamily(kineticLaw, "how fast a reaction goes: type of a reaction");


//- The place of a name, or stop
static label indexOf
(
    const dictionary& dict,
    const word& entry,
    const word& name,
    const substances& list,
    const char* whose
)
{
    const label index = list.find(name);
    if (index < 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << entry << " has " << name << ", which is not among "
            << whose << nl
            << "Valid choices: " << flatOutput(list.names()) << nl
            << exit(FatalIOError);
    }
    return index;
}


//- Stop if it has no part on the left side of the equation
static void checkReactant
(
    const dictionary& dict,
    const word& entry,
    const scalar coefficient
)
{
    if (!(coefficient > 0))
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << entry << " is " << dict.get<word>(entry)
            << ", which is not a reactant of the equation "
            << dict.get<string>("equation") << nl
            << "Name a reactant, or add it to the left side" << nl
            << exit(FatalIOError);
    }
}

} // End namespace cghs
} // End namespace Foam


Foam::autoPtr<Foam::cghs::kineticLaw>
Foam::cghs::kineticLaw::New
(
    const dictionary& dict,
    const reactionEquation& equation
)
{
    return constructorNamed<kineticLaw>
    (
        dict.get<word>("rate"),
        dict,
        *dictionaryConstructorTablePtr_
    )(dict, equation);
}


Foam::label Foam::cghs::kineticLaw::need
(
    const dictionary& dict,
    const rateArgument::kind what,
    const label index
)
{
    forAll(arguments_, a)
    {
        if (arguments_[a].what == what && arguments_[a].index == index)
        {
            return a;
        }
    }

    if (arguments_.size() == maxArguments)
    {
        FatalIOErrorInFunction(dict)
            << "The rate depends on more than " << maxArguments
            << " temperatures, species and solids" << nl
            << "Leave some out, or raise maxArguments in kineticLaw.H" << nl
            << exit(FatalIOError);
    }
    arguments_.append({what, index});
    return arguments_.size() - 1;
}


Foam::label Foam::cghs::kineticLaw::fluidIndex
(
    const dictionary& dict,
    const word& entry,
    const word& name,
    const reactionEquation& equation
)
{
    return
        indexOf
        (
            dict, entry, name, equation.fluid(), "the species of the fluid"
        );
}


Foam::label Foam::cghs::kineticLaw::solidIndex
(
    const dictionary& dict,
    const word& entry,
    const word& name,
    const reactionEquation& equation
)
{
    return indexOf(dict, entry, name, equation.solids(), "the solids");
}


Foam::label Foam::cghs::kineticLaw::fluidReactant
(
    const dictionary& dict,
    const word& entry,
    const reactionEquation& equation
)
{
    const word name(dict.get<word>(entry));
    const label k = fluidIndex(dict, entry, name, equation);
    checkReactant(dict, entry, equation.fluidReactants()[k]);
    return k;
}


Foam::label Foam::cghs::kineticLaw::solidReactant
(
    const dictionary& dict,
    const word& entry,
    const reactionEquation& equation
)
{
    const word name(dict.get<word>(entry));
    const label s = solidIndex(dict, entry, name, equation);
    checkReactant(dict, entry, equation.solidReactants()[s]);
    return s;
}
