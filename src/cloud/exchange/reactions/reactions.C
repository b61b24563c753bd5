/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "reactions.H"
#include "checkedEntry.H"
#include "cloudProperties.H"
#include "constantDictionary.H"
#include "knownEntries.H"
#include "sortedIndices.H"
#include "profiling.H"
#include "mathematicalConstants.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(reactions, 0);
    addToRunTimeSelectionTable(exchange, reactions, dictionary);
    describeModel
    (
        exchange,
        reactions,
        "composition, reactions with the fluid, shrinking, coke"
    );

} // End namespace cghs
} // End namespace Foam

// * * * * * * * * * * * * * * * Construction  * * * * * * * * * * * * * * * //

bool Foam::cghs::reactions::energetic(const dictionary& dict)
{
    return transportedQuantitiesOf(dict.topDict()).found("energy");
}


Foam::autoPtr<Foam::cghs::reactionScheme>
Foam::cghs::reactions::readScheme(const fvMesh& mesh, const bool energetic)
{
    const IOdictionary dict(constantDictionary(mesh, "reactions"));

    if (energetic && dict.found("species"))
    {
        FatalIOErrorInFunction(dict)
            << "There are species of a liquid, and the fluid has energy, but"
            << " what is solved has no enthalpy of its own" << nl
            << "Take energy out of transported, or species out of here for a"
            << " gas that has them in thermophysicalProperties" << nl
            << exit(FatalIOError);
    }

    // A liquid has no thermophysics of its solutes
    return autoPtr<reactionScheme>
    (
        new reactionScheme
        (
            dict,
            dict.found("species")
          ? dict
          : constantDictionary(mesh, "thermophysicalProperties"),
            energetic
        )
    );
}


Foam::cghs::reactions::reactions(const dictionary& dict, const fvMesh& mesh)
:
    mesh_(mesh),
    coeffs_(dict),
    scheme_(readScheme(mesh, energetic(dict))),
    cell_(scheme_(), reactingCell::readTolerances(dict)),
    slow_(dict.topDict(), scheme_()),
    film_(dict, scheme_->askingForFilm()),
    leastDiameter_
    (
        dict.found("leastDiameter")
      ? positiveScalar(dict, "leastDiameter")
      : 1e-6
    ),
    leastDensity_
    (
        dict.found("leastDensity") ? positiveScalar(dict, "leastDensity") : 0
    ),
    heat_(nullptr),
    gained_(),
    isGas_(true),
    amounts_(mesh.nCells()*nFluid(), 0),
    T_(mesh.nCells(), 0),
    p_(mesh.nCells(), 0),
    volume_(mesh.nCells(), 0),
    meets_(false),
    deltaT_(1),
    given_(mesh.nCells()*nFluid(), 0),
    in_(mesh.nCells(), 0),
    out_(mesh.nCells(), 0),
    momentum_(mesh.nCells(), Zero),
    enthalpy_(scheme_->energetic() ? mesh.nCells() : 0, 0),
    reactedT_(enthalpy_.size(), 0),
    relaxation_(enthalpy_.size(), 0),
    extents_(nReactions() + scheme_->inFluid().size(), 0),
    gain_(0),
    ahead_(0),
    steps_(0),
    heating_(0),
    meanY_(nSolids(), 0),
    mass_(-1),
    fed_(0),
    left_(0),
    burntOut_(0),
    defect_(0),
    goneNow_(0),
    growth_(-1)
{
    warnUnknownEntries
    (
        dict,
        wordList
        ({
            "relative", "absolute", "massTransfer", "T", "leastDiameter",
            "leastDensity"
        })
    );

    for (const word& name : scheme_->solids().names())
    {
        Y_.append(new propertyOf<scalar>("Y." + name));
        Y_.last().allow(0, 1).readFrom("Y." + name);
    }
    scheme_->report(Info);
}


void Foam::cghs::reactions::checkCase(const dictionary& properties) const
{
    const dictionary& solution = properties.subDict("solution");
    const wordList transported(transportedQuantitiesOf(properties));

    if (solution.get<word>("coupling") != "twoWay")
    {
        FatalIOErrorInFunction(solution)
            << "Entry coupling is " << solution.get<word>("coupling")
            << ", but exchanges has reactions, which change the fluid" << nl
            << "Write coupling twoWay, or take reactions out of exchanges"
            << nl << exit(FatalIOError);
    }
    if (!transported.found("species"))
    {
        FatalIOErrorInFunction(solution)
            << "Entry transported is " << flatOutput(transported)
            << ", but exchanges has reactions, which need the fluid's species"
            << nl << "Write transported (species), or take reactions out of"
            << " exchanges" << nl
            << exit(FatalIOError);
    }
    checkHeat(properties);

    const auto checkSum = [&](const dictionary& dict)
    {
        scalar sum = 0;
        bool any = false;
        for (const propertyOf<scalar>& Y : Y_)
        {
            any = any || dict.found(Y.name());
            sum += dict.getOrDefault<scalar>(Y.name(), 0);
        }
        if (any && !(mag(sum - 1) < 1e-6))
        {
            FatalIOErrorInFunction(dict)
                << "Mass fractions of the solids sum to " << sum
                << " but must sum to 1" << nl
                << "Entries are Y.<solid>, with solids "
                << flatOutput(scheme_->solids().names()) << nl
                << exit(FatalIOError);
        }
    };
    checkSum(properties.subOrEmptyDict("constantProperties"));
    for (const entry& e : properties.subOrEmptyDict("feeding"))
    {
        if (e.isDict())
        {
            checkSum(e.dict());
        }
    }
}


void Foam::cghs::reactions::checkHeat(const dictionary& properties) const
{
    if (!scheme_->energetic())
    {
        return;
    }

    const dictionary& subModels = properties.subDict("subModels");
    const wordList names(subModels.get<wordList>("exchanges"));
    const label h = names.find(heat::typeName);

    if (h < 0 || h > names.find(typeName))
    {
        FatalIOErrorInFunction(subModels)
            << "Entry exchanges is " << flatOutput(names)
            << ", but the fluid has energy, and reactions heat parcels, whose"
            << " temperatures heat has" << nl
            << "List heat before reactions, or take energy out of transported"
            << nl << exit(FatalIOError);
    }

    for (const substance& solid : scheme_->solids())
    {
        if (!solid.straight())
        {
            FatalIOErrorInFunction(coeffs_)
                << "The solid " << solid.name() << " of constant/reactions has"
                << " a heat capacity that depends on temperature" << nl
                << "Write solidThermo hConst, and its Cp and Hf" << nl
                << exit(FatalIOError);
        }
    }
}


void Foam::cghs::reactions::join(PtrList<exchange>& all)
{
    if (!scheme_->energetic())
    {
        return;
    }

    for (exchange& e : all)
    {
        if (isA<heat>(e))
        {
            heat_ = &refCast<heat>(e);
            heat_->startReacting();
        }
    }
}


void Foam::cghs::reactions::compose(parcelCapacity& Cp)
{
    if (scheme_->energetic())
    {
        forAll(Y_, s)
        {
            const substance& solid = scheme_->solids()[s];
            Cp.add(Y_[s], solid.Cp(300)/solid.M());
        }
    }
}


void Foam::cghs::reactions::addColumns(arena& parcels)
{
    for (propertyOf<scalar>& Y : Y_)
    {
        parcels.add(Y);
    }
    parcels.add(gained_);
    parcels.keep(*this);
}

// * * * * * * * * * * * * * * * * The step  * * * * * * * * * * * * * * * * //

void Foam::cghs::reactions::markGone(const arena& parcels, boolList& gone)
{
    for (label i = 0; i < parcels.size(); ++i)
    {
        if (isGone(parcels, i))
        {
            gone[i] = true;
            goneNow_ += parcels.motions[i].mass();
        }
    }
}


void Foam::cghs::reactions::meet(const arena& parcels, carrierFluid& fluid)
{
    meets_ = true;
    isGas_ = fluid.composition();

    const scalarField& alpha = fluid.alpha();
    const scalarField& rho = fluid.rho();

    volume_ = alpha*mesh_.V();
    p_ = isGas_ ? fluid.p().primitiveField() : scalarField(p_.size(), 0);
    T_ =
        isGas_
      ? fluid.field("T").primitiveField()
      : scalarField(T_.size(), coeffs_.get<scalar>("T"));

    if (film_.varies() && !heat_)
    {
        flows_.meet(fluid);
    }

    forAll(scheme_->fluid(), k)
    {
        const substance& s = scheme_->fluid()[k];
        const scalarField& Y = fluid.field(s.name());
        const label n = nFluid();
        forAll(Y, celli)
        {
            amounts_[celli*n + k] =
                max(Y[celli], scalar(0))*rho[celli]*volume_[celli]/s.M();
        }
    }
}


void Foam::cghs::reactions::checkSums(const arena& parcels)
{
    for (label i = 0; i < parcels.size(); ++i)
    {
        scalar sum = 0;
        for (const propertyOf<scalar>& Y : Y_)
        {
            sum += Y[i];
        }
        if (!(mag(sum - 1) < 1e-5))
        {
            FatalErrorInFunction
                << "Mass fractions of the solids of parcel " << parcels.ids[i]
                << " sum to " << sum << " but must sum to 1" << nl
                << "Give Y.<solid> in constantProperties, or fields of these"
                << " names with the parcels; solids are "
                << flatOutput(scheme_->solids().names()) << nl
                << exit(FatalError);
        }
        if (scheme_->constantDensity())
        {
            checkDensity(parcels, i);
        }
    }
}


void Foam::cghs::reactions::checkDensity
(
    const arena& parcels,
    const label i
) const
{
    scalar volume = 0;
    forAll(Y_, s)
    {
        volume += Y_[s][i]/scheme_->solids()[s].rho();
    }

    if (mag(parcels.density(i)*volume - 1) > 1e-3)
    {
        FatalErrorInFunction
            << "Parcel " << parcels.ids[i] << " has a density of "
            << parcels.density(i) << " kg/m^3, but its solids make "
            << 1/volume << " kg/m^3" << nl
            << "Give it that density, or correct rho of the solids in"
            << " constant/reactions, whose size is constantDensity" << nl
            << exit(FatalError);
    }
}


Foam::scalarField
Foam::cghs::reactions::bodiesOf(const arena& parcels) const
{
    const label width = bodyWidth();
    scalarField bodies(width*parcels.size());

    for (label i = 0; i < parcels.size(); ++i)
    {
        scalar* b = &bodies[width*i];
        const scalar m = parcels.motions[i].mass();

        b[0] = parcels.weights[i];
        b[1] = parcels.diameters[i];
        b[2] = 0;
        forAll(Y_, s)
        {
            b[3 + s] = m*Y_[s][i]/scheme_->solids()[s].M();
        }
        if (heat_)
        {
            scalar* h = b + heatPart();
            h[0] = heat_->temperatures()[i];
            h[1] = heat_->conductances()[i];
            h[2] = 0;
        }
    }
    return bodies;
}


void Foam::cghs::reactions::setFilms
(
    const arena& parcels,
    scalarField& bodies
)
{
    const label width = bodyWidth();
    scalarField film(parcelFlows::blockSize);

    if (!heat_)
    {
        flows_.fetch(parcels);
    }
    parcelFlows& past = heat_ ? heat_->flows() : flows_;
    past.forBlocks
    (
        parcels,
        [&](const label from, const UList<heatedFlow>& flows)
        {
            SubList<scalar> k(film, flows.size());
            film_.coefficients(flows, k);

            forAll(k, j)
            {
                bodies[width*(from + j) + filmPart()] = k[j];
            }
        }
    );
}


bool Foam::cghs::reactions::isSpent(const scalar* body) const
{
    const UList<scalar> n(const_cast<scalar*>(body + 3), nSolids());
    return scheme_->solids().massOf(n) < leastMass_*body[0];
}


void Foam::cghs::reactions::startBalance(const arena& parcels)
{
    if (mass_ >= 0)
    {
        return;
    }

    // Before anything came in or went out in this step
    scalar mass = carriedOut() - carriedIn();
    for (label i = 0; i < parcels.size(); ++i)
    {
        mass += parcels.motions[i].mass();
    }
    mass_ = max(returnReduce(mass, sumOp<scalar>()), scalar(0));
}


void Foam::cghs::reactions::addBody(const scalar* b, const scalar fluidT)
{
    const UList<scalar> amounts(const_cast<scalar*>(b + 3), nSolids());

    reactingCell::body body;
    body.W = b[0];
    body.d = b[1];
    body.T = heat_ ? b[heatPart()] : fluidT;
    body.conductance = heat_ ? b[heatPart() + 1] : 0;
    body.film = film_.varies() ? b[filmPart()] : film_.constant();
    cell_.add(body, amounts);
}


void Foam::cghs::reactions::noteMet
(
    const label celli,
    const UList<label>& which,
    const scalarField& bodies
)
{
    const label n = nFluid();
    scalar mass = 0;

    for (const label i : which)
    {
        mass += scheme_->solids().massOf
        (
            SubList<scalar>(bodies, nSolids(), bodyWidth()*i + 3)
        );
    }
    slow_.meet
    (
        SubList<scalar>(amounts_, n, celli*n),
        volume_[celli],
        T_[celli],
        p_[celli],
        mass
    );
}


void Foam::cghs::reactions::goAhead(const label nOwn, scalarField& bodies)
{
    if (slow_.startMean(cell_))
    {
        DynamicList<label> which(nOwn);
        for (label i = 0; i < nOwn; ++i)
        {
            const scalar* b = &bodies[bodyWidth()*i];
            if (!isSpent(b))
            {
                which.append(i);
                addBody(b, cell_.fluidTemperature());
            }
        }
        slow_.share(cell_, which, extents_, bodies, bodyWidth(), 3);
    }
    slow_.close(deltaT_);
}


void Foam::cghs::reactions::react
(
    const label celli,
    const UList<label>& which,
    scalarField& bodies,
    const scalar deltaT
)
{
    const label n = nFluid();
    const label width = bodyWidth();
    const SubList<scalar> fluid(amounts_, n, celli*n);

    DynamicList<label> reacting(which.size());

    cell_.start(fluid, T_[celli], p_[celli], volume_[celli]);
    for (const label i : which)
    {
        const scalar* b = &bodies[width*i];
        if (isSpent(b))
        {
            continue;
        }
        reacting.append(i);
        addBody(b, T_[celli]);
    }

    if (heat_ && cell_.rests())
    {
        return;
    }

    // The whole step is tried first, so that nothing has to be remembered
    scalar h = deltaT;
    if (!cell_.react(deltaT, h))
    {
        FatalErrorInFunction
            << "The reactions in cell " << celli << " at "
            << mesh_.C()[celli] << " could not be integrated over "
            << deltaT << " s: " << cell_.steps() << " steps, "
            << cell_.refusals() << " refused" << nl
            << "Its fluid has " << fluid << " mol of "
            << flatOutput(scheme_->fluid().names()) << " at " << T_[celli]
            << " K, and " << reacting.size() << " parcels react. Look at the"
            << " rates' units, heats and heat capacities" << nl
            << exit(FatalError);
    }
    steps_ = max(steps_, cell_.steps());

    // By extents, not by differences of what there is, which is much more: so
    // all that is given adds up
    SubList<scalar> given(given_, n, celli*n);

    forAll(reacting, j)
    {
        scalar* b = &bodies[width*reacting[j] + 2];
        const SubList<scalar> amounts(cell_.amounts(j));
        std::copy(amounts.begin(), amounts.end(), b + 1);
        UList<scalar> own(b + 1, nSolids());
        slow_.follow(cell_, j, own);

        for (label r = 0; r < nReactions(); ++r)
        {
            const scalar x = cell_.extent(j, r);
            *b -= addGiven(scheme_->inParticles()[r], x, given);
            extents_[r] += x;
        }
    }
    forAll(scheme_->inFluid(), r)
    {
        const scalar x = cell_.fluidExtent(r);
        addGiven(scheme_->inFluid()[r], x, given);
        extents_[nReactions() + r] += x;
    }

    if (heat_)
    {
        noteEnthalpy(celli, reacting, bodies, deltaT);
    }
}


void Foam::cghs::reactions::noteEnthalpy
(
    const label celli,
    const UList<label>& reacting,
    scalarField& bodies,
    const scalar deltaT
)
{
    const label n = nFluid();
    scalar k = 0;
    scalar& given = enthalpy_[celli];

    forAll(reacting, j)
    {
        scalar* h = &bodies[bodyWidth()*reacting[j] + heatPart()];
        h[0] = cell_.temperature(j);
        h[2] = cell_.enthalpyGot(j) - cell_.enthalpyTaken(j);
        k += h[1];
        given -= cell_.enthalpyGot(j);
    }
    for (label s = 0; s < n; ++s)
    {
        const substance& species = scheme_->fluid()[s];
        given -= given_[celli*n + s]/species.M()*species.formation();
    }

    reactedT_[celli] = cell_.fluidTemperature();
    relaxation_[celli] = k*deltaT/max(cell_.fluidCapacity(), VSMALL);
    heating_ += given;
}


Foam::scalar Foam::cghs::reactions::addGiven
(
    const reaction& r,
    const scalar extent,
    UList<scalar>& given
) const
{
    const scalarField& gain = r.equation().fluidGain();
    scalar all = 0;
    forAll(gain, k)
    {
        const scalar mass = gain[k]*extent*scheme_->fluid()[k].M();
        given[k] += mass;
        all += mass;
    }
    return all;
}


void Foam::cghs::reactions::evolve(arena& parcels, const scalar deltaT)
{
    growth_ = -1;
    extents_ = 0;
    gain_ = 0;
    ahead_ = 0;
    steps_ = 0;
    given_ = 0;
    in_ = 0;
    out_ = 0;
    momentum_ = Zero;
    enthalpy_ = 0;
    reactedT_ = 0;
    relaxation_ = 0;
    heating_ = 0;
    deltaT_ = max(deltaT, VSMALL);
    slow_.start(mesh_.time().value(), deltaT_);

    if (!meets_)
    {
        if (mass_ >= 0)
        {
            close(parcels, deltaT);
        }
        return;
    }

    // The fluid is met anew in each step that there are parcels
    meets_ = false;
    checkSums(parcels);
    startBalance(parcels);

    addProfiling(reactions, "cghs::reactions");

    // Parcels that are in cells of this rank, and visitors behind them
    scalarField bodies(bodiesOf(parcels));
    if (film_.varies())
    {
        setFilms(parcels, bodies);
    }
    const scalarField guests(parcels.visiting.toHosts(bodies, bodyWidth()));
    const label nOwn = parcels.size();
    bodies.append(guests);

    // Those that are away are behind all cells
    const label nCells = mesh_.nCells();
    labelList cells(SubList<label>(parcels.places(), nOwn));
    for (label& celli : cells)
    {
        celli = min(celli, nCells);
    }
    cells.append(parcels.visiting.hostedCells());

    labelList starts;
    const labelList order(sortedIndices(cells, nCells + 1, starts));
    const bool always = scheme_->inFluid().size();

    for (label celli = 0; celli < nCells; ++celli)
    {
        const label n = starts[celli + 1] - starts[celli];
        const SubList<label> which(order, n, starts[celli]);
        if (n && slow_.goesOn())
        {
            noteMet(celli, which, bodies);
        }
        if (n || always)
        {
            react(celli, which, bodies, deltaT);
        }
    }

    cell_.warnOfRanges();
    parcels.visiting.fromHosts
    (
        SubList<scalar>(bodies, guests.size(), nOwn*bodyWidth()),
        bodyWidth(),
        bodies
    );
    goAhead(nOwn, bodies);
    update(parcels, bodies);
    gather(parcels);
    if (heat_)
    {
        heat_->setReacted(reactedT_, relaxation_);
    }
}


void Foam::cghs::reactions::update
(
    arena& parcels,
    const scalarField& bodies
)
{
    const label width = bodyWidth();
    const substances& solids = scheme_->solids();
    growth_ = 0;
    scalar byReactions = 0;
    scalar fromFluid = 0;

    for (label i = 0; i < parcels.size(); ++i)
    {
        const scalar* n = &bodies[width*i + 3];
        gained_[i] = bodies[width*i + 2];
        gain_ += gained_[i];
        const bool spent = isSpent(&bodies[width*i]);
        if (spent && heat_)
        {
            // It holds no heat
            heat_->conductances()[i] = 0;
        }
        if (spent && gained_[i] == 0)
        {
            continue;
        }
        const scalar H = thermalEnthalpy(parcels, i);

        scalar m = 0;
        scalar V = 0;
        forAll(solids, s)
        {
            const scalar ms = n[s]*solids[s].M();
            m += ms;
            V += scheme_->constantDensity() ? ms/solids[s].rho() : 0;
        }
        const scalar W = parcels.weights[i];
        if (spent)
        {
            // The last of it has the composition and density of before
            m = max(m, 1e-3*leastMass_*W);
            V = m/parcels.density(i);
        }
        forAll(solids, s)
        {
            Y_[s][i] = spent ? Y_[s][i] : n[s]*solids[s].M()/m;
        }

        const scalar r = parcels.spheres[i].r;
        const scalar d =
            scheme_->constantDensity()
          ? cbrt(6*V/(W*constant::mathematical::pi))
          : parcels.diameters[i];

        parcels.setSize
        (
            i, d, W, m/(W*constant::mathematical::pi/6*pow3(d))
        );
        growth_ = max(growth_, parcels.spheres[i].r - r);

        if (heat_)
        {
            const scalar* h = &bodies[width*i + heatPart()];
            heat_->temperatures()[i] = h[0];
            byReactions += thermalEnthalpy(parcels, i) - H - h[2];
            fromFluid += h[2];
        }
    }
    if (heat_)
    {
        heat_->addReacted(byReactions, fromFluid);
    }
    reduce(growth_, maxOp<scalar>());
}


void Foam::cghs::reactions::gather(const arena& parcels)
{
    parcels.visiting.extend(in_);
    parcels.visiting.extend(out_);
    parcels.visiting.extend(momentum_);

    const UList<label>& places = parcels.places();
    for (label i = 0; i < parcels.size(); ++i)
    {
        const scalar lost = max(-gained_[i], scalar(0));
        in_[places[i]] += lost;
        out_[places[i]] += max(gained_[i], scalar(0));
        momentum_[places[i]] += lost*parcels.motions[i].v;
    }

    parcels.visiting.collect(in_);
    parcels.visiting.collect(out_);
    parcels.visiting.collect(momentum_);
}


Foam::tmp<Foam::volScalarField> Foam::cghs::reactions::rate
(
    const word& name,
    const scalarField& sums,
    const dimensionSet& dimensions
) const
{
    auto result = volScalarField::New
    (
        "reactions:" + name,
        mesh_,
        dimensionedScalar(dimensions, Zero)
    );

    result.ref().primitiveFieldRef() = sums/(mesh_.V()*deltaT_);

    return result;
}


Foam::cghs::exchangeTerms
Foam::cghs::reactions::terms(const word& quantity) const
{
    exchangeTerms terms;
    const label k = scheme_->fluid().find(quantity);

    if (k >= 0)
    {
        scalarField sums(mesh_.nCells());
        forAll(sums, celli)
        {
            sums[celli] = given_[celli*nFluid() + k];
        }
        terms.given = rate(quantity, sums, dimDensity/dimTime);
    }
    else if (quantity == "energy" && heat_)
    {
        terms.given = rate(quantity, enthalpy_, dimPower/dimVolume);
    }

    return terms;
}


Foam::cghs::massTerms Foam::cghs::reactions::massGiven() const
{
    massTerms terms;

    terms.in = rate("in", in_, dimDensity/dimTime);
    terms.out = rate("out", out_, dimDensity/dimTime);

    terms.momentum = volVectorField::New
    (
        "reactions:momentum",
        mesh_,
        dimensionedVector(dimDensity*dimVelocity/dimTime, Zero)
    );
    terms.momentum.ref().primitiveFieldRef() =
        momentum_/(mesh_.V()*deltaT_);

    return terms;
}


void Foam::cghs::reactions::complete
(
    arena& parcels,
    const carrierFluid& fluid,
    const scalar deltaT
)
{
    vectorField U(fluid.U().primitiveField() + fluid.dU()().primitiveField());
    parcels.visiting.fetch(U);
    const UList<label>& places = parcels.places();

    for (label i = 0; i < parcels.size(); ++i)
    {
        if (gained_[i] > 0)
        {
            vector& v = parcels.motions[i].v;
            v += (U[places[i]] - v)*gained_[i]/parcels.motions[i].mass();
        }
    }

    if (film_.varies())
    {
        film_.warnOutsideRange();
    }
    close(parcels, deltaT);
}


void Foam::cghs::reactions::close(const arena& parcels, const scalar deltaT)
{
    scalar mass = 0;
    meanY_ = 0;
    for (label i = 0; i < parcels.size(); ++i)
    {
        const scalar m = parcels.motions[i].mass();
        mass += m;
        forAll(Y_, s)
        {
            meanY_[s] += m*Y_[s][i];
        }
    }
    reduce(mass, sumOp<scalar>());
    reduce(meanY_, sumOp<scalarField>());
    meanY_ /= max(mass, VSMALL);

    reduce(extents_, sumOp<scalarField>());
    reduce(gain_, sumOp<scalar>());
    ahead_ = sum(slow_.ahead());
    reduce(steps_, maxOp<label>());
    reduce(heating_, sumOp<scalar>());
    fed_ = returnReduce(carriedIn(), sumOp<scalar>());
    burntOut_ = returnReduce(goneNow_, sumOp<scalar>());
    left_ = returnReduce(carriedOut(), sumOp<scalar>()) - burntOut_;
    clear();
    goneNow_ = 0;

    defect_ = mass - mass_ - gain_ - ahead_ - fed_ + left_ + burntOut_;
    mass_ = mass;
}

// * * * * * * * * * * * * * * * * Reports * * * * * * * * * * * * * * * * * //

Foam::List<Foam::cghs::figure> Foam::cghs::reactions::figures() const
{
    DynamicList<figure> list;

    for (const auto* place : {&scheme_->inParticles(), &scheme_->inFluid()})
    {
        for (const reaction& r : *place)
        {
            list.append({r.name(), extents_[list.size()]/deltaT_});
        }
    }
    list.append({"gained", gain_/deltaT_});
    list.append({"fed", fed_/deltaT_});
    list.append({"left", -left_/deltaT_});
    list.append({"burntOut", -burntOut_/deltaT_});
    forAll(Y_, s)
    {
        list.append({Y_[s].name(), meanY_[s]});
    }
    if (slow_.clockRuns())
    {
        list.append({"ahead", ahead_/deltaT_});
        list.append({"aheadMost", slow_.largest()});
    }
    list.append({"steps", scalar(steps_)});
    if (heat_)
    {
        list.append({"given", heating_/deltaT_});
    }

    return List<figure>(std::move(list));
}


Foam::List<Foam::cghs::figure> Foam::cghs::reactions::errors() const
{
    return List<figure>
    ({
        {"solidsDefect", mag(defect_)/max(mass_, VSMALL)}
    });
}


void Foam::cghs::reactions::report(const arena& parcels, Ostream& os) const
{
    os  << "reactions:";
    for (const figure& f : figures())
    {
        os  << ' ' << f.name << ' ' << f.value;
    }
    os  << nl << "        parcels " << max(mass_, scalar(0)) << " kg, from"
        << " nowhere " << defect_ << " kg" << nl;
}


void Foam::cghs::reactions::state(dictionary& state) const
{
    ledger::state(state);
}


void Foam::cghs::reactions::setState(const dictionary& state)
{
    ledger::setState(state);
}
