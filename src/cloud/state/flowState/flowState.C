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

} // End namespace cghs
} // End namespace Foam


Foam::dictionary Foam::cghs::readFlows
(
    const polyMesh& mesh,
    const word& cloudName
)
{
    return IOdictionary(flowsIO(mesh, cloudName, IOobject::READ_IF_PRESENT));
}


void Foam::cghs::writeFlows
(
    const polyMesh& mesh,
    const word& cloudName,
    const dictionary& flows
)
{
    IOdictionary
    (
        flowsIO(mesh, cloudName, IOobject::NO_READ),
        flows
    ).regIOobject::writeObject
    (
        IOstream::ASCII,
        IOstream::currentVersion,
        IOstream::UNCOMPRESSED,
        true
    );
}
