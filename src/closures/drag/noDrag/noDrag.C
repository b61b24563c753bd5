/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "noDrag.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(noDrag, 0);
    addToRunTimeSelectionTable(dragModel, noDrag, dictionary);
    describeModel(dragModel, noDrag, "the fluid passes unfelt");
}
}
