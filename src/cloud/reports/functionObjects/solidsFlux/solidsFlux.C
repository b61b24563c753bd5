/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "solidsFlux.H"
#include "arena.H"
#include "knownEntries.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(solidsFlux, 0);
    addToRunTimeSelectionTable(functionObject, solidsFlux, dictionary);
} // End namespace cghs
} // End namespace Foam


Foam::cghs::solidsFlux::solidsFlux
(
    const word& name,
    const Time& time,
    const dictionary& dict
)
:
    cloudFunctionObject(name, time, dict),
    flux_(cellField<vector>("solidsFlux", dimVelocity)),
    fraction_(cellField<scalar>("solidsFraction", dimless))
{
    warnUnknownOfFunction(dict, wordList({"cloud"}));
    read(dict);
}


bool Foam::cghs::solidsFlux::execute()
{
    const arena& parcels = this->parcels();

    vectorField& j = flux_.primitiveFieldRef();
    scalarField& phi = fraction_.primitiveFieldRef();

    j = Zero;
    phi = Zero;

    for (label i = 0; i < parcels.size(); ++i)
    {
        const label celli = parcels.cells[i];
        const scalar share = parcels.volume(i)/mesh_.V()[celli];

        j[celli] += share*parcels.motions[i].v;
        phi[celli] += share;
    }

    flux_.correctBoundaryConditions();
    fraction_.correctBoundaryConditions();

    return true;
}


bool Foam::cghs::solidsFlux::write()
{
    return flux_.write() && fraction_.write();
}
