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


Foam::label Foam::cghs::locator::walk(const vector& x, label& celli)
{
    constexpr label patience = 50;

    const label start = celli;
    label previous = -1;

    for (label step = 0; step < patience; ++step)
    {
        const label facei = exitFace(x, celli);

        if (facei == -1 || !mesh_.isInternalFace(facei))
        {
            return facei;
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
    nTracked_(0)
{
    inscribe();

    // Built by all ranks together, as the tracking may be called by one alone
    mesh_.tetBasePtIs();
}


Foam::vector Foam::cghs::locator::outwardNormal(const label facei) const
{
    const vector& area = mesh_.faceAreas()[facei];
    return area/max(mag(area), VSMALL);
}
