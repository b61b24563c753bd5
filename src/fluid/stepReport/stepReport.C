/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "stepReport.H"
#include "OSspecific.H"
#include "IOmanip.H"
#include "PstreamReduceOps.H"
#include "profiling.H"

Foam::cghs::stepReport::stepReport
(
    const cghsCloud& cloud,
    const Time& time
)
:
    cloud_(cloud),
    time_(time)
{
    if (Pstream::master())
    {
        openTable();
    }
}


void Foam::cghs::stepReport::openTable()
{
    const fileName folder
    (
        time_.globalPath()/"postProcessing"/cloud_.name()/time_.timeName()
    );

    mkDir(folder);
    table_.reset(new OFstream(folder/"parcels.dat"));

    table_()
        << "# time nParcels mass momentumX momentumY momentumZ"
        << " centreX centreY centreZ kineticEnergy rotationalEnergy"
        << " granularTemperature maxOverlap correctionWork nSolidsSteps"
        << " clippedCells continuityError escapedMass fedMass" << endl;
    table_().precision(16);
}


void Foam::cghs::stepReport::writeRow
(
    const census& c,
    const stepLog& log,
    const label nCrowded,
    const scalar continuityError
)
{
    const scalar escaped =
        returnReduce
        (
            cloud_.transportStage().gone().mass(),
            sumOp<scalar>()
        );

    if (!table_.valid())
    {
        return;
    }

    const vector centre(c.massMoment/max(c.mass, VSMALL));
    OFstream& os = table_();

    os  << time_.value() << token::SPACE
        << c.nParcels << token::SPACE << c.mass;

    for (const vector& v : {c.momentum, centre})
    {
        for (direction d = 0; d < 3; ++d)
        {
            os  << token::SPACE << v[d];
        }
    }

    os  << token::SPACE << c.kineticEnergy
        << token::SPACE << c.rotationalEnergy
        << token::SPACE << c.granularTemperature()
        << token::SPACE << log.maxOverlap
        << token::SPACE << log.correctionWork
        << token::SPACE << log.nSolidsSteps
        << token::SPACE << nCrowded
        << token::SPACE << continuityError
        << token::SPACE << escaped
        << token::SPACE << cloud_.massFed() << nl;

    if (time_.writeTime() || time_.timeIndex() % 50 == 0)
    {
        os.flush();
    }
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

    const label nCrowded = fluid.valid() ? log.nCrowdedCells : 0;
    const scalar defect = fluid.valid() ? fluid->continuityError() : 0;

    os  << "solids: " << log.nSolidsSteps << " steps of at least "
        << log.minDeltaT << " s, " << log.nListBuilds << " lists, "
        << c.nParcels << " parcels, " << c.mass << " kg" << nl
        << "        granular temperature " << c.granularTemperature()
        << ", largest overlap " << 100*log.maxOverlap
        << " % of d, correction work " << log.correctionWork << " J, "
        << log.nCrowdedCells << " cells too full" << nl;
    cloud_.report(os);

    if (fluid.valid())
    {
        fluid->report(os);
    }

    writeRow(c, log, nCrowded, defect);
}
