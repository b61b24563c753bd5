/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "Gunn.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(Gunn, 0);
    addToRunTimeSelectionTable(heatTransferModel, Gunn, dictionary);
    describeModel(heatTransferModel, Gunn, "suspensions and packed beds");
}
}


Foam::scalar Foam::cghs::Gunn::Nu(const heatedFlow& flow) const
{
    const scalar e = flow.e;
    const scalar Re = this->Re(flow);
    const scalar PrRoot = pow(prandtl(flow), 0.33);

    const scalar still = 7 - 10*e + 5*sqr(e);
    const scalar streaming = 1.33 - 2.4*e + 1.2*sqr(e);

    return
        still*(1 + 0.7*pow(Re, 0.2)*PrRoot)
      + streaming*pow(Re, 0.7)*PrRoot;
}
