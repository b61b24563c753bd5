/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "parcelFiles.H"
#include "passiveParticleCloud.H"
#include "IOField.H"
#include "fileOperation.H"
#include "PstreamReduceOps.H"
#include "SubList.H"
#include "globalIndex.H"
#include "HashSet.H"
#include "OSspecific.H"
#include "Time.H"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace Foam
{
namespace cghs
{

//- Hands properties on as fields
template<class Use>
class fieldSink
:
    public propertySink
{
    const Use& use_;

public:

    explicit fieldSink(const Use& use): use_(use) {}

    virtual void take(const word& name, const UList<label>& values)
    {
        use_(name, labelField(values));
    }

    virtual void take(const word& name, const UList<scalar>& values)
    {
        use_(name, scalarField(values));
    }

    virtual void take(const word& name, const UList<vector>& values)
    {
        use_(name, vectorField(values));
    }
};


//- Call use(name, values) for each field that is written
template<class Use>
static void forFields(const arena& parcels, const Use& use)
{
    const label n = parcels.size();

    vectorField x(n), v(n);
    scalarField d(n), rho(n), weight(n), dParcel(n);

    for (label i = 0; i < n; ++i)
    {
        x[i] = parcels.spheres[i].x;
        v[i] = parcels.motions[i].v;
        d[i] = parcels.diameters[i];
        rho[i] = parcels.density(i);
        weight[i] = parcels.weights[i];
        dParcel[i] = 2*parcels.spheres[i].r;
    }

    use("position", x);
    use("U", v);
    use("d", d);
    use("rho", rho);
    use("nParticle", weight);
    use("dParcel", dParcel);

    fieldSink<Use> sink(use);
    for (const property* p : parcels.properties())
    {
        if (p->written())
        {
            p->show(n, sink);
        }
    }
}


//- To be called on all ranks: with some file handlers they read together. Who
//  has no parcels has no file, or an empty one
template<class Type>
static Field<Type> readField
(
    const passiveParticleCloud& files,
    const word& name
)
{
    const IOField<Type> field
    (
        files.fieldIOobject(name, IOobject::MUST_READ),
        files.size() > 0
    );

    files.checkFieldIOobject(files, field);
    return field;
}


//- Is there such a field on a rank that has parcels? On all ranks the same
template<class Type>
static bool hasField(const passiveParticleCloud& files, const word& name)
{
    const bool there =
        files.fieldIOobject(name, IOobject::MUST_READ)
       .typeHeaderOk<IOField<Type>>(true);

    return returnReduce(there && files.size() > 0, orOp<bool>());
}


//- Writes each field that it is given
struct fieldWriter
{
    const passiveParticleCloud& files;
    IOstream::streamFormat fmt;
    IOstream::versionNumber ver;
    IOstream::compressionType cmp;

    template<class Type>
    void operator()(const word& name, const Field<Type>& values) const
    {
        IOField<Type>
        (
            files.fieldIOobject(name, IOobject::NO_READ),
            values
        ).writeObject(fmt, ver, cmp, values.size());
    }
};


//- Puts each field that it is given into a registry
struct fieldRegistrar
{
    objectRegistry& obr;

    template<class Type>
    void operator()(const word& name, const Field<Type>& values) const
    {
        cloud::createIOField<Type>(name, values.size(), obr) = values;
    }
};


//- Begin the report of an error in a file
static OSstream& errorIn(const fileName& path)
{
    return FatalIOError("readParcels", __FILE__, __LINE__, path);
}


static fileName pathOf(const passiveParticleCloud& files, const word& name)
{
    return files.fieldIOobject(name, IOobject::NO_READ).objectPath();
}


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


//- Is the exact position of a parcel in or by the mesh cell that OpenFOAM's
//  coordinates give? They need not agree closely: in warped cells decomposePar
//  moves what it knows by coordinates alone
static bool agrees
(
    const polyMesh& mesh,
    const vector& x,
    const label celli,
    const scalar diameter
)
{
    if (celli < 0 || celli >= mesh.nCells())
    {
        return false;
    }

    boundBox cell(mesh.points(), mesh.cellPoints()[celli], false);
    const vector margin(vector::uniform(diameter));

    return boundBox(cell.min() - margin, cell.max() + margin).contains(x);
}


//- The cell of an exact position, or -1
static label cellAt(const polyMesh& mesh, const vector& x, const label hint)
{
    const bool known = hint >= 0 && hint < mesh.nCells();

    return known && mesh.pointInCell(x, hint) ? hint : mesh.findCell(x);
}


//- The cells of all parcels by their exact positions: the mesh is not the one
//  that their coordinates were made for
static void findCells
(
    const passiveParticleCloud& files,
    const vectorField& x,
    labelUList& cells
)
{
    const polyMesh& mesh = files.pMesh();

    forAll(x, i)
    {
        cells[i] = cellAt(mesh, x[i], cells[i]);

        if (cells[i] < 0)
        {
            errorIn(pathOf(files, "position"))
                << "Parcel " << i << " is at " << x[i] << nl
                << "but that is outside the mesh"
                << (Pstream::parRun() ? " of this rank" : "")
                << ", and coordinates, which say what cell it is in, name another"
                << " place" << nl
                << "Was the mesh changed, or one of the two files edited?"
                << " Decompose anew from a time that fits the mesh, or fill it"
                << " anew with fillParcels" << nl
                << exit(FatalIOError);
        }
    }
}


//- Cells by OpenFOAM's coordinates, unless exact positions disagree with any of
//  them. Returns whether coordinates were right
static bool checkCells
(
    const passiveParticleCloud& files,
    const vectorField& x,
    const arena& parcels,
    labelUList& cells
)
{
    label nMisplaced = 0;

    forAll(x, i)
    {
        const scalar d = 2*parcels.spheres[i].r;

        nMisplaced += !agrees(files.pMesh(), x[i], cells[i], d);
    }
    reduce(nMisplaced, sumOp<label>());

    if (nMisplaced)
    {
        Info<< "Cloud " << files.name() << ": " << nMisplaced << " of "
            << returnReduce(x.size(), sumOp<label>())
            << " parcels are not in the cells that their coordinates name (has"
            << " the mesh been renumbered?): cells are found anew from exact"
            << " positions" << nl << endl;

        findCells(files, x, cells);
    }

    return nMisplaced == 0;
}


//- How much positions that are written with few digits may be rounded by [m];
//  0 if any has more than ten
static scalar rounding(const vectorField& x)
{
    constexpr int mostDigits = 10;
    scalar unit = 0;
    int digits = 1;

    for (const vector& xi : x)
    {
        for (const scalar c : xi)
        {
            char text[32];
            for (; digits <= mostDigits; ++digits)
            {
                std::snprintf(text, sizeof(text), "%.*g", digits, c);
                if (std::strtod(text, nullptr) == c)
                {
                    break;
                }
            }
            if (digits > mostDigits)
            {
                return 0;
            }
            unit = max(unit, mag(c));
        }
    }

    return unit > 0 ? 0.5*std::pow(10.0, floor(log10(unit)) + 1 - digits) : 0;
}


//- Tools of OpenFOAM that rewrite the files of a cloud, such as decomposePar,
//  round positions to writePrecision. Where that matters coordinates, which are
//  rounded to that share of a cell, are better
static void replaceRounded
(
    const passiveParticleCloud& files,
    const arena& parcels,
    vectorField& x
)
{
    const scalar rounded = returnReduce(rounding(x), maxOp<scalar>());

    if (rounded == 0)
    {
        return;
    }

    label nReplaced = 0;
    scalar largest = 0;
    label i = 0;

    for (const passiveParticle& p : files)
    {
        // Rounded coordinates do not sum up to one, which counts as far away from
        // the origin as the cell is
        const vector place
        (
            p.position()
          - (cmptSum(p.coordinates()) - 1)*files.pMesh().cellCentres()[p.cell()]
        );
        const scalar off = mag(place - x[i]);
        const scalar d = 2*parcels.spheres[i].r;

        if (off > 1e-3*d && off < 2*rounded)
        {
            largest = max(largest, off/d);
            x[i] = place;
            ++nReplaced;
        }
        ++i;
    }
    reduce(nReplaced, sumOp<label>());
    reduce(largest, maxOp<scalar>());

    if (nReplaced)
    {
        WarningInFunction
            << "The positions of " << nReplaced << " parcels in "
            << pathOf(files, "position") << " are rounded, by up to " << largest
            << " diameters: those of their coordinates are taken, which are"
            << " rounded less" << nl
            << "    A tool such as decomposePar has written them with few digits:"
            << " set writePrecision 17 in system/controlDict before it runs, or"
            << " writeFormat binary" << nl << endl;
    }
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

    if (exact)
    {
        SubList<label> cells(parcels.cells, n);

        if (checkCells(files, x, parcels, cells))
        {
            replaceRounded(files, parcels, x);
        }
    }
    else
    {
        x.setSize(n);
        i = 0;
        for (const passiveParticle& p : files)
        {
            x[i++] = p.position();
        }
    }

    forAll(x, i)
    {
        parcels.spheres[i].x = x[i];
    }

    return checkIds(files, parcels);
}


void Foam::cghs::removeParcels(const polyMesh& mesh, const word& cloudName)
{
    // Ranks that share a file have an empty one
    if (!Pstream::parRun() || fileHandler().type() == "uncollated")
    {
        const fileName folder
        (
            mesh.time().timePath()/cloud::prefix/cloudName
        );

        if (isDir(folder))
        {
            rmDir(folder);
        }
    }
}


void Foam::cghs::writeParcels
(
    const polyMesh& mesh,
    const word& cloudName,
    const arena& parcels,
    IOstream::streamFormat fmt,
    IOstream::versionNumber ver,
    IOstream::compressionType cmp
)
{
    // Nobody overwrites what a run before has left
    if (parcels.size() == 0)
    {
        removeParcels(mesh, cloudName);
    }

    passiveParticleCloud files(mesh, cloudName, IDLList<passiveParticle>());

    for (label i = 0; i < parcels.size(); ++i)
    {
        passiveParticle* p =
            new passiveParticle
            (
                mesh,
                parcels.spheres[i].x,
                parcels.cells[i]
            );

        // The parcel's number alone tells it from all others, on all ranks
        p->origProc() = 0;
        p->origId() = parcels.ids[i];
        files.addParticle(p);
    }

    // Readers outside OpenFOAM know the positions, not the coordinates
    const bool positions = particle::writeLagrangianPositions;
    particle::writeLagrangianPositions = true;
    files.writeObject(fmt, ver, cmp, true);
    particle::writeLagrangianPositions = positions;

    forFields(parcels, fieldWriter{files, fmt, ver, cmp});
}


void Foam::cghs::registerParcels(const arena& parcels, objectRegistry& obr)
{
    forFields(parcels, fieldRegistrar{obr});
}
