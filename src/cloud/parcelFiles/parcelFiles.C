/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "parcelFiles.H"
#include "passiveParticleCloud.H"
#include "IOField.H"

namespace Foam
{
namespace cghs
{

//- Call use(name, values) for each field that is written
template<class Use>
static void forFields(const arena& parcels, const Use& use)
{
    const label n = parcels.size();

    vectorField x(n), v(n), w(parcels.spinning() ? n : 0);
    scalarField d(n), rho(n), weight(n), dParcel(n);

    for (label i = 0; i < n; ++i)
    {
        x[i] = parcels.spheres[i].x;
        v[i] = parcels.motions[i].v;
        d[i] = parcels.diameters[i];
        rho[i] = parcels.density(i);
        weight[i] = parcels.weights[i];
        dParcel[i] = 2*parcels.spheres[i].r;

        if (parcels.spinning())
        {
            w[i] = parcels.spins[i];
        }
    }

    use("position", x);
    use("U", v);
    use("d", d);
    use("rho", rho);
    use("nParticle", weight);
    use("dParcel", dParcel);

    if (parcels.spinning())
    {
        use("omega", w);
    }
    if (parcels.fading())
    {
        use("presence", scalarField(SubList<scalar>(parcels.presences, n)));
        use("exitPatch", labelField(SubList<label>(parcels.exits, n)));
    }
    if (parcels.nMaterials() > 1)
    {
        use("typeId", labelField(SubList<label>(parcels.materials, n)));
    }
}


template<class Type>
static Field<Type> readField
(
    const passiveParticleCloud& files,
    const word& name,
    const IOobject::readOption option = IOobject::MUST_READ
)
{
    const IOField<Type> field(files.fieldIOobject(name, option), files.size());

    files.checkFieldIOobject(files, field);
    return field;
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


//- Stop at a value that is below 1, or else not above zero
static void checkSize
(
    const passiveParticleCloud& files,
    const word& name,
    const bool atLeastOne = false
)
{
    const scalarField values(readField<scalar>(files, name));

    forAll(values, i)
    {
        if (!(atLeastOne ? values[i] >= 1 : values[i] > 0))
        {
            FatalErrorInFunction
                << "Parcel " << i << " has " << name << ' ' << values[i]
                << " in " << files.fieldIOobject
                   (name, IOobject::NO_READ).objectPath()
                << nl << "It must be "
                << (atLeastOne ? "at least 1" : "greater than zero") << nl
                << exit(FatalError);
        }
    }
}

//- Stop if the exact position of a parcel is not in or by the mesh cell that
//  OpenFOAM's coordinates give. They need not agree closely: in warped cells
//  decomposePar moves what it knows by coordinates alone
static void checkPlace
(
    const passiveParticleCloud& files,
    const label i,
    const vector& x,
    const label celli,
    const scalar diameter
)
{
    const polyMesh& mesh = files.pMesh();
    boundBox cell(mesh.points(), mesh.cellPoints()[celli], false);
    const vector margin(vector::uniform(diameter));

    if (!boundBox(cell.min() - margin, cell.max() + margin).contains(x))
    {
        FatalErrorInFunction
            << "Parcel " << i << " is at " << x << " in "
            << files.fieldIOobject
               ("position", IOobject::NO_READ).objectPath()
            << nl << "but in cell " << celli << " around "
            << mesh.cellCentres()[celli] << " by its coordinates" << nl
            << "Is it outside the mesh, or was one of the two files edited?"
            << " Remove position to go by coordinates" << nl
            << exit(FatalError);
    }
}


//- Stop if there are fields of parcels, but nothing says where these are:
//  OpenFOAM takes that for a cloud without parcels
static void checkPlaced(const passiveParticleCloud& files)
{
    const fileName folder
    (
        files.time().timePath()/cloud::prefix/files.name()
    );

    const auto has = [&](const char* name)
    {
        return isFile(folder/name, true);
    };

    if (has("d") && !has("coordinates") && !has("positions"))
    {
        FatalErrorInFunction
            << folder << " has fields of parcels, but neither coordinates nor"
            << " positions" << nl
            << "Restore the file that is missing, make the parcels anew with"
            << " fillParcels, or remove the folder to run without" << nl
            << exit(FatalError);
    }
}


//- The number of each parcel's material
static labelField readMaterials
(
    const passiveParticleCloud& files,
    const label nMaterials
)
{
    const labelField materials(readField<label>(files, "typeId"));

    forAll(materials, i)
    {
        if (materials[i] < 0 || materials[i] >= nMaterials)
        {
            FatalErrorInFunction
                << "Parcel " << i << " has typeId " << materials[i] << " in "
                << files.fieldIOobject
                   ("typeId", IOobject::NO_READ).objectPath()
                << nl << "It must be from 0 to " << nMaterials - 1
                << ", the number in the contact model's list of materials" << nl
                << exit(FatalError);
        }
    }

    return materials;
}

//- Whoever is not known to come in or go out is all there
static void readPresence(const passiveParticleCloud& files, arena& parcels)
{
    static_cast<UList<scalar>&>(parcels.presences) = 1;
    static_cast<UList<label>&>(parcels.exits) = -1;

    if
    (
        files.fieldIOobject("presence", IOobject::MUST_READ)
       .typeHeaderOk<IOField<scalar>>(true)
    )
    {
        const scalarField presences(readField<scalar>(files, "presence"));
        const labelField exits(readField<label>(files, "exitPatch"));

        forAll(presences, i)
        {
            parcels.presences[i] = min(max(presences[i], 0), 1);
            parcels.exits[i] = exits[i];
        }
    }
}

} // End namespace cghs
} // End namespace Foam


void Foam::cghs::readParcels
(
    const polyMesh& mesh,
    const word& cloudName,
    arena& parcels
)
{
    const passiveParticleCloud files(mesh, cloudName);
    const label n = files.size();

    parcels.append(n);

    if (n == 0)
    {
        checkPlaced(files);
        return;
    }

    checkSize(files, "d");
    checkSize(files, "rho");
    checkSize(files, "nParticle", true);

    const vectorField v(readField<vector>(files, "U"));
    const scalarField d(readField<scalar>(files, "d"));
    const scalarField rho(readField<scalar>(files, "rho"));
    const scalarField weight(readField<scalar>(files, "nParticle"));

    const bool exact =
        files.fieldIOobject("position", IOobject::MUST_READ)
       .typeHeaderOk<IOField<vector>>(true);
    const bool spins =
        parcels.spinning()
     && files.fieldIOobject("omega", IOobject::MUST_READ)
       .typeHeaderOk<IOField<vector>>(true);

    const vectorField x
    (
        exact ? readField<vector>(files, "position") : vectorField()
    );
    const vectorField w
    (
        spins ? readField<vector>(files, "omega") : vectorField()
    );

    if (parcels.fading())
    {
        readPresence(files, parcels);
    }

    if (parcels.nMaterials() > 1)
    {
        const labelField materials(readMaterials(files, parcels.nMaterials()));

        forAll(materials, i)
        {
            parcels.materials[i] = materials[i];
        }
    }

    label i = 0;
    for (const passiveParticle& p : files)
    {
        parcels.setSize(i, d[i], weight[i], rho[i]);

        if (exact)
        {
            checkPlace(files, i, x[i], p.cell(), 2*parcels.spheres[i].r);
        }

        parcels.spheres[i].x = exact ? x[i] : p.position();
        parcels.motions[i].v = v[i];
        parcels.cells[i] = p.cell();
        parcels.ids[i] = p.origId();

        if (parcels.spinning())
        {
            parcels.spins[i] = spins ? w[i] : Zero;
        }
        ++i;
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
