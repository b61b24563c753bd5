/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "gasBetween.H"
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
    defineTypeNameAndDebug(gasBetween, 0);
    addToRunTimeSelectionTable(conductionModel, gasBetween, dictionary);
    describeModel
    (
        conductionModel,
        gasBetween,
        "through the gas between two parcels (Rong and Horio)"
    );
}
}


Foam::cghs::gasBetween::gasBetween(const dictionary& dict)
:
    layer_(scalarInRange(dict, "layer", SMALL, 1)),
    leastGap_(positiveScalar(dict, "leastGap")),
    kappa_("gasBetweenKappa"),
    k_("gasBetweenK")
{
    warnUnknownEntries(dict, wordList({"layer", "leastGap"}));

    kappa_.lend().hide();
    k_.lend().hide();
}


Foam::cghs::contactNeeds Foam::cghs::gasBetween::needs() const
{
    contactNeeds needs;
    needs.layer = layer_;
    return needs;
}


void Foam::cghs::gasBetween::addColumns(arena& parcels)
{
    parcels.add(kappa_);
    parcels.add(k_);
}


void Foam::cghs::gasBetween::meet
(
    const arena& parcels,
    const carrierFluid& fluid
)
{
    scalarField kappa(fluid.field("kappa").primitiveField());
    parcels.visiting.fetch(kappa);
    const UList<label>& places = parcels.places();

    for (label i = 0; i < parcels.size(); ++i)
    {
        kappa_[i] = kappa[places[i]];
        k_[i] = std::cbrt(parcels.weights[i]);
    }
}


Foam::scalar Foam::cghs::gasBetween::passes
(
    const conductingPair& pair,
    const arena& parcels
) const
{
    const contact& c = pair.c;

    if (c.atWall())
    {
        return 0;
    }

    return
        pair.deltaT
       *particleFluidParticle
        (
            -c.overlap,
            parcels.spheres[c.a].r,
            parcels.spheres[c.b].r,
            layer_,
            0.5*(k_[c.a] + k_[c.b])*leastGap_,
            0.5*(kappa_[c.a] + kappa_[c.b])
        );
}
