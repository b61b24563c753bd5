/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "locator.H"
#include "passiveParticle.H"
#include "indexedOctree.H"
#include "treeDataCell.H"

// * * * * * * * * * * * * * * * * The planes  * * * * * * * * * * * * * * * //

Foam::scalar Foam::cghs::locator::beyond
(
    const vector& x,
    const label facei,
    const label celli
) const
{
    const vector& area = mesh_.faceAreas()[facei];
    const scalar distance =
        ((x - mesh_.faceCentres()[facei]) & area)/max(mag(area), VSMALL);

    return mesh_.faceOwner()[facei] == celli ? distance : -distance;
}


void Foam::cghs::locator::inscribe()
{
    forAll(cores_, celli)
    {
        const labelList& points = mesh_.cellPoints()[celli];
        const boundBox box(mesh_.points(), points, false);
        const vector centre(box.midpoint());
        const vector half(0.5*box.span());

        // The box shrinks until its corner furthest out is within each face
        scalar share = 1;

        for (const label facei : mesh_.cells()[celli])
        {
            const vector n(outwardNormal(facei));
            const scalar corner = cmptMag(n) & half;
            const scalar room = -beyond(centre, facei, celli);

            share = min(share, room/max(corner, VSMALL));
        }

        cores_[celli] = core{centre, max(share, scalar(0))*half};
    }
}


Foam::label Foam::cghs::locator::exitFace
(
    const vector& x,
    const label celli
) const
{
    label inner = -1;
    label outer = -1;
    scalar furthestInner = 0;
    scalar furthestOuter = 0;

    for (const label facei : mesh_.cells()[celli])
    {
        const scalar distance = beyond(x, facei, celli);

        if (mesh_.isInternalFace(facei))
        {
            if (distance > furthestInner)
            {
                furthestInner = distance;
                inner = facei;
            }
        }
        else if (distance > furthestOuter)
        {
            furthestOuter = distance;
            outer = facei;
        }
    }

    return inner != -1 ? inner : outer;
}


void Foam::cghs::locator::findConcave()
{
    // Warped faces are not meant, whose points are a little off their plane
    constexpr scalar tolerance = 0.05;

    for
    (
        label facei = mesh_.nInternalFaces();
        facei < mesh_.nFaces();
        ++facei
    )
    {
        const label celli = mesh_.faceOwner()[facei];
        const scalar size = cbrt(mesh_.cellVolumes()[celli]);

        for (const label pointi : mesh_.cellPoints()[celli])
        {
            if (beyond(mesh_.points()[pointi], facei, celli) > tolerance*size)
            {
                concave_[celli] = true;
            }
        }
    }
}


Foam::label Foam::cghs::locator::ifOutside
(
    const vector& x,
    label& celli,
    const label facei
)
{
    if (mesh_.pointInCell(x, celli, polyMesh::CELL_TETS))
    {
        return -1;
    }

    // Through an inner face whose plane it is not beyond, or out through the
    // one found. Whoever is not where tracking ends is out
    label there = celli;
    const label met = track(mesh_.cellCentres()[celli], x, there);

    if (met == -1)
    {
        celli = there;
        return -1;
    }

    // Rather on to the other side of a coupled face than back from a wall
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    label coupled = -1;
    scalar furthest = 0;

    for (const label other : mesh_.cells()[celli])
    {
        const scalar distance =
            mesh_.isInternalFace(other) ? 0 : beyond(x, other, celli);

        if
        (
            distance > furthest
         && patches[patches.whichPatch(other)].coupled()
        )
        {
            furthest = distance;
            coupled = other;
        }
    }

    return coupled != -1 ? coupled : facei;
}


Foam::label Foam::cghs::locator::walk(const vector& x, label& celli)
{
    constexpr label patience = 50;

    const label start = celli;
    label previous = -1;

    for (label step = 0; step < patience; ++step)
    {
        const label facei = exitFace(x, celli);

        if (facei == -1)
        {
            return facei;
        }
        if (!mesh_.isInternalFace(facei))
        {
            return concave_[celli] ? ifOutside(x, celli, facei) : facei;
        }

        const label next =
            mesh_.faceOwner()[facei] == celli
          ? mesh_.faceNeighbour()[facei]
          : mesh_.faceOwner()[facei];

        if (next == previous)
        {
            break;  // Two warped cells each point at the other
        }

        previous = celli;
        celli = next;
    }

    celli = start;
    return track(mesh_.cellCentres()[start], x, celli);
}

// * * * * * * * * * * * * * * * The tetrahedra  * * * * * * * * * * * * * * //

Foam::label Foam::cghs::locator::track
(
    const vector& from,
    const vector& to,
    label& celli
)
{
    ++nTracked_;

    passiveParticle p(mesh_, from, celli);
    p.track(to - from, 0);
    celli = p.cell();

    return p.onBoundaryFace() ? p.face() : -1;
}


Foam::label Foam::cghs::locator::find(const vector& x) const
{
    return mesh_.cellTree().findInside(x);
}

// * * * * * * * * * * * * * * * * * Public  * * * * * * * * * * * * * * * * //

Foam::cghs::locator::locator(const polyMesh& mesh)
:
    mesh_(mesh),
    cores_(mesh.nCells()),
    concave_(mesh.nCells(), false),
    nTracked_(0)
{
    inscribe();
    findConcave();

    // Built by all ranks together, as the tracking may be called by one alone
    mesh_.tetBasePtIs();
}


Foam::vector Foam::cghs::locator::outwardNormal(const label facei) const
{
    const vector& area = mesh_.faceAreas()[facei];
    return area/max(mag(area), VSMALL);
}
