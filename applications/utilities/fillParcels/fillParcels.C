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

                sizeDistribution { ... }    // optional, see particleSizes
            }
        }

    Density and weight of the parcels are those of constant/<cloud>Properties,
    and so is the diameter where a region has no sizeDistribution. A mass or solidsFraction is met to
    within half of the parcel drawn last. Regions may overlap: in all of them
    the largest parcels are placed first. A region holds whole parcels. More solids
    than a random packing holds, or than find room, are a FatalIOError.

    In a two-dimensional mesh (empty patches) all centres are in the middle plane,
    and the thickness of the mesh plays no part in whether there is room. Volume
    and solidsFraction are still those of spheres in the volume of the mesh, as
    the fluid sees them.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "polyMesh.H"
#include "packer.H"
#include "meshFreedom.H"
#include "parcelBoundary.H"
#include "parcelFiles.H"
#include "flowState.H"
#include "cloudProperties.H"
#include "checkedEntry.H"
#include "knownEntries.H"
#include "particleSizes.H"
#include "IOdictionary.H"
#include "mathematicalConstants.H"

#include <algorithm>

namespace Foam
{
namespace cghs
{

//- No random packing of equal spheres is denser, and none of equal discs in a
//  plane [-]
constexpr scalar randomClosePacking = 0.64;
constexpr scalar randomCloseDiscs = 0.84;


//- The mesh as parcels fill it
struct container
{
    const polyMesh& mesh;

    //- Of a two-dimensional mesh [m], 0 of others
    scalar thickness;

    container(const polyMesh& m)
    :
        mesh(m),
        thickness(0)
    {
        for (direction d = 0; d < 3; ++d)
        {
            if (cghs::freedom(m)[d] == 0)
            {
                thickness = m.bounds().span()[d];
            }
        }
    }

    scalar densest() const
    {
        return thickness > 0 ? randomCloseDiscs : randomClosePacking;
    }

    //- What spheres of a volume and a radius take of a volume: of the plane in
    //  two dimensions
    scalar taken
    (
        const scalar volume,
        const scalar radius,
        const scalar room
    ) const
    {
        const scalar fraction = volume/max(room, VSMALL);

        return
            thickness > 0 ? 0.75*fraction*thickness/radius : fraction;
    }
};


//- What all parcels have in common
struct constants
:
    public particleProperties
{
    using particleProperties::particleProperties;

    scalar radius(const scalar diameter) const
    {
        return arena::radiusOf(diameter, weight);
    }

    scalar volume(const scalar diameter) const
    {
        return 4.0/3.0*constant::mathematical::pi*pow3(radius(diameter));
    }
};


//- Parcels of a region that are of about one size, the largest first
struct batch
{
    word region;
    const dictionary* dict;
    DynamicList<scalar> diameters;
};


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


static boundBox boxOf(const dictionary& region)
{
    return boundBox(region.get<vector>("min"), region.get<vector>("max"));
}


//- Stop if a region asks for more than it can hold
static void checkFraction
(
    const dictionary& region,
    const container& room,
    const scalar fraction,
    const label nParcels = -1
)
{
    if (fraction > room.densest())
    {
        FatalIOErrorInFunction(region)
            << "Region " << region.dictName() << " asks for ";
        if (nParcels >= 0)
        {
            FatalIOError << nParcels << " parcels, ";
        }
        FatalIOError
            << "a solids fraction of " << fraction
            << (room.thickness > 0 ? " of the plane" : "") << nl
            << "A random packing holds at most " << room.densest() << nl
            << "Ask for less or enlarge the region" << nl
            << exit(FatalIOError);
    }
}


static void checkEntries(const dictionary& region)
{
    warnUnknownEntries
    (
        region,
        wordList
        ({
            "min", "max", "number", "mass", "solidsFraction", "velocity",
            "velocitySpread", "sizeDistribution"
        })
    );
}


//- Draw the diameters of the parcels that a region asks for
static DynamicList<scalar> draw
(
    const dictionary& region,
    const container& mesh,
    const scalar room,
    const constants& parcel,
    const particleSizes& sizes
)
{
    const label nGiven =
        region.found("number") + region.found("mass")
      + region.found("solidsFraction");

    if (nGiven != 1)
    {
        FatalIOErrorInFunction(region)
            << "Found " << nGiven << " of the entries number, mass and"
            << " solidsFraction; give one of them" << nl
            << exit(FatalIOError);
    }

    DynamicList<scalar> diameters;

    if (region.found("number"))
    {
        const label n = labelFrom(region, "number", 0);

        for (label i = 0; i < n; ++i)
        {
            diameters.append(sizes.draw());
        }
        return diameters;
    }

    const scalar solids =
        region.found("mass")
      ? scalarInRange(region, "mass", 0, GREAT)/parcel.density
      : scalarInRange(region, "solidsFraction", 0, 1)*room;

    checkFraction
    (
        region,
        mesh,
        mesh.taken(solids, parcel.radius(sizes.largest()), room)
    );

    scalar missing = solids;
    while (missing > 0)
    {
        const scalar d = sizes.draw();

        // The last one, if that comes nearer
        if (parcel.volume(d) < 2*missing)
        {
            diameters.append(d);
        }
        missing -= parcel.volume(d);
    }

    return diameters;
}


//- Draw the parcels of a region and append them to the batches, by size
static void plan
(
    const polyMesh& mesh,
    const word& name,
    const dictionary& region,
    const constants& parcel,
    Random& random,
    DynamicList<batch>& batches
)
{
    checkEntries(region);

    const container whole(mesh);
    const scalar room = volumeOf(mesh, boxOf(region));
    const particleSizes sizes(region, parcel, random);
    DynamicList<scalar> diameters(draw(region, whole, room, parcel, sizes));

    std::sort(diameters.begin(), diameters.end(), std::greater<scalar>());

    scalar solids = 0;
    scalar taken = 0;
    for (const scalar d : diameters)
    {
        if (batches.empty() || batches.last().dict != &region
         || d < 0.5*batches.last().diameters[0])
        {
            batches.append(batch{name, &region, DynamicList<scalar>()});
        }
        batches.last().diameters.append(d);
        solids += parcel.volume(d);
        taken += whole.taken(parcel.volume(d), parcel.radius(d), room);
    }

    const scalar fraction = solids/max(room, VSMALL);

    checkFraction(region, whole, taken, diameters.size());

    Info<< "Region " << name << ": " << diameters.size() << " parcels, "
        << solids*parcel.density << " kg, solids fraction " << fraction << endl;
}


//- Names of the patches that parcels touch and that reach into a box
static wordList touchedIn
(
    const boundBox& box,
    const polyMesh& mesh,
    const List<labelPair>& touched
)
{
    DynamicList<word> names;

    for (const labelPair& patch : touched)
    {
        const polyPatch& pp = mesh.boundaryMesh()[patch.first()];
        bool inside = false;

        for (const face& f : pp)
        {
            inside = inside || box.overlaps(boundBox(pp.points(), f, false));
        }
        if (inside)
        {
            names.append(pp.name());
        }
    }

    return wordList(std::move(names));
}


//- Say what is in the way of parcels of diameter d: the sides of a box, patches,
//  nBefore larger ones
static void explainRoom
(
    const boundBox& box,
    const scalar d,
    const label nPlaced,
    const label nBefore,
    const polyMesh& mesh,
    const List<labelPair>& touched
)
{
    const vector freedom(cghs::freedom(mesh));

    for (direction cmpt = 0; cmpt < 3; ++cmpt)
    {
        if (freedom[cmpt] > 0 && box.span()[cmpt] < d)
        {
            FatalIOError
                << "It holds whole parcels, but is " << box.span()[cmpt]
                << " m long in " << vector::componentNames[cmpt] << nl;
        }
    }

    const wordList patches(touchedIn(box, mesh, touched));

    FatalIOError << "Whole, clear of each other";
    if (patches.size())
    {
        FatalIOError << ", of the patches " << flatOutput(patches);
    }
    if (nBefore)
    {
        FatalIOError << ", of the " << nBefore << " placed before";
    }
    FatalIOError << ", no more than " << nPlaced << " find room in it" << nl;
}


//- Find places for a batch
static void place
(
    const batch& b,
    const constants& parcel,
    const polyMesh& mesh,
    const List<labelPair>& touched,
    packer& spheres
)
{
    const label n = b.diameters.size();
    scalarList radii(n);

    forAll(radii, i)
    {
        radii[i] = parcel.radius(b.diameters[i]);
    }

    const boundBox box(boxOf(*b.dict));
    const label nBefore = spheres.spheres().size();
    const label nPlaced = spheres.fill(box, radii);

    if (nPlaced < n)
    {
        FatalIOErrorInFunction(*b.dict)
            << "Region " << b.region << " asks for " << n << " parcels of "
            << 2*radii.last() << " to " << 2*radii.first() << " m" << nl;
        explainRoom(box, 2*radii.first(), nPlaced, nBefore, mesh, touched);
        FatalIOError
            << "Ask for less or enlarge the region" << nl
            << exit(FatalIOError);
    }
}


//- Draw the velocities of a batch
static void appendVelocities
(
    const batch& b,
    const vector& freedom,
    Random& random,
    DynamicList<vector>& velocities
)
{
    const vector mean(b.dict->get<vector>("velocity"));
    const vector spread(b.dict->getOrDefault<vector>("velocitySpread", Zero));

    forAll(b.diameters, i)
    {
        const vector r(random.sample01<vector>());
        velocities.append
        (
            cmptMultiply
            (
                freedom,
                mean + cmptMultiply(spread, 2*r - vector::uniform(1))
            )
        );
    }
}

} // End namespace cghs
} // End namespace Foam


int main(int argc, char *argv[])
{
    using namespace Foam;
    using namespace Foam::cghs;

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

    const constants parcel(properties);
    const cghs::parcelBoundary boundary(mesh, properties.subDict("boundary"));

    const List<labelPair> touched(boundary.wallPatches());

    packer spheres(mesh, touched, fillDict.get<label>("seed"));


    // ---- Which parcels, and in which order --------------------------------

    DynamicList<batch> batches;

    for (const entry& e : fillDict.subDict("regions"))
    {
        plan(mesh, e.keyword(), e.dict(), parcel, spheres.random(), batches);
    }

    std::stable_sort
    (
        batches.begin(),
        batches.end(),
        [](const batch& a, const batch& b)
        {
            return a.diameters[0] > b.diameters[0];
        }
    );


    // ---- Where they go ----------------------------------------------------

    DynamicList<scalar> diameters;
    DynamicList<vector> velocities;

    for (const batch& b : batches)
    {
        place(b, parcel, mesh, touched, spheres);
        appendVelocities
        (
            b,
            cghs::freedom(mesh),
            spheres.random(),
            velocities
        );
        diameters.append(b.diameters);
    }


    // ---- Write ------------------------------------------------------------

    arena parcels(false, false);
    parcels.append(velocities.size());

    forAll(velocities, i)
    {
        parcels.setSize(i, diameters[i], parcel.weight, parcel.density);
        parcels.spheres[i].x = spheres.spheres()[i].x;
        parcels.motions[i].v = velocities[i];
        parcels.cells[i] = spheres.cells()[i];
        parcels.ids[i] = i;
    }

    removeParcels(mesh, cloudName);
    writeParcels
    (
        mesh,
        cloudName,
        parcels,
        runTime.writeFormat(),
        IOstream::currentVersion,
        runTime.writeCompression()
    );

    // Whoever reads them can tell that all are there. What has been before, as
    // feeders have counted it, is no more
    dictionary flows;
    flows.set("nParcels", parcels.size());
    writeFlows(mesh, cloudName, flows);

    Info<< nl << "Wrote " << parcels.size() << " parcels to time "
        << runTime.timeName() << nl << "End" << nl << endl;

    return 0;
}
