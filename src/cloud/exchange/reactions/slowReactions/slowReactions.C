/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "slowReactions.H"
#include "FlatOutput.H"
#include "PstreamReduceOps.H"

const Foam::Enum<Foam::cghs::slowReactions::exposureType>
Foam::cghs::slowReactions::exposureNames
({
    { exposureType::own, "own" },
    { exposureType::mean, "mean" }
});

namespace Foam
{
namespace cghs
{
    //- Changes of a parcel in a step that are warned of, over its mass
    static const scalar muchInAStep = 0.01;
}
}

// * * * * * * * * * * * * * * * Construction  * * * * * * * * * * * * * * * //

Foam::label Foam::cghs::slowReactions::indexOf(const word& reaction) const
{
    DynamicList<word> names;

    for (const cghs::reaction& r : scheme_.inParticles())
    {
        names.append(r.name());
    }

    const label r = names.find(reaction);
    if (r < 0)
    {
        FatalIOErrorInFunction(clock_.dict())
            << "Entry reactions names " << reaction
            << ", which is no reaction in particles" << nl
            << "Valid choices: " << flatOutput(names) << nl
            << exit(FatalIOError);
    }
    return r;
}


Foam::cghs::slowReactions::slowReactions
(
    const dictionary& cloudProperties,
    const reactionScheme& scheme
)
:
    scheme_(scheme),
    clock_(cloudProperties),
    slow_(),
    exposure_(exposureType::own),
    more_(0),
    met_(scheme.fluid().size() + 3, 0),
    ahead_(scheme.solids().size(), 0),
    largest_(0),
    warned_(false)
{
    for (const word& name : clock_.reactions())
    {
        slow_.append(indexOf(name));
    }
    if (slow_.size())
    {
        exposure_ = exposureNames.get("exposure", clock_.dict());
    }
}

// * * * * * * * * * * * * * * * * The step  * * * * * * * * * * * * * * * * //

void Foam::cghs::slowReactions::start(const scalar time, const scalar deltaT)
{
    more_ = clock_.passed(time, deltaT)/deltaT - 1;
    met_ = 0;
    ahead_ = 0;
    largest_ = 0;
}


void Foam::cghs::slowReactions::take
(
    UList<scalar>& amounts,
    const label r,
    const scalar extent
)
{
    const substances& solids = scheme_.solids();
    const scalarField& gain = scheme_.inParticles()[r].equation().solidGain();
    const scalar mass = solids.massOf(amounts);

    forAll(gain, s)
    {
        const scalar change = gain[s]*extent;

        if (!(amounts[s] + change >= 0))
        {
            FatalErrorInFunction
                << "In a step of the slowClock, " << 1 + more_
                << " times that of the flow, the reaction "
                << scheme_.inParticles()[r].name() << " would take "
                << -change << " mol of " << solids[s].name()
                << " from a parcel that has " << amounts[s] << nl
                << "Lower factor of slowClock, or the step of the flow"
                << nl << exit(FatalError);
        }

        amounts[s] += change;
        ahead_[s] += change*solids[s].M();
        largest_ = max(largest_, mag(change)*solids[s].M()/max(mass, VSMALL));
    }
}


void Foam::cghs::slowReactions::follow
(
    const reactingCell& cell,
    const label j,
    UList<scalar>& amounts
)
{
    if (!goesOn() || exposure_ != exposureType::own)
    {
        return;
    }
    for (const label r : slow_)
    {
        take(amounts, r, more_*cell.extent(j, r));
    }
}

// * * * * * * * * * * * * * * * Mean exposure * * * * * * * * * * * * * * * //

void Foam::cghs::slowReactions::meet
(
    const UList<scalar>& fluid,
    const scalar volume,
    const scalar T,
    const scalar p,
    const scalar mass
)
{
    const label n = fluid.size();

    for (label k = 0; k < n; ++k)
    {
        met_[k] += mass*fluid[k]/max(volume, VSMALL);
    }
    met_[n] += mass*T;
    met_[n + 1] += mass*p;
    met_[n + 2] += mass;
}


bool Foam::cghs::slowReactions::startMean(reactingCell& cell)
{
    if (!goesOn() || exposure_ != exposureType::mean)
    {
        return false;
    }
    reduce(met_, sumOp<scalarField>());

    if (!(met_.last() > 0))
    {
        return false;
    }
    const scalarField mean(met_/met_.last());
    const label n = met_.size() - 3;

    // A cubic metre of it
    cell.start(SubList<scalar>(mean, n), mean[n], mean[n + 1], 1);
    return true;
}


void Foam::cghs::slowReactions::share
(
    reactingCell& cell,
    const UList<label>& which,
    const UList<scalar>& extents,
    scalarField& bodies,
    const label width,
    const label place
)
{
    for (const label r : slow_)
    {
        const scalarField rates(cell.speeds(r));
        const scalar all = returnReduce(sum(rates), sumOp<scalar>());
        const scalar done = returnReduce(extents[r], sumOp<scalar>());

        if (done != 0 && all == 0)
        {
            FatalErrorInFunction
                << "Reaction " << scheme_.inParticles()[r].name()
                << " has gone by " << done << " mol in parcels, but by none in"
                << " the mean of the fluid that they met" << nl
                << "Write exposure own in slowClock" << nl
                << exit(FatalError);
        }

        forAll(which, j)
        {
            SubList<scalar> amounts
            (
                bodies, scheme_.solids().size(), which[j]*width + place
            );
            take(amounts, r, all == 0 ? 0 : more_*done*rates[j]/all);
        }
    }
}

// * * * * * * * * * * * * * * * * Reports * * * * * * * * * * * * * * * * * //

void Foam::cghs::slowReactions::close(const scalar deltaT)
{
    if (slow_.empty())
    {
        return;
    }
    reduce(ahead_, sumOp<scalarField>());
    reduce(largest_, maxOp<scalar>());

    if (!warned_ && largest_ > muchInAStep)
    {
        warned_ = true;
        WarningInFunction
            << "The slowClock changes a parcel by " << 100*largest_
            << " % of its mass in a step of " << deltaT << " s, "
            << (1 + more_)*deltaT << " s of slow time" << nl
            << "    Lower its factor, or the step, and compare; this is said"
            << " once" << nl << endl;
    }
}
