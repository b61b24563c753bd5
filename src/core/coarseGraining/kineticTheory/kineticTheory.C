/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "kineticTheory.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(kineticTheory, 0);
    addToRunTimeSelectionTable(restitutionScaling, kineticTheory, dictionary);
    describeModel
    (
        restitutionScaling,
        kineticTheory,
        "keeps what restitution takes (Eq 62)"
    );
}
}


Foam::scalar Foam::cghs::kineticTheory::ofParcel
(
    const dictionary& dict,
    const restitution& particle,
    const scalar W
) const
{
    const scalar e = particle.e;
    const scalar square = 1 + (sqr(e) - 1)*cbrt(W);

    // The limit is printed with six digits: what is printed is to be accepted
    if (square < -1e-5)
    {
        FatalIOErrorInFunction(dict)
            << "restitutionScaling kineticTheory has no real solution for"
            << " restitutionCoefficient " << e << " and parcelWeight " << W
            << nl << "The largest parcelWeight it allows here is "
            << pow3(1/(1 - sqr(e)))
            << nl << "Lower parcelWeight, or select restitutionScaling"
            << " logarithmic" << nl
            << exit(FatalIOError);
    }

    return sqrt(max(square, scalar(0)));
}
