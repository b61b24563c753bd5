/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "inlets.H"
#include "PstreamReduceOps.H"

namespace Foam
{
namespace cghs
{

//- Do the fluid and nothing else pass here, from outside?
static bool isOpen(const fvPatch& patch)
{
    return !patch.coupled() && !polyPatch::constraintType(patch.type());
}

} // End namespace cghs
} // End namespace Foam


Foam::List<Foam::cghs::inlet> Foam::cghs::inletsOf(caseView& view)
{
    // They may be functions of time, or of the density
    const_cast<volVectorField&>(view.fluid->U()).correctBoundaryConditions();

    const volVectorField& U = view.fluid->U();
    DynamicList<inlet> inlets;

    for (label i = 0; i < view.mesh.boundaryMesh().nNonProcessor(); ++i)
    {
        const fvPatch& patch = view.mesh.boundary()[i];
        if (!isOpen(patch))
        {
            continue;
        }

        const scalarField in
        (
            -view.fluid->alpha().boundaryField()[i]
           *(U.boundaryField()[i] & patch.Sf())
        );
        inlet it;
        it.patch = i;
        it.name = patch.name();
        it.area = gSum(patch.magSf());
        it.volumeFlow = gSum(in);
        it.massFlow = gSum(in*view.fluid->rho().boundaryField()[i]);

        if (it.volumeFlow > SMALL*it.area)
        {
            inlets.append(it);
        }
    }

    return List<inlet>(std::move(inlets));
}


Foam::scalar Foam::cghs::meanVelocity
(
    const UList<inlet>& inlets,
    const caseView& view
)
{
    scalar flow = 0;
    for (const inlet& it : inlets)
    {
        flow += it.volumeFlow;
    }
    return flow/view.crossSection();
}


bool Foam::cghs::hasOutlet(const caseView& view)
{
    const volVectorField& U = view.fluid->U();
    bool out = false;

    forAll(view.mesh.boundary(), i)
    {
        const fvPatch& patch = view.mesh.boundary()[i];
        const bool leads =
            sum(U.boundaryField()[i] & patch.Sf()) > SMALL*sum(patch.magSf());

        out =
            out
         || (
                isOpen(patch) && patch.size()
             && (view.fluid->p().boundaryField()[i].fixesValue() || leads)
            );
    }

    return returnReduce(out, orOp<bool>());
}
