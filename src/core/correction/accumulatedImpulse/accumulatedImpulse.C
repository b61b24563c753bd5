/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "accumulatedImpulse.H"
#include "checkedEntry.H"
#include "interleave.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(accumulatedImpulse, 0);
    addToRunTimeSelectionTable(correctionModel, accumulatedImpulse, dictionary);


    //- How fast a contact is believed to take up load from step to step: what
    //  comes at once is a blow that will not come again
    constexpr scalar growth = 1.2;


    //- Bring the parting speed to zero, if the load can. Returns the work [J]
    static inline scalar press
    (
        const contact& c,
        contactMemory& memory,
        bodies& b,
        const scalar me,
        const scalar rDeltaT
    )
    {
        // A gap may close in the step
        const scalar vn = partingSpeed(c, b);
        const scalar target = min(c.overlap, scalar(0))*rDeltaT;
        const scalar change = max(me*(target - vn), -memory.load);

        if (change == 0)
        {
            return 0;
        }

        push(c, b, change*c.n);
        memory.load += change;

        return change*(vn + 0.5*change/me);
    }


    //- Bring the slip to zero, if friction can
    static inline void hold
    (
        const contact& c,
        contactMemory& memory,
        bodies& b,
        const scalar mu,
        const scalar me
    )
    {
        const scalar lever = leverOf(c, b);
        const scalar mt = me/(1 + sqr(lever)/inertiaFactor);

        vector rubbing(memory.rubbing - mt*slipVelocity(c, b, lever));

        const scalar limit = mu*memory.load;
        const scalar size = mag(rubbing);

        if (size > limit)
        {
            rubbing *= limit/size;
        }

        const vector change(rubbing - memory.rubbing);
        push(c, b, change);
        turn(c, b, lever, change);
        memory.rubbing = rubbing;
    }
}
}


Foam::cghs::accumulatedImpulse::accumulatedImpulse(const dictionary& dict)
:
    nSweeps_(labelFrom(dict, "nSweeps", 1)),
    overlapShare_(scalarInRange(dict, "overlapShare", 0, 1)),
    overlapAllowed_(scalarInRange(dict, "overlapAllowed", 0, 0.1)),
    restingSteps_(scalarInRange(dict, "restingSteps", 0, GREAT))
{}


void Foam::cghs::accumulatedImpulse::begin
(
    contactList& list,
    bodies& b,
    const stepScales& step
) const
{
    // A force that lasts passes on an impulse in proportion to the step
    const scalar longer =
        step.previousDeltaT > 0 ? step.deltaT/step.previousDeltaT : 1;

    forAll(list.contacts, i)
    {
        const contact& c = list.contacts[i];
        contactMemory& memory = list.memories[i];

        if (memory.load > 0)
        {
            memory.load *= longer;
            memory.held *= longer;
            memory.rubbing *= longer;

            const scalar trusted =
                growth*memory.held + effectiveMass(c, b)*step.speed;

            if (memory.load > trusted)
            {
                memory.rubbing *= trusted/memory.load;
                memory.load = trusted;
            }

            // The plane of the contact has turned a little since
            memory.rubbing -= (memory.rubbing & c.n)*c.n;

            push(c, b, memory.load*c.n + memory.rubbing);

            if (b.spinning())
            {
                turn(c, b, leverOf(c, b), memory.rubbing);
            }
        }
        memory.held = memory.load;
    }
}


Foam::scalar Foam::cghs::accumulatedImpulse::sweepVelocities
(
    contactList& list,
    bodies& b,
    const impactTable& coeffs,
    const scalar rDeltaT,
    const bool backwards
) const
{
    scalar work = 0;

    interleave(list.contacts.size(), backwards, [&](const label i)
    {
        const contact& c = list.contacts[i];
        contactMemory& memory = list.memories[i];
        const scalar me = effectiveMass(c, b);
        const scalar mu = coeffs[c.surface].mu;

        work += press(c, memory, b, me, rDeltaT);

        if (mu > 0 && (memory.load > 0 || magSqr(memory.rubbing) > 0))
        {
            hold(c, memory, b, mu, me);
        }
    });

    return work;
}


void Foam::cghs::accumulatedImpulse::sweepPositions
(
    const UList<contact>& contacts,
    bodies& b,
    const scalar deltaT
) const
{
    for (const contact& c : contacts)
    {
        const scalar ra = b.spheres[c.a].r;
        const scalar rb = b.spheres[c.b].r;
        const scalar smaller = 2*(rb > 0 ? min(ra, rb) : ra);

        // What is left after the shifts so far, and after the bodies have
        // parted by themselves
        const scalar overlap =
            c.overlap
          - ((b.shifts[c.b] - b.shifts[c.a]) & c.n)
          - max(partingSpeed(c, b), scalar(0))*deltaT;

        const scalar excess = overlap - overlapAllowed_*smaller;

        if (excess > 0)
        {
            const vector s
            (
                (overlapShare_*excess*effectiveMass(c, b))*c.n
            );

            b.shifts[c.a] -= b.motions[c.a].invMass*s;
            b.shifts[c.b] += b.motions[c.b].invMass*s;
        }
    }
}


Foam::scalar Foam::cghs::accumulatedImpulse::sweep
(
    const label sweepi,
    contactList& list,
    bodies& b,
    const impactTable& coeffs,
    const stepScales& step
) const
{
    if (sweepi < nSweeps_)
    {
        return sweepVelocities(list, b, coeffs, 1/step.deltaT, sweepi % 2);
    }

    sweepPositions(list.contacts, b, step.deltaT);
    return 0;
}
