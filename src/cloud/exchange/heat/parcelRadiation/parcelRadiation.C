/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "parcelRadiation.H"
#include "checkedEntry.H"
#include "knownEntries.H"
#include "physicoChemicalConstants.H"
#include "mathematicalConstants.H"
#include "zeroGradientFvPatchFields.H"
#include "profiling.H"
#include "PstreamReduceOps.H"

#include <cmath>

// * * * * * * * * * * * * * * * Construction  * * * * * * * * * * * * * * * //

Foam::cghs::parcelRadiation::parcelRadiation
(
    const dictionary& dict,
    const fvMesh& mesh
)
:
    emissivity_(scalarInRange(dict, "emissivity", 0, 1)),
    absorption_
    (
        IOobject(absorptionName(), mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimless/dimLength, Zero),
        zeroGradientFvPatchScalarField::typeName
    ),
    emission_
    (
        IOobject(emissionName(), mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimPower/dimVolume, Zero),
        zeroGradientFvPatchScalarField::typeName
    ),
    scatter_
    (
        IOobject(scatterName(), mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimless/dimLength, Zero),
        zeroGradientFvPatchScalarField::typeName
    ),
    hottest_(0)
{
    warnUnknownEntries(dict, wordList({"emissivity"}));
}


void Foam::cghs::parcelRadiation::addColumns(arena& parcels)
{
    parcels.add(areas_);
    parcels.add(emitted_);
}

// * * * * * * * * * * * * * * * * The step  * * * * * * * * * * * * * * * * //

void Foam::cghs::parcelRadiation::emit
(
    const arena& parcels,
    const UList<scalar>& T,
    const parcelCapacity& Cp,
    const scalar deltaT
)
{
    addProfiling(radiation, "cghs::radiation");

    const scalar sigma = constant::physicoChemical::sigma.value();
    const UList<label>& places = parcels.places();
    const scalarField& V = absorption_.mesh().V();
    scalarField a(V.size(), Zero);
    scalarField E(V.size(), Zero);
    scalarField again(V.size(), Zero);

    scalar Tm = hottest_;
    for (label i = 0; i < parcels.size(); ++i)
    {
        Tm = max(Tm, T[i]);
    }
    reduce(Tm, maxOp<scalar>());

    for (scalarField* sum : {&a, &E, &again})
    {
        parcels.visiting.extend(*sum);
    }

    for (label i = 0; i < parcels.size(); ++i)
    {
        const scalar area =
            emissivity_*parcels.weights[i]
           *0.25*constant::mathematical::pi*sqr(parcels.diameters[i]);
        const scalar k = area*4*sigma*(T[i] + Tm)*(sqr(T[i]) + sqr(Tm));
        const scalar x = 2*k*deltaT/(Cp(i)*parcels.motions[i].mass());

        areas_[i] = area*(x > SMALL ? -std::expm1(-x)/x : 1);
        emitted_[i] = 4*sigma*pow4(T[i]);

        a[places[i]] += areas_[i];
        again[places[i]] += area - areas_[i];
        E[places[i]] += areas_[i]*emitted_[i];
    }

    for (scalarField* sum : {&a, &E, &again})
    {
        parcels.visiting.collect(*sum);
    }

    absorption_.primitiveFieldRef() = a/V;
    emission_.primitiveFieldRef() = E/V;
    scatter_.primitiveFieldRef() = again/V;
    absorption_.correctBoundaryConditions();
    emission_.correctBoundaryConditions();
    scatter_.correctBoundaryConditions();
}


Foam::scalar Foam::cghs::parcelRadiation::absorb
(
    const arena& parcels,
    UList<scalar>& T,
    const parcelCapacity& Cp,
    const volScalarField& G,
    const scalar deltaT
)
{
    addProfiling(radiation, "cghs::radiation");

    const scalar sigma = constant::physicoChemical::sigma.value();
    scalarField byPlace(G.primitiveField());
    parcels.visiting.fetch(byPlace);
    const UList<label>& places = parcels.places();
    scalar received = 0;

    for (label i = 0; i < parcels.size(); ++i)
    {
        const scalar Q =
            areas_[i]*(byPlace[places[i]] - emitted_[i])*deltaT;

        T[i] += Q/(Cp(i)*parcels.motions[i].mass());
        received += Q;
    }

    hottest_ = std::pow(max(gMax(G.primitiveField()), 0)/(4*sigma), 0.25);

    return received;
}
