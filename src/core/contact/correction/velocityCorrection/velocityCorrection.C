/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "velocityCorrection.H"
#include "hardSphereImpulse.H"
#include "frictionEntries.H"
#include "knownEntries.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(velocityCorrection, 0);
    addToRunTimeSelectionTable(correctionModel, velocityCorrection, dictionary);
    describeModel
    (
        correctionModel,
        velocityCorrection,
        "the chapter's, anew in each step"
    );

    // See the header
    constexpr scalar fresh = 1;
    constexpr scalar resting = 12;


    //- Friction of a push, which ends the slip at most: what one sweep throws
    //  back, the next would throw back again
    static void resistSlip
    (
        const contact& c,
        bodies& b,
        impactCoeffs k,
        const scalar me,
        const scalar Jn
    )
    {
        k.et = 0;
        resist(c, b, k, me, Jn);
    }
}
}


Foam::cghs::velocityCorrection::velocityCorrection(const dictionary& dict)
:
    nSweeps_(labelFrom(dict, "nSweeps", 0)),
    overlapShare_(scalarInRange(dict, "overlapShare", 0, 1)),
    velocityShare_(scalarInRange(dict, "velocityShare", 0, 1))
{
    warnUnknownEntries
    (
        dict,
        wordList({"nSweeps", "overlapShare", "velocityShare"})
    );
}


template<bool rubs>
Foam::scalar Foam::cghs::velocityCorrection::sweepContacts
(
    const label sweepi,
    contactList& list,
    bodies& b,
    const impactTable& coeffs,
    const stepScales& step
) const
{
    const scalar rDeltaT = 1/step.deltaT;
    const UList<contact>& contacts = list.contacts;
    // What presses on a bed comes from one end of the list: every other sweep
    // runs backwards, so that both ends are heard
    const bool backwards = sweepi % 2;

    scalar work = 0;

    const label n = contacts.size();

    for (label i = 0; i < n; ++i)
    {
        const contact& c = contacts[backwards ? n - 1 - i : i];
        const scalar vn = partingSpeed(c, b);
        const scalar room = c.overlap*rDeltaT;

        // What flies is due its impact, not a correction
        if (vn < -max(fresh*room, resting*step.speed))
        {
            collide(c, b, coeffs[c.surface], step.deltaT);
            continue;
        }

        // Which pairs still approach is a toss of a coin that a branch would
        // guess wrong: a gain of zero is cheaper
        const scalar gain =
            vn < 0
          ? max(min(overlapShare_*room - velocityShare_*vn, room - vn), scalar(0))
          : 0;

        const scalar me = effectiveMass(c, b);
        const scalar J = me*gain;

        if (rubs && J > 0)
        {
            resistSlip(c, b, coeffs[c.surface], me, J);
        }
        push(c, b, J*c.n);
        work += J*(vn + 0.5*gain);
    }

    return work;
}


Foam::scalar Foam::cghs::velocityCorrection::sweep
(
    const label sweepi,
    contactList& list,
    bodies& b,
    const impactTable& coeffs,
    const stepScales& step
) const
{
    const bool rubs =
        anyOf(coeffs, [](const impactCoeffs& k) { return k.mu > 0; });

    return
        rubs
      ? sweepContacts<true>(sweepi, list, b, coeffs, step)
      : sweepContacts<false>(sweepi, list, b, coeffs, step);
}
