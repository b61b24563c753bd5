/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "gatherWalls.H"
#include "patchParts.H"
#include "periodicShifts.H"
#include "Pstream.H"
#include "pointField.H"
#include "SubField.H"

namespace Foam
{
namespace cghs
{

//- The faces of one rank on a patch, in triangles
struct patchFan
{
    //- Three a triangle
    DynamicList<point> corners;

    //- The face of each triangle, of the first on
    DynamicList<label> faces;

    label nFaces = 0;
};


//- Is a face as flat as rounding can tell, and convex, so that any of its
//  corners sees all of it?
static bool planar
(
    const face& f,
    const pointField& points,
    const point& centre,
    const vector& area
)
{
    const scalar size = mag(area);
    const vector n(area/max(size, VSMALL));

    forAll(f, k)
    {
        const vector& a = points[f[f.rcIndex(k)]];
        const vector& b = points[f[k]];
        const vector& c = points[f[f.fcIndex(k)]];

        if
        (
            mag((b - centre) & n) > 1e-9*sqrt(size)
         || (((b - a) ^ (c - b)) & n) < -1e-9*size
        )
        {
            return false;
        }
    }

    return true;
}


static void append(patchFan& fan, const polyPatch& pp, const pointField& points)
{
    forAll(pp, i)
    {
        const face& f = pp[i];

        const auto add = [&](const point& a, const point& b, const point& c)
        {
            if (mag((b - a) ^ (c - a)) > VSMALL)
            {
                fan.corners.append(a);
                fan.corners.append(b);
                fan.corners.append(c);
                fan.faces.append(fan.nFaces + i);
            }
        };

        // A fan about a corner, or, as it follows a warped face best, about the
        // centre
        const point& centre = pp.faceCentres()[i];

        if (planar(f, points, centre, pp.faceAreas()[i]))
        {
            for (label k = 1; k < f.size() - 1; ++k)
            {
                add(points[f[0]], points[f[k]], points[f[k + 1]]);
            }
            continue;
        }

        forAll(f, k)
        {
            add(centre, points[f[k]], points[f.nextLabel(k)]);
        }
    }

    fan.nFaces += pp.size();
}


template<class Type>
static List<Type> ofAllRanks(Type&& own)
{
    List<Type> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = std::move(own);
    Pstream::gatherList(all);
    Pstream::scatterList(all);

    return all;
}

} // End namespace cghs
} // End namespace Foam


void Foam::cghs::gatherWalls
(
    const polyMesh& mesh,
    const UList<labelPair>& patches,
    const UList<vector>& periods,
    List<wallTriangle>& triangles,
    labelList& faces
)
{
    // Every rank sees all faces and keeps those near its part of the mesh.
    // How far parcels will reach is not known yet: the largest of them is
    // taken to fit into the mesh of a rank, widened by its own size
    boundBox box(mesh.points(), false);
    box.inflate(0.1);

    List<vector> shifts(periodicShifts(periods, false));
    shifts.append(vector(Zero));

    DynamicList<wallTriangle> kept;
    DynamicList<label> keptFaces;
    label firstFace = 0;

    const auto keep = [&]
    (
        const vector& a,
        const vector& b,
        const vector& c,
        const contact::surfaceType surface,
        const label facei
    )
    {
        if (box.overlaps(boundBox(min(min(a, b), c), max(max(a, b), c))))
        {
            kept.append(wallTriangle(a, b, c, surface));
            keptFaces.append(facei);
        }
    };

    for (const labelPair& patch : patches)
    {
        const auto surface = contact::surfaceType(patch.second());
        patchFan own;

        for (const label parti : patchParts(mesh, patch.first()))
        {
            append(own, mesh.boundaryMesh()[parti], mesh.points());
        }

        const List<pointField> corners
        (
            ofAllRanks(pointField(std::move(own.corners)))
        );
        const List<labelList> fanFaces
        (
            ofAllRanks(labelList(std::move(own.faces)))
        );
        const labelList nFaces(ofAllRanks(label(own.nFaces)));

        forAll(corners, rank)
        {
            const pointField& x = corners[rank];

            for (label k = 0; k < x.size(); k += 3)
            {
                for (const vector& s : shifts)
                {
                    keep
                    (
                        x[k] + s,
                        x[k + 1] + s,
                        x[k + 2] + s,
                        surface,
                        firstFace + fanFaces[rank][k/3]
                    );
                }
            }
            firstFace += nFaces[rank];
        }
    }

    triangles.transfer(kept);
    faces.transfer(keptFaces);
}
