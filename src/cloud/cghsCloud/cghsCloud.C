/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "cghsCloud.H"
#include "meshFreedom.H"
#include "cloudProperties.H"
#include "cloudChecks.H"
#include "parcelFiles.H"
#include "memoryFiles.H"
#include "flowState.H"
#include "checkedEntry.H"
#include "profiling.H"
#include "PstreamReduceOps.H"
#include "SubField.H"
#include "Time.H"

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
    exchanges_(subModels(), mesh, parcels_),
    transport_(mesh, properties_.subDict("boundary")),
    contacts_
    (
        std::move(contactModel_),
        wallDistance::New(subModels()),
        scalarInRange(solution(), "neighbourSkin", SMALL, 10),
        mesh,
        transport_.boundary().wallPatches(),
        periods(mesh),
        g
    ),
    wallMotion_(mesh),
    feeding_(properties_, parcels_, mesh),
    valves_
    (
        properties_.subDict("boundary"),
        mesh,
        transport_.boundary().patchesOf(parcelBoundary::action::valve)
    ),
    momentum_(nullptr),
    present_(true),
    exchanging_(false),
    warned_(false),
    slowClock_(properties_)
{
    checkEntries(properties_, parcels_);
    exchanges_.startLending(contacts_);

    if (!contacts_.needed())
    {
        transport_.startBouncing();
    }

    if (feeding_.recycling())
    {
        transport_.gone().keep();
    }
    if
    (
        coupling_ == couplingType::twoWay
     && (feeding_.needed() || !valves_.empty())
    )
    {
        parcels_.startFading();
    }

    const dictionary flows(readFlows(mesh, name));
    readAll(flows);

    if (coupling_ != couplingType::none)
    {
        enterFluid();
    }

    survey_ = transport_.survey(parcels_);
    contacts_.expect(largestSpeed());
    setFlows(flows);
}


void Foam::cghs::cghsCloud::readAll(const dictionary& flows)
{
    if (contacts_.remembers())
    {
        parcels_.add(contacts_.formerIndices());
    }

    const bool sameIds =
        readParcels
        (
            mesh_,
            name(),
            properties_.subDict("constantProperties"),
            parcels_
        );

    if (sameIds && contacts_.understands(flows.subOrEmptyDict("contacts")))
    {
        readMemories(*this, parcels_, contacts_);
    }
    checkConstants(properties_, parcels_);
    checkInventories(properties_, parcels_, mesh_);
    transport_.constrain(parcels_);
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
        transport_.boundary().plates(),
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
      ? min(maxDeltaT_, maxDisplacement_*survey_.diameterTime)
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

    survey_.crossed = false;
}


void Foam::cghs::cghsCloud::feed(const scalar deltaT)
{
    const bool consumed = exchanges_.consumes();

    if (valves_.empty() && !feeding_.needed() && !consumed)
    {
        return;
    }

    addProfiling(feed, "cghs::feed");

    labelList exits(valves_.findLeaving(parcels_, deltaT, g_));
    if (consumed)
    {
        exchanges_.markGone(parcels_, exits, transport::nowhere);
    }
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

        survey_ = transport_.survey(parcels_);
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
    if (contacts_.needed() ? contacts_.stale() : survey_.crossed)
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
        if (exchanges_.kick(parcels_, half))
        {
            contacts_.resized(0);
        }
    }

    contacts_.impacts(parcels_, deltaT);

    {
        addProfiling(suspension, "cghs::suspension");

        if (!momentum_)
        {
            fall(half);
        }
        if (exchanges_.kickAgain(parcels_, half))
        {
            contacts_.resized(0);
        }
    }

    contacts_.correct(parcels_, deltaT);

    {
        addProfiling(suspension, "cghs::suspension");

        exchanges_.settle(parcels_, half, last, fluidDeltaT);
    }

    exchanges_.lendContacts(contacts_, parcels_, deltaT);
    if (last)
    {
        exchanges_.lendNeighbours(contacts_, parcels_, fluidDeltaT);
    }

    survey_ = transport_.move(parcels_, deltaT);
    contacts_.moved(survey_.maxDistance, deltaT);
}


void Foam::cghs::cghsCloud::checkSteps
(
    const scalar n,
    const scalar remaining
) const
{
    if (!(n < 1e6))
    {
        FatalErrorInFunction
            << "The parcels' speed asks for " << n << " solids steps in "
            << remaining << " s" << nl
            << "The fastest moves by its diameter in "
            << survey_.diameterTime << " s: the run has gone out of hand."
            << " Lower maxCo or maxDeltaT" << nl
            << exit(FatalError);
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

    // Where there is no parcel one solids step is as good as many
    const bool nobody = empty();
    scalar remaining = deltaT;

    while (remaining > 0)
    {
        // Speeds change from one solids step to the next: so does their
        // number, seen from each
        const scalar n =
            nobody ? 1 : ceil(remaining/solidsDeltaT() - SMALL);
        const bool last = n <= 1;

        checkSteps(n, remaining);

        const scalar dt = last ? remaining : remaining/n;

        solidsStep(dt, last, deltaT);

        remaining = last ? 0 : remaining - dt;
        ++log_.nSolidsSteps;
        log_.minDeltaT = min(log_.minDeltaT, dt);
    }

    exchanges_.evolve(parcels_, deltaT);

    if (exchanges_.growth() >= 0)
    {
        contacts_.resized(exchanges_.growth());
    }
    if (isFelt())
    {
        exchanges_.leave(parcels_, deltaT);
        log_.nCrowdedCells = momentum_->nCrowdedCells();
    }

    log_.nListBuilds = contacts_.nBuilds();
    log_.overlaps = contacts_.overlaps();
    log_.overlaps.gather();
    log_.correctionWork =
        returnReduce(contacts_.tally().correctionWork, sumOp<scalar>());
    warnOfOverlaps();
}


void Foam::cghs::cghsCloud::warnOfOverlaps()
{
    const scalar muchOverlap = 0.01;    // of d, mean
    const scalar muchFall = 0.05;       // g dt^2, of d
    const scalar goodFall = 0.02;

    if (warned_ || log_.overlaps.mean() < muchOverlap)
    {
        return;
    }

    const scalar d = log_.overlaps.diameter();
    const scalar fall = mag(g_)*sqr(log_.minDeltaT)/d;
    if (fall > muchFall)
    {
        warned_ = true;
        WarningInFunction
            << "Parcels that touch overlap by " << 100*log_.overlaps.mean()
            << " % of d in the mean, " << 100*log_.overlaps.largest()
            << " % at most" << nl
            << "    Gravity alone moves those at rest by " << 100*fall
            << " % in a solids step of " << log_.minDeltaT << " s" << nl
            << "    Lower maxDeltaT in solution of " << name()
            << "Properties, to " << std::sqrt(goodFall*d/mag(g_))
            << " s for " << 100*goodFall << " %" << nl << endl;
    }
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

    exchanges_.meet(parcels_, fluid);
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

    exchanges_.complete(parcels_, fluid, deltaT);
    exchanging_ = false;
}

// * * * * * * * * * * * * * * * * Reports * * * * * * * * * * * * * * * * * //

Foam::scalar Foam::cghs::cghsCloud::massFed() const
{
    scalar mass = 0;
    for (const feeder& f : feeding_.feeders())
    {
        mass += f.fed();
    }
    return mass;
}


Foam::List<Foam::cghs::figure> Foam::cghs::cghsCloud::errors() const
{
    return exchanges_.errors();
}


std::size_t Foam::cghs::cghsCloud::bytesPerParcel() const
{
    return
        parcels_.bytesPerParcel()
      + contacts_.bytes()/max(parcels_.size(), 1);
}


void Foam::cghs::cghsCloud::report(Ostream& os) const
{
    slowClock_.report(mesh_.time().value(), os);
    feeding_.report(os);
    exchanges_.report(parcels_, os);

    if (debug)
    {
        os  << "memory: " << label(bytesPerParcel()) << " bytes a parcel, "
            << label(parcels_.bytesPerParcel()) << " of them in columns" << nl;
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
            transport_.gone().massBy(),
            mesh_.boundaryMesh().nNonProcessor()
        )
    );
    reduce(escaped, sumOp<scalarField>());

    dictionary byPatch;
    forAll(escaped, patchi)
    {
        if (transport_.boundary().escapes(patchi))
        {
            byPatch.add(mesh_.boundaryMesh()[patchi].name(), escaped[patchi]);
        }
    }

    dictionary flows;
    flows.add("nParcels", returnReduce(parcels_.size(), sumOp<label>()));
    flows.add("massEscaped", byPatch);
    feeding_.state(flows);
    flows.add("diameterTime", survey_.diameterTime);
    flows.add("contacts", contacts_.state());

    const dictionary states(exchanges_.state());
    if (!states.empty())
    {
        flows.add("exchanges", states);
    }
    return flows;
}


void Foam::cghs::cghsCloud::setFlows(const dictionary& flows)
{
    checkCount(flows, parcels_, mesh_, name());

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

    transport_.gone().setMass(escaped);
    feeding_.setState(flows);
    flows.readIfPresent("diameterTime", survey_.diameterTime);
    contacts_.setState(flows.subOrEmptyDict("contacts"));

    exchanges_.setState(flows.subOrEmptyDict("exchanges"));
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
