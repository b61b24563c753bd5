/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "meshFreedom.H"
#include "coupledPolyPatch.H"
#include "PstreamReduceOps.H"

Foam::vector Foam::cghs::freedom(const polyMesh& mesh)
{
    const Vector<label>& d = mesh.solutionD();

    return vector(d.x() > 0, d.y() > 0, d.z() > 0);
}


Foam::List<Foam::vector> Foam::cghs::periods(const polyMesh& mesh)
{
    DynamicList<vector> own;

    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        const coupledPolyPatch* coupled = isA<coupledPolyPatch>(pp);

        if (!coupled || pp.empty())
        {
            continue;
        }

        if (!coupled->parallel())
        {
            FatalErrorInFunction
                << "Patch " << pp.name() << " couples by a rotation; parcels"
                << " can only pass periodic patches that are parallel" << nl
                << exit(FatalError);
        }

        if (coupled->separated())
        {
            own.append(coupled->separation()[0]);
        }
    }

    List<List<vector>> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = own;
    Pstream::gatherList(all);
    Pstream::scatterList(all);

    // Each period is met from both sides, and by many ranks
    DynamicList<vector> different;
    for (const List<vector>& ofRank : all)
    {
        for (const vector& p : ofRank)
        {
            bool known = false;
            for (const vector& q : different)
            {
                known =
                    known || min(mag(p - q), mag(p + q)) < 1e-6*mag(p);
            }

            if (!known)
            {
                different.append(p);
            }
        }
    }

    return List<vector>(std::move(different));
}
