/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "solidsInventory.H"
#include "cghsCloud.H"
#include "meshNames.H"
#include "PstreamReduceOps.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(solidsInventory, 0);
    addToRunTimeSelectionTable(functionObject, solidsInventory, dictionary);
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
    writeFile(mesh_, name, typeName),
    zones_(),
    patches_(),
    feeders_(),
    inZone_(),
    flown_(),
    flownStep_(-1),
    now_(),
    moments_()
{
    read(dict);
}


bool Foam::cghs::solidsInventory::read(const dictionary& dict)
{
    cloudFunctionObject::read(dict);
    writeFile::read(dict);

    if (now_.size())
    {
        // Read again during the run
        keepState();
    }

    findZones(dict);
    findPatches(dict);
    findFeeders(dict);

    if (now_.empty())
    {
        now_.resize
        (
            1 + zones_.size() + patches_.size() + feeders_.size(),
            Zero
        );
        flown_ = flownSoFar();
        flownStep_ = mesh_.time().timeIndex();
    }
    resume(dict);

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


void Foam::cghs::solidsInventory::findPatches(const dictionary& dict)
{
    const polyBoundaryMesh& all = mesh_.boundaryMesh();
    const transport& stage = theCloud().transportStage();
    const wordList wanted(dict.get<wordList>("patches"));

    patches_.resize(wanted.size());

    forAll(wanted, i)
    {
        patches_[i] = all.findPatchID(wanted[i]);

        if (patches_[i] < 0 || !stage.escapes(patches_[i]))
        {
            DynamicList<word> valid;
            forAll(all, patchi)
            {
                if (stage.escapes(patchi))
                {
                    valid.append(all[patchi].name());
                }
            }

            FatalIOErrorInFunction(dict)
                << "Entry patches: parcels do not escape through "
                << wanted[i] << nl
                << "Valid choices: " << valid << nl
                << exit(FatalIOError);
        }
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


void Foam::cghs::solidsInventory::resume(const dictionary& dict)
{
    // The length of the step comes first
    moments_ = blockMoments(1 + now_.size());

    wordList formerNames;
    if (!getProperty("names", formerNames))
    {
        return;
    }

    List<scalar> state;
    getProperty("moments", state);

    if (formerNames != names() || !moments_.setState(state))
    {
        FatalIOErrorInFunction(dict)
            << "Entries cellZones, patches and feeders ask for " << names()
            << " but until time " << mesh_.time().timeName() << " it was "
            << formerNames << nl
            << "Ask for the same, or rename the function object to start"
            << " anew" << nl
            << exit(FatalIOError);
    }
}


void Foam::cghs::solidsInventory::keepState()
{
    setProperty("names", names());
    setProperty("moments", moments_.state());
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


void Foam::cghs::solidsInventory::openTable()
{
    resetFile(typeName);

    file() << "# time";
    for (const word& name : names())
    {
        file() << ' ' << name << ' ' << name << "Mean " << name << "Error";
    }
    file() << endl;
    file().precision(writePrecision_);
}

// * * * * * * * * * * * * * * * * The sums  * * * * * * * * * * * * * * * * //

Foam::scalarField Foam::cghs::solidsInventory::flownSoFar() const
{
    const scalarField& escaped = theCloud().transportStage().massEscapedBy();
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


bool Foam::cghs::solidsInventory::execute()
{
    const arena& parcels = this->parcels();
    const scalar deltaT = mesh_.time().deltaTValue();

    now_ = Zero;

    for (label i = 0; i < parcels.size(); ++i)
    {
        const scalar mass = parcels.motions[i].mass();
        now_[0] += mass;

        forAll(inZone_, z)
        {
            if (inZone_[z][parcels.cells[i]])
            {
                now_[1 + z] += mass;
            }
        }
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
        now_[1 + zones_.size() + k] = (flown[k] - flown_[k])/deltaT;
    }
    flown_ = flown;

    reduce(now_, sumOp<scalarField>());

    scalarField sample(1 + now_.size(), deltaT);
    forAll(now_, q)
    {
        sample[1 + q] = deltaT*now_[q];
    }
    moments_.add(sample);

    return true;
}


bool Foam::cghs::solidsInventory::write()
{
    if (writeToFile() && moments_.nSamples() > 0)
    {
        if (!filePtr_.valid())
        {
            openTable();
        }
        file() << mesh_.time().value();
        forAll(now_, q)
        {
            const blockMoments::estimate mean(moments_.ratio(1 + q, 0));
            file() << ' ' << now_[q] << ' ' << mean.value << ' ' << mean.error;
        }
        file() << endl;
    }

    keepState();

    return true;
}
