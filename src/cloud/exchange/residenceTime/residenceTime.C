/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "residenceTime.H"
#include "fvMesh.H"
#include "knownEntries.H"
#include "PstreamReduceOps.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(residenceTime, 0);
    addToRunTimeSelectionTable(exchange, residenceTime, dictionary);
    describeModel
    (
        exchange,
        residenceTime,
        "how long a parcel has been in the mesh"
    );
}
}

const Foam::Enum<Foam::cghs::residenceTime::recycledType>
Foam::cghs::residenceTime::recycledNames
({
    { recycledType::afresh, "afresh" },
    { recycledType::goOn, "goOn" }
});


Foam::cghs::residenceTime::residenceTime
(
    const dictionary& dict,
    const fvMesh& mesh
)
:
    time_(mesh.time()),
    clock_(dict.topDict()),
    ages_("age"),
    massGone_(0),
    ageGone_(0),
    allGone_(0),
    allAgeGone_(0),
    mean_(0),
    oldest_(0),
    outflow_(0)
{
    warnUnknownEntries(dict, wordList({"recycled"}));

    ages_.allow(0, GREAT).readFrom("age");

    const recycledType recycled =
        recycledNames.getOrDefault("recycled", dict, recycledType::afresh);

    if (recycled == recycledType::afresh)
    {
        ages_.forget();
    }
}


void Foam::cghs::residenceTime::addColumns(arena& parcels)
{
    parcels.add(ages_);
    parcels.keep(*this);
}


void Foam::cghs::residenceTime::noteOut
(
    const arena& parcels,
    const label i,
    const label
)
{
    const scalar m = parcels.motions[i].mass();

    massGone_ += m;
    ageGone_ += m*ages_[i];
}


void Foam::cghs::residenceTime::countGone(const scalar deltaT)
{
    const scalar mass = returnReduce(massGone_, sumOp<scalar>());

    outflow_ = mass/max(deltaT, VSMALL);
    allGone_ += mass;
    allAgeGone_ += returnReduce(ageGone_, sumOp<scalar>());

    massGone_ = 0;
    ageGone_ = 0;
}


void Foam::cghs::residenceTime::evolve(arena& parcels, const scalar deltaT)
{
    scalar mass = 0;
    scalar sum = 0;
    oldest_ = 0;
    const scalar older = clock_.passed(time_.value(), deltaT);

    for (label i = 0; i < parcels.size(); ++i)
    {
        ages_[i] += older;

        const scalar m = parcels.motions[i].mass();
        mass += m;
        sum += m*ages_[i];
        oldest_ = max(oldest_, ages_[i]);
    }
    reduce(mass, sumOp<scalar>());
    reduce(sum, sumOp<scalar>());
    reduce(oldest_, maxOp<scalar>());

    mean_ = sum/max(mass, VSMALL);
    countGone(deltaT);
}

// * * * * * * * * * * * * * * * Reports, state  * * * * * * * * * * * * * * //

void Foam::cghs::residenceTime::state(dictionary& state) const
{
    // Parcels that are taken out before they are written count in the next step
    state.add("massGone", returnReduce(massGone_, sumOp<scalar>()));
    state.add("ageGone", returnReduce(ageGone_, sumOp<scalar>()));
    state.add("allGone", allGone_);
    state.add("allAgeGone", allAgeGone_);
}


void Foam::cghs::residenceTime::setState(const dictionary& state)
{
    const bool counts = Pstream::master();

    massGone_ = counts ? state.getOrDefault<scalar>("massGone", 0) : 0;
    ageGone_ = counts ? state.getOrDefault<scalar>("ageGone", 0) : 0;
    allGone_ = state.getOrDefault<scalar>("allGone", 0);
    allAgeGone_ = state.getOrDefault<scalar>("allAgeGone", 0);
}


Foam::List<Foam::cghs::figure> Foam::cghs::residenceTime::figures() const
{
    return List<figure>
    ({
        {"mean", mean_},
        {"oldest", oldest_},
        {"outflow", outflow_},
        {"leaving", leaving()}
    });
}


void Foam::cghs::residenceTime::report(const arena&, Ostream& os) const
{
    os  << "residenceTime: mean age " << mean_ << " s, oldest " << oldest_
        << " s, of what leaves " << leaving() << " s" << nl;
}
