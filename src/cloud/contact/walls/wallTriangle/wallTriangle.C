/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "wallTriangle.H"

Foam::cghs::wallTriangle::wallTriangle
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


bool Foam::cghs::wallTriangle::crosses
(
    const vector& p,
    const vector& q
) const
{
    const scalar before = (a - p) & normal;
    const scalar after = (a - q) & normal;

    if (before < 0 || after >= 0)
    {
        return false;
    }

    const vector fromC(p + (before/(before - after))*(q - p) - c);
    const scalar u = gradA & fromC;
    const scalar v = gradB & fromC;

    // No gap between triangles that share a side
    constexpr scalar inside = -1e-6;
    return u > inside && v > inside && 1 - u - v > inside;
}
