/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "pointPlace.H"
#include "checkedEntry.H"
#include "knownEntries.H"
#include "meshTools.H"
#include "indexedOctree.H"
#include "treeDataCell.H"
#include "PstreamReduceOps.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(pointPlace, 0);
    addToRunTimeSelectionTable(feedPlace, pointPlace, dictionary);
    describeModel
    (
        feedPlace,
        pointPlace,
        "around points, as from a pipe that the mesh does not show"
    );
}
}


Foam::cghs::pointPlace::pointPlace
(
    const dictionary& dict,
    const polyMesh& mesh
)
:
    feedPlace(dict),
    mesh_(mesh),
    points_(dict.get<List<point>>("points")),
    radius_(scalarInRange(dict, "radius", 0, GREAT)),
    velocity_(dict.get<vector>("velocity"))
{
    warnUnknownEntries(dict, wordList({"points", "radius", "velocity"}));

    if (points_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry points is empty" << nl
            << "Give at least one point, ((x y z))" << nl
            << exit(FatalIOError);
    }

    for (point x : points_)
    {
        meshTools::constrainToMeshCentre(mesh, x);

        if
        (
            returnReduce(mesh.cellTree().findInside(x), maxOp<label>()) == -1
        )
        {
            FatalIOErrorInFunction(dict)
                << "Entry points: " << x << " is not in the mesh, which spans "
                << mesh.bounds() << nl
                << exit(FatalIOError);
        }
    }
}


Foam::cghs::feedPlace::entrance Foam::cghs::pointPlace::suggest
(
    Random& random,
    const scalar,
    const scalar,
    transport& cells
) const
{
    const label i = random.position<label>(0, points_.size() - 1);

    // Within the sphere
    vector offset;
    do
    {
        offset = 2*random.sample01<vector>() - vector::uniform(1);
    }
    while (magSqr(offset) > 1);

    entrance e{points_[i] + radius_*offset, velocity_, -1};
    meshTools::constrainToMeshCentre(mesh_, e.x);
    e.cell = cells.cells().find(e.x);

    return e;
}


Foam::boundBox Foam::cghs::pointPlace::centres
(
    const scalar,
    const scalar
) const
{
    boundBox box(points_, false);
    return
        boundBox
        (
            box.min() - vector::uniform(radius_),
            box.max() + vector::uniform(radius_)
        );
}
