/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "visitors.H"
#include "arena.H"
#include "globalMeshData.H"
#include "locator.H"
#include "processorCyclicPolyPatch.H"
#include "PstreamBuffers.H"
#include "PstreamReduceOps.H"

namespace Foam
{
namespace cghs
{

//- Send each rank its list, empty it, and return what has come from each
template<class Type>
static List<List<Type>> post(List<DynamicList<Type>>& sent)
{
    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
    List<List<Type>> came(sent.size());

    forAll(sent, rank)
    {
        if (sent[rank].size())
        {
            UOPstream os(rank, buffers);
            os << List<Type>(sent[rank]);
            sent[rank].clear();
        }
    }

    labelList sizes;
    buffers.finishedSends(sizes);

    forAll(came, rank)
    {
        if (sizes[rank])
        {
            UIPstream is(rank, buffers);
            is >> came[rank];
        }
    }
    return came;
}

} // End namespace cghs
} // End namespace Foam


Foam::cghs::visitors::visitors(const polyMesh& mesh, locator& cells)
:
    mesh_(mesh),
    cells_(cells)
{}

// * * * * * * * * * * * * * * * * * Public  * * * * * * * * * * * * * * * * //

bool Foam::cghs::visitors::leadTo(const label facei) const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const polyPatch& pp = patches[patches.whichPatch(facei)];

    return isA<processorPolyPatch>(pp) && !isA<processorCyclicPolyPatch>(pp);
}


void Foam::cghs::visitors::sendOn
(
    visitor v,
    const label facei,
    List<DynamicList<visitor>>& sent
) const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const label patchi = patches.whichPatch(facei);
    const processorPolyPatch& pp =
        refCast<const processorPolyPatch>(patches[patchi]);

    v.patch = mesh_.globalData().processorPatchNeighbours()[patchi];
    v.face = pp.whichFace(facei);
    sent[pp.neighbProcNo()].append(v);
}


void Foam::cghs::visitors::host
(
    const UList<visitor>& came,
    List<DynamicList<visitor>>& sent,
    List<DynamicList<label>>& cells,
    List<DynamicList<label>>& guests
) const
{
    const labelList& procPatches = mesh_.globalData().processorPatches();

    for (const visitor& v : came)
    {
        const polyPatch& pp = mesh_.boundaryMesh()[procPatches[v.patch]];

        label celli = pp.faceCells()[v.face];
        const label facei = cells_.follow(v.x, celli);

        // Not back by the face that it came in by, see transport::settleFrom
        if
        (
            facei != -1
         && facei != pp.start() + v.face
         && leadTo(facei)
        )
        {
            sendOn(v, facei, sent);
        }
        else
        {
            cells[v.rank].append(celli);
            guests[v.rank].append(v.parcel);
        }
    }
}


void Foam::cghs::visitors::find
(
    arena& parcels,
    const UList<labelPair>& beyond
) const
{
    const label nRanks = Pstream::nProcs();
    List<DynamicList<visitor>> sent(nRanks);
    List<DynamicList<label>> cells(nRanks);
    List<DynamicList<label>> guests(nRanks);

    for (const labelPair& p : beyond)
    {
        const label i = p.first();

        sendOn
        (
            visitor{Pstream::myProcNo(), i, -1, -1, parcels.spheres[i].x},
            p.second(),
            sent
        );
    }

    bool any = true;
    for (label round = 0; any && round < ranksPassed; ++round)
    {
        const List<List<visitor>> came(post(sent));

        any = false;
        for (const List<visitor>& ofRank : came)
        {
            host(ofRank, sent, cells, guests);
        }
        for (const List<visitor>& toRank : sent)
        {
            any = any || toRank.size();
        }
        reduce(any, orOp<bool>());
    }

    labelListList hosted(nRanks);
    forAll(hosted, rank)
    {
        hosted[rank] = std::move(cells[rank]);
    }
    parcels.visiting.set
    (
        parcels.cells,
        mesh_.nCells(),
        post(guests),
        std::move(hosted)
    );
}
