/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "searchGrid.H"
#include "sortedIndices.H"
#include "ListOps.H"

#include <algorithm>

Foam::scalar Foam::cghs::searchGrid::nCells(const vector& span) const
{
    scalar n = 1;

    for (direction d = 0; d < 3; ++d)
    {
        n *= floor(span[d]/width_) + 1;
    }

    return n;
}


void Foam::cghs::searchGrid::bulkOf
(
    const UList<sphere>& spheres,
    vector& low,
    vector& high
)
{
    // So many in a hundred, at each end of each direction, are not the bulk
    constexpr label strays = 1;

    const label cut = strays*spheres.size()/100;
    List<scalar> x(spheres.size());

    for (direction d = 0; d < 3; ++d)
    {
        forAll(spheres, i)
        {
            x[i] = spheres[i].x[d];
        }

        std::nth_element(x.begin(), x.begin() + cut, x.end());
        low[d] = x[cut];

        const label top = x.size() - 1 - cut;
        std::nth_element(x.begin(), x.begin() + top, x.end());
        high[d] = x[top];
    }
}


void Foam::cghs::searchGrid::lay
(
    const UList<sphere>& spheres,
    const scalar width
)
{
    vector low(GREAT, GREAT, GREAT);
    vector high(-GREAT, -GREAT, -GREAT);

    for (const sphere& s : spheres)
    {
        low = min(low, s.x);
        high = max(high, s.x);
    }

    if (spheres.empty())
    {
        low = high = Zero;
    }

    const scalar maxCells = 4.0*spheres.size() + 64;
    width_ = max(width, VSMALL);

    // A few strays far from the rest would make a grid of empty cells: they
    // are counted to the outermost cells instead
    if (nCells(high - low) > maxCells)
    {
        bulkOf(spheres, low, high);
    }

    // What is sparse all over gets wider cells
    while (nCells(high - low) > maxCells)
    {
        width_ *= 1.3;
    }

    origin_ = low;
    const vector span(high - low);

    for (direction d = 0; d < 3; ++d)
    {
        n_[d] = label(span[d]/width_) + 1;
    }
}

// * * * * * * * * * * * * * * * * * Public  * * * * * * * * * * * * * * * * //

Foam::cghs::searchGrid::searchGrid(const direction layerAxis)
:
    axes_((layerAxis + 1) % 3, (layerAxis + 2) % 3, layerAxis),
    origin_(Zero),
    width_(1),
    n_(1, 1, 1),
    cellStart_(2, Zero)
{}


Foam::labelList Foam::cghs::searchGrid::sort
(
    const UList<sphere>& spheres,
    const scalar width
)
{
    lay(spheres, width);

    labelList cells(spheres.size());

    forAll(spheres, i)
    {
        cells[i] = index(spheres[i].x);
    }

    return sortedIndices(cells, n_.x()*n_.y()*n_.z(), cellStart_);
}
