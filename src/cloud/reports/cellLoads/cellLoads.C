/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "cellLoads.H"
#include "fvMesh.H"
#include "emptyPolyPatch.H"
#include "wedgePolyPatch.H"
#include "PstreamReduceOps.H"

Foam::cghs::cellLoads::cellLoads(const fvMesh& mesh)
:
    lengths_(mesh.nCells(), Zero),
    occupied_(mesh.nCells())
{
    const scalarField areas(mag(mesh.faceAreas()));
    const auto note = [&](const label celli, const label facei)
    {
        lengths_[celli] = max(lengths_[celli], areas[facei]);
    };

    for (label facei = 0; facei < mesh.nInternalFaces(); ++facei)
    {
        note(mesh.faceOwner()[facei], facei);
        note(mesh.faceNeighbour()[facei], facei);
    }
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (!isA<emptyPolyPatch>(patch) && !isA<wedgePolyPatch>(patch))
        {
            forAll(patch, i)
            {
                note(patch.faceCells()[i], patch.start() + i);
            }
        }
    }

    lengths_ = mesh.cellVolumes()/max(lengths_, VSMALL);
}


Foam::List<Foam::cghs::figure> Foam::cghs::cellLoads::figures
(
    const arena& parcels,
    const scalar deltaT
)
{
    const UList<label>& places = parcels.places();
    occupied_ = false;

    label nParcels = 0;
    label nCells = 0;
    scalar courant = 0;
    for (label i = 0; i < parcels.size(); ++i)
    {
        const label celli = places[i];
        if (celli >= lengths_.size())
        {
            continue;
        }
        ++nParcels;
        if (!occupied_[celli])
        {
            occupied_[celli] = true;
            ++nCells;
        }
        courant = max(courant, mag(parcels.motions[i].v)/lengths_[celli]);
    }

    reduce(nParcels, sumOp<label>());
    reduce(nCells, sumOp<label>());
    reduce(courant, maxOp<scalar>());

    return List<figure>
    ({
        {"parcelsPerCell", scalar(nParcels)/max(nCells, 1)},
        {"solidsCourant", courant*deltaT}
    });
}
