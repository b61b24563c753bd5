/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "gasAtWalls.H"
#include "conductionScaling.H"
#include "gasLens.H"
#include "checkedEntry.H"
#include "knownEntries.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

#include <cmath>

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(gasAtWalls, 0);
    addToRunTimeSelectionTable(conductionModel, gasAtWalls, dictionary);
    describeModel
    (
        conductionModel,
        gasAtWalls,
        "through the gas between parcels and walls (Rong and Horio)"
    );
}
}


Foam::cghs::gasAtWalls::gasAtWalls(const dictionary& dict)
:
    layer_(scalarInRange(dict, "layer", SMALL, 1)),
    leastGap_(positiveScalar(dict, "leastGap"))
{
    warnUnknownEntries(dict, wordList({"layer", "leastGap"}));
}


Foam::cghs::contactNeeds Foam::cghs::gasAtWalls::needs() const
{
    contactNeeds needs;
    needs.layer = layer_;
    return needs;
}


void Foam::cghs::gasAtWalls::meet(const arena&, const carrierFluid& fluid)
{
    kappa_ = fluid.field("kappa").primitiveField();
}


Foam::scalar Foam::cghs::gasAtWalls::passes
(
    const conductingPair& pair,
    const arena& parcels
) const
{
    const contact& c = pair.c;

    if (!c.atWall() || kappa_.empty())
    {
        return 0;
    }

    const scalar W = parcels.weights[c.a];
    const scalar k = std::cbrt(W);
    const scalar gap = -c.overlap;

    return
        pair.deltaT*wallFactor(W)
       *particleFluidWall
        (
            gap > 0 ? k*gap : gap,
            parcels.spheres[c.a].r,
            layer_,
            k*leastGap_,
            kappa_[parcels.places()[c.a]]
        );
}
