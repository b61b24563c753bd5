/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "patchPlace.H"
#include "checkedEntry.H"
#include "knownEntries.H"
#include "meshNames.H"
#include "meshTools.H"
#include "triPointRef.H"
#include "addToRunTimeSelectionTable.H"

#include <algorithm>

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(patchPlace, 0);
    addToRunTimeSelectionTable(feedPlace, patchPlace, dictionary);

    //- What random places hold in the volume that is swept [-]
    constexpr scalar randomFraction = 0.3;
}
}

// * * * * * * * * * * * * * * * Construction  * * * * * * * * * * * * * * * //

Foam::cghs::patchPlace::patchPlace
(
    const dictionary& dict,
    const polyMesh& mesh
)
:
    feedPlace(dict),
    mesh_(mesh),
    speed_(positiveScalar(dict, "speed")),
    triangles_
    (
        gatherTriangles
        (
            mesh.boundaryMesh()
            [
                patchNamed(dict.get<word>("patch"), "patch", dict, mesh)
            ]
        )
    ),
    areas_(triangles_.size())
{
    warnUnknownEntries(dict, wordList({"patch", "speed", "direction"}));

    scalar sum = 0;
    forAll(areas_, i)
    {
        areas_[i] = (sum += mag(triangles_[i].area()));
    }

    if (triangles_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Patch " << dict.get<word>("patch") << " has no faces" << nl
            << "Feed through one that has, or mend the mesh" << nl
            << exit(FatalIOError);
    }
}

// * * * * * * * * * * * * * * * * * Public  * * * * * * * * * * * * * * * * //

Foam::cghs::feedPlace::entrance Foam::cghs::patchPlace::suggest
(
    Random& random,
    const scalar r,
    const scalar deltaT,
    transport& cells
) const
{
    const scalar mark = random.sample01<scalar>()*areas_.last();
    const label i =
        std::lower_bound(areas_.begin(), areas_.end(), mark) - areas_.begin();
    const patchTriangle& t = triangles_[min(i, triangles_.size() - 1)];

    const vector area(t.area());
    const vector inward(-area/mag(area));
    const point onPatch
    (
        triPointRef(t.corners[0], t.corners[1], t.corners[2])
       .randomPoint(random)
    );

    // A little deeper than touching, as that counts as a contact
    const scalar depth =
        (1 + 1e-6)*r + random.sample01<scalar>()*speed_*deltaT;

    entrance e{onPatch + depth*inward, speed_*inward, t.cell};
    meshTools::constrainToMeshCentre(mesh_, e.x);

    if (e.cell != -1 && !cells.enters(e.x, e.cell))
    {
        e.cell = -1;
    }
    return e;
}


Foam::boundBox Foam::cghs::patchPlace::centres
(
    const scalar r,
    const scalar deltaT
) const
{
    const boundBox box(boundsOf(triangles_));
    const vector depth(vector::uniform(1.1*r + speed_*deltaT));
    return boundBox(box.min() - depth, box.max() + depth);
}


Foam::scalar Foam::cghs::patchPlace::largestRate(const scalar rho) const
{
    return randomFraction*rho*areas_.last()*speed_;
}
