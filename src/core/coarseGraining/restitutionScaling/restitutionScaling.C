/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "restitutionScaling.H"
#include "selectModel.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(restitutionScaling, 0);
    defineRunTimeSelectionTable(restitutionScaling, dictionary);
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
