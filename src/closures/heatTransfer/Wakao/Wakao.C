/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "Wakao.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(Wakao, 0);
    addToRunTimeSelectionTable(heatTransferModel, Wakao, dictionary);
    describeModel(heatTransferModel, Wakao, "packed beds");
}
}


Foam::scalar Foam::cghs::Wakao::Nu(const heatedFlow& flow) const
{
    return 2 + 1.1*pow(Re(flow), 0.6)*cbrt(prandtl(flow));
}
