/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "constantDiffusivity.H"
#include "checkedEntry.H"
#include "knownEntries.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
namespace diffusivityModels
{
    defineTypeNameAndDebug(constant, 0);
    addToRunTimeSelectionTable(diffusivityModel, constant, dictionary);
    describeModel(diffusivityModel, constant, "a diffusivity for each species");
}
}
}


Foam::cghs::diffusivityModels::constant::constant
(
    const dictionary& dict,
    const wordList& species
)
:
    diffusivityModel(dict)
{
    const word ofOthers("default");
    const dictionary& D = dict.subDict("D");

    for (const word& name : species)
    {
        const word& entry = D.found(name) ? name : ofOthers;

        if (!D.found(entry))
        {
            FatalIOErrorInFunction(D)
                << "Entry " << name << " is missing: the diffusivity of that"
                << " species [m^2/s]" << nl
                << "Add it, or an entry default for all that are not named,"
                << " e.g. 2e-5 in a gas, 1e-9 in a liquid" << nl
                << exit(FatalIOError);
        }
        D_.set(name, scalarInRange(D, entry, 0, GREAT));
    }

    wordList known(species);
    known.append(ofOthers);
    warnUnknownEntries(D, known);
    warnUnknownEntries(dict, wordList({"D", "Sct"}));
}


Foam::tmp<Foam::volScalarField>
Foam::cghs::diffusivityModels::constant::diffusivity
(
    const word& species,
    const volScalarField& alpha,
    const volScalarField& rho,
    const volScalarField& mu,
    const volScalarField& mut
) const
{
    const dimensionedScalar D("D", dimViscosity, D_[species]);

    return withEddies(alpha, rho*D, mut);
}
