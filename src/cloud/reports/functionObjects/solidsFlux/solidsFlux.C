/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "solidsFlux.H"
#include "arena.H"
#include "knownEntries.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(solidsFlux, 0);
    addToRunTimeSelectionTable(functionObject, solidsFlux, dictionary);
    describeFunction
    (
        solidsFlux,
        "fraction and flux of the solids now, as fields"
    );
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
    const UList<label>& places = parcels.places();

    scalarField V(mesh_.V());
    vectorField j(mesh_.nCells(), Zero);
    scalarField phi(mesh_.nCells(), Zero);

    parcels.visiting.fetch(V);
    parcels.visiting.extend(j);
    parcels.visiting.extend(phi);

    for (label i = 0; i < parcels.size(); ++i)
    {
        const label placei = places[i];
        const scalar share = parcels.volume(i)/V[placei];

        j[placei] += share*parcels.motions[i].v;
        phi[placei] += share;
    }

    parcels.visiting.collect(j);
    parcels.visiting.collect(phi);

    flux_.primitiveFieldRef() = j;
    fraction_.primitiveFieldRef() = phi;

    flux_.correctBoundaryConditions();
    fraction_.correctBoundaryConditions();

    return true;
}


bool Foam::cghs::solidsFlux::write()
{
    return flux_.write() && fraction_.write();
}
