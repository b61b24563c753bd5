/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "triangleSearch.H"

#include <cmath>

void Foam::cghs::triangleSearch::widen(const scalar reach)
{
    if (reach > reach_)
    {
        reach_ = 1.01*reach;
        grids_.clear();
    }
}


const Foam::cghs::triangleGrid& Foam::cghs::triangleSearch::gridOf
(
    const UList<wallTriangle>& triangles,
    const scalar reach
)
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
            new triangleGrid(triangles, std::ldexp(reach_, -level))
        );
    }

    return grids_[level];
}


std::size_t Foam::cghs::triangleSearch::bytes() const
{
    std::size_t n = 0;

    forAll(grids_, level)
    {
        if (grids_.set(level))
        {
            n += grids_[level].bytes();
        }
    }

    return n;
}
