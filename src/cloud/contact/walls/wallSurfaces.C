/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "wallSurfaces.H"
#include "closestPoint.H"
#include "patchParts.H"
#include "facesOfRanks.H"
#include "periodicShifts.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "pointField.H"
#include "SubField.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * * Triangles * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace cghs
{

//- Nearness of two points, or of a point and a plane, in radii
constexpr scalar nearness = 1e-6;


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

} // End namespace cghs
} // End namespace Foam


Foam::cghs::wallSurfaces::triangle::triangle
(
    const vector& a,
    const vector& b,
    const vector& c,
    const contact::surfaceType surface
)
:
    a(a),
    b(b),
    c(c),
    surface(surface),
    thin(false)
{
    const vector area((b - a) ^ (c - a));

    normal = area/mag(area);
    gradA = (area ^ (c - b))/magSqr(area);
    gradB = (area ^ (a - c))/magSqr(area);
    heights = {1/mag(gradA), 1/mag(gradB), 1/mag(gradA + gradB)};
}


void Foam::cghs::wallSurfaces::appendCorners
(
    const polyPatch& pp,
    const pointField& points,
    const label firstFace,
    DynamicList<point>& corners,
    DynamicList<label>& faces
)
{
    forAll(pp, i)
    {
        const face& f = pp[i];

        const auto add = [&](const point& a, const point& b, const point& c)
        {
            if (mag((b - a) ^ (c - a)) > VSMALL)
            {
                corners.append(a);
                corners.append(b);
                corners.append(c);
                faces.append(firstFace + i);
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
}


// * * * * * * * * * * * * * * * * The grids * * * * * * * * * * * * * * * * //

Foam::label Foam::cghs::wallSurfaces::triangleGrid::index
(
    const vector& x
) const
{
    label i = 0;

    for (direction d = 0; d < 3; ++d)
    {
        const scalar cell = floor((x[d] - origin[d])/width);

        if (cell < 0 || cell >= n[d])
        {
            return -1;
        }
        i = i*n[d] + label(cell);
    }

    return i;
}


Foam::cghs::wallSurfaces::triangleGrid::triangleGrid
(
    const UList<triangle>& all,
    const scalar reach
)
:
    origin(Zero),
    width(1),
    n(0, 0, 0),
    start(1, Zero)
{
    constexpr scalar maxCells = 2e6;

    boundBox box(vector::uniform(GREAT), vector::uniform(-GREAT));
    for (const triangle& t : all)
    {
        for (const vector& p : {t.a, t.b, t.c})
        {
            box.min() = min(box.min(), p);
            box.max() = max(box.max(), p);
        }
    }

    if (all.empty())
    {
        return;
    }

    box.inflate(SMALL);
    origin = box.min() - vector::uniform(reach);
    const vector span(box.span() + vector::uniform(2*reach));

    // No finer than a parcel's reach, no more cells than memory is worth
    width = max(reach, cbrt(span.x()*span.y()*span.z()/maxCells));
    for (direction d = 0; d < 3; ++d)
    {
        n[d] = label(span[d]/width) + 1;
    }

    const label nCells = n.x()*n.y()*n.z();

    // Once to count, once to fill
    labelList count(nCells, Zero);
    labelList fill;

    for (const bool counting : {true, false})
    {
        forAll(all, ti)
        {
            const triangle& t = all[ti];
            labelVector lo, hi;

            for (direction d = 0; d < 3; ++d)
            {
                const scalar low = min(min(t.a[d], t.b[d]), t.c[d]) - reach;
                const scalar high = max(max(t.a[d], t.b[d]), t.c[d]) + reach;
                lo[d] = max(label(floor((low - origin[d])/width)), 0);
                hi[d] = min(label((high - origin[d])/width), n[d] - 1);
            }

            for (label i = lo.x(); i <= hi.x(); ++i)
            {
                for (label j = lo.y(); j <= hi.y(); ++j)
                {
                    for (label k = lo.z(); k <= hi.z(); ++k)
                    {
                        const vector centre
                        (
                            origin + width*vector(i + 0.5, j + 0.5, k + 0.5)
                        );
                        const vector p
                        (
                            closestPoint(t.a, t.b, t.c, centre).point
                        );

                        if (mag(p - centre) > reach + 0.87*width)
                        {
                            continue;  // Off its half diagonal: out of reach
                        }

                        const label c = (i*n.y() + j)*n.z() + k;

                        if (counting)
                        {
                            ++count[c];
                        }
                        else
                        {
                            triangles[fill[c]++] = ti;
                        }
                    }
                }
            }
        }

        if (counting)
        {
            start.resize(nCells + 1);
            start[0] = 0;
            forAll(count, c)
            {
                start[c + 1] = start[c] + count[c];
            }
            triangles.resize(start.last());
            fill = SubList<label>(start, nCells);
        }
    }
}


void Foam::cghs::wallSurfaces::widen(const scalar reach)
{
    if (reach > reach_)
    {
        reach_ = 1.01*reach;
        grids_.clear();
    }
}


const Foam::cghs::wallSurfaces::triangleGrid&
Foam::cghs::wallSurfaces::gridOf(const scalar reach)
{
    constexpr label maxGrids = 8;

    const label level = min(std::ilogb(reach_/reach), maxGrids - 1);

    if (level >= grids_.size())
    {
        grids_.resize(level + 1);
    }
    if (!grids_.set(level))
    {
        grids_.set
        (
            level,
            new triangleGrid(triangles_, std::ldexp(reach_, -level))
        );
    }

    return grids_[level];
}


template<class Visitor>
void Foam::cghs::wallSurfaces::forNear
(
    const vector& x,
    const scalar reach,
    const Visitor& visit
)
{
    const triangleGrid& grid = gridOf(reach);
    const label c = grid.index(x);

    if (c == -1)
    {
        return;
    }

    for (label k = grid.start[c]; k < grid.start[c + 1]; ++k)
    {
        const triangle& t = triangles_[grid.triangles[k]];

        // The plane alone tells most of them to be too far off
        if
        (
            mag((t.a - x) & t.normal) < reach
         && magSqr(closestPoint(t.a, t.b, t.c, x).point - x) < sqr(reach)
        )
        {
            visit(grid.triangles[k]);
        }
    }
}

// * * * * * * * * * * * * * * * * The contacts  * * * * * * * * * * * * * * //

void Foam::cghs::wallSurfaces::appendNear
(
    const label ti,
    const sphere& s,
    const scalar reach,
    DynamicList<near>& found
) const
{
    const triangle& t = triangles_[ti];

    const scalar height = (t.a - s.x) & t.normal;

    // Out of reach of the plane, or behind a baffle
    if (height > reach || height < 0)
    {
        return;
    }

    const vector fromC(s.x - t.c);
    const scalar u = t.gradA & fromC;
    const scalar v = t.gradB & fromC;
    const scalar w = 1 - u - v;

    vector d(height*t.normal);
    const bool interior = u >= 0 && v >= 0 && w >= 0;

    if (!interior)
    {
        // Out of reach of a side
        const scalar beside =
            -min(min(u*t.heights[0], v*t.heights[1]), w*t.heights[2]);

        if (sqr(beside) + sqr(height) > sqr(reach))
        {
            return;
        }

        d = closestPoint(t.a, t.b, t.c, s.x).point - s.x;

        if (magSqr(d) >= sqr(reach))
        {
            return;
        }
    }

    const scalar least = nearness*s.r;
    found.append
    (
        near
        {
            magSqr(d) < sqr(least) ? least*t.normal : d, interior, t.surface, ti
        }
    );
}


void Foam::cghs::wallSurfaces::findContacts
(
    const label i,
    const sphere& s,
    const label wallBody,
    const scalar reach,
    DynamicList<near>& found,
    DynamicList<contact>& contacts,
    DynamicList<label>& faces
) const
{
    found.clear();
    contacts.clear();
    faces.clear();

    for (label k = start_[i]; k < start_[i + 1]; ++k)
    {
        appendNear(candidates_[k], s, reach, found);
    }

    std::sort
    (
        found.begin(),
        found.end(),
        [](const near& a, const near& b)
        {
            return
                a.interior != b.interior
              ? a.interior
              : magSqr(a.d) < magSqr(b.d);
        }
    );

    for (const near& f : found)
    {
        bool hidden = false;

        for (const contact& c : contacts)
        {
            hidden =
                hidden || (f.d & c.n) > s.r - c.overlap - nearness*s.r;
        }

        if (!hidden)
        {
            const label body =
                moving_.empty() ? wallBody : wallBody + movingBody_[f.triangle];

            contacts.append(makeContact(i, body, f.surface, i, f.d, s.r));
            faces.append(faces_[f.triangle]);
        }
    }
}


void Foam::cghs::wallSurfaces::find
(
    const UList<sphere>& spheres,
    const label nOwn,
    const scalar skin
)
{
    scalar reach = 0;
    for (label i = 0; i < nOwn; ++i)
    {
        reach = max(reach, spheres[i].r + skin);
    }

    widen(reach);
    findThin(reach);

    start_.resize(nOwn + 1);
    candidates_.clear();

    for (label i = 0; i < nOwn; ++i)
    {
        start_[i] = candidates_.size();

        forNear
        (
            spheres[i].x,
            spheres[i].r + skin,
            [&](const label ti) { candidates_.append(ti); }
        );
    }

    start_[nOwn] = candidates_.size();

    findMoving();
}


void Foam::cghs::wallSurfaces::findMoving()
{
    for (const label ti : moving_)
    {
        movingBody_[ti] = 0;
    }
    moving_.clear();

    if (velocities_.empty())
    {
        return;
    }

    movingBody_.resize(triangles_.size(), 0);

    for (const label ti : candidates_)
    {
        if (!movingBody_[ti] && velocities_[faces_[ti]] != vector::zero)
        {
            moving_.append(ti);
            movingBody_[ti] = moving_.size();
        }
    }
}


bool Foam::cghs::wallSurfaces::setVelocities
(
    const UList<vectorField>& byPatch
)
{
    bool moves = false;
    for (const vectorField& u : byPatch)
    {
        for (const vector& ui : u)
        {
            moves = moves || ui != vector::zero;
        }
    }

    if (!returnReduce(moves, orOp<bool>()))
    {
        const bool stopped = velocities_.size();
        velocities_.clear();
        return stopped;
    }

    const Field<vector> all(facesOfRanks(byPatch));

    const bool changed = all.size() != velocities_.size() || all != velocities_;
    velocities_ = all;
    return changed;
}


bool Foam::cghs::wallSurfaces::crosses
(
    const triangle& t,
    const vector& a,
    const vector& b
)
{
    const scalar before = (t.a - a) & t.normal;
    const scalar after = (t.a - b) & t.normal;

    if (before < 0 || after >= 0)
    {
        return false;
    }

    const vector fromC(a + (before/(before - after))*(b - a) - t.c);
    const scalar u = t.gradA & fromC;
    const scalar v = t.gradB & fromC;

    // No gap between triangles that share a side
    constexpr scalar inside = -1e-6;
    return u > inside && v > inside && 1 - u - v > inside;
}


bool Foam::cghs::wallSurfaces::findThin(const scalar thickness)
{
    // A rank without parcels has none to keep apart
    if (thickness <= max(thinnest_, scalar(0)))
    {
        return anyThin_;
    }

    // A little more, so that it is not asked for again; no more than the grid
    // serves anyway, as a wider one would make all look-ups dearer
    widen(thickness);
    thinnest_ = min(1.01*thickness, reach_);

    const triangleGrid& grid = gridOf(thinnest_);

    for (triangle& t : triangles_)
    {
        const vector centre((t.a + t.b + t.c)/3);
        const label c = grid.index(centre);

        for
        (
            label k = c == -1 ? 0 : grid.start[c];
            !t.thin && c != -1 && k < grid.start[c + 1];
            ++k
        )
        {
            // Most are of the same wall, and look the same way
            const triangle& other = triangles_[grid.triangles[k]];

            if ((t.normal & other.normal) < -0.5)
            {
                const vector behind
                (
                    closestPoint(other.a, other.b, other.c, centre).point
                  - centre
                );

                t.thin =
                    magSqr(behind) < sqr(thinnest_)
                 && (behind & t.normal) > -nearness*thinnest_;
            }
        }
        anyThin_ = anyThin_ || t.thin;
    }

    return anyThin_;
}


bool Foam::cghs::wallSurfaces::between(const vector& a, const vector& b)
{
    const scalar reach = mag(b - a);

    if (reach == 0)
    {
        return false;
    }
    widen(reach);

    bool found = false;
    forNear
    (
        a,
        reach,
        [&](const label ti)
        {
            const triangle& t = triangles_[ti];
            found = found || (t.thin && (crosses(t, a, b) || crosses(t, b, a)));
        }
    );
    return found;
}


bool Foam::cghs::wallSurfaces::touches(const sphere& s)
{
    widen(s.r);

    bool touching = false;
    forNear(s.x, s.r, [&](const label) { touching = true; });
    return touching;
}

// * * * * * * * * * * * * * * * * * Public  * * * * * * * * * * * * * * * * //

Foam::cghs::wallSurfaces::wallSurfaces
(
    const polyMesh& mesh,
    const UList<labelPair>& patches,
    const UList<vector>& periods
)
:
    reach_(-1),
    thinnest_(-1),
    anyThin_(false),
    start_(1, Zero)
{
    // Every rank sees all faces and keeps those near its part of the mesh.
    // How far parcels will reach is not known yet: the largest of them is
    // taken to fit into the mesh of a rank, widened by its own size
    boundBox box(mesh.points(), false);
    box.inflate(0.1);
    DynamicList<triangle> kept;

    List<vector> shifts(periodicShifts(periods, false));
    shifts.append(vector(Zero));

    DynamicList<label> faces;
    label firstFace = 0;

    for (const labelPair& patch : patches)
    {
        const auto surface = contact::surfaceType(patch.second());
        DynamicList<point> own;
        DynamicList<label> ownFaces;
        label nOwnFaces = 0;
        patches_.append(patch.first());

        for (const label parti : patchParts(mesh, patch.first()))
        {
            const polyPatch& pp = mesh.boundaryMesh()[parti];

            appendCorners(pp, mesh.points(), nOwnFaces, own, ownFaces);
            nOwnFaces += pp.size();
        }

        List<pointField> all(Pstream::nProcs());
        all[Pstream::myProcNo()] = pointField(std::move(own));
        Pstream::gatherList(all);
        Pstream::scatterList(all);

        List<labelList> allFaces(Pstream::nProcs());
        allFaces[Pstream::myProcNo()] = ownFaces;
        Pstream::gatherList(allFaces);
        Pstream::scatterList(allFaces);

        labelList nFaces(Pstream::nProcs(), Zero);
        nFaces[Pstream::myProcNo()] = nOwnFaces;
        Pstream::gatherList(nFaces);
        Pstream::scatterList(nFaces);

        forAll(all, rank)
        {
            const pointField& corners = all[rank];

            for (label k = 0; k < corners.size(); k += 3)
            {
                for (const vector& s : shifts)
                {
                    const vector a(corners[k] + s);
                    const vector b(corners[k + 1] + s);
                    const vector c(corners[k + 2] + s);

                    if
                    (
                        box.overlaps
                        (
                            boundBox(min(min(a, b), c), max(max(a, b), c))
                        )
                    )
                    {
                        kept.append(triangle(a, b, c, surface));
                        faces.append(firstFace + allFaces[rank][k/3]);
                    }
                }
            }
            firstFace += nFaces[rank];
        }
    }

    triangles_.transfer(kept);
    faces_.transfer(faces);
}


std::size_t Foam::cghs::wallSurfaces::bytes() const
{
    std::size_t n = start_.size() + candidates_.capacity();

    forAll(grids_, level)
    {
        if (grids_.set(level))
        {
            n += grids_[level].start.size() + grids_[level].triangles.size();
        }
    }

    return
        triangles_.byteSize() + faces_.byteSize() + velocities_.byteSize()
      + sizeof(label)*n;
}
