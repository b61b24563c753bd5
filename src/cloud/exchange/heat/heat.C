/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "heat.H"
#include "heatArrow.H"
#include "checkedEntry.H"
#include "knownEntries.H"
#include "profiling.H"
#include "Time.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(heat, 0);
    addToRunTimeSelectionTable(exchange, heat, dictionary);

} // End namespace cghs
} // End namespace Foam

// * * * * * * * * * * * * * * * Construction  * * * * * * * * * * * * * * * //

Foam::cghs::heat::heat(const dictionary& dict, const fvMesh& mesh)
:
    mesh_(mesh),
    Cp_(positiveScalar(dict, "Cp")),
    law_(heatTransferModel::New(dict)),
    T_("T"),
    response_(mesh.nCells(), Zero),
    given_(mesh.nCells(), Zero),
    deltaT_(1),
    flows_(blockSize_),
    Nu_(blockSize_),
    taken_(0),
    told_(0),
    takenInAll_(0),
    warned_(false)
{
    warnUnknownEntries(dict, wordList({"Cp", heatTransferModel::typeName}));

    T_.allow(SMALL, 1e4).readFrom("T").require();
}


void Foam::cghs::heat::addColumns(arena& parcels)
{
    parcels.add(T_);
    parcels.add(responses_);
}

// * * * * * * * * * * * * * * * * The step  * * * * * * * * * * * * * * * * //

void Foam::cghs::heat::meet(const arena&, carrierFluid& fluid)
{
    const scalarField& Cp = fluid.field("Cp").primitiveField();
    const scalarField& kappa = fluid.field("kappa").primitiveField();

    U_ = fluid.U().primitiveField();
    fluidT_ = fluid.field("T").primitiveField();
    fluid_.setSize(mesh_.nCells());

    forAll(fluid_, celli)
    {
        heatedFlow& f = fluid_[celli];

        f.e = fluid.alpha()[celli];
        f.rho = fluid.rho()[celli];
        f.mu = fluid.mu()[celli];
        f.Cp = Cp[celli];
        f.kappa = kappa[celli];
    }
}


void Foam::cghs::heat::findResponses
(
    const arena& parcels,
    const label from,
    const label n,
    const scalar deltaT
)
{
    for (label j = 0; j < n; ++j)
    {
        const label celli = parcels.cells[from + j];

        flows_[j] = fluid_[celli];
        flows_[j].u = mag(U_[celli] - parcels.motions[from + j].v);
        flows_[j].d = parcels.diameters[from + j];
    }

    SubList<scalar> Nu(Nu_, n);
    law_->nusselts(SubList<heatedFlow>(flows_, n), Nu);

    for (label j = 0; j < n; ++j)
    {
        const label i = from + j;
        const scalar C = capacity(parcels, i);
        const scalar k =
            parcels.weights[i]*convectiveConductance(flows_[j], Nu[j]);

        responses_[i] = heatArrow::response(C, k, deltaT);
    }
}


void Foam::cghs::heat::evolve(arena& parcels, const scalar deltaT)
{
    if (fluid_.empty())
    {
        return;
    }

    addProfiling(heat, "cghs::heat");

    for (label from = 0; from < parcels.size(); from += blockSize_)
    {
        findResponses
        (
            parcels,
            from,
            min(blockSize_, parcels.size() - from),
            deltaT
        );
    }
}


void Foam::cghs::heat::leave(const arena& parcels, const scalar deltaT)
{
    addProfiling(heat, "cghs::heat");

    deltaT_ = max(deltaT, VSMALL);
    response_ = Zero;
    given_ = Zero;

    for (label i = 0; i < parcels.size(); ++i)
    {
        const label celli = parcels.cells[i];

        response_[celli] += responses_[i];
        given_[celli] += responses_[i]*(T_[i] - fluidT_[celli]);
    }
}


Foam::tmp<Foam::volScalarField> Foam::cghs::heat::rate
(
    const word& name,
    const scalarField& sums,
    const dimensionSet& dimensions
) const
{
    auto result = volScalarField::New
    (
        "heat:" + name,
        mesh_,
        dimensionedScalar(dimensions, Zero)
    );

    result.ref().primitiveFieldRef() = sums/(mesh_.V()*deltaT_);

    return result;
}


Foam::cghs::exchangeTerms
Foam::cghs::heat::terms(const word& quantity) const
{
    exchangeTerms terms;

    if (quantity == "energy")
    {
        const dimensionSet powerDensity(dimPower/dimVolume);

        terms.given = rate("given", given_, powerDensity);
        terms.response =
            rate("response", response_, powerDensity/dimTemperature);
    }

    return terms;
}


void Foam::cghs::heat::complete
(
    arena& parcels,
    const carrierFluid& fluid,
    const scalar deltaT
)
{
    addProfiling(heat, "cghs::heat");

    const tmp<volScalarField> tdT(fluid.change("T"));
    const scalarField& dT = tdT().primitiveField();

    taken_ = 0;
    for (label i = 0; i < parcels.size(); ++i)
    {
        const label celli = parcels.cells[i];
        const scalar Q = responses_[i]*(fluidT_[celli] + dT[celli] - T_[i]);

        T_[i] += Q/capacity(parcels, i);
        taken_ += Q;
    }

    told_ = 0;
    forAll(given_, celli)
    {
        told_ -= given_[celli] - response_[celli]*dT[celli];
    }
    deltaT_ = deltaT;
    takenInAll_ += returnReduce(taken_, sumOp<scalar>());
}

// * * * * * * * * * * * * * * * * Reports * * * * * * * * * * * * * * * * * //

void Foam::cghs::heat::report(const arena& parcels, Ostream& os) const
{
    scalar sumCT = 0;
    scalar sumC = 0;
    scalar least = GREAT;
    scalar most = -GREAT;

    for (label i = 0; i < parcels.size(); ++i)
    {
        const scalar C = capacity(parcels, i);

        sumCT += C*T_[i];
        sumC += C;
        least = min(least, T_[i]);
        most = max(most, T_[i]);
    }
    reduce(sumCT, sumOp<scalar>());
    reduce(sumC, sumOp<scalar>());
    reduce(least, minOp<scalar>());
    reduce(most, maxOp<scalar>());

    const scalar taken = returnReduce(taken_, sumOp<scalar>());

    if (sumC > 0)
    {
        if (least < 100 && !warned_)
        {
            warned_ = true;
            WarningInFunction
                << "Parcels have a T of " << least << ", which is very cold for"
                << " an absolute temperature [K]. If degrees Celsius were meant"
                << " in constantProperties, feeding or the file of T, add 273.15"
                << nl << endl;
        }
        os  << "heat:   parcels of " << least << " to " << most << " K, mean "
            << sumCT/sumC << " K, take " << taken/deltaT_
            << " W from the fluid, " << takenInAll_ << " J so far" << nl;
    }
}


void Foam::cghs::heat::state(dictionary& state) const
{
    state.add("taken", takenInAll_);
}


void Foam::cghs::heat::setState(const dictionary& state)
{
    state.readIfPresent("taken", takenInAll_);
}
