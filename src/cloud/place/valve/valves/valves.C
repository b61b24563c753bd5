/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "valves.H"
#include "PstreamReduceOps.H"

namespace Foam
{
namespace cghs
{

//- Let the fluid see a little more of those that come in, and less of those
//  that go out
static void fade(arena& parcels, const scalar deltaT, const vector& g)
{
    for (label i = 0; i < parcels.size(); ++i)
    {
        // In the time in which it moves by its diameter, or falls it
        const scalar d = 2*parcels.spheres[i].r;
        const scalar rate =
            max(mag(parcels.motions[i].v)/d, sqrt(mag(g)/d));
        const scalar change =
            parcels.exits[i] == -1 ? deltaT*rate : -deltaT*rate;

        parcels.presences[i] =
            min(max(parcels.presences[i] + change, 0), 1);
    }
}

} // End namespace cghs
} // End namespace Foam


Foam::cghs::valves::valves
(
    const dictionary& boundary,
    const polyMesh& mesh,
    const labelUList& patches
)
{
    for (const label patchi : patches)
    {
        const word& name = mesh.boundaryMesh()[patchi].name();

        if (!boundary.isDict(name))
        {
            FatalIOErrorInFunction(boundary)
                << "Patch " << name << " is an inventoryValve, but has no"
                << " inventory" << nl << "Write "
                << name << " { type inventoryValve; inventory <kg>; }" << nl
                << exit(FatalIOError);
        }

        valves_.append
        (
            new inventoryValve(boundary.subDict(name), mesh, patchi)
        );
    }
}


void Foam::cghs::valves::open(const arena& parcels, labelUList& exits) const
{
    if (valves_.empty())
    {
        return;
    }

    scalar mass = 0;
    forAll(exits, i)
    {
        mass += exits[i] == -1 ? parcels.motions[i].mass() : 0;
    }
    reduce(mass, sumOp<scalar>());

    for (const inventoryValve& valve : valves_)
    {
        mass -= valve.release(parcels, mass, exits);
    }
}


Foam::labelList Foam::cghs::valves::findLeaving
(
    arena& parcels,
    const scalar deltaT,
    const vector& g
) const
{
    labelList exits(parcels.size(), -1);

    if (!parcels.fading())
    {
        open(parcels, exits);
        return exits;
    }

    fade(parcels, deltaT, g);
    open(parcels, parcels.exits);

    forAll(exits, i)
    {
        if (parcels.presences[i] <= 0)
        {
            exits[i] = parcels.exits[i];
        }
    }

    return exits;
}
