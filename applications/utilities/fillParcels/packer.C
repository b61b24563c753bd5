/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "packer.H"
#include "meshFreedom.H"

namespace Foam
{
namespace cghs
{

static FixedList<direction, 3> emptyLast(const vector& freedom)
{
    FixedList<direction, 3> axes({0, 1, 2});

    for (direction d = 0; d < 2; ++d)
    {
        if (freedom[d] == 0)
        {
            std::swap(axes[d], axes[2]);
        }
    }
    return axes;
}

}
}


Foam::cghs::packer::packer
(
    const polyMesh& mesh,
    const List<labelPair>& wallPatches,
    const label seed
)
:
    freedom_(freedom(mesh)),
    axes_(emptyLast(freedom_)),
    bounds_(mesh.bounds()),
    locator_(mesh),
    walls_(mesh, wallPatches, periods(mesh)),
    random_(seed)
{}


Foam::cghs::packer::gridCell
Foam::cghs::packer::sizeGrid::cellAt(const vector& x) const
{
    return gridCell
    ({
        label(floor(x.x()/width)),
        label(floor(x.y()/width)),
        label(floor(x.z()/width))
    });
}


Foam::cghs::packer::sizeGrid& Foam::cghs::packer::gridFor(const scalar r)
{
    for (sizeGrid& grid : grids_)
    {
        if (2*r <= grid.width && grid.width < 4*r)
        {
            return grid;
        }
    }

    grids_.append(new sizeGrid{2*r, {}});
    return grids_.last();
}


bool Foam::cghs::packer::wallBetween(const vector& a, const vector& b)
{
    return walls_.findThin(mag(b - a)) && walls_.between(a, b);
}


bool Foam::cghs::packer::freeOfOthers(const sphere& s)
{
    for (const sizeGrid& grid : grids_)
    {
        const vector reach(vector::uniform(s.r + 0.5*grid.width));
        const gridCell from(grid.cellAt(s.x - reach));
        const gridCell to(grid.cellAt(s.x + reach));

        for (label i = from[0]; i <= to[0]; ++i)
        {
            for (label j = from[1]; j <= to[1]; ++j)
            {
                for (label k = from[2]; k <= to[2]; ++k)
                {
                    const auto near = grid.spheres.cfind(gridCell({i, j, k}));

                    if (!near.found())
                    {
                        continue;
                    }

                    for (const label other : near())
                    {
                        const sphere& t = placed_[other];

                        if
                        (
                            magSqr(t.x - s.x) < sqr(s.r + t.r)
                         && !wallBetween(s.x, t.x)
                        )
                        {
                            return false;
                        }
                    }
                }
            }
        }
    }

    return true;
}


Foam::label Foam::cghs::packer::freeCell
(
    const sphere& s,
    const boundBox& region
)
{
    if (!region.contains(s.x) || !freeOfOthers(s))
    {
        return -1;
    }

    const label celli = locator_.find(s.x);

    return celli == -1 || walls_.touches(s) ? -1 : celli;
}


void Foam::cghs::packer::place(const sphere& s, const label celli)
{
    sizeGrid& grid = gridFor(s.r);

    grid.spheres(grid.cellAt(s.x)).append(placed_.size());
    placed_.append(s);
    cells_.append(celli);
}


void Foam::cghs::packer::forget(const label nKept)
{
    placed_.resize(nKept);
    cells_.resize(nKept);
    grids_.clear();

    forAll(placed_, i)
    {
        sizeGrid& grid = gridFor(placed_[i].r);
        grid.spheres(grid.cellAt(placed_[i].x)).append(i);
    }
}


Foam::boundBox Foam::cghs::packer::centresIn
(
    const boundBox& region,
    const scalar r
) const
{
    const vector margin(vector::uniform(r*(1 + 1e-9)));
    boundBox centres(region.min() + margin, region.max() - margin);

    for (direction d = 0; d < 3; ++d)
    {
        if (freedom_[d] == 0)
        {
            centres.min()[d] = centres.max()[d] = bounds_.centre()[d];
        }
    }
    return centres;
}


bool Foam::cghs::packer::addSequentially
(
    const boundBox& region,
    const UList<scalar>& radii
)
{
    // Once so many draws in a row find no place, few places are left
    constexpr label patience = 2000;

    label failures = 0;

    for (label added = 0; added < radii.size() && failures < patience; )
    {
        const boundBox centres(centresIn(region, radii[added]));
        const sphere s
        (
            random_.position(centres.min(), centres.max()),
            radii[added]
        );
        const label celli = freeCell(s, centres);

        if (celli == -1)
        {
            ++failures;
        }
        else
        {
            place(s, celli);
            failures = 0;
            ++added;
        }
    }

    return failures < patience;
}


Foam::List<Foam::vector> Foam::cghs::packer::freeSites
(
    const boundBox& region,
    const scalar r,
    const scalar a
)
{
    // Layers of triangles, each over the hollows of the one before
    const vector step(a, a*sqrt(0.75), a*sqrt(2.0/3.0));
    const vector hollow(0.5*a, step.y()/3, 0);
    vector span(Zero);
    for (direction d = 0; d < 3; ++d)
    {
        span[d] = region.span()[axes_[d]];
    }

    DynamicList<vector> sites;
    vector last(Zero);

    for (label k = 0; k*step.z() <= span.z(); ++k)
    {
        for (label j = 0; j*step.y() <= span.y(); ++j)
        {
            for (label i = 0; i*step.x() <= span.x(); ++i)
            {
                const vector x
                (
                    i*step.x() + hollow.x()*((j + k) % 2),
                    j*step.y() + hollow.y()*(k % 2),
                    k*step.z()
                );

                if (x.x() <= span.x() && x.y() <= span.y())
                {
                    sites.append(x);
                    last = max(last, x);
                }
            }
        }
    }

    // No gap at the far sides. A single layer goes to the middle
    DynamicList<vector> free;

    for (const vector& site : sites)
    {
        vector x(region.min());
        for (direction d = 0; d < 3; ++d)
        {
            x[axes_[d]] +=
                last[d] > 0 ? site[d]*(span[d]/last[d]) : 0.5*span[d];
        }

        // Rounding must not put the last layer outside
        x = min(x, region.max());

        if (freeCell(sphere(x, r), region) != -1)
        {
            free.append(x);
        }
    }

    return List<vector>(std::move(free));
}


Foam::label Foam::cghs::packer::addOnLattice
(
    const boundBox& region,
    const UList<scalar>& radii
)
{
    const scalar r = radii[0];
    const label n = radii.size();

    // The widest lattice that has n free sites
    scalar tight = 2*r*(1 + 1e-6);
    scalar wide = 4*r;

    const label capacity = freeSites(region, r, tight).size();
    if (capacity < n)
    {
        return capacity;
    }

    for (label step = 0; step < 12; ++step)
    {
        const scalar a = 0.5*(tight + wide);
        (freeSites(region, r, a).size() < n ? wide : tight) = a;
    }

    List<vector> sites(freeSites(region, r, tight));

    // Two neighbours that are shaken towards each other just do not touch
    const scalar play = 0.5*(tight - 2*r)/sqrt(3.0);

    for (label i = 0; i < n; ++i)
    {
        std::swap(sites[i], sites[random_.position(i, sites.size() - 1)]);

        const sphere site(sites[i], radii[i]);
        const sphere shaken
        (
            sites[i]
          + play
           *cmptMultiply
            (
                freedom_,
                2*random_.sample01<vector>() - vector::uniform(1)
            ),
            radii[i]
        );

        const label celli = freeCell(shaken, region);

        if (celli != -1)
        {
            place(shaken, celli);
        }
        else
        {
            place(site, locator_.find(site.x));
        }
    }

    return n;
}


Foam::label Foam::cghs::packer::fill
(
    const boundBox& region,
    const UList<scalar>& radii
)
{
    const label n = radii.size();
    const label before = placed_.size();

    if (n == 0)
    {
        return 0;
    }

    // The box holds whole spheres
    const boundBox centres(centresIn(region, radii[0]));

    if (centres.empty())
    {
        return 0;
    }

    if (addSequentially(region, radii))
    {
        return n;
    }

    forget(before);
    return addOnLattice(centres, radii);
}
