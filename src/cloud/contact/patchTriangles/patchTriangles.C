/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "patchTriangles.H"
#include "polyMesh.H"
#include "DynamicList.H"

#include <algorithm>

namespace Foam
{
namespace cghs
{

//- By x, then y, then z, of one corner after the other
static bool before(const patchTriangle& a, const patchTriangle& b)
{
    const scalar* const p = a.corners[0].cdata();
    const scalar* const q = b.corners[0].cdata();

    return std::lexicographical_compare(p, p + 9, q, q + 9);
}

} // End namespace cghs
} // End namespace Foam


Foam::List<Foam::cghs::patchTriangle> Foam::cghs::gatherTriangles
(
    const polyPatch& patch
)
{
    const pointField& points = patch.boundaryMesh().mesh().points();

    List<List<point>> corners(Pstream::nProcs());
    DynamicList<point> own;
    DynamicList<label> ownCells;

    forAll(patch, i)
    {
        const face& f = patch[i];

        for (label k = 1; k < f.size() - 1; ++k)
        {
            for (const label pointi : {f[0], f[k], f[k + 1]})
            {
                own.append(points[pointi]);
            }
            ownCells.append(patch.faceCells()[i]);
        }
    }

    corners[Pstream::myProcNo()] = own;
    Pstream::gatherList(corners);
    Pstream::scatterList(corners);

    DynamicList<patchTriangle> all;
    forAll(corners, rank)
    {
        const bool here = rank == Pstream::myProcNo();
        const List<point>& c = corners[rank];

        for (label k = 0; k < c.size(); k += 3)
        {
            patchTriangle t;
            t.corners = {c[k], c[k + 1], c[k + 2]};
            t.cell = here ? ownCells[k/3] : -1;
            all.append(t);
        }
    }

    std::sort(all.begin(), all.end(), before);

    return List<patchTriangle>(std::move(all));
}


Foam::boundBox Foam::cghs::boundsOf(const UList<patchTriangle>& triangles)
{
    boundBox box;

    for (const patchTriangle& t : triangles)
    {
        for (const point& x : t.corners)
        {
            box.add(x);
        }
    }

    return box;
}
