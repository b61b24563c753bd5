/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "parcelFiles.H"
#include "passiveParticleCloud.H"
#include "fileOperation.H"
#include "IOField.H"
#include "OSspecific.H"
#include "Time.H"

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

} // End namespace cghs
} // End namespace Foam


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
