/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "parcelFiles.H"
#include "fieldFiles.H"
#include "places.H"
#include "fileOperation.H"
#include "globalIndex.H"
#include "HashSet.H"
#include "OSspecific.H"
#include "Time.H"

namespace Foam
{
namespace cghs
{

//- A field of numbers of which none is below 1, or else all are above zero
static scalarField readSize
(
    const passiveParticleCloud& files,
    const word& name,
    const bool atLeastOne = false
)
{
    const scalarField values(readField<scalar>(files, name));

    forAll(values, i)
    {
        if (!((atLeastOne ? values[i] >= 1 : values[i] > 0) && values[i] < GREAT))
        {
            errorIn(pathOf(files, name))
                << "Parcel " << i << " has " << name << ' ' << values[i]
                << nl << "It must be "
                << (atLeastOne ? "at least 1" : "greater than zero") << nl
                << exit(FatalIOError);
        }
    }

    return values;
}


//- A field of vectors that are all finite
static vectorField readVectors
(
    const passiveParticleCloud& files,
    const word& name
)
{
    const vectorField values(readField<vector>(files, name));

    forAll(values, i)
    {
        if (!(cmptMax(cmptMag(values[i])) < GREAT))
        {
            errorIn(pathOf(files, name))
                << "Parcel " << i << " has " << name << ' ' << values[i] << nl
                << "Restore the file, or restart from an earlier time" << nl
                << exit(FatalIOError);
        }
    }

    return values;
}


//- Stop if there are fields of parcels, but OpenFOAM has read no places for them:
//  it takes that for a cloud without parcels
static void checkPlaced(const passiveParticleCloud& files)
{
    const fileName folder
    (
        files.time().timePath()/cloud::prefix/files.name()
    );

    if
    (
        !isFile(folder/"d", true)
     || IOField<scalar>(files.fieldIOobject("d", IOobject::MUST_READ)).empty()
    )
    {
        return;
    }

    const auto state = [&](const char* name)
    {
        return isFile(folder/name, true) ? " is there" : " is missing";
    };
    const fileName properties
    (
        files.time().timePath()/"uniform"/cloud::prefix/files.name()
       /"cloudProperties"
    );

    errorIn(folder)
        << folder << " has fields of parcels, but OpenFOAM reads no places for"
        << " them" << nl
        << "    coordinates" << state("coordinates") << ", positions"
        << state("positions") << nl
        << "    It reads coordinates if " << properties
        << " says 'geometry coordinates;', else positions" << nl
        << "Restore the file that is missing or empty, or make that entry name"
        << " the one that is there; or make the parcels anew with fillParcels;"
        << " or remove the folder to run without parcels" << nl
        << exit(FatalIOError);
}


//- Properties as they are in files
class fileSource
:
    public propertySource
{
    const passiveParticleCloud& files_;

    template<class Type>
    bool read(const word& name, Field<Type>& values) const
    {
        const bool there = hasField<Type>(files_, name);

        if (there)
        {
            values = readField<Type>(files_, name);
        }
        return there;
    }

public:

    explicit fileSource(const passiveParticleCloud& files): files_(files) {}

    virtual bool give(const word& name, labelField& values)
    {
        return read(name, values);
    }

    virtual bool give(const word& name, scalarField& values)
    {
        return read(name, values);
    }

    virtual bool give(const word& name, vectorField& values)
    {
        return read(name, values);
    }
};


//- What is not in files is not to be found there
class noSource
:
    public propertySource
{
public:

    virtual bool give(const word&, labelField&) { return false; }

    virtual bool give(const word&, scalarField&) { return false; }

    virtual bool give(const word&, vectorField&) { return false; }
};


//- Give the parcels numbers of their own if theirs do not tell them apart.
//  Returns whether they do
static bool checkIds(const passiveParticleCloud& files, arena& parcels)
{
    labelHashSet seen(2*parcels.size());
    bool apart = true;

    for (label i = 0; i < parcels.size(); ++i)
    {
        apart = seen.insert(parcels.ids[i]) && parcels.ids[i] >= 0 && apart;
    }

    if (returnReduce(apart, andOp<bool>()))
    {
        return true;
    }

    const globalIndex numbers(parcels.size());

    for (label i = 0; i < parcels.size(); ++i)
    {
        parcels.ids[i] = numbers.toGlobal(i);
    }

    WarningInFunction
        << "The numbers of the parcels in " << pathOf(files, "origId")
        << " do not tell them apart: they are given new ones, and contacts begin"
        << " without memory" << nl << endl;

    return false;
}


static void readProperties
(
    const passiveParticleCloud& files,
    const dictionary& constantProperties,
    arena& parcels
)
{
    fileSource inFiles(files);
    noSource nowhere;

    for (property* p : parcels.properties())
    {
        propertySource& source =
            p->written()
          ? static_cast<propertySource&>(inFiles)
          : static_cast<propertySource&>(nowhere);
        const label bad =
            p->fill(parcels.size(), source, constantProperties);

        if (bad >= 0)
        {
            errorIn(pathOf(files, p->name())) << "Parcel " << bad << " has ";
            p->explain(bad, FatalIOError);
            FatalIOError
                << nl << "Restore the file or mend the value" << nl
                << exit(FatalIOError);
        }
    }
}

} // End namespace cghs
} // End namespace Foam


bool Foam::cghs::readParcels
(
    const polyMesh& mesh,
    const word& cloudName,
    const dictionary& constantProperties,
    arena& parcels
)
{
    const passiveParticleCloud files(mesh, cloudName);
    const label n = files.size();

    parcels.append(n);

    // Ranks that share a file cannot look into it alone
    const bool ownFiles =
        !Pstream::parRun() || fileHandler().type() == "uncollated";

    if (n == 0 && ownFiles)
    {
        checkPlaced(files);
    }
    if (returnReduce(n, sumOp<label>()) == 0)
    {
        return true;
    }

    const scalarField d(readSize(files, "d"));
    const scalarField rho(readSize(files, "rho"));
    const scalarField weight(readSize(files, "nParticle", true));
    const vectorField v(readVectors(files, "U"));

    const bool exact = hasField<vector>(files, "position");
    vectorField x(exact ? readVectors(files, "position") : vectorField());

    label i = 0;
    for (const passiveParticle& p : files)
    {
        parcels.setSize(i, d[i], weight[i], rho[i]);
        parcels.motions[i].v = v[i];
        parcels.cells[i] = p.cell();
        parcels.ids[i] = p.origId();
        ++i;
    }
    readProperties(files, constantProperties, parcels);

    placeParcels(files, exact, x, parcels);

    return checkIds(files, parcels);
}
