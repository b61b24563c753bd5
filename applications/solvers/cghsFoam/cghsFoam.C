/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Application
    cghsFoam

Description
    Transient solver for fluidised beds: a liquid or a gas in the voidage of
    parcels that truly collide (coarse-grained, time-driven hard spheres with
    correction), see doc/theory.md.

Usage
    cghsFoam [-cloud name]
    cghsFoam -postProcess [-latestTime] [-func name]
    cghsFoam -listModels

    The cloud is called parcels unless named, its properties are in
    constant/<name>Properties. With  coupling none;  there, no fluid is read
    or solved.

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "profiling.H"
#include "cghsCloud.H"
#include "modelList.H"
#include "fluidModel.H"
#include "progress.H"
#include "stepReport.H"

using namespace Foam::cghs;

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Transient solver for fluidised beds of colliding, coarse-grained"
        " parcels in a liquid or gas."
    );
    argList::addOption("cloud", "name", "name of the cloud, default parcels");

    argList::addBoolOption
    (
        "listModels",
        "list all models, with a line on each, and end"
    );

    // With -postProcess: function objects on the times that are written
    #define NO_CONTROL
    #include "postProcess.H"

    #include "setRootCaseLists.H"

    if (args.found("listModels"))
    {
        autoPtr<Time> librariesOfCase;
        if (isFile(args.path()/"system"/Time::controlDictName))
        {
            librariesOfCase.reset(new Time(Time::controlDictName, args));
        }
        listModels(Info);
        return 0;
    }

    #include "createTime.H"
    #include "createMesh.H"
    #include "createTimeControls.H"


    // ---- The parcels, and the fluid if there is one -----------------------

    #include "createFields.H"

    const bool withFluid = fluid.valid();

    stepReport report(cloud, mesh);
    progress pace(runTime);

    Info<< nl << "Starting time loop" << nl << endl;

    while (runTime.run())
    {
        // ---- How long the step may be -------------------------------------

        #include "readTimeControls.H"

        if (withFluid)
        {
            const scalar CoNum = fluid->courantNumber();
            #include "setDeltaT.H"
        }

        ++runTime;

        Info<< "Time = " << runTime.timeName() << nl << endl;

        const scalar deltaT = runTime.deltaTValue();


        // ---- Parcels: feeding, exchange, contact, transport ---------------

        cloud.feed(deltaT);

        if (withFluid)
        {
            cloud.meet(fluid());
        }

        cloud.evolve(deltaT);


        // ---- Fluid: voidage, momentum, pressure; what the parcels answer --

        if (withFluid)
        {
            fluid->solve(cloud);
            cloud.complete(fluid(), deltaT);
        }


        // ---- Report and write ---------------------------------------------

        report.write(Info, fluid);
        pace.report(Info);

        runTime.write();

        runTime.printExecutionTime(Info);
    }

    Info<< "End" << nl << endl;

    return 0;
}
