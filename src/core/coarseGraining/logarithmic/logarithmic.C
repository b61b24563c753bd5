/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "logarithmic.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(logarithmic, 0);
    addToRunTimeSelectionTable(restitutionScaling, logarithmic, dictionary);
    describeModel(restitutionScaling, logarithmic, "by Eq 57: any W");
}
}


Foam::scalar Foam::cghs::logarithmic::ofParcel
(
    const dictionary&,
    const restitution& particle,
    const scalar W
) const
{
    return pow(particle.e, sqrt(W));
}
