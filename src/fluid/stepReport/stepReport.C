/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "stepReport.H"
#include "profiling.H"
#include "PstreamReduceOps.H"

Foam::cghs::stepReport::stepReport
(
    const cghsCloud& cloud,
    const fvMesh& mesh
)
:
    cloud_(cloud),
    time_(mesh.time()),
    loads_(mesh),
    parcels_(time_, cloud.name(), "parcels", 16),
    errors_(time_, "errorIndicators", cloud.name(), 6)
{}


void Foam::cghs::stepReport::writeParcels
(
    const census& c,
    const label nCrowded,
    const scalar continuityError
)
{
    const stepLog& log = cloud_.log();
    const scalar escaped =
        returnReduce
        (
            cloud_.transportStage().gone().mass(),
            sumOp<scalar>()
        );
    const vector centre(c.massMoment/max(c.mass, VSMALL));

    parcels_.write
    (
        List<figure>
        ({
            {"nParcels", scalar(c.nParcels)},
            {"mass", c.mass},
            {"momentumX", c.momentum.x()},
            {"momentumY", c.momentum.y()},
            {"momentumZ", c.momentum.z()},
            {"centreX", centre.x()},
            {"centreY", centre.y()},
            {"centreZ", centre.z()},
            {"kineticEnergy", c.kineticEnergy},
            {"rotationalEnergy", c.rotationalEnergy},
            {"granularTemperature", c.granularTemperature()},
            {"maxOverlap", log.overlaps.largest()},
            {"correctionWork", log.correctionWork},
            {"nSolidsSteps", scalar(log.nSolidsSteps)},
            {"clippedCells", scalar(nCrowded)},
            {"continuityError", continuityError},
            {"escapedMass", escaped},
            {"fedMass", cloud_.massFed()}
        })
    );
}


void Foam::cghs::stepReport::writeErrors
(
    const census& c,
    const autoPtr<fluidModel>& fluid
)
{
    const stepLog& log = cloud_.log();
    const scalar deltaT = time_.deltaTValue();
    const scalar clock = clock_.timeIncrement();

    List<figure> list
    ({
        {"deltaT", deltaT},
        {"secondsPerDay", 86400*deltaT/max(clock, VSMALL)},
        {"maxOverlap", log.overlaps.largest()},
        {"meanOverlap", log.overlaps.mean()},
        {
            "correctionWork",
            log.correctionWork/max(c.kineticEnergy, VSMALL)
        },
        {"crowdedCells", scalar(log.nCrowdedCells)}
    });
    list.append(loads_.figures(cloud_.parcels(), deltaT));
    list.append(cloud_.errors());
    if (fluid.valid())
    {
        list.append(fluid->errors());
    }

    errors_.write(list);
}


void Foam::cghs::stepReport::write
(
    Ostream& os,
    const autoPtr<fluidModel>& fluid
)
{
    addProfiling(report, "cghs::report");

    const census c(cloud_.count());
    const stepLog& log = cloud_.log();

    os  << "solids: " << log.nSolidsSteps << " steps of at least "
        << log.minDeltaT << " s, " << log.nListBuilds << " lists, "
        << c.nParcels << " parcels, " << c.mass << " kg" << nl
        << "        granular temperature " << c.granularTemperature()
        << ", largest overlap " << 100*log.overlaps.largest()
        << " % of d, correction work " << log.correctionWork << " J, "
        << log.nCrowdedCells << " cells too full" << nl;
    cloud_.report(os);

    if (fluid.valid())
    {
        fluid->report(os);
    }

    writeParcels
    (
        c,
        fluid.valid() ? log.nCrowdedCells : 0,
        fluid.valid() ? fluid->continuityError() : 0
    );
    writeErrors(c, fluid);
}
