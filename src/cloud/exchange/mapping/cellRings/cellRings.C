/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "cellRings.H"
#include "wallSurfaces.H"
#include "meshFreedom.H"
#include "emptyPolyPatch.H"
#include "processorPolyPatch.H"
#include "cyclicPolyPatch.H"
#include "PstreamBuffers.H"
#include "PstreamReduceOps.H"

namespace Foam
{
namespace cghs
{

//- All patches that nothing passes on its way between cells. Those between
//  ranks are parts of others
static List<labelPair> surfacesOf
(
    const polyMesh& mesh,
    const UList<bool>& goesOn
)
{
    DynamicList<labelPair> patches;

    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if
        (
            !goesOn[pp.index()]
         && !isA<emptyPolyPatch>(pp)
         && !isA<processorPolyPatch>(pp)
        )
        {
            patches.append(labelPair(pp.index(), contact::parcelWall));
        }
    }
    return List<labelPair>(std::move(patches));
}

}
}

// * * * * * * * * * * * * * * * *  Sights  * * * * * * * * * * * * * * * * * //

bool Foam::cghs::cellRings::same(const sight& a, const sight& b) const
{
    return a.cell == b.cell && mag(a.centre - b.centre) < tolerance_;
}


bool Foam::cghs::cellRings::merge(const sights& from, sights& into) const
{
    const label before = into.size();

    for (const sight& s : from)
    {
        bool known = false;

        for (const sight& t : into)
        {
            known = known || same(s, t);
        }
        if (!known)
        {
            into.append(s);
        }
    }

    return into.size() > before;
}


Foam::cghs::cellRings::sight
Foam::cghs::cellRings::ofCell(const label celli) const
{
    return sight{numbers_.toGlobal(celli), mesh_.cellCentres()[celli]};
}


Foam::label Foam::cghs::cellRings::imageOf(const sight& s)
{
    if (numbers_.isLocal(s.cell))
    {
        const label celli = numbers_.toLocal(s.cell);

        if (same(s, ofCell(celli)))
        {
            return celli;
        }
    }

    DynamicList<label>& known = others_(s.cell);

    for (const label image : known)
    {
        if (mag(s.centre - centres_[image]) < tolerance_)
        {
            return image;
        }
    }

    known.append(centres_.size());
    centres_.append(s.centre);
    return known.last();
}

// * * * * * * * * * * * * * *  Between patches  * * * * * * * * * * * * * * //

void Foam::cghs::cellRings::transform
(
    const coupledPolyPatch& patch,
    sights& seen
)
{
    pointField places(seen.size());

    forAll(seen, i)
    {
        places[i] = seen[i].centre;
    }

    patch.transformPosition(places);

    forAll(seen, i)
    {
        seen[i].centre = places[i];
    }
}


bool Foam::cghs::cellRings::passesRanks(const polyPatch& pp) const
{
    return
        isA<processorPolyPatch>(pp) && pp.nPoints() > 0 && goesOn_[pp.index()];
}


bool Foam::cghs::cellRings::shareBetweenRanks(Map<sights>& byPoint) const
{
    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();

    for (const polyPatch& pp : patches)
    {
        if (passesRanks(pp))
        {
            const processorPolyPatch& patch =
                refCast<const processorPolyPatch>(pp);

            UOPstream os(patch.neighbProcNo(), buffers);

            forAll(patch.meshPoints(), i)
            {
                os  << patch.neighbPoints()[i]
                    << List<sight>(byPoint[patch.meshPoints()[i]]);
            }
        }
    }

    buffers.finishedSends();
    bool anyNew = false;

    for (const polyPatch& pp : patches)
    {
        if (passesRanks(pp))
        {
            const processorPolyPatch& patch =
                refCast<const processorPolyPatch>(pp);

            UIPstream is(patch.neighbProcNo(), buffers);

            for (label i = 0; i < patch.nPoints(); ++i)
            {
                const label point = readLabel(is);
                sights seen{List<sight>(is)};

                // A point that is not matched has no number there
                if (point != -1)
                {
                    transform(patch, seen);
                    anyNew =
                        merge(seen, byPoint(patch.meshPoints()[point]))
                     || anyNew;
                }
            }
        }
    }

    return anyNew;
}


bool Foam::cghs::cellRings::sharePeriodic(Map<sights>& byPoint) const
{
    bool anyNew = false;

    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (!isA<cyclicPolyPatch>(pp) || !goesOn_[pp.index()])
        {
            continue;
        }

        const cyclicPolyPatch& here = refCast<const cyclicPolyPatch>(pp);
        const cyclicPolyPatch& there = here.neighbPatch();

        // Pairs of points are known to the first patch of the two
        const bool first = here.owner();
        const edgeList& pairs =
            first ? here.coupledPoints() : there.coupledPoints();

        for (const edge& pair : pairs)
        {
            const label a = here.meshPoints()[first ? pair[0] : pair[1]];
            const label b = there.meshPoints()[first ? pair[1] : pair[0]];

            sights seen(byPoint[b]);
            transform(here, seen);
            anyNew = merge(seen, byPoint[a]) || anyNew;
        }
    }

    return anyNew;
}


void Foam::cghs::cellRings::share(Map<sights>& byPoint) const
{
    // A point may be one with others by way of several ranks and periods
    bool anyNew = true;

    while (anyNew)
    {
        anyNew = Pstream::parRun() && shareBetweenRanks(byPoint);
        anyNew = sharePeriodic(byPoint) || anyNew;
        reduce(anyNew, orOp<bool>());
    }
}

// * * * * * * * * * * * * * * *  The rings * * * * * * * * * * * * * * * * * //

Foam::Map<Foam::cghs::cellRings::sights>
Foam::cghs::cellRings::cellsOfPoints() const
{
    Map<sights> cellsOf;

    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (!goesOn_[pp.index()])
        {
            continue;
        }

        for (const label pointi : pp.meshPoints())
        {
            sights& cells = cellsOf(pointi);

            if (cells.empty())
            {
                for (const label celli : mesh_.pointCells()[pointi])
                {
                    cells.append(ofCell(celli));
                }
            }
        }
    }

    share(cellsOf);
    return cellsOf;
}


Foam::cghs::cellRings::sights Foam::cghs::cellRings::around
(
    const label celli,
    const Map<sights>& byPoint
) const
{
    sights seen;

    for (const label pointi : mesh_.cellPoints()[celli])
    {
        const auto found = byPoint.cfind(pointi);

        if (found.found())
        {
            merge(*found, seen);
        }
        else
        {
            for (const label other : mesh_.pointCells()[pointi])
            {
                merge(sights(1, ofCell(other)), seen);
            }
        }
    }

    return seen;
}


Foam::Map<Foam::cghs::cellRings::sights>
Foam::cghs::cellRings::ringsOfPoints(const Map<sights>& cellsOf) const
{
    Map<sights> ringsOf;

    forAllConstIters(cellsOf, iter)
    {
        sights& rings = ringsOf(iter.key());

        for (const label celli : mesh_.pointCells()[iter.key()])
        {
            merge(around(celli, cellsOf), rings);
        }
    }

    share(ringsOf);
    return ringsOf;
}


Foam::labelList Foam::cghs::cellRings::imagesOf(const sights& seen)
{
    labelList images(seen.size());

    forAll(seen, i)
    {
        images[i] = imageOf(seen[i]);
    }

    return images;
}


Foam::labelHashSet& Foam::cghs::cellRings::keepInSight
(
    wallSurfaces& walls,
    const label celli,
    labelHashSet& seen
) const
{
    if (walls.anyThin())
    {
        const point& here = mesh_.cellCentres()[celli];

        for (const label image : seen.toc())
        {
            if (image != celli && walls.between(here, centres_[image]))
            {
                seen.erase(image);
            }
        }
    }

    return seen;
}


void Foam::cghs::cellRings::makeRings
(
    const Map<sights>& cellsOf,
    wallSurfaces& walls
)
{
    forAllConstIters(cellsOf, iter)
    {
        aboutPoint_.insert(iter.key(), imagesOf(*iter));
    }

    labelHashSet seen;
    start_[0] = 0;

    for (label celli = 0; celli < nCells(); ++celli)
    {
        seen.clear();

        for (const label pointi : mesh_.cellPoints()[celli])
        {
            seen.insert(aboutPoint(pointi));
        }

        ring_.append(keepInSight(walls, celli, seen).sortedToc());
        start_[celli + 1] = ring_.size();
    }
}


void Foam::cghs::cellRings::makeWideRings
(
    const Map<sights>& ringsOf,
    wallSurfaces& walls
)
{
    DynamicList<labelList> rings;

    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (!goesOn_[pp.index()])
        {
            continue;
        }

        for (const label celli : pp.faceCells())
        {
            if (wide_[celli] != -1)
            {
                continue;
            }

            labelHashSet seen;

            for (const label pointi : mesh_.cellPoints()[celli])
            {
                const auto found = ringsOf.cfind(pointi);

                if (found.found())
                {
                    seen.insert(imagesOf(*found));
                }
            }

            wide_[celli] = rings.size();
            rings.append(keepInSight(walls, celli, seen).sortedToc());
        }
    }

    wideRings_.transfer(rings);
}


void Foam::cghs::cellRings::connect()
{
    slots_.resize(nImages());

    for (label celli = 0; celli < nCells(); ++celli)
    {
        slots_[celli] = celli;
    }

    forAllConstIters(others_, iter)
    {
        for (const label image : *iter)
        {
            slots_[image] = iter.key();
        }
    }

    if (!Pstream::parRun())
    {
        return;
    }

    SubList<label> remote(slots_, nImages() - nCells(), nCells());
    labelList elements(remote);
    List<Map<label>> compact;

    exchange_.reset(new mapDistributeBase(numbers_, elements, compact));
    remote = elements;
}


bool Foam::cghs::cellRings::leftThroughCoupled
(
    const point& x,
    const label celli
) const
{
    for (const label facei : mesh_.cells()[celli])
    {
        const label i = facei - mesh_.nInternalFaces();

        if
        (
            i >= 0
         && passed_[i]
         && ((x - mesh_.faceCentres()[facei]) & mesh_.faceAreas()[facei]) > 0
        )
        {
            return true;
        }
    }

    return false;
}

// * * * * * * * * * * * * * * * * * Public  * * * * * * * * * * * * * * * * //

Foam::cghs::cellRings::cellRings
(
    const polyMesh& mesh,
    const labelUList& plates
)
:
    mesh_(mesh),
    numbers_(mesh.nCells()),
    tolerance_(1e-6*mesh.bounds().mag()),
    centres_(mesh.cellCentres()),
    start_(mesh.nCells() + 1),
    wide_(mesh.nCells(), -1),
    goesOn_(mesh.boundaryMesh().size()),
    passed_(mesh.nFaces() - mesh.nInternalFaces(), false)
{
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        const bool goesOn = pp.coupled() && !plates.found(pp.index());

        goesOn_[pp.index()] = goesOn;
        SubList<bool>(passed_, pp.size(), pp.offset()) = goesOn;
    }

    const Map<sights> cellsOf(cellsOfPoints());

    wallSurfaces walls
    (
        mesh,
        surfacesOf(mesh, goesOn_),
        periods(mesh)
    );
    walls.findThin(tolerance_);

    makeRings(cellsOf, walls);
    makeWideRings(ringsOfPoints(cellsOf), walls);
    connect();
}


Foam::labelHashSet Foam::cghs::cellRings::aboutFace(const label facei) const
{
    labelHashSet images;

    for (const label pointi : mesh_.faces()[facei])
    {
        images.insert(aboutPoint(pointi));
    }

    return images;
}


Foam::label Foam::cghs::cellRings::maxSize() const
{
    label size = 0;

    for (label celli = 0; celli < nCells(); ++celli)
    {
        size = max(size, start_[celli + 1] - start_[celli]);
    }
    for (const labelList& ring : wideRings_)
    {
        size = max(size, ring.size());
    }

    return size;
}


std::size_t Foam::cghs::cellRings::bytes() const
{
    std::size_t bytes =
        centres_.byteSize() + slots_.byteSize() + ring_.byteSize()
      + start_.byteSize() + wide_.byteSize();

    for (const labelList& ring : wideRings_)
    {
        bytes += ring.byteSize();
    }

    return bytes;
}
