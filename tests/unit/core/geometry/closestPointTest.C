/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    The nearest point of a triangle, against geometry and brute force.

\*---------------------------------------------------------------------------*/

#include "closestPoint.H"
#include "claim.H"
#include "sampler.H"

#include <catch2/catch.hpp>

namespace Foam
{
namespace cghs
{

namespace
{

struct triangle
{
    vector a, b, c;

    vector at(const scalar u, const scalar v) const
    {
        return a + u*(b - a) + v*(c - a);
    }

    scalar size() const { return max(mag(b - a), mag(c - a)); }

    vector normal() const
    {
        const vector n((b - a) ^ (c - a));
        return n/mag(n);
    }

    nearestOnTriangle nearest(const vector& x) const
    {
        return closestPoint(a, b, c, x);
    }
};


//- Any shape, from equilateral to thin, of any size, anywhere
triangle randomTriangle(sampler& random)
{
    const scalar size = random.acrossDecades(1e-6, 1e3);
    const vector shift((random.between(0, 3)*size)*random.direction());
    triangle t;
    t.a = shift + size*random.direction();
    t.b = shift + size*random.direction();
    t.c = shift + size*random.direction();
    return t;
}


//- With the angle at a above a right one
triangle obtuseTriangle(sampler& random)
{
    triangle t(randomTriangle(random));
    const vector along((t.b - t.a)/mag(t.b - t.a));
    const scalar reach = mag((t.c - t.a) & along);
    t.c -= (((t.c - t.a) & along) + reach + 0.3*t.size())*along;
    return t;
}


//- Its corners nearly in a line: the height is this share of the length
triangle sliver(const scalar height, sampler& random)
{
    const vector along(random.direction());
    vector across(along ^ random.direction());
    across /= mag(across);

    triangle t;
    t.a = random.inBox(vector::uniform(-1), vector::uniform(1));
    t.b = t.a + along;
    t.c = t.a + random.between(-0.5, 1.5)*along + height*across;

    // Any corner may be the one between the others
    for (label turn = random.below(3); turn > 0; --turn)
    {
        const vector a(t.a);
        t.a = t.b;
        t.b = t.c;
        t.c = a;
    }
    return t;
}


//- A point near enough to matter: anywhere, or right above the inside
vector pointNear(const triangle& t, sampler& random)
{
    const scalar reach = random.acrossDecades(1e-3, 3)*t.size();
    const vector normal((t.b - t.a) ^ (t.c - t.a));

    if (random.below(2) && mag(normal) > 0)
    {
        const scalar u = random.between(0, 1);
        return
            t.at(u, random.between(0, 1 - u)) + (reach/mag(normal))*normal;
    }

    const vector base(t.at(random.between(-0.5, 1.5), random.between(-0.5, 1)));
    return base + reach*random.direction();
}


//- Distance of a point and the segment pq
scalar distanceToSegment(const vector& p, const vector& q, const vector& x)
{
    const scalar length2 = magSqr(q - p);
    const scalar share = length2 > 0 ? ((x - p) & (q - p))/length2 : 0;
    return mag(p + min(max(share, scalar(0)), scalar(1))*(q - p) - x);
}


//- Distance of a point and a triangle: the least of the distances to all
//  segments parallel to ac, found by thirds, since it is a convex function
scalar distanceByForce(const triangle& t, const vector& x)
{
    const auto distance = [&](const scalar u)
    {
        return distanceToSegment(t.at(u, 0), t.at(u, 1 - u), x);
    };

    scalar low = 0, high = 1;
    for (label i = 0; i < 100; ++i)
    {
        const scalar third = (high - low)/3;

        if (distance(low + third) < distance(high - third))
        {
            high -= third;
        }
        else
        {
            low += third;
        }
    }

    return min(distance(low), min(distance(0), distance(1)));
}


//- The point p of a convex body is the nearest to x if, and only if, no corner
//  q lies further towards x: (x - p) . (q - p) <= 0. By how much is that
//  missed, in squared lengths?
scalar optimalityError(const triangle& t, const vector& x, const vector& p)
{
    const vector towards(x - p);
    const scalar beyond =
        max
        (
            towards & (t.a - p),
            max(towards & (t.b - p), towards & (t.c - p))
        );

    return max(beyond, scalar(0))/sqr(t.size());
}


//- How far a point is outside of a triangle, in lengths, as seen from many
//  directions
scalar excursion(const triangle& t, const vector& p, sampler& random)
{
    scalar worst = 0;
    for (label i = 0; i < 12; ++i)
    {
        const vector n(random.direction());
        const scalar limit = max(n & t.a, max(n & t.b, n & t.c));
        worst = max(worst, (n & p) - limit);
    }
    return worst/t.size();
}


//- Check the answers for many points around triangles of a kind. Where these
//  are thin, rounding may shift the point along them by the given tolerance
template<class MakeTriangle>
void settleKind
(
    const char* nearestName,
    const char* withinName,
    const char* forceName,
    const scalar tolerance,
    const label seed,
    const MakeTriangle& make
)
{
    claim nearest(nearestName, tolerance);
    claim within(withinName, 1e-14);
    claim force(forceName, 1e-11);
    sampler random(seed);

    for (label i = 0; i < 5000; ++i)
    {
        const triangle t(make(random));
        const vector x(pointNear(t, random));
        const vector p(t.nearest(x).point);

        nearest.see(optimalityError(t, x, p));
        within.see(excursion(t, p, random));
        force.see(mag(mag(x - p) - distanceByForce(t, x))/t.size());
    }

    nearest.settle();
    within.settle();
    force.settle();
}

}


TEST_CASE("No point of a triangle is nearer than the nearest", "[geometry]")
{
    settleKind
    (
        "geometry.nearest", "geometry.withinTriangle", "geometry.bruteForce",
        1e-11, 91, randomTriangle
    );
}


TEST_CASE("Obtuse triangles are no different", "[geometry]")
{
    settleKind
    (
        "geometry.nearestObtuse", "geometry.withinObtuse",
        "geometry.bruteForceObtuse", 1e-11, 92, obtuseTriangle
    );
}


TEST_CASE("Slivers of any thinness are no different", "[geometry]")
{
    settleKind
    (
        "geometry.nearestSliver", "geometry.withinSliver",
        "geometry.bruteForceSliver", 1e-7, 93,
        [](sampler& random)
        {
            return sliver(random.acrossDecades(1e-20, 1e-2), random);
        }
    );
}


TEST_CASE("Corners in one line or one point are no different", "[geometry]")
{
    settleKind
    (
        "geometry.nearestLine", "geometry.withinLine",
        "geometry.bruteForceLine", 1e-14, 94,
        [](sampler& random) { return sliver(0, random); }
    );

    claim point("geometry.pointTriangle", 0);
    claim edge("geometry.twoCornersAlike", 1e-14);
    sampler random(95);
    for (label i = 0; i < 500; ++i)
    {
        const vector a(random.direction()), b(2*random.direction());
        const vector x(3*random.direction());
        point.count(closestPoint(a, a, a, x).point == a);
        point.count(!closestPoint(a, a, a, x).interior);

        const vector p(closestPoint(a, b, b, x).point);
        edge.see(mag(closestPoint(b, a, a, x).point - p));
        edge.see(mag(closestPoint(a, b, a, x).point - p));
        edge.see(optimalityError(triangle{a, b, b}, x, p));
    }
    point.settle();
    edge.settle();
}


TEST_CASE("Above the inside the nearest point is the foot, and interior",
    "[geometry]")
{
    claim foot("geometry.foot", 1e-12);
    claim flag("geometry.interiorFlag", 0);
    sampler random(96);

    for (label i = 0; i < 5000; ++i)
    {
        const triangle t(randomTriangle(random));
        const scalar area2 = mag((t.b - t.a) ^ (t.c - t.a));

        if (area2 < 1e-2*sqr(t.size()))
        {
            continue;
        }

        const scalar u = random.between(0.001, 0.998);
        const scalar v = random.between(0.001, 0.999 - u);
        const scalar height = random.between(-1, 1)*t.size();
        const nearestOnTriangle n = t.nearest(t.at(u, v) + height*t.normal());

        foot.see(mag(n.point - t.at(u, v))/t.size());
        flag.count(n.interior);
    }

    foot.settle();
    flag.settle();
}


TEST_CASE("Beyond an edge or a corner the nearest point lies on it",
    "[geometry]")
{
    claim edge("geometry.edge", 1e-12);
    claim corner("geometry.corner", 1e-14);
    claim flag("geometry.rimFlag", 0);
    sampler random(97);

    for (label i = 0; i < 5000; ++i)
    {
        const triangle t(randomTriangle(random));

        if (mag((t.b - t.a) ^ (t.c - t.a)) < 1e-2*sqr(t.size()))
        {
            continue;
        }

        const vector along((t.b - t.a)/mag(t.b - t.a));
        vector outwards(along ^ t.normal());
        outwards *= sign(outwards & (t.a - t.c));
        const vector height(random.between(-1, 1)*t.size()*t.normal());

        // Beyond the edge, above or below the triangle's plane
        const vector onEdge(t.a + random.between(0, 1)*(t.b - t.a));
        const scalar beyond = random.between(1e-3, 2)*t.size();
        const nearestOnTriangle e =
            t.nearest(onEdge + beyond*outwards + height);
        edge.see(mag(e.point - onEdge)/t.size());
        flag.count(!e.interior);

        // Beyond the corner: on the other side of it than both edges
        const vector toB((t.b - t.a)/mag(t.b - t.a));
        const vector toC((t.c - t.a)/mag(t.c - t.a));
        const nearestOnTriangle v = t.nearest
        (
            t.a - t.size()*(random.between(0.01, 1)*(toB + toC)) + height
        );
        corner.see(mag(v.point - t.a)/t.size());
        flag.count(!v.interior);
    }

    edge.settle();
    corner.settle();
    flag.settle();
}


TEST_CASE("Points of the triangle are their own nearest", "[geometry]")
{
    claim own("geometry.ownPoints", 1e-13);
    sampler random(98);

    for (label i = 0; i < 2000; ++i)
    {
        const triangle t(randomTriangle(random));
        const scalar u = random.between(0, 1);
        const vector inside(t.at(u, random.between(0, 1 - u)));

        for (const vector& x : {inside, t.a, t.b, t.c, 0.5*(t.a + t.b)})
        {
            own.see(mag(t.nearest(x).point - x)/t.size());
        }
    }

    own.settle();
}


TEST_CASE("The corners may be named in any order", "[geometry]")
{
    claim same("geometry.anyOrder", 1e-12);
    sampler random(99);

    for (label i = 0; i < 2000; ++i)
    {
        const triangle t(randomTriangle(random));

        if (mag((t.b - t.a) ^ (t.c - t.a)) < 1e-3*sqr(t.size()))
        {
            continue;
        }

        const vector x(pointNear(t, random));
        const vector p(t.nearest(x).point);
        same.see(mag(closestPoint(t.b, t.c, t.a, x).point - p)/t.size());
        same.see(mag(closestPoint(t.c, t.b, t.a, x).point - p)/t.size());
    }

    same.settle();
}

} // End namespace cghs
} // End namespace Foam
