/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "feeder.H"
#include "integral.H"
#include "knownEntries.H"
#include "checkedEntry.H"
#include "meshNames.H"
#include "Hasher.H"

const Foam::Enum<Foam::cghs::feeder::shortageType>
Foam::cghs::feeder::shortageNames
({
    { shortageType::makeUp, "makeUp" },
    { shortageType::refuse, "refuse" }
});

namespace Foam
{
namespace cghs
{
    //- Places suggested for each parcel that is due
    constexpr label nTries = 30;

    //- Numbers of a departure in a state, before those of its properties
    constexpr label nNumbers = 5;

    //- More parcels owed than this are warned of
    constexpr label manyParcels = 10;
}
}

// * * * * * * * * * * * * * * * Construction  * * * * * * * * * * * * * * * //

namespace Foam
{
namespace cghs
{

//- The feeder's entries, and the constantProperties that it does not have
static dictionary freshEntries
(
    const dictionary& dict,
    const dictionary& cloudProperties
)
{
    dictionary all(dict);
    all |= cloudProperties.subDict("constantProperties");
    return all;
}

}
}


void Foam::cghs::feeder::checkEntries(const arena& parcels) const
{
    wordList known
    ({
        "feedPlace", "massFlowRate", "recycle", "shortage", "diameter",
        "density", "parcelWeight", "sizeDistribution", "typeId", "seed"
    });
    known.append(parcels.entryNames());
    warnUnknownEntries(dict_, known);

    // Asked for where there is one material, too
    parcels.materials.check(fresh_);

    for (const property* p : parcels.properties())
    {
        p->check(fresh_);
    }
}


void Foam::cghs::feeder::readSupply(const polyMesh& mesh)
{
    if (dict_.found("massFlowRate") == dict_.found("recycle"))
    {
        FatalIOErrorInFunction(dict_)
            << "Feeder " << name_ << " needs one of the entries massFlowRate"
            << " and recycle" << nl
            << exit(FatalIOError);
    }

    if (dict_.found("massFlowRate"))
    {
        massFlowRate_ = Function1<scalar>::New("massFlowRate", dict_);
        sizes_.reset(new particleSizes(dict_, particle_, random_));
        return;
    }

    recycles_.resize(mesh.boundaryMesh().size(), false);

    for (const word& name : dict_.get<wordList>("recycle"))
    {
        recycles_[patchNamed(name, "recycle", dict_, mesh)] = true;
    }
}


Foam::cghs::feeder::feeder
(
    const word& name,
    const dictionary& dict,
    const dictionary& cloudProperties,
    const arena& parcels,
    const polyMesh& mesh
)
:
    name_(name),
    dict_(dict),
    particle_(cloudProperties, dict_),
    fresh_(freshEntries(dict_, cloudProperties)),
    seed_(dict.getOrDefault<label>("seed", 1)),
    random_(seed_),
    place_(feedPlace::New(dict_, mesh)),
    massFlowRate_(),
    recycles_(),
    sizes_(),
    shortage_(shortageNames.get("shortage", dict)),
    waiting_(),
    nSteps_(0),
    due_(0),
    fed_(0),
    refused_(0),
    nFed_(0),
    fits_(false),
    warned_(false),
    clock_(cloudProperties)
{
    checkEntries(parcels);
    readSupply(mesh);
}


Foam::scalar Foam::cghs::feeder::largestDiameter() const
{
    return
        recycling()
      ? 0
      : 2*arena::radiusOf(sizes_->largest(), particle_.weight);
}

// * * * * * * * * * * * * * * * * The line  * * * * * * * * * * * * * * * * //

void Foam::cghs::feeder::take(const departure& parcel)
{
    due_ += parcel.mass();
    waiting_.append(parcel);
}


void Foam::cghs::feeder::drawWaiting()
{
    scalar inLine = 0;
    for (const departure& parcel : waiting_)
    {
        inLine += parcel.mass();
    }

    // The one that is not due yet stays in the line: to draw it again would
    // favour the small
    while (inLine <= owed())
    {
        waiting_.append
        (
            departure
            {
                sizes_->draw(),
                particle_.weight,
                particle_.density,
                -1,
                -1,
                scalarList()
            }
        );
        inLine += waiting_.last().mass();
    }
}


Foam::label Foam::cghs::feeder::nDue() const
{
    if (recycling())
    {
        return waiting_.size();
    }

    scalar inLine = 0;
    label n = 0;

    while (n < waiting_.size() && (inLine += waiting_[n].mass()) <= owed())
    {
        ++n;
    }

    return n;
}

// * * * * * * * * * * * * * * * * The checks  * * * * * * * * * * * * * * * //

void Foam::cghs::feeder::checkRate(const scalar rate) const
{
    const scalar largest = place_->largestRate(particle_.density);

    if (!(rate >= 0))
    {
        FatalIOErrorInFunction(dict_)
            << "Entry massFlowRate of " << name_ << " is " << rate
            << " kg/s but must not be negative" << nl
            << "Parcels leave by the entries of boundary" << nl
            << exit(FatalIOError);
    }

    if (rate > largest)
    {
        FatalIOErrorInFunction(place_->dict())
            << "Feeder " << name_ << " is to feed " << rate
            << " kg/s, but there is room for no more than " << largest
            << " kg/s" << nl
            << "Raise the speed by " << rate/largest
            << " times at least, widen the patch or lower massFlowRate"
            << (clock_.runs() ? " or the factor of slowClock" : "") << nl
            << exit(FatalIOError);
    }
}


void Foam::cghs::feeder::checkFits(transport& cells, contactStage& contacts)
{
    constexpr label nTrials = 1000;

    const departure& parcel = waiting_[0];
    const scalar r = arena::radiusOf(parcel.d, parcel.weight);
    label nInside = 0;
    bool fits = false;

    for (label trial = 0; trial < nTrials; ++trial)
    {
        const feedPlace::entrance e(place_->suggest(random_, r, 0, cells));

        if (e.cell != -1)
        {
            ++nInside;
            fits = fits || !contacts.touchesWall(sphere(e.x, r));
        }
    }

    fits_ = returnReduce(fits, orOp<bool>());

    if (!fits_)
    {
        reduce(nInside, sumOp<label>());
        refusePlace(r, nTrials, nInside);
    }
}


void Foam::cghs::feeder::refusePlace
(
    const scalar r,
    const label nTrials,
    const label nInside
) const
{
    FatalIOErrorInFunction(place_->dict())
        << "A parcel of " << 2*r << " m does not fit into the place where "
        << name_ << " feeds. Of " << nTrials << " centres within "
        << place_->centres(r, 0) << nl;

    if (nInside < nTrials)
    {
        FatalIOError << nTrials - nInside << " are outside the mesh" << nl;
    }
    if (nInside)
    {
        FatalIOError
            << nInside << " are nearer than " << r << " m to a patch that parcels"
            << " touch" << nl;
    }

    FatalIOError
        << (nInside ? "Widen the place" : "Move the place into the mesh")
        << " or lower parcelWeight" << nl
        << exit(FatalIOError);
}


void Foam::cghs::feeder::warnOnce(const scalar missing)
{
    if (!warned_ && waiting_.size() && missing > manyParcels*waiting_[0].mass())
    {
        warned_ = true;
        WarningInFunction
            << "Feeder " << name_ << " finds no room for " << missing
            << " kg of " << due_ << " kg due: they "
            << (
                   shortage_ == shortageType::makeUp
                 ? "come in when there is room"
                 : "are refused"
               )
            << ". Is the bed in front of it packed, or the speed too low?"
            << " Said once; see the line feeding of each step" << endl;
    }
}

// * * * * * * * * * * * * * * * * The step  * * * * * * * * * * * * * * * * //

void Foam::cghs::feeder::startStep(const label purpose)
{
    // Random numbers of a step do not depend on what came before, so that a
    // restart goes on with the same
    const FixedList<label, 3> key({seed_, nSteps_, purpose});

    random_.reset(label(Hasher(key.cdata(), sizeof(key)) >> 1));
}


Foam::label Foam::cghs::feeder::lineUp(const scalar time, const scalar deltaT)
{
    // Not all of a long line are worth the search in each step
    constexpr label nAtLeast = 16;

    scalar dueNow = 0;

    if (!recycling())
    {
        dueNow =
            integral
            (
                [&](const scalar t) { return massFlowRate_->value(t); },
                clock_.at(time - deltaT),
                clock_.at(time)
            );
        checkRate(dueNow/deltaT);
        due_ += dueNow;
        drawWaiting();
    }

    const label n = nDue();

    return
        n > 0
      ? min(n, nAtLeast + 2*label(dueNow/waiting_[0].mass()))
      : 0;
}


void Foam::cghs::feeder::findPlaces
(
    const label n,
    const scalar deltaT,
    transport& cells,
    vacancies& room,
    DynamicList<arrival>& arrivals
)
{
    List<vacancies::suggestion> suggestions(n*nTries);
    List<vector> velocities(n*nTries);
    scalar largest = 0;

    forAll(suggestions, t)
    {
        const departure& parcel = waiting_[t/nTries];
        const scalar r = arena::radiusOf(parcel.d, parcel.weight);
        const feedPlace::entrance e
        (
            place_->suggest(random_, r, deltaT, cells)
        );

        suggestions[t] = vacancies::suggestion{sphere(e.x, r), e.cell};
        velocities[t] = e.v;
        largest = max(largest, r);
    }

    boundBox box(place_->centres(largest, deltaT));
    box.min() -= vector::uniform(largest);
    box.max() += vector::uniform(largest);

    const labelField owners(room.owners(suggestions, box));
    label parcel = 0;

    forAll(suggestions, t)
    {
        const vacancies::suggestion& it = suggestions[t];

        if
        (
            t/nTries >= parcel
         && owners[t] != -1
         && room.freeOfAccepted(it.s)
        )
        {
            // On to the next parcel: the others of this one's are not needed
            parcel = t/nTries + 1;
            room.accept(it.s);
            arrivals.append
            (
                arrival
                {
                    waiting_[t/nTries], it.s.x, velocities[t], owners[t],
                    it.cell, &fresh_
                }
            );
        }
    }
}


void Foam::cghs::feeder::feed
(
    const scalar time,
    const scalar deltaT,
    transport& cells,
    contactStage& contacts,
    vacancies& room,
    DynamicList<arrival>& arrivals
)
{
    startStep(0);
    const label n = lineUp(time, deltaT);

    if (!fits_ && waiting_.size())
    {
        startStep(1);
        checkFits(cells, contacts);
    }

    startStep(2);
    const label first = arrivals.size();
    if (n > 0)
    {
        findPlaces(n, deltaT, cells, room, arrivals);
    }

    nFed_ = arrivals.size() - first;
    leaveLine(SubList<arrival>(arrivals, nFed_, first));

    if (shortage_ == shortageType::refuse)
    {
        refuse();
    }

    warnOnce(owed() + refused_);
    ++nSteps_;
}


void Foam::cghs::feeder::leaveLine(const UList<arrival>& arrivals)
{
    // Those that arrived are in the order of the line
    DynamicList<departure> left;
    label next = 0;

    for (const departure& parcel : waiting_)
    {
        if (next < arrivals.size() && !(parcel != arrivals[next].parcel))
        {
            fed_ += parcel.mass();
            ++next;
        }
        else
        {
            left.append(parcel);
        }
    }

    waiting_.transfer(left);
}


void Foam::cghs::feeder::refuse()
{
    for (label n = nDue(); n > 0; --n)
    {
        refused_ += waiting_[0].mass();
        waiting_.remove(0);
    }
}


void Foam::cghs::feeder::report(Ostream& os) const
{
    os  << "feeding " << name_ << ": " << nFed_ << " parcels now, "
        << fed_ << " kg of " << due_ << " kg due so far, " << owed()
        << " kg owed, " << refused_ << " kg refused" << nl;
}

// * * * * * * * * * * * * * * * * The state * * * * * * * * * * * * * * * * //

Foam::dictionary Foam::cghs::feeder::state() const
{
    List<scalarList> numbers(waiting_.size());

    forAll(waiting_, k)
    {
        const departure& parcel = waiting_[k];

        numbers[k] =
            scalarList
            ({
                parcel.d, parcel.weight, parcel.density, scalar(parcel.id),
                scalar(parcel.patch)
            });
        numbers[k].append(parcel.row);
    }

    dictionary state;
    state.add("steps", nSteps_);
    state.add("due", due_);
    state.add("fed", fed_);
    state.add("refused", refused_);
    state.add("waiting", numbers);
    return state;
}


void Foam::cghs::feeder::setState(const dictionary& state)
{
    state.readEntry("steps", nSteps_);
    state.readEntry("due", due_);
    state.readEntry("fed", fed_);
    state.readEntry("refused", refused_);

    waiting_.clear();

    for (const scalarList& x : state.get<List<scalarList>>("waiting"))
    {
        waiting_.append
        (
            departure
            {
                x[0], x[1], x[2], label(x[3]), label(x[4]),
                SubList<scalar>(x, x.size() - nNumbers, nNumbers)
            }
        );
    }
}
