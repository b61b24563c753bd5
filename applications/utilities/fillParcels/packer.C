/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "packer.H"
#include "mathematicalConstants.H"

Foam::cghs::packer::packer
(
    const polyMesh& mesh,
    const labelList& wallPatches,
    const label seed
)
:
    mesh_(mesh),
    locator_(mesh),
    walls_(mesh, wallPatches),
    random_(seed),
    width_(0)
{}


Foam::cghs::packer::gridCell
Foam::cghs::packer::cellAt(const vector& x) const
{
    return gridCell
    ({
        label(floor(x.x()/width_)),
        label(floor(x.y()/width_)),
        label(floor(x.z()/width_))
    });
}


Foam::label Foam::cghs::packer::freeCell
(
    const sphere& s,
    const boundBox& region
)
{
    if (!region.contains(s.x))
    {
        return -1;
    }

    const gridCell c(cellAt(s.x));

    for (label i = -1; i <= 1; ++i)
    {
        for (label j = -1; j <= 1; ++j)
        {
            for (label k = -1; k <= 1; ++k)
            {
                const auto near =
                    grid_.cfind(gridCell({c[0] + i, c[1] + j, c[2] + k}));

                if (!near.found())
                {
                    continue;
                }

                for (const label other : near())
                {
                    const sphere& t = placed_[other];

                    if (magSqr(t.x - s.x) < sqr(s.r + t.r))
                    {
                        return -1;
                    }
                }
            }
        }
    }

    const label celli = locator_.find(s.x);

    return celli == -1 || walls_.touches(s) ? -1 : celli;
}


void Foam::cghs::packer::place(const sphere& s, const label celli)
{
    grid_(cellAt(s.x)).append(placed_.size());
    placed_.append(s);
    cells_.append(celli);
}


void Foam::cghs::packer::forget(const label nKept)
{
    placed_.resize(nKept);
    cells_.resize(nKept);
    grid_.clear();

    forAll(placed_, i)
    {
        grid_(cellAt(placed_[i].x)).append(i);
    }
}


bool Foam::cghs::packer::addSequentially
(
    const boundBox& region,
    const scalar r,
    const label n
)
{
    // Once so many draws in a row find no place, few places are left
    constexpr label patience = 2000;

    label failures = 0;

    for (label added = 0; added < n && failures < patience; )
    {
        const sphere s(random_.position(region.min(), region.max()), r);
        const label celli = freeCell(s, region);

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
    const scalar dy = a*sqrt(0.75);
    const scalar dz = a*sqrt(2.0/3.0);
    const vector span(region.span());

    DynamicList<vector> sites;

    for (label k = 0; k*dz <= span.z(); ++k)
    {
        for (label j = 0; j*dy <= span.y(); ++j)
        {
            const scalar shift = 0.5*a*(j % 2) + 0.5*a*(k % 2);

            for (label i = 0; i*a + shift <= span.x(); ++i)
            {
                const vector x
                (
                    region.min()
                  + vector
                    (
                        i*a + shift,
                        j*dy + (k % 2)*dy/3,
                        k*dz
                    )
                );

                if (freeCell(sphere(x, r), region) != -1)
                {
                    sites.append(x);
                }
            }
        }
    }

    return List<vector>(std::move(sites));
}


bool Foam::cghs::packer::addOnLattice
(
    const boundBox& region,
    const scalar r,
    const label n
)
{
    // The widest lattice that has n free sites
    scalar tight = 2*r*(1 + 1e-6);
    scalar wide = 4*r;

    if (freeSites(region, r, tight).size() < n)
    {
        return false;
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

        const sphere site(sites[i], r);
        const sphere shaken
        (
            sites[i]
          + play*(2*random_.sample01<vector>() - vector::uniform(1)),
            r
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

    return true;
}


void Foam::cghs::packer::widenGrid(const scalar r)
{
    if (2*r > width_)
    {
        width_ = 2*r;
        forget(placed_.size());
    }
}


bool Foam::cghs::packer::fill
(
    const boundBox& region,
    const scalar r,
    const label n
)
{
    const label before = placed_.size();

    widenGrid(r);

    // The box holds whole spheres
    const vector margin(vector::uniform(r*(1 + 1e-9)));
    const boundBox centres(region.min() + margin, region.max() - margin);

    if (centres.empty())
    {
        return n == 0;
    }

    if (addSequentially(centres, r, n))
    {
        return true;
    }

    forget(before);
    return addOnLattice(centres, r, n);
}


Foam::label Foam::cghs::packer::capacity
(
    const boundBox& region,
    const scalar r
)
{
    widenGrid(r);

    const vector margin(vector::uniform(r*(1 + 1e-9)));
    const boundBox centres(region.min() + margin, region.max() - margin);

    return
        centres.empty()
      ? 0
      : freeSites(centres, r, 2*r*(1 + 1e-6)).size();
}
