/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Application
    fillParcels

Description
    Fills boxes of the mesh with parcels at random, without overlaps with each
    other or with walls, and writes them to the start time.

Usage
    fillParcels [-cloud name]        in serial, before decomposePar

    system/fillParcelsDict:

        seed    1;

        regions
        {
            bed
            {
                min             (0 0 0);
                max             (0.1 0.25 0.015);   // [m]

                // One of
                number          5000;
                mass            0.103;              // [kg]
                solidsFraction  0.3;                // of the region's volume

                velocity        (0 0 0);            // [m/s]
                velocitySpread  (0.05 0.05 0.05);   // uniform in +- this
            }
        }

    Diameter, density and weight of the parcels are those of
    constant/<cloud>Properties. More solids than a random packing holds, or
    than fit between the walls, are a FatalIOError.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "polyMesh.H"
#include "packer.H"
#include "transport.H"
#include "parcelFiles.H"
#include "cloudProperties.H"
#include "checkedEntry.H"
#include "mathematicalConstants.H"
#include "IOdictionary.H"
#include "SortableList.H"

using namespace Foam;
using namespace Foam::cghs;

//- No random packing of equal spheres is denser [-]
constexpr scalar randomClosePacking = 0.64;


//- Volume of the mesh in a box, by cell centres [m^3]
static scalar volumeOf(const polyMesh& mesh, const boundBox& box)
{
    scalar volume = 0;

    forAll(mesh.cellVolumes(), celli)
    {
        if (box.contains(mesh.cellCentres()[celli]))
        {
            volume += mesh.cellVolumes()[celli];
        }
    }

    return volume;
}


//- How many parcels a region asks for
static label numberOf
(
    const dictionary& dict,
    const scalar regionVolume,
    const scalar parcelVolume,
    const scalar density
)
{
    const label nGiven =
        dict.found("number") + dict.found("mass")
      + dict.found("solidsFraction");

    if (nGiven != 1)
    {
        FatalIOErrorInFunction(dict)
            << "Found " << nGiven << " of the entries number, mass and"
            << " solidsFraction; give one of them" << nl
            << exit(FatalIOError);
    }

    if (dict.found("number"))
    {
        return labelFrom(dict, "number", 0);
    }

    const scalar solids =
        dict.found("mass")
      ? scalarInRange(dict, "mass", 0, GREAT)/density
      : scalarInRange(dict, "solidsFraction", 0, 1)*regionVolume;

    return label(solids/parcelVolume + 0.5);
}


int main(int argc, char *argv[])
{
    argList::addNote("Fills boxes of the mesh with parcels");
    argList::addOption("cloud", "name", "name of the cloud, default parcels");
    argList::noParallel();

    #include "setRootCase.H"
    #include "createTime.H"
    #include "createPolyMesh.H"

    const word cloudName(args.get<word>("cloud", "parcels"));

    const IOdictionary properties(readCloudProperties(mesh, cloudName));
    const IOdictionary fillDict
    (
        IOobject
        (
            "fillParcelsDict",
            runTime.system(),
            mesh,
            IOobject::MUST_READ
        )
    );


    // ---- The parcel -------------------------------------------------------

    const particleProperties particle(properties);
    const scalar density = particle.density;
    const scalar radius = 0.5*particle.parcelDiameter();
    const scalar volume = 4.0/3.0*constant::mathematical::pi*pow3(radius);


    // ---- Where they go ----------------------------------------------------

    const transport boundary(mesh, properties.subDict("boundary"));

    packer spheres
    (
        mesh,
        boundary.wallPatches(),
        fillDict.get<label>("seed")
    );
    DynamicList<vector> velocities;

    for (const entry& e : fillDict.subDict("regions"))
    {
        const dictionary& dict = e.dict();
        const boundBox box(dict.get<vector>("min"), dict.get<vector>("max"));
        const scalar room = volumeOf(mesh, box);
        const label n = numberOf(dict, room, volume, density);
        const scalar fraction = n*volume/max(room, VSMALL);

        if
        (
            fraction > randomClosePacking
         || !spheres.fill(box, radius, n)
        )
        {
            FatalIOErrorInFunction(dict)
                << "Region " << e.keyword() << " asks for " << n
                << " parcels of " << 2*radius
                << " m, a solids fraction of " << fraction << nl
                << "A random packing holds at most " << randomClosePacking
                << ", and between its walls this region takes no more than "
                << spheres.capacity(box, radius) << " parcels" << nl
                << "Ask for less or enlarge the region" << nl
                << exit(FatalIOError);
        }

        const vector velocity(dict.get<vector>("velocity"));
        const vector spread
        (
            dict.getOrDefault<vector>("velocitySpread", Zero)
        );

        while (velocities.size() < spheres.spheres().size())
        {
            const vector r(spheres.random().sample01<vector>());
            velocities.append
            (
                velocity + cmptMultiply(spread, 2*r - vector::uniform(1))
            );
        }

        Info<< "Region " << e.keyword() << ": " << n << " parcels, "
            << n*volume*density << " kg, solids fraction " << fraction << endl;
    }


    // ---- Write ------------------------------------------------------------

    arena parcels(false, false);
    parcels.append(velocities.size());

    forAll(velocities, i)
    {
        parcels.spheres[i] = spheres.spheres()[i];
        parcels.motions[i] = motion(velocities[i], 1/(density*volume));
        parcels.weights[i] = particle.parcelWeight;
        parcels.diameters[i] = particle.diameter;
        parcels.cells[i] = spheres.cells()[i];
        parcels.ids[i] = i;
    }

    writeParcels
    (
        mesh,
        cloudName,
        parcels,
        runTime.writeFormat(),
        IOstream::currentVersion,
        runTime.writeCompression()
    );

    Info<< nl << "Wrote " << parcels.size() << " parcels to time "
        << runTime.timeName() << nl << "End" << nl << endl;

    return 0;
}
