/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "dragModel.H"
#include "knownEntries.H"
#include "selectModel.H"
#include "modelList.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(dragModel, 0);
    defineRunTimeSelectionTable(dragModel, dictionary);
    defineRunTimeSelectionTable(dragModel, published);
    describeFamily(dragModel, "how the fluid drags particles: subModels");
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
        asked_.note(f.e, superficialRe(f));
    }
}


bool Foam::cghs::dragModel::warnOutsideRange() const
{
    return asked_.warn("Drag law " + type(), range());
}
