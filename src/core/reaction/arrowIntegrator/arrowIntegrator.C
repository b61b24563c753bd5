/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "blockIntegrator.H"


Foam::autoPtr<Foam::cghs::arrowIntegrator>
Foam::cghs::arrowIntegrator::New(const label nExtents)
{
    arrowIntegrator* made = nullptr;

    switch (nExtents)
    {
        case 1: made = new blockIntegrator<1>(nExtents); break;
        case 2: made = new blockIntegrator<2>(nExtents); break;
        case 3: made = new blockIntegrator<3>(nExtents); break;
        case 4: made = new blockIntegrator<4>(nExtents); break;
        case 5: made = new blockIntegrator<5>(nExtents); break;
        case 6: made = new blockIntegrator<6>(nExtents); break;
        case 7: made = new blockIntegrator<7>(nExtents); break;
        case 8: made = new blockIntegrator<8>(nExtents); break;
        default: made = new blockIntegrator<Eigen::Dynamic>(nExtents);
    }

    return autoPtr<arrowIntegrator>(made);
}
