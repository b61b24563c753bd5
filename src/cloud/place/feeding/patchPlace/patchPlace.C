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
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

#include <algorithm>

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(patchPlace, 0);
    addToRunTimeSelectionTable(feedPlace, patchPlace, dictionary);
    describeModel(feedPlace, patchPlace, "through a patch");

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
    direction_(dict.getOrDefault<vector>("direction", Zero)),
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

    checkDirection(dict);

    if (triangles_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Patch " << dict.get<word>("patch") << " has no faces" << nl
            << "Feed through one that has, or mend the mesh" << nl
            << exit(FatalIOError);
    }
}

void Foam::cghs::patchPlace::checkDirection(const dictionary& dict)
{
    if (!dict.found("direction"))
    {
        return;
    }

    const scalar size = mag(direction_);
    bool inward = size > VSMALL;

    for (const patchTriangle& t : triangles_)
    {
        inward = inward && (t.area() & direction_) < -0.05*size*mag(t.area());
    }

    if (!inward)
    {
        FatalIOErrorInFunction(dict)
            << "Entry direction is " << direction_ << ", which does not lead"
            << " into the mesh at all faces of patch " << dict.get<word>("patch")
            << nl << "Give a direction within 87 degrees of the inward normal, or"
            << " none for that normal" << nl
            << exit(FatalIOError);
    }

    direction_ /= size;
}


Foam::vector Foam::cghs::patchPlace::directionAt(const vector& inward) const
{
    return direction_ == vector::zero ? inward : direction_;
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

    // A little deeper than touching, as that counts as a contact, and as far on
    // its way as it may have come in the step
    const vector v(speed_*directionAt(inward));
    const point place
    (
        onPatch + (1 + 1e-6)*r*inward + random.sample01<scalar>()*deltaT*v
    );

    entrance e{place, v, t.cell};
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
    // The volume that is swept
    scalar inflow = 0;
    for (const patchTriangle& t : triangles_)
    {
        const vector area(t.area());
        inflow -= area & directionAt(-area/mag(area));
    }

    return randomFraction*rho*inflow*speed_;
}
