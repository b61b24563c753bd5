/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "movingTriangles.H"
#include "facesOfRanks.H"
#include "PstreamReduceOps.H"

bool Foam::cghs::movingTriangles::set(const UList<vectorField>& byPatch)
{
    bool moves = false;
    for (const vectorField& u : byPatch)
    {
        for (const vector& ui : u)
        {
            moves = moves || ui != vector::zero;
        }
    }

    if (!returnReduce(moves, orOp<bool>()))
    {
        const bool stopped = velocities_.size();
        velocities_.clear();
        return stopped;
    }

    const Field<vector> all(facesOfRanks(byPatch));

    const bool changed = all.size() != velocities_.size() || all != velocities_;
    velocities_ = all;
    return changed;
}


void Foam::cghs::movingTriangles::find
(
    const UList<label>& touched,
    const UList<label>& faces
)
{
    for (const label ti : moving_)
    {
        bodies_[ti] = 0;
    }
    moving_.clear();

    if (velocities_.empty())
    {
        return;
    }

    bodies_.resize(faces.size(), 0);

    for (const label ti : touched)
    {
        if (!bodies_[ti] && velocities_[faces[ti]] != vector::zero)
        {
            moving_.append(ti);
            bodies_[ti] = moving_.size();
        }
    }
}
