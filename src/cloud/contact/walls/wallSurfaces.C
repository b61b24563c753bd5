/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "wallSurfaces.H"
#include "gatherWalls.H"

#include <algorithm>

namespace Foam
{
namespace cghs
{

//- Nearness of two points, or of a point and a plane, in radii
constexpr scalar nearness = 1e-6;

} // End namespace cghs
} // End namespace Foam


Foam::cghs::wallSurfaces::wallSurfaces
(
    const polyMesh& mesh,
    const UList<labelPair>& patches,
    const UList<vector>& periods
)
:
    thinnest_(-1),
    anyThin_(false),
    start_(1, Zero)
{
    for (const labelPair& patch : patches)
    {
        patches_.append(patch.first());
    }

    gatherWalls(mesh, patches, periods, triangles_, faces_);
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
    const wallTriangle& t = triangles_[ti];
    vector d;
    bool interior = false;

    if (!t.nearest(s.x, reach, d, interior))
    {
        return;
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
    const scalar distance,
    const label wallBody,
    const scalar gap,
    DynamicList<near>& found,
    DynamicList<contact>& contacts,
    DynamicList<label>& faces
) const
{
    // Where the sphere meets a surface, from its centre
    const auto distanceTo = [&](const label surface)
    {
        return surface == contact::parcelMirror ? s.r : distance;
    };

    found.clear();
    contacts.clear();
    faces.clear();

    for (label k = start_[i]; k < start_[i + 1]; ++k)
    {
        const label ti = candidates_[k];

        appendNear(ti, s, distanceTo(triangles_[ti].surface) + gap, found);
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
            const scalar to = distanceTo(c.surface) - c.overlap;

            hidden = hidden || (f.d & c.n) > to - nearness*s.r;
        }

        if (!hidden)
        {
            const label body = moving_.bodyOf(f.triangle, wallBody);

            contacts.append
            (
                makeContact
                (
                    i,
                    body,
                    f.surface,
                    i,
                    f.d,
                    distanceTo(f.surface)
                )
            );
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

    search_.widen(reach);
    findThin(reach);

    start_.resize(nOwn + 1);
    candidates_.clear();

    for (label i = 0; i < nOwn; ++i)
    {
        start_[i] = candidates_.size();

        search_.forNear
        (
            triangles_,
            spheres[i].x,
            spheres[i].r + skin,
            [&](const label ti) { candidates_.append(ti); }
        );
    }

    start_[nOwn] = candidates_.size();

    moving_.find(candidates_, faces_);
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
    search_.widen(thickness);
    thinnest_ = min(1.01*thickness, search_.reach());

    const triangleGrid& grid = search_.gridOf(triangles_, thinnest_);

    for (wallTriangle& t : triangles_)
    {
        const vector centre((t.a + t.b + t.c)/3);

        for (const label ti : grid.near(centre))
        {
            if (t.thin)
            {
                break;
            }

            // Most are of the same wall, and look the same way
            const wallTriangle& other = triangles_[ti];

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
    search_.widen(reach);

    bool found = false;
    search_.forNear
    (
        triangles_,
        a,
        reach,
        [&](const label ti)
        {
            const wallTriangle& t = triangles_[ti];
            found = found || (t.thin && t.between(a, b));
        }
    );
    return found;
}


bool Foam::cghs::wallSurfaces::touches(const sphere& s)
{
    search_.widen(s.r);

    bool touching = false;
    search_.forNear
    (
        triangles_,
        s.x,
        s.r,
        [&](const label) { touching = true; }
    );
    return touching;
}


std::size_t Foam::cghs::wallSurfaces::bytes() const
{
    return
        triangles_.size()*sizeof(wallTriangle) + faces_.byteSize()
      + moving_.bytes()
      + search_.bytes()
      + sizeof(label)*(start_.size() + candidates_.capacity());
}
