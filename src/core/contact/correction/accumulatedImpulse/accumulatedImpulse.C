/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "accumulatedImpulse.H"
#include "frictionEntries.H"
#include "knownEntries.H"
#include "impulseKernels.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

#include <numeric>

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(accumulatedImpulse, 0);
    addToRunTimeSelectionTable(correctionModel, accumulatedImpulse, dictionary);
    describeModel
    (
        correctionModel,
        accumulatedImpulse,
        "by contacts that remember: dense beds that rest"
    );


    //- How fast a contact is believed to take up load from step to step: what
    //  comes at once is a blow that will not come again. Less than this and
    //  contacts of a dense flow, which live for some steps only, part before
    //  they bear what they should: the flow is too slow
    constexpr scalar growth = 3;


    static scalar sum(const scalar (&s)[laneCount])
    {
        return std::accumulate(s, s + laneCount, scalar(0));
    }


    CGHS_FOR_EACH_PROCESSOR
    static void run(warmStart<true>& kernel)
    {
        kernel.list.lanes.sweep(false, kernel);
    }

    CGHS_FOR_EACH_PROCESSOR
    static void run(warmStart<false>& kernel)
    {
        kernel.list.lanes.sweep(false, kernel);
    }

    CGHS_FOR_EACH_PROCESSOR
    static void run(pressAndHold<true>& kernel, const bool backwards)
    {
        kernel.list.lanes.sweep(backwards, kernel);
    }

    CGHS_FOR_EACH_PROCESSOR
    static void run(pressAndHold<false>& kernel, const bool backwards)
    {
        kernel.list.lanes.sweep(backwards, kernel);
    }

    CGHS_FOR_EACH_PROCESSOR
    static void run(separate& kernel)
    {
        kernel.list.lanes.sweep(false, kernel);
    }
}
}


Foam::cghs::accumulatedImpulse::accumulatedImpulse(const dictionary& dict)
:
    nSweeps_(labelFrom(dict, "nSweeps", 1)),
    overlapShare_(scalarInRange(dict, "overlapShare", 0, 1)),
    overlapAllowed_(scalarInRange(dict, "overlapAllowed", 0, 0.1)),
    restingSteps_(scalarInRange(dict, "restingSteps", 0, GREAT))
{
    warnUnknownEntries
    (
        dict,
        wordList({"nSweeps", "overlapShare", "overlapAllowed", "restingSteps"})
    );
}


void Foam::cghs::accumulatedImpulse::remember(contactList& list) const
{
    forAll(list.blocks, k)
    {
        const memoryBlock& block = list.blocks[k];

        for (label l = 0; l < list.lanes[k].size; ++l)
        {
            contactMemory& memory = list.memories[list.lanes.contactOf(k, l)];

            memory.load = block.load[l];
            memory.rubbing = vector
            (
                block.rubbing[0][l],
                block.rubbing[1][l],
                block.rubbing[2][l]
            );
        }
    }
}


void Foam::cghs::accumulatedImpulse::begin
(
    contactList& list,
    bodies& b,
    const impactTable& coeffs,
    const stepScales& step
) const
{
    list.lanes.resize(list.contacts.size());
    list.blocks.resize(list.lanes.size());

    b.spinning()
  ? start<true>(list, b, coeffs, step)
  : start<false>(list, b, coeffs, step);
}


template<bool spinning>
void Foam::cghs::accumulatedImpulse::start
(
    contactList& list,
    bodies& b,
    const impactTable& coeffs,
    const stepScales& step
) const
{
    warmStart<spinning> kernel(list, b, coeffs);

    kernel.longer =
        step.previousDeltaT > 0 ? step.deltaT/step.previousDeltaT : 1;

    kernel.growth = growth;
    kernel.speed = step.speed;
    kernel.overlapAllowed = overlapAllowed_;

    // The second half of the step's forces comes after the impacts: what they
    // left as resting is faster by half a step then
    kernel.restingSpeed = (restingSteps_ + 1)*step.speed;
    kernel.pressingRate = 0.25/step.deltaT;

    run(kernel);
}


void Foam::cghs::accumulatedImpulse::resistRolling
(
    const contactList& list,
    bodies& b,
    const impactTable& coeffs
) const
{
    if (!anyOf(coeffs, [](const impactCoeffs& k) { return k.rolling > 0; }))
    {
        return;
    }

    forAll(list.contacts, i)
    {
        const contact& c = list.contacts[i];
        const scalar load = list.memories[i].load;

        if (load > 0)
        {
            cghs::resistRolling(c, b, coeffs[c.surface].rolling, load);
        }
    }
}


Foam::scalar Foam::cghs::accumulatedImpulse::sweepVelocities
(
    contactList& list,
    bodies& b,
    const impactTable& coeffs,
    const scalar deltaT,
    const bool rubs,
    const bool backwards
) const
{
    if (rubs)
    {
        pressAndHold<true> kernel(list, b, coeffs, deltaT);
        run(kernel, backwards);
        return sum(kernel.work);
    }

    pressAndHold<false> kernel(list, b, coeffs, deltaT);
    run(kernel, backwards);
    return sum(kernel.work);
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
        return sweepVelocities
        (
            list,
            b,
            coeffs,
            step.deltaT,
            b.spinning() && rubsIn(sweepi),
            sweepi % 2
        );
    }

    remember(list);
    resistRolling(list, b, coeffs);

    separate kernel(list, b, overlapShare_, step.deltaT);
    run(kernel);
    return 0;
}
