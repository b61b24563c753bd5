/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "wallMotion.H"
#include "patchParts.H"
#include "wallPolyPatch.H"
#include "localIOdictionary.H"
#include "PstreamReduceOps.H"
#include "Time.H"

namespace Foam
{
namespace cghs
{

//- What of a velocity is along the faces. What comes in through a patch that the
//  mesh calls a wall moves nobody along
static vectorField along(const fvPatchVectorField& U)
{
    // Rounding of what is across
    constexpr scalar nothing = 1e-6;

    const vectorField n(U.patch().nf());
    vectorField u(U - n*(n & U));

    forAll(u, i)
    {
        if (mag(u[i]) < nothing*mag(U[i]))
        {
            u[i] = Zero;
        }
    }
    return u;
}

}
}


Foam::cghs::wallMotion::wallMotion(const fvMesh& mesh)
:
    mesh_(mesh),
    read_(),
    looked_(false)
{}


bool Foam::cghs::wallMotion::moves(const IOobject& file) const
{
    const localIOdictionary U(file, volVectorField::typeName);
    const dictionary& boundary = U.subDict("boundaryField");

    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        const dictionary* entry = boundary.findDict(pp.name());

        if (isA<wallPolyPatch>(pp) && entry)
        {
            const word type(entry->get<word>("type"));

            if (type != "noSlip" && type != "slip" && type != "zeroGradient")
            {
                return true;
            }
        }
    }

    return false;
}


const Foam::volVectorField* Foam::cghs::wallMotion::velocity()
{
    const volVectorField* U = mesh_.findObject<volVectorField>("U");

    if (U)
    {
        return U;
    }

    if (!looked_)
    {
        looked_ = true;

        IOobject file
        (
            "U",
            mesh_.time().findInstance
            (
                mesh_.dbDir(),
                "U",
                IOobject::READ_IF_PRESENT
            ),
            mesh_,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        );
        const bool there = file.typeHeaderOk<volVectorField>(true);

        if (returnReduce(there, andOp<bool>()) && moves(file))
        {
            read_.reset(new volVectorField(file, mesh_));
        }
    }

    if (read_.valid())
    {
        read_->correctBoundaryConditions();
    }
    return read_.get();
}


Foam::List<Foam::vectorField> Foam::cghs::wallMotion::velocities
(
    const labelUList& patches
)
{
    List<vectorField> byPatch(patches.size());
    const volVectorField* U = velocity();

    forAll(patches, k)
    {
        byPatch[k].resize(nFacesOf(mesh_, patches[k]), Zero);

        if (!U)
        {
            continue;
        }

        const fvPatchVectorField& at = U->boundaryField()[patches[k]];

        if
        (
            isA<wallPolyPatch>(mesh_.boundaryMesh()[patches[k]])
         && at.fixesValue()
         && !at.assignable()
        )
        {
            byPatch[k] = along(at);
        }
    }

    return byPatch;
}
