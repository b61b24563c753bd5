/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "cghsCloud.H"
#include "cloudProperties.H"
#include "parcelFiles.H"
#include "memoryFiles.H"
#include "flowState.H"
#include "checkedEntry.H"
#include "knownEntries.H"
#include "profiling.H"
#include "PstreamReduceOps.H"
#include "SubField.H"
#include "Time.H"

#include <functional>

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(cghsCloud, 0);
}
}

const Foam::Enum<Foam::cghs::cghsCloud::couplingType>
Foam::cghs::cghsCloud::couplingNames
({
    { couplingType::none, "none" },
    { couplingType::oneWay, "oneWay" },
    { couplingType::twoWay, "twoWay" }
});


Foam::scalar Foam::cghs::census::granularTemperature() const
{
    return
    (
        cmptSum(meanSquare) - magSqr(meanVelocity)
    )/3;
}

// * * * * * * * * * * * * * * * Construction  * * * * * * * * * * * * * * * //

Foam::scalar Foam::cghs::cghsCloud::largestDiameter() const
{
    scalar d = 0;

    for (label i = 0; i < parcels_.size(); ++i)
    {
        d = max(d, 2*parcels_.spheres[i].r);
    }

    return max(returnReduce(d, maxOp<scalar>()), feeding_.largestDiameter());
}


void Foam::cghs::cghsCloud::checkEntries() const
{
    warnUnknownEntries
    (
        properties_,
        wordList
        ({
            "solution", "constantProperties", "subModels", "boundary", "feeding"
        }),
        true
    );
    warnUnknownEntries
    (
        solution(),
        wordList
        ({
            "coupling", "fluid", "maxDisplacement", "maxDeltaT",
            "neighbourSkin", "minVoidage", "transported", "energyCoeffs"
        })
    );
    wordList constants({"diameter", "density", "parcelWeight"});
    constants.append(parcels_.entryNames());
    warnUnknownEntries(properties_.subDict("constantProperties"), constants);
    warnUnknownEntries
    (
        subModels(),
        wordList({"contactModel", "dragModel", "mappingModel", "exchanges"})
    );
}


void Foam::cghs::cghsCloud::checkConstants() const
{
    const particleProperties stated(properties_);
    const label n = parcels_.size();

    const auto check = [&]
    (
        const char* name,
        const scalar value,
        const std::function<scalar(const label)>& of
    )
    {
        scalar least = GREAT, most = -GREAT;
        for (label i = 0; i < n; ++i)
        {
            least = min(least, of(i));
            most = max(most, of(i));
        }
        reduce(least, minOp<scalar>());
        reduce(most, maxOp<scalar>());

        if
        (
            least <= most
         && (value < least*(1 - 1e-6) || value > most*(1 + 1e-6))
        )
        {
            WarningInFunction
                << "Entry " << name << " in constantProperties of "
                << properties_.name() << " is " << value
                << ", but the parcels that are there have "
                << string(most > least ? Foam::name(least) + " to " : "").c_str()
                << most << nl << "    They keep their own. The entry is for new parcels"
                << " (fillParcels, feeding); parcelWeight is also that which"
                << " restitutionScaling takes" << nl << endl;
        }
    };

    check
    (
        "parcelWeight",
        stated.weight,
        [&](const label i) { return parcels_.weights[i]; }
    );
    check
    (
        "density",
        stated.density,
        [&](const label i) { return parcels_.density(i); }
    );

    if (properties_.subDict("constantProperties").found("diameter"))
    {
        check
        (
            "diameter",
            stated.diameter(),
            [&](const label i) { return parcels_.diameters[i]; }
        );
    }
}


void Foam::cghs::cghsCloud::makeValves()
{
    const dictionary& boundary = properties_.subDict("boundary");

    for (const label patchi : transport_.patchesOf(transport::action::valve))
    {
        const word& name = mesh_.boundaryMesh()[patchi].name();

        if (!boundary.isDict(name))
        {
            FatalIOErrorInFunction(boundary)
                << "Patch " << name << " is an inventoryValve, but has no"
                << " inventory" << nl << "Write "
                << name << " { type inventoryValve; inventory <kg>; }" << nl
                << exit(FatalIOError);
        }

        valves_.append
        (
            new inventoryValve(boundary.subDict(name), mesh_, patchi)
        );
    }
}


Foam::scalar Foam::cghs::cghsCloud::largestSpeed() const
{
    scalar speed = 0;

    for (label i = 0; i < parcels_.size(); ++i)
    {
        speed = max(speed, mag(parcels_.motions[i].v));
    }

    return returnReduce(speed, maxOp<scalar>());
}


Foam::cghs::cghsCloud::cghsCloud
(
    const fvMesh& mesh,
    const word& name,
    const vector& g
)
:
    cloud(mesh, name),
    mesh_(mesh),
    properties_(readCloudProperties(mesh, name)),
    coupling_(couplingNames.get("coupling", solution())),
    g_(g),
    maxDisplacement_(scalarInRange(solution(), "maxDisplacement", SMALL, 0.5)),
    maxDeltaT_(positiveScalar(solution(), "maxDeltaT")),
    contactModel_
    (
        contactModel::New
        (
            subModels(),
            scalarInRange
            (
                properties_.subDict("constantProperties"),
                "parcelWeight",
                1,
                GREAT
            )
        )
    ),
    parcels_
    (
        contactModel_->needsSpin(),
        contactModel_->needsShifts(),
        max(contactModel_->materials().size(), 1)
    ),
    exchanges_(cghs::exchange::New(subModels(), mesh, parcels_)),
    transport_(mesh, properties_.subDict("boundary")),
    contacts_
    (
        std::move(contactModel_),
        scalarInRange(solution(), "neighbourSkin", SMALL, 10),
        mesh,
        transport_.wallPatches(),
        transport::periods(mesh),
        g
    ),
    wallMotion_(mesh),
    feeding_(properties_, parcels_, mesh),
    momentum_(nullptr),
    present_(true),
    exchanging_(false)
{
    checkEntries();
    makeValves();

    for (cghs::exchange& e : exchanges_)
    {
        if (e.looksAtContacts())
        {
            contacts_.startLending(e.needs());
            e.setWalls(contacts_.wallPatches());
        }
    }

    if (feeding_.recycling())
    {
        transport_.keepDepartures();
    }
    if
    (
        coupling_ == couplingType::twoWay
     && (feeding_.needed() || valves_.size())
    )
    {
        parcels_.startFading();
    }

    if (contacts_.remembers())
    {
        parcels_.add(contacts_.formerIndices());
    }

    const dictionary flows(readFlows(mesh, name));
    const bool sameIds =
        readParcels
        (
            mesh,
            name,
            properties_.subDict("constantProperties"),
            parcels_
        );
    if (sameIds && contacts_.understands(flows.subOrEmptyDict("contacts")))
    {
        readMemories(*this, parcels_, contacts_);
    }
    checkConstants();
    transport_.constrain(parcels_);

    if (coupling_ != couplingType::none)
    {
        enterFluid();
    }

    state_ = transport_.survey(parcels_);
    contacts_.expect(largestSpeed());
    setFlows(flows);
}


void Foam::cghs::cghsCloud::enterFluid()
{
    const bool twoWay = coupling_ == couplingType::twoWay;

    momentum_ = new momentum
    (
        subModels(),
        mesh_,
        name(),
        g_,
        largestDiameter(),
        twoWay ? scalarInRange(solution(), "minVoidage", 0.01, 1) : 0
    );
    exchanges_.append(momentum_);
    momentum_->addColumns(parcels_);

    if (twoWay)
    {
        if (contacts_.needed())
        {
            momentum_->startHolding();
        }
        momentum_->leave(parcels_, 0);
    }
}

// * * * * * * * * * * * * * * * * The step  * * * * * * * * * * * * * * * * //

Foam::scalar Foam::cghs::cghsCloud::solidsDeltaT() const
{
    // Parcels that do not touch may go further than their diameter
    return
        contacts_.needed()
      ? min(maxDeltaT_, maxDisplacement_*state_.diameterTime)
      : maxDeltaT_;
}


void Foam::cghs::cghsCloud::fall(const scalar deltaT)
{
    for (label i = 0; i < parcels_.size(); ++i)
    {
        parcels_.motions[i].v += deltaT*g_;
    }
}


void Foam::cghs::cghsCloud::startAfresh()
{
    contacts_.noteIndices(parcels_);
    settle();
    feeding_.recycle(transport_);
}


void Foam::cghs::cghsCloud::settle()
{
    transport_.settle(parcels_);

    if (contacts_.needed())
    {
        contacts_.rebuild(parcels_);
    }

    state_.crossed = false;
}


void Foam::cghs::cghsCloud::fade(const scalar deltaT)
{
    for (label i = 0; i < parcels_.size(); ++i)
    {
        // In the time in which it moves by its diameter, or falls it
        const scalar d = 2*parcels_.spheres[i].r;
        const scalar rate =
            max(mag(parcels_.motions[i].v)/d, sqrt(mag(g_)/d));
        const scalar change =
            parcels_.exits[i] == -1 ? deltaT*rate : -deltaT*rate;

        parcels_.presences[i] =
            min(max(parcels_.presences[i] + change, 0), 1);
    }
}


void Foam::cghs::cghsCloud::openValves(labelUList& exits) const
{
    if (valves_.empty())
    {
        return;
    }

    scalar mass = 0;
    forAll(exits, i)
    {
        mass += exits[i] == -1 ? parcels_.motions[i].mass() : 0;
    }
    reduce(mass, sumOp<scalar>());

    for (const inventoryValve& valve : valves_)
    {
        mass -= valve.release(parcels_, mass, exits);
    }
}


Foam::labelList Foam::cghs::cghsCloud::findLeaving(const scalar deltaT)
{
    labelList exits(parcels_.size(), -1);

    if (!parcels_.fading())
    {
        openValves(exits);
        return exits;
    }

    fade(deltaT);
    openValves(parcels_.exits);

    forAll(exits, i)
    {
        if (parcels_.presences[i] <= 0)
        {
            exits[i] = parcels_.exits[i];
        }
    }

    return exits;
}


void Foam::cghs::cghsCloud::feed(const scalar deltaT)
{
    if (valves_.empty() && !feeding_.needed())
    {
        return;
    }

    addProfiling(feed, "cghs::feed");

    const labelList exits(findLeaving(deltaT));
    bool anyLeaves = false;
    for (const label patchi : exits)
    {
        anyLeaves = anyLeaves || patchi != -1;
    }
    reduce(anyLeaves, orOp<bool>());

    const DynamicList<feeder::arrival> arrivals
    (
        feeding_.find
        (
            parcels_,
            mesh_.time().value(),
            deltaT,
            transport_,
            contacts_
        )
    );

    if (anyLeaves || arrivals.size())
    {
        contacts_.noteIndices(parcels_);
        parcels_.dismissGuests();
        transport_.release(parcels_, exits);
        feeding_.append(arrivals, parcels_);
        settle();

        state_ = transport_.survey(parcels_);
        contacts_.expect(largestSpeed());
    }
}


void Foam::cghs::cghsCloud::solidsStep
(
    const scalar deltaT,
    const bool last,
    const scalar fluidDeltaT
)
{
    if (contacts_.needed() ? contacts_.stale() : state_.crossed)
    {
        startAfresh();
    }

    const scalar half = 0.5*deltaT;
    {
        addProfiling(suspension, "cghs::suspension");

        if (!momentum_)
        {
            fall(half);
        }
        for (cghs::exchange& e : exchanges_)
        {
            if (e.kick(parcels_, half))
            {
                contacts_.resized(0);
            }
        }
    }

    contacts_.impacts(parcels_, deltaT);

    {
        addProfiling(suspension, "cghs::suspension");

        if (!momentum_)
        {
            fall(half);
        }
        for (cghs::exchange& e : exchanges_)
        {
            if (e.kickAgain(parcels_, half))
            {
                contacts_.resized(0);
            }
        }
    }

    contacts_.correct(parcels_, deltaT);

    {
        addProfiling(suspension, "cghs::suspension");

        for (cghs::exchange& e : exchanges_)
        {
            e.settle(parcels_, half, last, fluidDeltaT);
        }
    }

    lendContacts(deltaT);
    if (last)
    {
        lendNeighbours(fluidDeltaT);
    }

    state_ = transport_.move(parcels_, deltaT);
    contacts_.moved(state_.maxDistance, deltaT);
}


void Foam::cghs::cghsCloud::lendContacts(const scalar deltaT)
{
    for (cghs::exchange& e : exchanges_)
    {
        const UList<cghs::exchange::lookRound>& rounds = e.contactRounds();

        if (rounds.size())
        {
            contacts_.refreshSizes(parcels_);
        }

        forAll(rounds, k)
        {
            contacts_.lend
            (
                rounds[k].shown,
                rounds[k].collected,
                &contactLog::now,
                [&](const contactList& list)
                {
                    k == 0
                  ? e.touch(list, parcels_, deltaT)
                  : e.touchAgain(list, parcels_, deltaT);
                }
            );
        }

        if (rounds.size())
        {
            e.touched(parcels_);
        }
    }
}


void Foam::cghs::cghsCloud::lendNeighbours(const scalar fluidDeltaT)
{
    bool found = false;

    for (cghs::exchange& e : exchanges_)
    {
        const UList<cghs::exchange::lookRound>& rounds = e.neighbourRounds();

        if (rounds.empty())
        {
            continue;
        }
        if (!found)
        {
            contacts_.findNeighbours(parcels_);
            found = true;
        }

        forAll(rounds, k)
        {
            contacts_.lend
            (
                rounds[k].shown,
                rounds[k].collected,
                &contactLog::near,
                [&](const contactList& list)
                {
                    k == 0
                  ? e.near(list, parcels_, fluidDeltaT)
                  : e.nearAgain(list, parcels_, fluidDeltaT);
                }
            );
        }
        e.wereNear(parcels_);
    }
}


void Foam::cghs::cghsCloud::evolve(const scalar deltaT)
{
    addProfiling(evolve, "cghs::evolve");

    log_ = stepLog();
    contacts_.resetLog();

    if (contacts_.needed())
    {
        contacts_.moveWalls
        (
            wallMotion_.velocities(contacts_.wallPatches())
        );
    }

    scalar remaining = deltaT;

    while (remaining > 0)
    {
        // Speeds change from one solids step to the next: so does their
        // number, seen from each
        const scalar n = ceil(remaining/solidsDeltaT() - SMALL);
        const bool last = n <= 1;

        if (!(n < 1e6))
        {
            FatalErrorInFunction
                << "The parcels' speed asks for " << n << " solids steps in "
                << remaining << " s" << nl
                << "The fastest moves by its diameter in "
                << state_.diameterTime << " s: the run has gone out of hand."
                << " Lower maxCo or maxDeltaT" << nl
                << exit(FatalError);
        }
        const scalar dt = last ? remaining : remaining/n;

        solidsStep(dt, last, deltaT);

        remaining = last ? 0 : remaining - dt;
        ++log_.nSolidsSteps;
        log_.minDeltaT = min(log_.minDeltaT, dt);
    }

    for (cghs::exchange& e : exchanges_)
    {
        e.evolve(parcels_, deltaT);
    }

    if (loads())
    {
        for (cghs::exchange& e : exchanges_)
        {
            e.leave(parcels_, deltaT);
        }
        log_.nCrowdedCells = momentum_->nCrowdedCells();
    }

    log_.nListBuilds = contacts_.nBuilds();
    log_.maxOverlap = returnReduce(contacts_.maxOverlap(), maxOp<scalar>());
    log_.correctionWork =
        returnReduce(contacts_.tally().correctionWork, sumOp<scalar>());
}

// * * * * * * * * * * * * * * * * The fluid * * * * * * * * * * * * * * * * //

void Foam::cghs::cghsCloud::meet(carrierFluid& fluid)
{
    const bool before = present_;
    present_ = !empty();
    exchanging_ = present_ || before;

    if (!exchanging_)
    {
        return;
    }

    for (cghs::exchange& e : exchanges_)
    {
        e.meet(parcels_, fluid);
    }
}


Foam::cghs::exchangeTerms
Foam::cghs::cghsCloud::terms(const word& quantity) const
{
    exchangeTerms sum;

    for (const cghs::exchange& e : exchanges_)
    {
        sum.add(e.terms(quantity));
    }

    return sum;
}


void Foam::cghs::cghsCloud::complete
(
    const carrierFluid& fluid,
    const scalar deltaT
)
{
    if (!exchanging_)
    {
        return;
    }

    for (cghs::exchange& e : exchanges_)
    {
        e.complete(parcels_, fluid, deltaT);
    }
    exchanging_ = false;
}

// * * * * * * * * * * * * * * * * Reports * * * * * * * * * * * * * * * * * //

Foam::cghs::census Foam::cghs::cghsCloud::count() const
{
    census c;

    for (label i = 0; i < parcels_.size(); ++i)
    {
        const motion& m = parcels_.motions[i];
        const scalar mass = m.mass();

        ++c.nParcels;
        c.mass += mass;
        c.volume += parcels_.volume(i);
        c.momentum += mass*m.v;
        c.massMoment += mass*parcels_.spheres[i].x;
        c.kineticEnergy += 0.5*mass*magSqr(m.v);
        c.meanVelocity += m.v;
        c.meanSquare += cmptMultiply(m.v, m.v);

        if (parcels_.spinning())
        {
            c.rotationalEnergy +=
                0.5*inertiaFactor*mass*sqr(parcels_.spheres[i].r)
               *magSqr(parcels_.spins[i]);
        }
    }

    reduce(c.nParcels, sumOp<label>());

    for (scalar* s : {&c.mass, &c.volume, &c.kineticEnergy, &c.rotationalEnergy})
    {
        reduce(*s, sumOp<scalar>());
    }

    for
    (
        vector* v
      : {&c.momentum, &c.massMoment, &c.meanVelocity, &c.meanSquare}
    )
    {
        reduce(*v, sumOp<vector>());
    }

    c.meanVelocity /= max(c.nParcels, 1);
    c.meanSquare /= max(c.nParcels, 1);

    return c;
}


Foam::scalar Foam::cghs::cghsCloud::massFed() const
{
    scalar mass = 0;
    for (const feeder& f : feeding_.feeders())
    {
        mass += f.fed();
    }
    return mass;
}


std::size_t Foam::cghs::cghsCloud::bytesPerParcel() const
{
    return
        parcels_.bytesPerParcel()
      + contacts_.bytes()/max(parcels_.size(), 1);
}


void Foam::cghs::cghsCloud::report(Ostream& os) const
{
    feeding_.report(os);

    for (const cghs::exchange& e : exchanges_)
    {
        e.report(parcels_, os);
    }
}

// * * * * * * * * * * * * * * * Input and output  * * * * * * * * * * * * * //

Foam::dictionary Foam::cghs::cghsCloud::flows() const
{
    // Patches between ranks, which differ from rank to rank, come last
    scalarField escaped
    (
        SubField<scalar>
        (
            transport_.massEscapedBy(),
            mesh_.boundaryMesh().nNonProcessor()
        )
    );
    reduce(escaped, sumOp<scalarField>());

    dictionary byPatch;
    forAll(escaped, patchi)
    {
        if (transport_.escapes(patchi))
        {
            byPatch.add(mesh_.boundaryMesh()[patchi].name(), escaped[patchi]);
        }
    }

    dictionary flows;
    flows.add("nParcels", returnReduce(parcels_.size(), sumOp<label>()));
    flows.add("massEscaped", byPatch);
    feeding_.state(flows);
    flows.add("diameterTime", state_.diameterTime);
    flows.add("contacts", contacts_.state());

    dictionary states;
    for (const cghs::exchange& e : exchanges_)
    {
        dictionary state;
        e.state(state);
        if (!state.empty())
        {
            states.add(e.type(), state);
        }
    }
    if (!states.empty())
    {
        flows.add("exchanges", states);
    }
    return flows;
}


void Foam::cghs::cghsCloud::checkCount(const dictionary& flows) const
{
    const label found = returnReduce(parcels_.size(), sumOp<label>());
    const label written = flows.getOrDefault<label>("nParcels", found);

    if (found != written)
    {
        FatalIOErrorInFunction(flows)
            << "Cloud " << name() << ": " << written << " parcels were written,"
            << " but " << found << " are found" << nl
            << "Is a folder " << mesh_.time().timeName()/cloud::prefix/name()
            << (
                   found < written
                 ? " or a file in it missing, on one of the ranks? Restore it,"
                 : " left over from another run, on one of the ranks? Remove it,"
               )
            << " or restart from an earlier time" << nl
            << "If parcels were added or taken out on purpose remove the entry"
            << " nParcels" << nl
            << exit(FatalIOError);
    }
}


void Foam::cghs::cghsCloud::setFlows(const dictionary& flows)
{
    checkCount(flows);

    const dictionary byPatch(flows.subOrEmptyDict("massEscaped"));
    scalarField escaped(mesh_.boundaryMesh().size(), Zero);

    // The master counts for all
    for (const entry& e : byPatch)
    {
        const label patchi = mesh_.boundaryMesh().findPatchID(e.keyword());

        if (Pstream::master() && patchi >= 0)
        {
            escaped[patchi] = byPatch.get<scalar>(e.keyword());
        }
    }

    transport_.setMassEscaped(escaped);
    feeding_.setState(flows);
    flows.readIfPresent("diameterTime", state_.diameterTime);
    contacts_.setState(flows.subOrEmptyDict("contacts"));

    const dictionary states(flows.subOrEmptyDict("exchanges"));
    for (cghs::exchange& e : exchanges_)
    {
        e.setState(states.subOrEmptyDict(e.type()));
    }
}


bool Foam::cghs::cghsCloud::writeObject
(
    IOstream::streamFormat fmt,
    IOstream::versionNumber ver,
    IOstream::compressionType cmp,
    const bool
) const
{
    // Between settlings parcels may be beyond their cells. Function objects too
    // may write, at any time; OpenFOAM has declared that const
    const_cast<cghsCloud&>(*this).startAfresh();

    // A restart goes on from these, whatever writePrecision is
    const allDigits precise;

    writeParcels(mesh_, name(), parcels_, fmt, ver, cmp);
    if (contacts_.remembers())
    {
        writeMemories(*this, parcels_, contacts_, ver, cmp);
    }
    writeFlows(mesh_, name(), flows());

    return true;
}


void Foam::cghs::cghsCloud::writeObjects(objectRegistry& obr) const
{
    registerParcels(parcels_, obr);
}
