/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "cellDrag.H"

namespace Foam
{
namespace cghs
{
    //- Pseudo-time of T over what a cell can stand, which is 0.15 h^2 in cubes
    constexpr scalar shareOfLimit = 0.68;
}
}


Foam::cghs::cellDrag::cellDrag
(
    const fvMesh& mesh,
    const mappingModel& mapping
)
:
    mapping_(mapping),
    shares_(mesh)
{
    shares_.setLocalStep(shareOfLimit);
}


void Foam::cghs::cellDrag::spread
(
    volVectorField& F,
    const volVectorField& U,
    const volVectorField& smoothU,
    volScalarField& b
) const
{
    volVectorField f("cellDrag", smoothU);

    shares_.step(f);
    f *= b;
    f.correctBoundaryConditions();
    shares_.step(f);

    F -= f;
    F.correctBoundaryConditions();
    mapping_.spread(F);

    shares_.step(b);
    mapping_.spread(b);
    F += b*U;
}
