/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "packedLayer.H"
#include "checkedEntry.H"
#include "knownEntries.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

#include <cmath>

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(packedLayer, 0);
    addToRunTimeSelectionTable(wallDistance, packedLayer, dictionary);
    describeModel
    (
        wallDistance,
        packedLayer,
        "nearer, as a packed bed of their particles would be"
    );
}
}


Foam::cghs::packedLayer::packedLayer(const dictionary& coeffs)
:
    layer_
    (
        coeffs.found("layer") ? scalarInRange(coeffs, "layer", 0, 0.25) : 0.16
    )
{
    warnUnknownEntries(coeffs, wordList({"layer"}));
}


Foam::scalar Foam::cghs::packedLayer::of
(
    const scalar radius,
    const scalar W
) const
{
    return radius*(1 - 2*layer_*(1 - 1/std::cbrt(W)));
}
