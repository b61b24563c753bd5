/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "noCorrection.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(noCorrection, 0);
    addToRunTimeSelectionTable(correctionModel, noCorrection, dictionary);
    describeModel(correctionModel, noCorrection, "impacts alone: dilute flow");
}
}
