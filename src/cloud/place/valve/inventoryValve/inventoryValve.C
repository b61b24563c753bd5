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

    //- A parcel that may go
    struct leaver
    {
        label id;
        label rank;
        label index;
        scalar mass;
    };
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
    triangles_(gatherTriangles(mesh.boundaryMesh()[patchi])),
    box_(boundsOf(triangles_))
{
    warnUnknownEntries(dict, wordList({"type", "inventory"}));
}


bool Foam::cghs::inventoryValve::touches(const sphere& s) const
{
    const scalar reach = touchingDistance*s.r;
    const vector margin(vector::uniform(reach));

    if (!boundBox(box_.min() - margin, box_.max() + margin).contains(s.x))
    {
        return false;
    }

    for (const patchTriangle& t : triangles_)
    {
        const FixedList<point, 3>& c = t.corners;
        const vector nearest(closestPoint(c[0], c[1], c[2], s.x).point);

        if (magSqr(nearest - s.x) < sqr(reach))
        {
            return true;
        }
    }

    return false;
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

    // By their numbers, so that it does not depend on the ranks
    List<List<label>> ids(Pstream::nProcs());
    List<List<scalar>> masses(Pstream::nProcs());
    DynamicList<label> touching;
    {
        DynamicList<label> ownIds;
        DynamicList<scalar> ownMasses;

        for (label i = 0; i < parcels.size(); ++i)
        {
            if (exits[i] == -1 && touches(parcels.spheres[i]))
            {
                touching.append(i);
                ownIds.append(parcels.ids[i]);
                ownMasses.append(parcels.motions[i].mass());
            }
        }
        ids[Pstream::myProcNo()] = ownIds;
        masses[Pstream::myProcNo()] = ownMasses;
    }
    Pstream::gatherList(ids);
    Pstream::scatterList(ids);
    Pstream::gatherList(masses);
    Pstream::scatterList(masses);

    DynamicList<leaver> leavers;
    forAll(ids, rank)
    {
        forAll(ids[rank], k)
        {
            leavers.append(leaver{ids[rank][k], rank, k, masses[rank][k]});
        }
    }
    std::sort
    (
        leavers.begin(),
        leavers.end(),
        [](const leaver& a, const leaver& b) { return a.id < b.id; }
    );

    scalar released = 0;

    for (const leaver& it : leavers)
    {
        if (mass - released - it.mass >= inventory_)
        {
            released += it.mass;

            if (it.rank == Pstream::myProcNo())
            {
                exits[touching[it.index]] = patch_;
            }
        }
    }

    return released;
}
