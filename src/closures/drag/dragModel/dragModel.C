/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "dragModel.H"
#include "knownEntries.H"
#include "selectModel.H"
#include "vector2D.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(dragModel, 0);
    defineRunTimeSelectionTable(dragModel, dictionary);
    defineRunTimeSelectionTable(dragModel, published);
}
}


Foam::cghs::dragModel::dragModel(const dictionary& dict)
{
    warnUnknownEntries(dict, wordList());
}


Foam::autoPtr<Foam::cghs::dragModel> Foam::cghs::dragModel::New
(
    const dictionary& subModels
)
{
    return selectModel<dragModel>(subModels, *dictionaryConstructorTablePtr_);
}


Foam::autoPtr<Foam::cghs::dragModel> Foam::cghs::dragModel::NewOrPublished
(
    const word& law,
    const dictionary& subModels
)
{
    const auto published = publishedConstructorTablePtr_->cfind(law);

    if (subModels.found(law + "Coeffs"))
    {
        dictionary choice(subModels);
        choice.set(typeName, law);
        return New(choice);
    }

    return published.found() ? published()() : nullptr;
}


Foam::wordList Foam::cghs::dragModel::names()
{
    return dictionaryConstructorTablePtr_->sortedToc();
}


void Foam::cghs::dragModel::note(const UList<slipFlow>& flows) const
{
    for (const slipFlow& f : flows)
    {
        lowestVoidage_ = min(lowestVoidage_, f.e);
        highestRe_ = max(highestRe_, superficialRe(f));
    }
}


bool Foam::cghs::dragModel::warnOutsideRange() const
{
    const dragRange limits = range();
    const vector2D extremes
    (
        returnReduce
        (
            vector2D(-lowestVoidage_, highestRe_),
            maxOp<vector2D>()
        )
    );
    const scalar e = -extremes.x();
    const scalar Re = extremes.y();

    const bool tellVoidage = !warnedOfVoidage_ && e < limits.minVoidage;
    const bool tellRe = !warnedOfRe_ && Re > limits.maxRe;

    if (tellVoidage)
    {
        WarningInFunction
            << "Drag law " << type() << " was asked at voidage " << e
            << " but is made for " << limits.minVoidage << " to 1." << nl
            << "    It is extrapolated; this is said once" << nl << endl;
    }
    if (tellRe)
    {
        WarningInFunction
            << "Drag law " << type() << " was asked at Re " << Re
            << " but is made for Re up to " << limits.maxRe << '.' << nl
            << "    It is extrapolated; this is said once" << nl << endl;
    }

    warnedOfVoidage_ = warnedOfVoidage_ || tellVoidage;
    warnedOfRe_ = warnedOfRe_ || tellRe;

    return tellVoidage || tellRe;
}
