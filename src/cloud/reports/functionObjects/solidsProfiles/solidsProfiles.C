/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "solidsProfiles.H"
#include "arena.H"
#include "knownEntries.H"
#include "PstreamReduceOps.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(solidsProfiles, 0);
    addToRunTimeSelectionTable(functionObject, solidsProfiles, dictionary);
    describeFunction
    (
        solidsProfiles,
        "means along lines, radii and heights, with error bars"
    );
}
}


Foam::cghs::solidsProfiles::solidsProfiles
(
    const word& name,
    const Time& time,
    const dictionary& dict
)
:
    cloudFunctionObject(name, time, dict),
    writeFile(mesh_, name, name),
    profiles_()
{
    read(dict);
}


bool Foam::cghs::solidsProfiles::read(const dictionary& dict)
{
    warnUnknownOfFunction(dict, wordList({"cloud", "profiles"}));

    cloudFunctionObject::read(dict);
    writeFile::read(dict);

    // Read again during the run, these go on
    keepState();
    profiles_.clear();

    for (const entry& e : dict.subDict("profiles"))
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(dict)
                << "Entry " << e.keyword() << " of profiles must be a"
                << " dictionary: the profile of that name" << nl
                << exit(FatalIOError);
        }

        auto profile = autoPtr<solidsProfile>::New(e.dict(), mesh_);
        List<scalar> state;

        if (getProperty(profile->name(), state) && !profile->setState(state))
        {
            FatalIOErrorInFunction(e.dict())
                << "Profile " << profile->name() << " has other bins than it"
                << " had until time " << mesh_.time().timeName() << nl
                << "Give it back its bins, or another name to start anew" << nl
                << exit(FatalIOError);
        }
        profiles_.append(profile);
    }

    return true;
}


void Foam::cghs::solidsProfiles::keepState()
{
    for (const solidsProfile& profile : profiles_)
    {
        setProperty(profile.name(), profile.state());
    }
}


Foam::scalarField Foam::cghs::solidsProfiles::sums() const
{
    label size = 0;
    for (const solidsProfile& profile : profiles_)
    {
        size += profile.nSums();
    }

    scalarField all(size, Zero);
    label start = 0;

    for (const solidsProfile& profile : profiles_)
    {
        SubList<scalar> part(all, profile.nSums(), start);
        profile.sum(parcels(), part);
        start += part.size();
    }

    reduce(all, sumOp<scalarField>());

    return all;
}


bool Foam::cghs::solidsProfiles::execute()
{
    const scalarField all(sums());
    label start = 0;

    for (solidsProfile& profile : profiles_)
    {
        profile.add
        (
            SubList<scalar>(all, profile.nSums(), start),
            mesh_.time().deltaTValue()
        );
        start += profile.nSums();
    }

    return true;
}


bool Foam::cghs::solidsProfiles::write()
{
    for (const solidsProfile& profile : profiles_)
    {
        autoPtr<OFstream> table
        (
            createFile(profile.name(), mesh_.time().value())
        );

        if (table.valid())
        {
            table->precision(writePrecision_);
            profile.write(table(), name());
        }
    }
    keepState();

    return true;
}
