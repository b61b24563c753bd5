/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "restitutionScaling.H"
#include "selectModel.H"
#include "modelList.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(restitutionScaling, 0);
    defineRunTimeSelectionTable(restitutionScaling, dictionary);
    describeFamily
    (
        restitutionScaling,
        "restitution of parcels of W particles: of a contactModel"
    );
}
}


Foam::autoPtr<Foam::cghs::restitutionScaling>
Foam::cghs::restitutionScaling::New(const dictionary& dict)
{
    return selectModel<restitutionScaling>
    (
        dict,
        *dictionaryConstructorTablePtr_
    );
}
