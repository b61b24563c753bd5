/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "blockIntegrator.H"


Foam::autoPtr<Foam::cghs::arrowIntegrator>
Foam::cghs::arrowIntegrator::New(const label nActive)
{
    arrowIntegrator* made = nullptr;

    switch (nActive)
    {
        case 1: made = new blockIntegrator<1>; break;
        case 2: made = new blockIntegrator<2>; break;
        case 3: made = new blockIntegrator<3>; break;
        case 4: made = new blockIntegrator<4>; break;
        default: made = new blockIntegrator<Eigen::Dynamic>;
    }

    return autoPtr<arrowIntegrator>(made);
}
