/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "inventoryValve.H"
#include "closestPoint.H"
#include "checkedEntry.H"
#include "knownEntries.H"
#include "PstreamReduceOps.H"

#include <algorithm>

namespace Foam
{
namespace cghs
{
    //- A parcel touches if it is no further from the valve than this times its
    //  radius
    constexpr scalar touchingDistance = 1.02;

    //- A parcel that may go: one that touches before those that do not, by
    //  their numbers, and those by their distance from the valve [m^2]. So it
    //  does not depend on the ranks
    struct leaver
    {
        scalar farSqr;
        label id;
        label rank;
        label index;
        scalar mass;

        bool operator<(const leaver& b) const
        {
            return farSqr < b.farSqr || (farSqr == b.farSqr && id < b.id);
        }
    };


    //- The same list of all ranks on all ranks, by rank
    template<class Type>
    static List<List<Type>> ofAllRanks(const UList<Type>& own)
    {
        List<List<Type>> all(Pstream::nProcs());
        all[Pstream::myProcNo()] = own;
        Pstream::gatherList(all);
        Pstream::scatterList(all);
        return all;
    }
}
}


Foam::cghs::inventoryValve::inventoryValve
(
    const dictionary& dict,
    const polyMesh& mesh,
    const label patchi
)
:
    patch_(patchi),
    inventory_(scalarInRange(dict, "inventory", 0, GREAT)),
    reach_(dict.found("reach") ? scalarInRange(dict, "reach", 0, GREAT) : 0),
    triangles_(gatherTriangles(mesh.boundaryMesh()[patchi])),
    box_(boundsOf(triangles_))
{
    warnUnknownEntries(dict, wordList({"type", "inventory", "reach"}));
}


Foam::scalar Foam::cghs::inventoryValve::distanceSqr
(
    const point& x,
    const scalar within
) const
{
    scalar nearest = GREAT;
    const vector margin(vector::uniform(within));

    if (boundBox(box_.min() - margin, box_.max() + margin).contains(x))
    {
        for (const patchTriangle& t : triangles_)
        {
            const FixedList<point, 3>& c = t.corners;
            const point there(closestPoint(c[0], c[1], c[2], x).point);

            nearest = min(nearest, magSqr(there - x));
        }
    }

    return nearest < sqr(within) ? nearest : GREAT;
}


Foam::List<Foam::cghs::leaver> Foam::cghs::inventoryValve::candidates
(
    const arena& parcels,
    const labelUList& exits
) const
{
    DynamicList<scalar> farSqr;
    DynamicList<label> ids;
    DynamicList<label> indices;
    DynamicList<scalar> masses;

    for (label i = 0; i < parcels.size(); ++i)
    {
        const sphere& s = parcels.spheres[i];
        const scalar touching = touchingDistance*s.r;
        const scalar away =
            exits[i] == -1 ? distanceSqr(s.x, max(touching, reach_)) : GREAT;

        if (away < GREAT)
        {
            farSqr.append(away < sqr(touching) ? 0 : away);
            ids.append(parcels.ids[i]);
            indices.append(i);
            masses.append(parcels.motions[i].mass());
        }
    }

    const auto allFar = ofAllRanks<scalar>(farSqr);
    const auto allIds = ofAllRanks<label>(ids);
    const auto allIndices = ofAllRanks<label>(indices);
    const auto allMasses = ofAllRanks<scalar>(masses);
    DynamicList<leaver> leavers;

    forAll(allIds, rank)
    {
        forAll(allIds[rank], k)
        {
            leavers.append
            (
                leaver
                {
                    allFar[rank][k],
                    allIds[rank][k],
                    rank,
                    allIndices[rank][k],
                    allMasses[rank][k]
                }
            );
        }
    }

    std::sort(leavers.begin(), leavers.end());
    return List<leaver>(std::move(leavers));
}


Foam::scalar Foam::cghs::inventoryValve::release
(
    const arena& parcels,
    const scalar mass,
    labelUList& exits
) const
{
    if (mass <= inventory_)
    {
        return 0;
    }

    scalar released = 0;

    for (const leaver& it : candidates(parcels, exits))
    {
        if (mass - released - it.mass >= inventory_)
        {
            released += it.mass;

            if (it.rank == Pstream::myProcNo())
            {
                exits[it.index] = patch_;
            }
        }
    }

    return released;
}
