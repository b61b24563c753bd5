/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "solidsInventory.H"
#include "cghsCloud.H"
#include "knownEntries.H"
#include "meshNames.H"
#include "PstreamReduceOps.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(solidsInventory, 0);
    addToRunTimeSelectionTable(functionObject, solidsInventory, dictionary);
    describeFunction
    (
        solidsInventory,
        "mass in the mesh and in zones, in- and outflow"
    );
}
}

// * * * * * * * * * * * * * * * Construction  * * * * * * * * * * * * * * * //

Foam::cghs::solidsInventory::solidsInventory
(
    const word& name,
    const Time& time,
    const dictionary& dict
)
:
    cloudFunctionObject(name, time, dict),
    zones_(),
    patches_(),
    feeders_(),
    inZone_(),
    flown_(),
    flownStep_(-1),
    means_(*this, mesh_, typeName)
{
    read(dict);
}


bool Foam::cghs::solidsInventory::read(const dictionary& dict)
{
    warnUnknownOfFunction
    (
        dict,
        wordList({"cloud", "cellZones", "patches", "feeders"})
    );

    cloudFunctionObject::read(dict);

    const bool again = means_.names().size();

    findZones(dict);
    patches_ = exitPatches(dict);
    findFeeders(dict);

    means_.start(names(), dict, "Entries cellZones, patches and feeders");

    if (!again)
    {
        flown_ = flownSoFar();
        flownStep_ = mesh_.time().timeIndex();
    }

    return true;
}


void Foam::cghs::solidsInventory::findZones(const dictionary& dict)
{
    const wordList wanted(dict.get<wordList>("cellZones"));

    zones_.resize(wanted.size());
    inZone_.resize(wanted.size());

    forAll(wanted, i)
    {
        zones_[i] = cellZoneNamed(wanted[i], "cellZones", dict, mesh_);

        inZone_[i] = boolList(mesh_.nCells(), false);
        UIndirectList<bool>(inZone_[i], mesh_.cellZones()[zones_[i]]) = true;
    }
}


void Foam::cghs::solidsInventory::findFeeders(const dictionary& dict)
{
    const PtrList<feeder>& all = theCloud().feeders();
    wordList valid(all.size());

    forAll(all, i)
    {
        valid[i] = all[i].name();
    }

    const wordList wanted(dict.getOrDefault<wordList>("feeders", wordList()));
    feeders_.resize(wanted.size());

    forAll(wanted, i)
    {
        feeders_[i] = valid.find(wanted[i]);

        if (feeders_[i] < 0)
        {
            FatalIOErrorInFunction(dict)
                << "Entry feeders: there is no feeder " << wanted[i] << nl
                << "Valid choices: " << valid << nl
                << exit(FatalIOError);
        }
    }
}


Foam::wordList Foam::cghs::solidsInventory::names() const
{
    DynamicList<word> list({"mass"});

    for (const label zonei : zones_)
    {
        list.append("mass(" + mesh_.cellZones()[zonei].name() + ')');
    }
    for (const label patchi : patches_)
    {
        list.append("outflow(" + mesh_.boundaryMesh()[patchi].name() + ')');
    }
    for (const label feederi : feeders_)
    {
        list.append("inflow(" + theCloud().feeders()[feederi].name() + ')');
    }

    return wordList(std::move(list));
}


// * * * * * * * * * * * * * * * * The sums  * * * * * * * * * * * * * * * * //

Foam::scalarField Foam::cghs::solidsInventory::flownSoFar() const
{
    const scalarField& escaped = theCloud().transportStage().gone().massBy();
    DynamicList<scalar> flown;

    for (const label patchi : patches_)
    {
        flown.append(escaped[patchi]);
    }
    for (const label feederi : feeders_)
    {
        // All ranks know it; one is to count it
        flown.append
        (
            Pstream::master() ? theCloud().feeders()[feederi].fed() : 0
        );
    }

    return scalarField(std::move(flown));
}


Foam::scalar Foam::cghs::solidsInventory::massIn(const boolList& cells) const
{
    const arena& parcels = this->parcels();
    const UList<label>& places = parcels.places();

    boolList inside(cells);
    parcels.visiting.fetch(inside);

    scalar sum = 0;
    for (label i = 0; i < parcels.size(); ++i)
    {
        if (inside[places[i]])
        {
            sum += parcels.motions[i].mass();
        }
    }

    return sum;
}


bool Foam::cghs::solidsInventory::execute()
{
    const arena& parcels = this->parcels();
    const scalar deltaT = mesh_.time().deltaTValue();

    scalarField& now = means_.now();
    now = Zero;

    for (label i = 0; i < parcels.size(); ++i)
    {
        now[0] += parcels.motions[i].mass();
    }
    forAll(inZone_, z)
    {
        now[1 + z] = massIn(inZone_[z]);
    }

    const scalarField flown(flownSoFar());
    const label step = mesh_.time().timeIndex();
    const bool known = flownStep_ == step - 1;
    flownStep_ = step;

    if (!known)
    {
        flown_ = flown;
        return true;
    }

    forAll(flown, k)
    {
        now[1 + zones_.size() + k] = (flown[k] - flown_[k])/deltaT;
    }
    flown_ = flown;

    reduce(now, sumOp<scalarField>());

    means_.add(deltaT);

    return true;
}


bool Foam::cghs::solidsInventory::write()
{
    means_.write();

    return true;
}
