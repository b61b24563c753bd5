/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "addedMass.H"
#include "checkedEntry.H"
#include "knownEntries.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(addedMass, 0);
    addToRunTimeSelectionTable(forceModel, addedMass, dictionary);
    describeModel
    (
        forceModel,
        addedMass,
        "the fluid that goes along with particles: liquids"
    );
}
}


bool Foam::cghs::addedMass::readCrowding(const dictionary& dict)
{
    const word crowding(dict.get<word>("crowding"));

    if (crowding != "none" && crowding != "Zuber")
    {
        FatalIOErrorInFunction(dict)
            << "Entry crowding is " << crowding << nl
            << "Valid choices: none, Zuber" << nl
            << exit(FatalIOError);
    }

    return crowding == "Zuber";
}


Foam::cghs::addedMass::addedMass(const dictionary& dict)
:
    C_(scalarInRange(dict, "C", 0, 10)),
    crowds_(readCrowding(dict))
{
    warnUnknownEntries(dict, wordList({"C", "crowding"}));
}


void Foam::cghs::addedMass::add
(
    const UList<ambientFlow>& flows,
    UList<forceTerms>& terms
) const
{
    forAll(flows, i)
    {
        const scalar a = coefficient(flows[i].e)*flows[i].rho;

        terms[i].inertia += a;
        terms[i].push += a*flows[i].turning;
    }
}
