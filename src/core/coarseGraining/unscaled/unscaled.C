/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "unscaled.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(unscaled, 0);
    addToRunTimeSelectionTable(restitutionScaling, unscaled, dictionary);
    describeModel(restitutionScaling, unscaled, "that of the particles");
}
}


Foam::scalar Foam::cghs::unscaled::ofParcel
(
    const dictionary&,
    const restitution& particle,
    const scalar
) const
{
    return particle.e;
}
