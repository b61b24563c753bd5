/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "heatTransferModel.H"
#include "knownEntries.H"
#include "selectModel.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(heatTransferModel, 0);
    defineRunTimeSelectionTable(heatTransferModel, dictionary);
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


Foam::wordList Foam::cghs::heatTransferModel::names()
{
    return dictionaryConstructorTablePtr_->sortedToc();
}


bool Foam::cghs::heatTransferModel::warn
(
    const char* quantity,
    const scalarMinMax& asked,
    const scalarMinMax& limits,
    bool& warned
) const
{
    const bool below = asked.min() < limits.min();
    const bool tell = !warned && (below || asked.max() > limits.max());

    if (tell)
    {
        WarningInFunction
            << "Law of convection " << type() << " was asked at " << quantity
            << ' ' << (below ? asked.min() : asked.max())
            << " but is made for " << limits.min() << " to " << limits.max()
            << '.' << nl
            << "    It is extrapolated; this is said once" << nl << endl;
    }
    warned = warned || tell;

    return tell;
}


bool Foam::cghs::heatTransferModel::warnOutsideRange() const
{
    const heatTransferRange limits(range());
    heatTransferRange all(asked_);

    reduce(all.voidage, minMaxOp<scalar>());
    reduce(all.Re, minMaxOp<scalar>());

    if (!all.Re.valid())
    {
        return false;
    }

    const bool ofVoidage =
        warn("voidage", all.voidage, limits.voidage, warnedOfVoidage_);

    return warn("Re", all.Re, limits.Re, warnedOfRe_) || ofVoidage;
}
