/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "wallHeat.H"
#include "mixedFvPatchFields.H"
#include "wallPolyPatch.H"
#include "volFields.H"
#include "PstreamReduceOps.H"

Foam::cghs::wallHeat::wallHeat(const fvMesh& mesh)
:
    mesh_(mesh),
    patches_(mesh.boundaryMesh().findPatchIDs<wallPolyPatch>().sortedToc()),
    now_(patches_.size(), Zero),
    power_(patches_.size(), Zero),
    total_(patches_.size(), Zero),
    fluxes_(),
    any_(false),
    met_(false),
    toFluid_()
{}


Foam::scalarField Foam::cghs::wallHeat::givenTemperatures
(
    const fvPatchScalarField& T,
    const label n
)
{
    scalarField given(n, Zero);

    if (!isA<wallPolyPatch>(T.patch().patch()))
    {
        return given;
    }

    const auto* mixed = isA<mixedFvPatchScalarField>(T);

    forAll(T, facei)
    {
        if (mixed ? mixed->valueFraction()[facei] > 0 : T.fixesValue())
        {
            given[facei] = T[facei];
        }
    }
    return given;
}

// * * * * * * * * * * * * * * * * The step  * * * * * * * * * * * * * * * * //

void Foam::cghs::wallHeat::meet(const carrierFluid& fluid)
{
    const volScalarField& T = fluid.field("T");
    const volScalarField& kappa = fluid.field("kappa");
    const volScalarField& alpha = fluid.alpha();

    fluxes_.clear();

    for (const label patchi : patches_)
    {
        const fvPatchScalarField& Tw = T.boundaryField()[patchi];

        if (!met_ && isA<mixedFvPatchScalarField>(Tw))
        {
            // At the start of a run it does not know yet what it is: the
            // fluid has not been solved for
            const_cast<fvPatchScalarField&>(Tw).evaluate();
        }

        const scalarField given(givenTemperatures(Tw, Tw.size()));
        const scalarField rest
        (
            (1 - alpha.boundaryField()[patchi])
           *kappa.boundaryField()[patchi]*Tw.snGrad()*Tw.patch().magSf()
        );

        forAll(rest, facei)
        {
            if (given[facei] == 0 && mag(rest[facei]) > VSMALL)
            {
                fluxes_.append
                (
                    flux{patchi, Tw.patch().faceCells()[facei], rest[facei]}
                );
            }
        }
    }

    met_ = true;
    any_ = returnReduce(fluxes_.size() > 0, orOp<bool>());
}


Foam::scalar Foam::cghs::wallHeat::give
(
    const arena& parcels,
    UList<scalar>& T,
    const parcelCapacity& Cp,
    const scalar deltaT
)
{
    toFluid_.clear();

    if (!any_)
    {
        return 0;
    }

    const UList<label>& places = parcels.places();
    scalarField volumes(mesh_.nCells(), Zero);
    parcels.visiting.extend(volumes);

    for (label i = 0; i < parcels.size(); ++i)
    {
        volumes[places[i]] += parcels.volume(i);
    }
    parcels.visiting.collect(volumes);

    scalarField density(mesh_.nCells(), Zero);
    toFluid_.resize(mesh_.nCells(), Zero);
    scalar received = 0;

    for (const flux& f : fluxes_)
    {
        const scalar Q = f.power*deltaT;

        if (volumes[f.cell] > 0)
        {
            density[f.cell] += Q/volumes[f.cell];
            received += Q;
            add(f.patch, Q);
        }
        else
        {
            toFluid_[f.cell] += Q;
        }
    }
    parcels.visiting.fetch(density);

    for (label i = 0; i < parcels.size(); ++i)
    {
        T[i] +=
            density[places[i]]*parcels.volume(i)
           *parcels.motions[i].invMass/Cp(i);
    }

    return received;
}


void Foam::cghs::wallHeat::add(const label patchi, const scalar heat)
{
    const label k = patches_.find(patchi);

    if (k != -1)
    {
        now_[k] += heat;
    }
}


void Foam::cghs::wallHeat::close(const scalar deltaT)
{
    reduce(now_, sumOp<scalarField>());
    power_ = now_/deltaT;
    total_ += now_;
    now_ = Zero;
}

// * * * * * * * * * * * * * * * * Reports * * * * * * * * * * * * * * * * * //

Foam::word Foam::cghs::wallHeat::name(const label k) const
{
    return "wall:" + mesh_.boundaryMesh()[patches_[k]].name();
}


void Foam::cghs::wallHeat::report(Ostream& os) const
{
    os  << "        walls give parcels";
    forAll(patches_, k)
    {
        os  << (k ? ", " : " ") << mesh_.boundaryMesh()[patches_[k]].name()
            << ' ' << power_[k] << " W (" << total_[k] << " J so far)";
    }
    os  << nl;
}


void Foam::cghs::wallHeat::state(dictionary& state) const
{
    forAll(patches_, k)
    {
        state.add(name(k), total_[k]);
    }
}


void Foam::cghs::wallHeat::setState(const dictionary& state)
{
    forAll(patches_, k)
    {
        state.readIfPresent(name(k), total_[k]);
    }
}
