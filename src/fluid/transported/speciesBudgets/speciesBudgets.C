/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "speciesBudgets.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(speciesBudgets, 0);
}
}


Foam::cghs::speciesBudgets::speciesBudgets
(
    const wordList& names,
    const polyMesh& mesh
)
:
    regIOobject
    (
        IOobject(typeName, mesh.time().timeName(), mesh)
    ),
    List<speciesBudget>(names.size()),
    names_(names)
{
    // Those between ranks, which differ from rank to rank, come last
    const label nPatches = mesh.boundaryMesh().nNonProcessor();

    for (speciesBudget& b : *this)
    {
        b.carried = scalarField(nPatches, Zero);
        b.diffused = scalarField(nPatches, Zero);
    }
}
