/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "noContact.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(noContact, 0);
    addToRunTimeSelectionTable(contactModel, noContact, dictionary);
    describeModel
    (
        contactModel,
        noContact,
        "parcels pass through each other"
    );
}
}
