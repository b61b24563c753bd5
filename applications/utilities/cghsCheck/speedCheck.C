/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "page.H"
#include "basicSpecieMixture.H"
#include "SolverPerformance.H"
#include "memInfo.H"

#include <ctime>

namespace Foam
{
namespace cghs
{

//- A parcel that overlaps by more is thrown about at the start, of d [-]
constexpr scalar deepOverlap = 0.2;

//- A mass fraction that is not worth a look [-]
constexpr scalar traces = 1e-4;

//- Beyond, hardly anyone waits [s]
constexpr scalar longRun = 30*86400.0;


//- What steps cost, in seconds of a core of this machine. What other programs
//  take of it does not count
struct costs
{
    label nSteps = 0;
    label nSolidsSteps = 0;
    scalar solids = 0;
    scalar fluid = 0;

    //- The cheapest and the dearest step
    scalar least = GREAT;
    scalar most = 0;

    scalar perSolidsStep() const { return solids/max(nSolidsSteps, 1); }

    scalar perFluidStep() const { return fluid/max(nSteps, 1); }
};


//- Of this program, which OpenFOAM's cpuTime counts in hundredths [s]
static scalar coreTime()
{
    return scalar(std::clock())/CLOCKS_PER_SEC;
}


//- The parcels' part of a step: as the solver makes it
static void moveParcels(caseView& view, const scalar deltaT)
{
    view.cloud.feed(deltaT);
    if (view.fluid.valid())
    {
        view.cloud.meet(view.fluid());
    }
    view.cloud.evolve(deltaT);
}


//- And the fluid's
static void solveFluid(caseView& view, const scalar deltaT)
{
    if (view.fluid.valid())
    {
        view.fluid->solve(view.cloud);
        view.cloud.complete(view.fluid(), deltaT);
    }
}


//- One step of the solver, of which nothing is written
static void makeStep(caseView& view, costs& sum)
{
    ++view.runTime;
    const scalar deltaT = view.runTime.deltaTValue();

    const scalar start = coreTime();
    moveParcels(view, deltaT);
    const scalar solids = coreTime() - start;
    solveFluid(view, deltaT);
    const scalar whole = coreTime() - start;

    ++sum.nSteps;
    sum.nSolidsSteps += view.cloud.log().nSolidsSteps;
    sum.solids += solids;
    sum.fluid += whole - solids;
    sum.least = min(sum.least, whole);
    sum.most = max(sum.most, whole);
}


//- Steps for about so long [s], after a first one that builds what stays; at
//  least two. The same number on all ranks
static costs makeSteps(caseView& view, const scalar seconds)
{
    // The solvers' lines are for a run
    solverPerformance::debug = 0;
    SolverPerformance<vector>::debug = 0;

    costs first, rest;
    const scalar start = coreTime();

    makeStep(view, first);
    do
    {
        makeStep(view, rest);
    }
    while
    (
        rest.nSteps < 50
     && returnReduce(coreTime() - start, maxOp<scalar>()) < seconds
    );

    return rest;
}


//- The step of the fluid that a run will make [s], by the present flow
static scalar expectedFluidStep(const caseView& view)
{
    const scalar deltaT = view.runTime.deltaTValue();

    if (!view.adjusts())
    {
        return deltaT;
    }

    const scalar Courant = view.fluid->courantNumber();

    return min
    (
        view.longestFluidStep(),
        deltaT*view.largestCourant()/max(Courant, VSMALL)
    );
}


//- Solids steps in a step of the fluid: by the speed that parcels have, or will
//  have in the flow
static scalar expectedSolidsSteps
(
    const caseView& view,
    const UList<parcelKind>& kinds,
    const UList<inlet>& inlets,
    const scalar fluidStep
)
{
    const scalar d = smallestParcel(kinds);
    const scalar flow = view.fluid.valid() ? meanVelocity(inlets, view) : 0;

    return ceil
    (
        fluidStep/view.solidsStep(d, max(view.largestSpeed(), flow)) - SMALL
    );
}


static void checkDuration
(
    const caseView& view,
    const scalar wallTimeOfASecond,
    findings& found
)
{
    const scalar end = view.runTime.endTime().value();
    const scalar left = end - view.runTime.value();
    const scalar duration = wallTimeOfASecond*max(left, scalar(0));

    page::line
    (
        "simulated seconds in a day",
        page::number(86400/wallTimeOfASecond)
    );
    page::line
    (
        "to endTime",
        textOf(duration, " s = ", duration/3600, " h")
    );

    if (duration > longRun)
    {
        found.warn
        (
            place("system/controlDict", "endTime", end),
            textOf("that takes about ", duration/86400, " days here"),
            "a larger parcelWeight, larger cells, or a shorter run; cghsStudy"
            " tells what that costs in accuracy"
        );
    }
}


static void printMemory(const caseView& view)
{
    const memInfo memory;
    const scalar n = view.cloud.parcels().size();
    const scalar parcels = n*view.cloud.bytesPerParcel();

    if (n > 0)
    {
        page::line
        (
            "bytes a parcel, with its contacts",
            Foam::name(label(view.cloud.bytesPerParcel()))
        );
    }
    if (memory.valid())
    {
        const scalar all = 1024.0*memory.rss();

        page::line("memory of this rank [MB]", page::number(1e-6*all));
        page::line
        (
            "bytes a cell",
            page::number
            (
                max(all - view.memoryBefore - parcels, scalar(0))
               /view.mesh.nCells()
            )
        );
    }
}


//- Parcels that begin within each other
static void checkOverlaps(const caseView& view, findings& found)
{
    const scalar largest = view.cloud.log().overlaps.largest();

    page::line
    (
        "largest overlap in the last step",
        textOf(100*largest, " % of a parcel")
    );
    if (largest > deepOverlap)
    {
        found.warn
        (
            place
            (
                view.startTime + "/lagrangian/" + view.cloud.name(),
                "positions",
                textOf(100*largest, " % of d")
            ),
            "parcels begin deep within each other, and are driven apart",
            "place them by fillParcels, or give them smaller diameters"
        );
    }
}


//- How soon parcels use up a species of the fluid where they do most [s]
static void printReactionTimes(const caseView& view, const scalar deltaT)
{
    const basicSpecieMixture* mixture =
        view.fluid.valid() ? view.fluid->mixture() : nullptr;

    if (!mixture || !view.twoWay())
    {
        return;
    }
    for (const word& name : mixture->species())
    {
        const exchangeTerms terms(view.cloud.terms(name));
        if (!terms.any())
        {
            continue;
        }

        const scalarField content
        (
            view.fluid->alpha().primitiveField()
           *view.fluid->rho().primitiveField()
        );
        const scalarField used(-terms.given().primitiveField());
        const scalarField before
        (
            content*view.fluid->field(name).primitiveField() + deltaT*used
        );
        scalar fastest = 0;

        forAll(before, celli)
        {
            if (before[celli] > traces*content[celli])
            {
                fastest = max(fastest, used[celli]/before[celli]);
            }
        }
        reduce(fastest, maxOp<scalar>());

        if (fastest > 0)
        {
            page::line
            (
                "least time to use up " + name,
                textOf(1/fastest, " s; fluid step ", deltaT, " s")
            );
        }
    }
}

} // End namespace cghs
} // End namespace Foam


void Foam::cghs::checkSpeed
(
    caseView& view,
    const UList<parcelKind>& kinds,
    const UList<inlet>& inlets,
    const scalar seconds,
    findings& found
)
{
    page::title("Speed and memory, by steps that are not written");

    const costs cost(makeSteps(view, seconds));
    const scalar fluidStep = expectedFluidStep(view);
    const scalar nSolids =
        expectedSolidsSteps(view, kinds, inlets, fluidStep);

    page::line
    (
        "steps made",
        textOf
        (
            cost.nSteps, " with ", cost.nSolidsSteps, " solids steps, ",
            cost.least, " to ", cost.most, " s each"
        )
    );
    page::line("a solids step", textOf(cost.perSolidsStep(), " s"));
    page::line("a fluid step", textOf(cost.perFluidStep(), " s"));
    page::line
    (
        "expected",
        textOf
        (
            nSolids, " solids steps in a fluid step of ", fluidStep, " s"
        )
    );
    checkDuration
    (
        view,
        (cost.perFluidStep() + nSolids*cost.perSolidsStep())/fluidStep,
        found
    );
    page::line
    (
        "uncertainty",
        textOf
        (
            "a factor of 2 or so: by the state at the start, on ",
            Pstream::nProcs(), " free cores of this machine"
        )
    );

    checkOverlaps(view, found);
    printReactionTimes(view, view.runTime.deltaTValue());
    printMemory(view);
}
