/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "massFractions.H"
#include "FlatOutput.H"


Foam::scalarField Foam::cghs::amountsPerMass
(
    const dictionary& dict,
    const substances& list
)
{
    const dictionary& Y = dict.subDict("Y");
    scalarField amounts(list.size(), 0);
    scalar sum = 0;

    for (const entry& e : Y)
    {
        const word name(e.keyword());
        const scalar y = readScalar(e.stream());
        const label k = list.find(name);

        if (k < 0)
        {
            FatalIOErrorInFunction(Y)
                << "There is a mass fraction of " << name
                << ", which is not known here" << nl
                << "Valid choices: " << flatOutput(list.names()) << nl
                << exit(FatalIOError);
        }
        if (!(y >= 0))
        {
            FatalIOErrorInFunction(Y)
                << "The mass fraction of " << name << " is " << y
                << " but must not be below zero" << nl
                << exit(FatalIOError);
        }
        amounts[k] = y/list[k].M();
        sum += y;
    }

    if (!(mag(sum - 1) < 1e-6))
    {
        FatalIOErrorInFunction(Y)
            << "Mass fractions sum to " << sum << " but must sum to 1" << nl
            << "Correct them, e.g. that of the most abundant one" << nl
            << exit(FatalIOError);
    }
    return amounts/sum;
}
