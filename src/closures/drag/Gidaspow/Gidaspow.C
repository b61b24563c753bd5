/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "Gidaspow.H"
#include "sphereDrag.H"
#include "checkedEntry.H"
#include "knownEntries.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(Gidaspow, 0);
    addToRunTimeSelectionTable(dragModel, Gidaspow, dictionary);
    addToRunTimeSelectionTable(dragModel, Gidaspow, published);
    describeModel
    (
        dragModel,
        Gidaspow,
        "Ergun for a voidage up to 0.8, Wen and Yu above"
    );
}
}


Foam::cghs::Gidaspow::Gidaspow()
:
    blendWidth_(0)
{}


Foam::cghs::Gidaspow::Gidaspow(const dictionary& dict)
:
    blendWidth_(scalarInRange(dict, "blendWidth", 0, 0.4))
{
    warnUnknownEntries(dict, wordList({"blendWidth"}));
}


Foam::scalar Foam::cghs::Gidaspow::D(const slipFlow& f) const
{
    return blended
    (
        f.e,
        0.8,
        blendWidth_,
        [&]{ return ergunD(f); },
        [&]{ return wenYuD(f); }
    );
}
