/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Application
    cghsCheck

Description
    Checks a case of cghsFoam without running it, as checkMesh does a mesh.

    The case is constructed as cghsFoam does it, so that all that models refuse
    is refused here. Then sizes, velocities, time scales, packing, flows and
    controls are printed and held against each other. Last a few steps are made
    in memory, to tell what a run will cost and which entries nothing reads.
    Nothing is written to the case.

    Each finding names file, entry and value, says what that means and what to
    do about it. It is a note (nothing is wrong), a warning (the case runs, but
    hardly does what is meant) or an error (it does not run, or loses what it is
    run for). Warnings that OpenFOAM and models print count, too.

Usage
    cghsCheck [-cloud name] [-trial seconds] [-noTrial]
    mpirun -np 2 cghsCheck -parallel

      - -cloud name     the properties are in constant/<name>Properties
      - -trial seconds  how long steps are made for, 5 unless given
      - -noTrial        make none: no speed, and entries that are read during a
                        run are not looked at

    Closes with 'Case OK.', or with the numbers of errors and warnings. The exit
    status is 0 unless there are errors.

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "memInfo.H"
#include "checks.H"
#include "page.H"

using namespace Foam::cghs;

static void addOptions()
{
    argList::addNote
    (
        "Checks a case of cghsFoam without running it: sizes of parcels,"
        " velocities, time scales, packing, flows, controls, speed, entries"
        " that nothing reads.\n"
        "Notes, warnings and errors name file, entry, value and remedy. Nothing"
        " is written. The exit status is 1 if there are errors."
    );
    argList::addOption("cloud", "name", "name of the cloud, default parcels");
    argList::addOption("trial", "seconds", "time for trial steps, default 5");
    argList::addBoolOption("noTrial", "make no trial steps");
}


//- The last line, and the exit status
static int conclude(const findings& found, const printedWarnings& printed)
{
    const label nErrors = found.count(findings::error);
    const label nWarnings = found.count(findings::warning) + printed.count();

    if (printed.count())
    {
        Info<< nl << printed.count() << " of the warnings are OpenFOAM's and"
            << " the models' own, above: --> FOAM Warning" << endl;
    }
    if (nErrors || nWarnings)
    {
        Info<< nl << nErrors << " errors, " << nWarnings << " warnings" << nl
            << endl;
    }
    else
    {
        Info<< nl << "Case OK." << nl << endl;
    }

    return nErrors ? 1 : 0;
}


int main(int argc, char *argv[])
{
    addOptions();

    const printedWarnings printed;

    #include "setRootCaseLists.H"
    #include "createTime.H"

    // That of the case is for its files
    Sout.precision(6);

    const scalar memoryBefore = 1024.0*memInfo().rss();

    #include "createMesh.H"


    // ---- The parcels and the fluid, as the solver makes them --------------

    #include "createFields.H"

    caseView view
    {
        runTime, mesh, g.value(), cloud, fluid, runTime.timeName(), memoryBefore
    };
    findings found;

    const List<parcelKind> kinds(parcelKindsOf(view));
    const List<inlet> inlets
    (
        fluid.valid() ? inletsOf(view) : List<inlet>()
    );


    // ---- What it is made of ------------------------------------------------

    checkParcels(view, kinds, found);
    checkContact(view, kinds, found);
    if (fluid.valid())
    {
        checkVelocities(view, kinds, inlets, found);
    }
    checkTimeScales(view, kinds, inlets, found);
    checkPacking(view, kinds, found);
    checkFlows(view, kinds, inlets, found);
    checkControl(view, found);


    // ---- What a run will cost, and what it has read ------------------------

    if (!args.found("noTrial"))
    {
        checkSpeed(view, kinds, inlets, args.get<scalar>("trial", 5), found);
        checkEntriesRead(view, printed, found);
    }

    const int status = conclude(found, printed);

    if (status)
    {
        // args, when it is taken down, would end the program with 0
        Pstream::exit(status);
    }
    return 0;
}
