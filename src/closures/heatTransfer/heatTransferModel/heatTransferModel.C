/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "heatTransferModel.H"
#include "knownEntries.H"
#include "selectModel.H"
#include "modelList.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(heatTransferModel, 0);
    defineRunTimeSelectionTable(heatTransferModel, dictionary);
    describeFamily
    (
        heatTransferModel,
        "convection between fluid and particles: heatCoeffs"
    );
}
}


Foam::cghs::heatTransferModel::heatTransferModel(const dictionary& dict)
{
    warnUnknownEntries(dict, wordList());
}


Foam::autoPtr<Foam::cghs::heatTransferModel>
Foam::cghs::heatTransferModel::New(const dictionary& subModels)
{
    return selectModel<heatTransferModel>
    (
        subModels,
        *dictionaryConstructorTablePtr_
    );
}


Foam::autoPtr<Foam::cghs::heatTransferModel>
Foam::cghs::heatTransferModel::New
(
    const word& name,
    const dictionary& subModels
)
{
    return selectNamed<heatTransferModel>
    (
        name,
        subModels,
        *dictionaryConstructorTablePtr_
    );
}


Foam::wordList Foam::cghs::heatTransferModel::names()
{
    return dictionaryConstructorTablePtr_->sortedToc();
}


bool Foam::cghs::heatTransferModel::warnOutsideRange
(
    const string& what
) const
{
    return asked_.warn("Law of " + what + ' ' + type(), range());
}
