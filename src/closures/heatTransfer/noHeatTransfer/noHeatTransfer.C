/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "noHeatTransfer.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(noHeatTransfer, 0);
    addToRunTimeSelectionTable(heatTransferModel, noHeatTransfer, dictionary);
    describeModel(heatTransferModel, noHeatTransfer, "no convection");
}
}
