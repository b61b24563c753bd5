/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "flowState.H"
#include "cloud.H"
#include "IOdictionary.H"
#include "Time.H"

namespace Foam
{
namespace cghs
{

static IOobject flowsIO
(
    const polyMesh& mesh,
    const word& cloudName,
    const IOobject::readOption read
)
{
    return IOobject
    (
        "flows",
        mesh.time().timeName(),
        "uniform"/cloud::prefix/cloudName,
        mesh.time(),
        read,
        IOobject::NO_WRITE,
        false
    );
}

//- Stop at the flows of an earlier time: redistributePar without -overwrite
//  makes a new time, one step later, and copies the folder uniform of time 0
static void checkTime(const polyMesh& mesh, const IOdictionary& flows)
{
    const Time& now = mesh.time();
    const scalar written = flows.getOrDefault<scalar>("time", now.value());

    if (written >= now.value() - 1.5*now.deltaTValue())
    {
        return;
    }

    FatalIOErrorInFunction(flows)
        << "The file is that of time " << written << ", but the run starts at "
        << now.timeName() << nl
        << "What has been fed and has left, and what contacts remember, would"
        << " be those of that time" << nl
        << "redistributePar without -overwrite leaves it so: copy "
        << flows.name() << " from the time that was redistributed (processor0"
        << " has it) to time " << now.timeName() << " of all ranks, or remove"
        << " time " << now.timeName() << " and run redistributePar -overwrite"
        << nl
        << "If the file is meant as it is remove its entry time" << nl
        << exit(FatalIOError);
}

} // End namespace cghs
} // End namespace Foam


Foam::dictionary Foam::cghs::readFlows
(
    const polyMesh& mesh,
    const word& cloudName
)
{
    const IOdictionary flows
    (
        flowsIO(mesh, cloudName, IOobject::READ_IF_PRESENT)
    );
    checkTime(mesh, flows);

    return flows;
}


void Foam::cghs::writeFlows
(
    const polyMesh& mesh,
    const word& cloudName,
    const dictionary& flows
)
{
    IOdictionary file(flowsIO(mesh, cloudName, IOobject::NO_READ), flows);

    // By its name: the value of a run that goes on may differ in the last digit
    file.add("time", mesh.time().timeName());
    file.regIOobject::writeObject
    (
        IOstream::ASCII,
        IOstream::currentVersion,
        IOstream::UNCOMPRESSED,
        true
    );
}
