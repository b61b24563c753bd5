/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "accumulatedImpulse.H"
#include "checkedEntry.H"
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
        contact& c,
        bodies& b,
        const scalar me,
        const scalar rDeltaT
    )
    {
        // A gap may close in the step
        const scalar vn = partingSpeed(c, b);
        const scalar target = min(c.overlap, scalar(0))*rDeltaT;
        const scalar change = max(me*(target - vn), -c.load);

        if (change == 0)
        {
            return 0;
        }

        push(c, b, change*c.n);
        c.load += change;

        return change*(vn + 0.5*change/me);
    }


    //- Bring the slip to zero, if friction can
    static inline void hold
    (
        contact& c,
        bodies& b,
        const scalar mu,
        const scalar me
    )
    {
        const scalar lever = leverOf(c, b);
        const scalar mt = me/(1 + sqr(lever)/inertiaFactor);

        vector rubbing(c.rubbing - mt*slipVelocity(c, b, lever));

        const scalar limit = mu*c.load;
        const scalar size = mag(rubbing);

        if (size > limit)
        {
            rubbing *= limit/size;
        }

        const vector change(rubbing - c.rubbing);
        push(c, b, change);
        turn(c, b, lever, change);
        c.rubbing = rubbing;
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
    UList<contact>& contacts,
    bodies& b,
    const stepScales& step
) const
{
    for (contact& c : contacts)
    {
        if (c.load > 0)
        {
            const scalar trusted =
                growth*c.held + effectiveMass(c, b)*step.speed;

            if (c.load > trusted)
            {
                c.rubbing *= trusted/c.load;
                c.load = trusted;
            }

            // The plane of the contact has turned a little since
            c.rubbing -= (c.rubbing & c.n)*c.n;

            push(c, b, c.load*c.n + c.rubbing);

            if (b.spinning())
            {
                turn(c, b, leverOf(c, b), c.rubbing);
            }
        }
        c.held = c.load;
    }
}


Foam::scalar Foam::cghs::accumulatedImpulse::sweepVelocities
(
    UList<contact>& contacts,
    bodies& b,
    const impactTable& coeffs,
    const scalar rDeltaT,
    const bool backwards
) const
{
    const label n = contacts.size();
    scalar work = 0;

    for (label i = 0; i < n; ++i)
    {
        contact& c = contacts[backwards ? n - 1 - i : i];
        const scalar me = effectiveMass(c, b);
        const scalar mu = coeffs[c.surface].mu;

        work += press(c, b, me, rDeltaT);

        if (mu > 0 && (c.load > 0 || magSqr(c.rubbing) > 0))
        {
            hold(c, b, mu, me);
        }
    }

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
    UList<contact>& contacts,
    bodies& b,
    const impactTable& coeffs,
    const stepScales& step
) const
{
    if (sweepi < nSweeps_)
    {
        return sweepVelocities(contacts, b, coeffs, 1/step.deltaT, sweepi % 2);
    }

    sweepPositions(contacts, b, step.deltaT);
    return 0;
}
