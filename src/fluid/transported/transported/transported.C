/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "transported.H"
#include "selectModel.H"
#include "fluidModel.H"
#include "species.H"
#include "modelList.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(transported, 0);
    defineRunTimeSelectionTable(transported, fluid);
    describeFamily
    (
        transported,
        "what the fluid carries: transported of solution, any number"
    );
}
}


Foam::wordList Foam::cghs::transported::selected(const dictionary& solution)
{
    wordList names(solution.getOrDefault(typeName, wordList()));

    forAll(names, i)
    {
        if (names.find(names[i]) != i)
        {
            FatalIOErrorInFunction(solution)
                << "Entry " << typeName << " is " << flatOutput(names)
                << ": it names " << names[i] << " twice" << nl
                << "Name each quantity once" << nl
                << exit(FatalIOError);
        }
    }

    // The composition that a step comes to is that of its energy
    const label first = names.find(species::typeName);
    if (first > 0)
    {
        Swap(names[0], names[first]);
    }

    return names;
}


Foam::autoPtr<Foam::cghs::transported> Foam::cghs::transported::New
(
    const word& modelType,
    const dictionary& solution,
    fluidModel& fluid
)
{
    return constructorNamed<transported>
    (
        modelType,
        solution,
        *fluidConstructorTablePtr_
    )(solution.subOrEmptyDict(modelType + "Coeffs"), fluid);
}
