/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "SchmidtDiffusivity.H"
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
    defineTypeNameAndDebug(Schmidt, 0);
    addToRunTimeSelectionTable(diffusivityModel, Schmidt, dictionary);
    describeModel(diffusivityModel, Schmidt, "all alike, by a Schmidt number");
}
}
}


Foam::cghs::diffusivityModels::Schmidt::Schmidt
(
    const dictionary& dict,
    const wordList&
)
:
    diffusivityModel(dict),
    Sc_(positiveScalar(dict, "Sc"))
{
    warnUnknownEntries(dict, wordList({"Sc", "Sct"}));
}


Foam::tmp<Foam::volScalarField>
Foam::cghs::diffusivityModels::Schmidt::diffusivity
(
    const word&,
    const volScalarField& alpha,
    const volScalarField&,
    const volScalarField& mu,
    const volScalarField& mut
) const
{
    return withEddies(alpha, mu/Sc_, mut);
}
