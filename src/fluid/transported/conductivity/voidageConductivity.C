/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "voidageConductivity.H"
#include "checkedEntry.H"
#include "knownEntries.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
namespace conductivityModels
{
    defineTypeNameAndDebug(voidage, 0);
    addToRunTimeSelectionTable(conductivityModel, voidage, dictionary);
    describeModel
    (
        conductivityModel,
        voidage,
        "in proportion to the voidage, and by eddies"
    );
}
}
}


Foam::cghs::conductivityModels::voidage::voidage(const dictionary& dict)
:
    Prt_(dict.getOrDefault<scalar>("Prt", 0.85))
{
    checkPositive(dict, "Prt", Prt_);
    warnUnknownEntries(dict, wordList({"Prt"}));
}


Foam::tmp<Foam::volScalarField>
Foam::cghs::conductivityModels::voidage::conductivity
(
    const volScalarField& alpha,
    const volScalarField& kappa,
    const volScalarField& Cp,
    const volScalarField& mut
) const
{
    return alpha*(kappa + mut*Cp/Prt_);
}
