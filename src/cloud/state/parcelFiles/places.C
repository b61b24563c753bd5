/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "places.H"
#include "fieldFiles.H"
#include "SubList.H"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace Foam
{
namespace cghs
{

//- Is the exact position of a parcel in or by the mesh cell that OpenFOAM's
//  coordinates give? They need not agree closely: in warped cells decomposePar
//  moves what it knows by coordinates alone
static bool agrees
(
    const polyMesh& mesh,
    const vector& x,
    const label celli,
    const scalar diameter
)
{
    if (celli < 0 || celli >= mesh.nCells())
    {
        return false;
    }

    boundBox cell(mesh.points(), mesh.cellPoints()[celli], false);
    const vector margin(vector::uniform(diameter));

    return boundBox(cell.min() - margin, cell.max() + margin).contains(x);
}


//- The cell of an exact position, or -1
static label cellAt(const polyMesh& mesh, const vector& x, const label hint)
{
    const bool known = hint >= 0 && hint < mesh.nCells();

    return known && mesh.pointInCell(x, hint) ? hint : mesh.findCell(x);
}


//- The cells of all parcels by their exact positions: the mesh is not the one
//  that their coordinates were made for
static void findCells
(
    const passiveParticleCloud& files,
    const vectorField& x,
    labelUList& cells
)
{
    const polyMesh& mesh = files.pMesh();

    forAll(x, i)
    {
        cells[i] = cellAt(mesh, x[i], cells[i]);

        if (cells[i] < 0)
        {
            errorIn(pathOf(files, "position"))
                << "Parcel " << i << " is at " << x[i] << nl
                << "but that is outside the mesh"
                << (Pstream::parRun() ? " of this rank" : "")
                << ", and coordinates, which say what cell it is in, name another"
                << " place" << nl
                << "Was the mesh changed, or one of the two files edited?"
                << " Decompose anew from a time that fits the mesh, or fill it"
                << " anew with fillParcels" << nl
                << exit(FatalIOError);
        }
    }
}


//- Cells by OpenFOAM's coordinates, unless exact positions disagree with any of
//  them. Returns whether coordinates were right
static bool checkCells
(
    const passiveParticleCloud& files,
    const vectorField& x,
    const arena& parcels,
    labelUList& cells
)
{
    label nMisplaced = 0;

    forAll(x, i)
    {
        const scalar d = 2*parcels.spheres[i].r;

        nMisplaced += !agrees(files.pMesh(), x[i], cells[i], d);
    }
    reduce(nMisplaced, sumOp<label>());

    if (nMisplaced)
    {
        Info<< "Cloud " << files.name() << ": " << nMisplaced << " of "
            << returnReduce(x.size(), sumOp<label>())
            << " parcels are not in the cells that their coordinates name (has"
            << " the mesh been renumbered?): cells are found anew from exact"
            << " positions" << nl << endl;

        findCells(files, x, cells);
    }

    return nMisplaced == 0;
}


//- How much positions that are written with few digits may be rounded by [m];
//  0 if any has more than ten
static scalar rounding(const vectorField& x)
{
    constexpr int mostDigits = 10;
    scalar unit = 0;
    int digits = 1;

    for (const vector& xi : x)
    {
        for (const scalar c : xi)
        {
            char text[32];
            for (; digits <= mostDigits; ++digits)
            {
                std::snprintf(text, sizeof(text), "%.*g", digits, c);
                if (std::strtod(text, nullptr) == c)
                {
                    break;
                }
            }
            if (digits > mostDigits)
            {
                return 0;
            }
            unit = max(unit, mag(c));
        }
    }

    return unit > 0 ? 0.5*std::pow(10.0, floor(log10(unit)) + 1 - digits) : 0;
}


//- Tools of OpenFOAM that rewrite the files of a cloud, such as decomposePar,
//  round positions to writePrecision. Where that matters coordinates, which are
//  rounded to that share of a cell, are better
static void replaceRounded
(
    const passiveParticleCloud& files,
    const arena& parcels,
    vectorField& x
)
{
    const scalar rounded = returnReduce(rounding(x), maxOp<scalar>());

    if (rounded == 0)
    {
        return;
    }

    label nReplaced = 0;
    scalar largest = 0;
    label i = 0;

    for (const passiveParticle& p : files)
    {
        // Rounded coordinates do not sum up to one, which counts as far away from
        // the origin as the cell is
        const vector place
        (
            p.position()
          - (cmptSum(p.coordinates()) - 1)*files.pMesh().cellCentres()[p.cell()]
        );
        const scalar off = mag(place - x[i]);
        const scalar d = 2*parcels.spheres[i].r;

        if (off > 1e-3*d && off < 2*rounded)
        {
            largest = max(largest, off/d);
            x[i] = place;
            ++nReplaced;
        }
        ++i;
    }
    reduce(nReplaced, sumOp<label>());
    reduce(largest, maxOp<scalar>());

    if (nReplaced)
    {
        WarningInFunction
            << "The positions of " << nReplaced << " parcels in "
            << pathOf(files, "position") << " are rounded, by up to " << largest
            << " diameters: those of their coordinates are taken, which are"
            << " rounded less" << nl
            << "    A tool such as decomposePar has written them with few digits:"
            << " set writePrecision 17 in system/controlDict before it runs, or"
            << " writeFormat binary" << nl << endl;
    }
}


} // End namespace cghs
} // End namespace Foam


void Foam::cghs::placeParcels
(
    const passiveParticleCloud& files,
    const bool exact,
    vectorField& x,
    arena& parcels
)
{
    if (exact)
    {
        SubList<label> cells(parcels.cells, x.size());

        if (checkCells(files, x, parcels, cells))
        {
            replaceRounded(files, parcels, x);
        }
    }
    else
    {
        x.setSize(files.size());
        label i = 0;
        for (const passiveParticle& p : files)
        {
            x[i++] = p.position();
        }
    }

    forAll(x, i)
    {
        parcels.spheres[i].x = x[i];
    }
}
