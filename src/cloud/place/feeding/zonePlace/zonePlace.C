/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "zonePlace.H"
#include "knownEntries.H"
#include "meshNames.H"
#include "meshTools.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(zonePlace, 0);
    addToRunTimeSelectionTable(feedPlace, zonePlace, dictionary);
    describeModel(feedPlace, zonePlace, "anywhere in a cellZone");
}
}


Foam::cghs::zonePlace::zonePlace
(
    const dictionary& dict,
    const polyMesh& mesh
)
:
    feedPlace(dict),
    mesh_(mesh),
    velocity_(dict.get<vector>("velocity")),
    inZone_(mesh.nCells(), false),
    box_()
{
    warnUnknownEntries(dict, wordList({"cellZone", "velocity"}));

    const word name(dict.get<word>("cellZone"));
    const label zonei = cellZoneNamed(name, "cellZone", dict, mesh);

    for (const label celli : mesh.cellZones()[zonei])
    {
        inZone_[celli] = true;

        for (const label pointi : mesh.cellPoints()[celli])
        {
            box_.add(mesh.points()[pointi]);
        }
    }
    box_.reduce();

    if (box_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "The cellZone " << name << " has no cells" << nl
            << "Feed into one that has" << nl
            << exit(FatalIOError);
    }
}


Foam::cghs::feedPlace::entrance Foam::cghs::zonePlace::suggest
(
    Random& random,
    const scalar,
    const scalar,
    transport& cells
) const
{
    entrance e
    {
        box_.min() + cmptMultiply(random.sample01<vector>(), box_.span()),
        velocity_,
        -1
    };
    meshTools::constrainToMeshCentre(mesh_, e.x);

    const label celli = cells.cells().find(e.x);

    if (celli != -1 && inZone_[celli])
    {
        e.cell = celli;
    }
    return e;
}
