/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "page.H"
#include "fileOperation.H"
#include "functionObject.H"

namespace Foam
{
namespace cghs
{

static const char* const controlFile = "system/controlDict";


//- Will the run do anything, and write it?
static void checkTimes(const caseView& view, findings& found)
{
    const dictionary& control = view.runTime.controlDict();
    const scalar start = view.runTime.value();
    const scalar end = view.runTime.endTime().value();

    page::line("time", textOf(start, " s to ", end, " s"));

    if (end <= start)
    {
        found.warn
        (
            place(controlFile, "endTime", end),
            textOf("the run starts at ", start, " s: it makes no step"),
            "raise endTime, or start from an earlier time by startFrom"
        );
        return;
    }

    const word writes(control.getOrDefault<word>("writeControl", "timeStep"));
    const scalar entered = control.getOrDefault<scalar>("writeInterval", GREAT);
    const scalar interval =
        writes == "timeStep" ? entered*view.runTime.deltaTValue() : entered;
    const bool known =
        writes == "runTime" || writes == "adjustableRunTime"
     || (
            writes == "timeStep"
         && !control.getOrDefault<bool>("adjustTimeStep", false)
        );

    page::line("writes", textOf(writes, ", writeInterval ", entered));

    if (known && interval > (end - start)*(1 + 1e-6))
    {
        found.warn
        (
            place(controlFile, "writeInterval", entered),
            textOf
            (
                "times would be written every ", interval, " s, but the run is"
                " over in ", end - start, " s: nothing of it is kept"
            ),
            textOf("a writeInterval of ", end - start, " s or less")
        );
    }
    if (known && interval < (1 - 1e-6)*view.runTime.deltaTValue())
    {
        found.warn
        (
            place(controlFile, "deltaT", view.runTime.deltaTValue()),
            textOf
            (
                "it is longer than the ", interval, " s after which times are"
                " to be written"
            ),
            "lower deltaT, or raise writeInterval"
        );
    }
}


//- Open the libraries that it names. True if all are there
static bool openLibraries
(
    const dictionary& function,
    const caseView& view,
    findings& found
)
{
    fileNameList names;
    if (!function.readIfPresent("libs", names))
    {
        function.readIfPresent("functionObjectLibs", names);
    }

    bool all = true;
    for (const fileName& name : names)
    {
        if (!view.runTime.libs().open(name, false))
        {
            all = false;
            found.fail
            (
                place
                (
                    controlFile, "functions." + function.dictName() + ".libs",
                    name
                ),
                "there is no such library: the run goes on without this"
                " function object",
                "mend the name, or build the library: ours are cghsCloud and"
                " cghsFluid"
            );
        }
    }
    return all;
}


static void checkType(const dictionary& function, findings& found)
{
    const word type(function.getOrDefault<word>("type", "none"));

    if
    (
        !functionObject::dictionaryConstructorTablePtr_
     || !functionObject::dictionaryConstructorTablePtr_->found(type)
    )
    {
        found.fail
        (
            place
            (
                controlFile, "functions." + function.dictName() + ".type", type
            ),
            "no library that is loaded has a function object of this type: the"
            " run goes on without it",
            "mend the type, or name its library in libs"
        );
    }
}


static void checkFunction
(
    const dictionary& function,
    const caseView& view,
    findings& found
)
{
    if (!function.getOrDefault<bool>("enabled", true))
    {
        return;
    }
    if (openLibraries(function, view, found))
    {
        checkType(function, found);
    }

    const scalar end = view.runTime.endTime().value();
    const scalar start = function.getOrDefault<scalar>("timeStart", -GREAT);
    if (start >= end && end > view.runTime.value())
    {
        found.warn
        (
            place
            (
                controlFile, "functions." + function.dictName() + ".timeStart",
                start
            ),
            textOf("the run ends before, at ", end, " s: it has no result"),
            "lower timeStart, or raise endTime"
        );
    }

    const word cloud(function.getOrDefault<word>("cloud", view.cloud.name()));
    if (cloud != view.cloud.name())
    {
        found.warn
        (
            place
            (
                controlFile, "functions." + function.dictName() + ".cloud",
                cloud
            ),
            "the cloud of this case is " + view.cloud.name(),
            "give that name, or run with the option -cloud " + cloud
        );
    }
}


static void checkFunctions(const caseView& view, findings& found)
{
    label n = 0;
    for
    (
        const entry& e
      : view.runTime.controlDict().subOrEmptyDict("functions")
    )
    {
        if (e.isDict())
        {
            ++n;
            checkFunction(e.dict(), view, found);
        }
    }
    page::line("function objects", Foam::name(n));
}


//- How many ranks the case is divided into; 1 if it is not
static label nRanksThere(const Time& runTime)
{
    return
        Pstream::parRun()
      ? Pstream::nProcs()
      : max(fileHandler().nProcs(runTime.path()), label(1));
}


static void checkRanks(const caseView& view, findings& found)
{
    const label nRanks = nRanksThere(view.runTime);
    const IOobject file
    (
        "decomposeParDict",
        view.runTime.caseSystem(),
        view.runTime,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );

    page::line("ranks that the case is divided into", Foam::name(nRanks));

    if (nRanks == 1 || !IOobject(file).typeHeaderOk<IOdictionary>())
    {
        return;
    }

    const label nAsked = IOdictionary(file).get<label>("numberOfSubdomains");
    if (nAsked != nRanks)
    {
        found.warn
        (
            place("system/decomposeParDict", "numberOfSubdomains", nAsked),
            textOf
            (
                "the case is divided into ", nRanks, ": mpirun -np ", nAsked,
                " cghsFoam -parallel will refuse it"
            ),
            "run decomposePar -force, or mend the entry"
        );
    }
}

} // End namespace cghs
} // End namespace Foam


void Foam::cghs::checkControl(const caseView& view, findings& found)
{
    page::title("Times, function objects, ranks");

    checkTimes(view, found);
    checkFunctions(view, found);
    checkRanks(view, found);
}
