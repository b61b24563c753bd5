/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "parcelRadius.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(parcelRadius, 0);
    addToRunTimeSelectionTable(wallDistance, parcelRadius, dictionary);
    describeModel(wallDistance, parcelRadius, "with their surface");
}
}
