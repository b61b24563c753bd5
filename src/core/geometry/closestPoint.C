/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "closestPoint.H"

namespace Foam
{
namespace cghs
{

//- The point of segment ab nearest to x
static vector onSegment(const vector& a, const vector& b, const vector& x)
{
    const vector along(b - a);
    const scalar share = ((x - a) & along)/max(magSqr(along), VSMALL);

    return a + min(max(share, scalar(0)), scalar(1))*along;
}

} // End namespace cghs
} // End namespace Foam


Foam::cghs::nearestOnTriangle Foam::cghs::closestPoint
(
    const vector& a,
    const vector& b,
    const vector& c,
    const vector& x
)
{
    const vector normal((b - a) ^ (c - a));
    const scalar area2 = magSqr(normal);

    // A sliver has no plane to speak of
    const scalar longest =
        max(max(magSqr(b - a), magSqr(c - b)), magSqr(a - c));

    if (area2 > SMALL*sqr(longest))
    {
        // Barycentric coordinates of the foot of the perpendicular
        const scalar u = (((c - b) ^ (x - b)) & normal)/area2;
        const scalar v = (((a - c) ^ (x - c)) & normal)/area2;
        const scalar w = 1 - u - v;

        if (u >= 0 && v >= 0 && w >= 0)
        {
            return {u*a + v*b + w*c, true};
        }
    }

    // Outside, or a sliver: the nearest point is on the rim
    const vector candidates[3] =
    {
        onSegment(a, b, x), onSegment(b, c, x), onSegment(c, a, x)
    };

    vector best = candidates[0];

    for (const vector& p : candidates)
    {
        if (magSqr(p - x) < magSqr(best - x))
        {
            best = p;
        }
    }

    return {best, false};
}
