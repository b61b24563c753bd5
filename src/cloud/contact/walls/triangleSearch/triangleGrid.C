/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "triangleGrid.H"

namespace Foam
{
namespace cghs
{

//- Of all corners
static boundBox boundsOf(const UList<wallTriangle>& all)
{
    boundBox box(vector::uniform(GREAT), vector::uniform(-GREAT));

    for (const wallTriangle& t : all)
    {
        for (const vector& p : {t.a, t.b, t.c})
        {
            box.min() = min(box.min(), p);
            box.max() = max(box.max(), p);
        }
    }

    return box;
}

} // End namespace cghs
} // End namespace Foam


void Foam::cghs::triangleGrid::range
(
    const wallTriangle& t,
    const scalar reach,
    labelVector& low,
    labelVector& high
) const
{
    for (direction d = 0; d < 3; ++d)
    {
        const scalar from = min(min(t.a[d], t.b[d]), t.c[d]) - reach;
        const scalar to = max(max(t.a[d], t.b[d]), t.c[d]) + reach;

        low[d] = max(label(floor((from - origin_[d])/width_)), 0);
        high[d] = min(label((to - origin_[d])/width_), n_[d] - 1);
    }
}


template<class Visitor>
void Foam::cghs::triangleGrid::forCells
(
    const UList<wallTriangle>& all,
    const scalar reach,
    const Visitor& visit
) const
{
    labelVector lo, hi;

    forAll(all, ti)
    {
        const wallTriangle& t = all[ti];
        range(t, reach, lo, hi);

        for (label i = lo.x(); i <= hi.x(); ++i)
        {
            for (label j = lo.y(); j <= hi.y(); ++j)
            {
                for (label k = lo.z(); k <= hi.z(); ++k)
                {
                    const vector centre
                    (
                        origin_ + width_*vector(i + 0.5, j + 0.5, k + 0.5)
                    );
                    const vector p(closestPoint(t.a, t.b, t.c, centre).point);

                    // Off its half diagonal: out of reach
                    if (!(mag(p - centre) > reach + 0.87*width_))
                    {
                        visit((i*n_.y() + j)*n_.z() + k, ti);
                    }
                }
            }
        }
    }
}


Foam::cghs::triangleGrid::triangleGrid
(
    const UList<wallTriangle>& all,
    const scalar reach
)
:
    origin_(Zero),
    width_(1),
    n_(0, 0, 0),
    start_(1, Zero)
{
    constexpr scalar maxCells = 2e6;

    if (all.empty())
    {
        return;
    }

    boundBox box(boundsOf(all));
    box.inflate(SMALL);
    origin_ = box.min() - vector::uniform(reach);
    const vector span(box.span() + vector::uniform(2*reach));

    // No finer than a parcel's reach, no more cells than memory is worth
    const auto widthFor = [&](const vector& s)
    {
        return max(reach, cbrt(s.x()*s.y()*s.z()/maxCells));
    };

    width_ = widthFor(span);
    if (cmptProduct(vector::one + span/width_) > 2*maxCells)
    {
        // A plate alone: as flat as it is there is one cell across it
        width_ = widthFor(max(span, vector::uniform(0.01*cmptMax(span))));
    }
    for (direction d = 0; d < 3; ++d)
    {
        n_[d] = label(span[d]/width_) + 1;
    }

    // Once to count, once to fill
    const label nCells = n_.x()*n_.y()*n_.z();
    labelList count(nCells, Zero);
    forCells(all, reach, [&](const label c, const label) { ++count[c]; });

    start_.resize(nCells + 1);
    start_[0] = 0;
    forAll(count, c)
    {
        start_[c + 1] = start_[c] + count[c];
    }

    triangles_.resize(start_.last());
    labelList next(SubList<label>(start_, nCells));
    forCells
    (
        all,
        reach,
        [&](const label c, const label ti) { triangles_[next[c]++] = ti; }
    );
}
