/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "diffusivityModel.H"
#include "selectModel.H"
#include "checkedEntry.H"
#include "modelList.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(diffusivityModel, 0);
    defineRunTimeSelectionTable(diffusivityModel, dictionary);
    describeFamily
    (
        diffusivityModel,
        "how species diffuse in the fluid: speciesCoeffs"
    );
}
}


Foam::autoPtr<Foam::cghs::diffusivityModel>
Foam::cghs::diffusivityModel::New
(
    const dictionary& dict,
    const wordList& species
)
{
    if (!dict.found(typeName))
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << typeName << " is missing: nothing says how "
            << flatOutput(species) << " diffuse" << nl
            << "Valid choices:" << nl
            << dictionaryConstructorTablePtr_->sortedToc() << nl
            << exit(FatalIOError);
    }

    return
        selectModel<diffusivityModel>
        (
            dict,
            *dictionaryConstructorTablePtr_,
            species
        );
}


Foam::cghs::diffusivityModel::diffusivityModel(const dictionary& dict)
:
    Sct_(dict.getOrDefault<scalar>("Sct", 0.7))
{
    checkPositive(dict, "Sct", Sct_);
}


Foam::tmp<Foam::volScalarField> Foam::cghs::diffusivityModel::withEddies
(
    const volScalarField& alpha,
    const tmp<volScalarField>& molecular,
    const volScalarField& mut
) const
{
    return alpha*(molecular + mut/Sct_);
}
