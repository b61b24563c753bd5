/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "balancedWalls.H"
#include "fixedFluxPressureFvPatchScalarField.H"
#include "zeroGradientFvPatchFields.H"
#include "basicSymmetryFvPatchField.H"

namespace Foam
{
namespace cghs
{

static bool isGiven(const fvPatchVectorField& U)
{
    return
        (U.fixesValue() && !U.assignable())
     || isA<basicSymmetryFvPatchField<vector>>(U);
}


static void balance(volScalarField& p, const fvPatch& patch)
{
    p.boundaryFieldRef().set
    (
        patch.index(),
        new fixedFluxPressureFvPatchScalarField(patch, p.internalField())
    );

    fvPatchScalarField& pp = p.boundaryFieldRef()[patch.index()];
    pp == pp.patchInternalField();
}

} // End namespace cghs
} // End namespace Foam


void Foam::cghs::balanceWalls(volScalarField& p, const volVectorField& U)
{
    DynamicList<word> balanced;

    for (const fvPatch& patch : p.mesh().boundary())
    {
        if
        (
            isGiven(U.boundaryField()[patch.index()])
         && p.boundaryField()[patch.index()].type()
         == zeroGradientFvPatchScalarField::typeName
        )
        {
            balance(p, patch);
            balanced.append(patch.name());
        }
    }

    if (balanced.size())
    {
        Info<< "p is zeroGradient at " << flatOutput(balanced)
            << ", where U is given: it is taken as fixedFluxPressure, so that"
            << " it balances weight and drag in the cells beside" << nl << endl;
    }
}
