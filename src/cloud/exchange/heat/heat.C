/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "heat.H"
#include "heatArrow.H"
#include "checkedEntry.H"
#include "cloudProperties.H"
#include "knownEntries.H"
#include "profiling.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(heat, 0);
    addToRunTimeSelectionTable(exchange, heat, dictionary);
    describeModel
    (
        exchange,
        heat,
        "temperature, convection, conduction, radiation"
    );

} // End namespace cghs
} // End namespace Foam

// * * * * * * * * * * * * * * * Construction  * * * * * * * * * * * * * * * //

Foam::cghs::heat::heat(const dictionary& dict, const fvMesh& mesh)
:
    mesh_(mesh),
    coeffs_(dict),
    Cp_(dict.found("Cp") ? positiveScalar(dict, "Cp") : 0),
    law_(heatTransferModel::New(dict)),
    T_("T"),
    conduction_(dict, Cp_, T_),
    wallHeat_(mesh),
    radiation_
    (
        dict.found("radiation")
      ? new parcelRadiation(dict.subDict("radiation"), mesh)
      : nullptr
    ),
    response_(mesh.nCells(), Zero),
    given_(mesh.nCells(), Zero),
    deltaT_(1),
    meets_(false),
    twoWay_(false),
    Nu_(parcelFlows::blockSize),
    balance_(),
    fromFluid_(balance_.open("fluid")),
    fed_(balance_.open("fed")),
    left_(balance_.open("left")),
    fromFlux_(balance_.open("wallFlux")),
    walls_(),
    radiated_(radiation_.valid() ? balance_.open("radiation") : -1),
    reacted_(-1),
    mismatch_(0),
    exchanged_(0),
    range_{GREAT, -GREAT, 0},
    warned_(false)
{
    warnUnknownEntries
    (
        dict,
        wordList
        ({
            "Cp", heatTransferModel::typeName, "conduction", "radiation"
        })
    );

    T_.allow(SMALL, 1e4).readFrom("T").require();

    for (label m = 0; m < conduction_.nModels(); ++m)
    {
        walls_.append(balance_.open(conduction_.name(m)));
    }

    needOfContacts(conduction_.needs());
}


void Foam::cghs::heat::join(PtrList<exchange>& all)
{
    for (exchange& e : all)
    {
        e.compose(Cp_);
    }
    if (!Cp_.known())
    {
        // Which stops: there is none
        positiveScalar(coeffs_, "Cp");
    }
    if (Cp_.composed() && coeffs_.found("Cp"))
    {
        WarningInFunction
            << "Entry Cp of heatCoeffs is " << coeffs_.get<scalar>("Cp")
            << " but is not used: the solids of constant/reactions have their"
            << " own" << nl << "    Remove it" << nl << endl;
    }

    conduction_.join();
    conduction_.forRounds
    (
        [&]
        (
            const bool layered,
            const UList<property*>& shown,
            const UList<property*>& collected
        )
        {
            layered
          ? lookAtNeighbours(shown, collected)
          : lookAtContacts(shown, collected);
        }
    );
}


void Foam::cghs::heat::checkCase(const dictionary& properties) const
{
    const dictionary& solution = properties.subDict("solution");
    const wordList transported(transportedQuantitiesOf(properties));

    if (solution.get<word>("coupling") == "none")
    {
        WarningInFunction
            << "Entry exchanges of " << properties.name() << " has heat, but"
            << " coupling is none: there is no fluid, and nothing is exchanged"
            << nl << "    Choose oneWay or twoWay" << nl << endl;
    }
    else if (!transported.found("energy"))
    {
        FatalIOErrorInFunction(solution)
            << "Entry transported is " << flatOutput(transported)
            << ", but exchanges has heat, which needs the fluid's energy" << nl
            << "Write transported (energy), or take heat out of exchanges" << nl
            << exit(FatalIOError);
    }

    warnOfCelsius(properties.subOrEmptyDict("constantProperties"));
    for (const entry& e : properties.subOrEmptyDict("feeding"))
    {
        if (e.isDict())
        {
            warnOfCelsius(e.dict());
        }
    }
}


void Foam::cghs::heat::warnOfCelsius(const dictionary& dict)
{
    const scalar T = dict.getOrDefault<scalar>("T", 293);

    if (T > 0 && T < cold_)
    {
        WarningInFunction
            << "Entry T is " << T << " in " << dict.name() << ", which is very"
            << " cold for an absolute temperature [K]" << nl
            << "    If these are degrees Celsius, add 273.15" << nl << endl;
    }
}


void Foam::cghs::heat::addColumns(arena& parcels)
{
    parcels.add(T_);
    parcels.add(responses_);
    parcels.keep(*this);

    if (radiation_.valid())
    {
        radiation_->addColumns(parcels);
    }
    conduction_.addColumns(parcels);
}

// * * * * * * * * * * * * * * * * Reactions * * * * * * * * * * * * * * * * //

void Foam::cghs::heat::startReacting()
{
    reacted_ = balance_.open("reactions");
}


void Foam::cghs::heat::setReacted
(
    const scalarField& T,
    const scalarField& x
)
{
    reactedT_ = T;
    relaxation_ = x;
}


void Foam::cghs::heat::addReacted
(
    const scalar byReactions,
    const scalar fromFluid
)
{
    balance_.add(reacted_, byReactions);
    balance_.add(fromFluid_, fromFluid);
}


void Foam::cghs::heat::respondLater
(
    const arena& parcels,
    const scalar deltaT
)
{
    parcels.visiting.fetch(reactedT_);
    parcels.visiting.fetch(relaxation_);
    const UList<label>& places = parcels.places();

    for (label i = 0; i < parcels.size(); ++i)
    {
        const label placei = places[i];
        const scalar C = share()*capacity(parcels, i);
        scalar& r = responses_[i];

        r =
            hasReacted(placei)
          ? heatArrow::laterResponse(C, r, deltaT, relaxation_[placei])
          : heatArrow::response(C, r, deltaT);
    }
}

// * * * * * * * * * * * * * * * * The step  * * * * * * * * * * * * * * * * //

void Foam::cghs::heat::meet(const arena& parcels, carrierFluid& fluid)
{
    wallHeat_.meet(fluid);
    conduction_.meet(parcels, fluid);

    const scalarField& Cp = fluid.field("Cp");
    const scalarField& kappa = fluid.field("kappa");

    meets_ = true;

    if (radiation_.valid())
    {
        // Stop now if it has none
        fluid.field("G");
    }

    fluidT_ = fluid.field("T").primitiveField();
    flows_.meet(fluid);

    forAll(fluidT_, celli)
    {
        heatedFlow& f = flows_.fluid()[celli];

        f.Cp = Cp[celli];
        f.kappa = kappa[celli];
    }
}


void Foam::cghs::heat::findResponses
(
    const arena& parcels,
    const label from,
    const UList<heatedFlow>& flows,
    const scalar deltaT
)
{
    SubList<scalar> Nu(Nu_, flows.size());
    law_->nusselts(flows, Nu);

    forAll(flows, j)
    {
        const label i = from + j;
        const scalar k =
            parcels.weights[i]*convectiveConductance(flows[j], Nu[j]);

        responses_[i] =
            reacting()
          ? k
          : heatArrow::response(share()*capacity(parcels, i), k, deltaT);
    }
}


void Foam::cghs::heat::evolve(arena& parcels, const scalar deltaT)
{
    conduction_.evolve(deltaT);
    conduction_.moveTo(wallHeat_);
    forAll(walls_, m)
    {
        balance_.add(walls_[m], conduction_.fromWalls(m));
    }

    if (!meets_)
    {
        close(parcels, deltaT);
        return;
    }

    addProfiling(heat, "cghs::heat");

    balance_.add(fromFlux_, wallHeat_.give(parcels, T_, Cp_, deltaT));

    parcels.visiting.fetch(fluidT_);
    flows_.fetch(parcels);
    flows_.forBlocks
    (
        parcels,
        [&](const label from, const UList<heatedFlow>& flows)
        {
            findResponses(parcels, from, flows, deltaT);
        }
    );

    if (radiation_.valid() && !reacting())
    {
        radiation_->emit(parcels, T_, Cp_, deltaT);
    }
}


void Foam::cghs::heat::leave(const arena& parcels, const scalar deltaT)
{
    addProfiling(heat, "cghs::heat");

    twoWay_ = true;
    deltaT_ = max(deltaT, VSMALL);
    if (reacting() && meets_)
    {
        respondLater(parcels, deltaT);
        if (radiation_.valid())
        {
            // As they are now, which may be smaller
            radiation_->emit(parcels, T_, Cp_, deltaT);
        }
    }
    response_ = Zero;
    given_ = Zero;
    parcels.visiting.extend(response_);
    parcels.visiting.extend(given_);

    const UList<label>& places = parcels.places();

    for (label i = 0; i < parcels.size(); ++i)
    {
        const label placei = places[i];

        response_[placei] += responses_[i];
        given_[placei] +=
            responses_[i]*(drivenFrom(i, placei) - fluidT_[placei]);
    }

    parcels.visiting.collect(response_);
    parcels.visiting.collect(given_);
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

        scalarField given(given_);

        if (wallHeat_.toFluid().size())
        {
            given += wallHeat_.toFluid();
        }
        terms.given = rate("given", given, powerDensity);
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

    scalarField dT(fluid.change("T")().primitiveField());
    parcels.visiting.fetch(dT);
    const UList<label>& places = parcels.places();

    // Of the parcels; of the cells; of the magnitudes
    scalarField sums(3, Zero);

    for (label i = 0; i < parcels.size(); ++i)
    {
        const label placei = places[i];
        const scalar Q =
            responses_[i]
           *(fluidT_[placei] + dT[placei] - drivenFrom(i, placei));

        T_[i] += Q/capacity(parcels, i);
        sums[0] += Q;
        sums[2] += mag(Q);
    }

    forAll(given_, celli)
    {
        sums[1] -= given_[celli] - response_[celli]*dT[celli];
    }

    balance_.add(fromFluid_, sums[0]);
    law_->warnOutsideRange();

    if (radiation_.valid())
    {
        const volScalarField& G = fluid.field("G");

        balance_.add
        (
            radiated_,
            radiation_->absorb(parcels, T_, Cp_, G, deltaT)
        );
    }

    if (twoWay_)
    {
        reduce(sums, sumOp<scalarField>());
        mismatch_ = mag(sums[0] - sums[1])/deltaT;
        exchanged_ = sums[2]/deltaT;
        twoWay_ = false;
    }
    meets_ = false;
    close(parcels, deltaT);
}


void Foam::cghs::heat::close(const arena& parcels, const scalar deltaT)
{
    scalar enthalpy = 0;
    scalar sumC = 0;
    range_.least = GREAT;
    range_.most = -GREAT;

    for (label i = 0; i < parcels.size(); ++i)
    {
        const scalar C = capacity(parcels, i);

        enthalpy += C*T_[i];
        sumC += C;
        range_.least = min(range_.least, T_[i]);
        range_.most = max(range_.most, T_[i]);
    }
    reduce(sumC, sumOp<scalar>());
    reduce(range_.least, minOp<scalar>());
    reduce(range_.most, maxOp<scalar>());

    balance_.add(fed_, carriedIn());
    balance_.add(left_, -carriedOut());
    clear();
    balance_.close(enthalpy, deltaT);
    wallHeat_.close(deltaT);
    range_.mean = balance_.stored()/max(sumC, VSMALL);

    if (sumC > 0)
    {
        checkRange();
    }
}


void Foam::cghs::heat::checkRange()
{
    if (range_.least < cold_ && !warned_)
    {
        warned_ = true;
        WarningInFunction
            << "Parcels have a T of " << range_.least << " K, which is very"
            << " cold" << nl
            << "    If degrees Celsius are meant in constantProperties, in"
            << " feeding or in the file of T, add 273.15" << nl << endl;
    }
}

// * * * * * * * * * * * * * * * * Reports * * * * * * * * * * * * * * * * * //

Foam::List<Foam::cghs::figure> Foam::cghs::heat::figures() const
{
    DynamicList<figure> list;

    list.append(figure{"TMin", range_.least});
    list.append(figure{"TMean", range_.mean});
    list.append(figure{"TMax", range_.most});
    list.append(figure{"stored", balance_.storage()});

    for (label i = 0; i < balance_.nAccounts(); ++i)
    {
        list.append(figure{balance_.name(i), balance_.power(i)});
    }
    for (label k = 0; k < wallHeat_.nPatches(); ++k)
    {
        list.append(figure{wallHeat_.name(k), wallHeat_.power(k)});
    }

    return List<figure>(std::move(list));
}


Foam::List<Foam::cghs::figure> Foam::cghs::heat::errors() const
{
    return List<figure>
    ({
        {"heatDefect", balance_.relativeDefect()},
        {"heatMismatch", mag(mismatch_)/max(exchanged_, VSMALL)}
    });
}


void Foam::cghs::heat::report(const arena& parcels, Ostream& os) const
{
    if (range_.most < range_.least)
    {
        return;
    }

    os  << "heat:   parcels of " << range_.least << " to " << range_.most
        << " K, mean " << range_.mean << " K; they and the fluid differ by "
        << mismatch_ << " W out of " << exchanged_ << " W" << nl;
    balance_.report(os);
    wallHeat_.report(os);
    conduction_.report(os);
}


void Foam::cghs::heat::state(dictionary& state) const
{
    balance_.state(state);
    wallHeat_.state(state);

    ledger::state(state);
    conduction_.state(state);
    if (radiation_.valid())
    {
        radiation_->state(state);
    }
}


void Foam::cghs::heat::setState(const dictionary& state)
{
    balance_.setState(state);
    wallHeat_.setState(state);
    ledger::setState(state);
    conduction_.setState(state);
    if (radiation_.valid())
    {
        radiation_->setState(state);
    }
}
