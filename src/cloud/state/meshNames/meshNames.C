/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "meshNames.H"

namespace Foam
{
namespace cghs
{

static label checked
(
    const label index,
    const char* kind,
    const word& name,
    const word& entry,
    const dictionary& dict,
    const wordList& valid
)
{
    if (index < 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << entry << ": there is no " << kind << ' ' << name
            << nl << "Valid choices: " << valid << nl
            << exit(FatalIOError);
    }

    return index;
}

} // End namespace cghs
} // End namespace Foam


Foam::label Foam::cghs::patchNamed
(
    const word& name,
    const word& entry,
    const dictionary& dict,
    const polyMesh& mesh
)
{
    const polyBoundaryMesh& patches = mesh.boundaryMesh();

    return checked
    (
        patches.findPatchID(name), "patch", name, entry, dict, patches.names()
    );
}


Foam::label Foam::cghs::cellZoneNamed
(
    const word& name,
    const word& entry,
    const dictionary& dict,
    const polyMesh& mesh
)
{
    const cellZoneMesh& zones = mesh.cellZones();

    return checked
    (
        zones.findZoneID(name), "cellZone", name, entry, dict, zones.names()
    );
}
