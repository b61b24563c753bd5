/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "RanzMarshall.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(RanzMarshall, 0);
    addToRunTimeSelectionTable(heatTransferModel, RanzMarshall, dictionary);
    describeModel(heatTransferModel, RanzMarshall, "a single sphere");
}
}


Foam::scalar Foam::cghs::RanzMarshall::Nu(const heatedFlow& flow) const
{
    return 2 + 0.6*sqrt(Re(flow))*cbrt(prandtl(flow));
}
