/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "cloudChecks.H"
#include "cloudProperties.H"
#include "knownEntries.H"
#include "cloud.H"
#include "polyMesh.H"
#include "Time.H"
#include "PstreamReduceOps.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace cghs
{

//- Warn if an entry of constantProperties is not what parcels have
template<class Value>
static void warnIfOthers
(
    const dictionary& properties,
    const arena& parcels,
    const char* name,
    const scalar value,
    const Value& of
)
{
    scalar least = GREAT, most = -GREAT;
    for (label i = 0; i < parcels.size(); ++i)
    {
        least = min(least, of(i));
        most = max(most, of(i));
    }
    reduce(least, minOp<scalar>());
    reduce(most, maxOp<scalar>());

    if
    (
        least <= most
     && (value < least*(1 - 1e-6) || value > most*(1 + 1e-6))
    )
    {
        const string from(most > least ? Foam::name(least) + " to " : "");

        WarningInFunction
            << "Entry " << name << " in constantProperties of "
            << properties.name() << " is " << value
            << ", but the parcels that are there have "
            << from.c_str() << most << nl
            << "    They keep their own. The entry is for new parcels"
            << " (fillParcels, feeding); parcelWeight is also that which"
            << " restitutionScaling takes" << nl << endl;
    }
}


//- Of all that there is or may be [kg/m^3]
static scalar densest(const dictionary& properties, const arena& parcels)
{
    scalar most = particleProperties(properties).density;

    for (const entry& e : properties.subOrEmptyDict("feeding"))
    {
        if (e.isDict())
        {
            most = max(most, particleProperties(properties, e.dict()).density);
        }
    }
    for (label i = 0; i < parcels.size(); ++i)
    {
        most = max(most, parcels.density(i));
    }

    return returnReduce(most, maxOp<scalar>());
}


//- Stop if a mesh cannot hold what an entry inventory asks for
static void checkInventory
(
    const dictionary& valve,
    const dictionary& properties,
    const arena& parcels,
    const polyMesh& mesh
)
{
    // The share of equal spheres in their closest packing
    const scalar packed = constant::mathematical::pi/sqrt(18.0);
    const scalar volume = gSum(mesh.cellVolumes());
    const scalar most = packed*volume*densest(properties, parcels);
    const scalar inventory = valve.get<scalar>("inventory");

    if (inventory > most)
    {
        FatalIOErrorInFunction(valve)
            << "Entry inventory is " << inventory << " kg, but a mesh of "
            << volume << " m^3 holds " << most << " kg of these particles"
            << " at most, packed as closely as spheres can be" << nl
            << "Choose an inventory below that; a fluidised bed takes about"
            << " half of the room" << nl
            << exit(FatalIOError);
    }
}

} // End namespace cghs
} // End namespace Foam


void Foam::cghs::checkEntries
(
    const dictionary& properties,
    const arena& parcels
)
{
    warnUnknownEntries
    (
        properties,
        wordList
        ({
            "solution", "constantProperties", "subModels", "boundary", "feeding"
        }),
        true
    );
    warnUnknownEntries
    (
        properties.subDict("solution"),
        wordList
        ({
            "coupling", "fluid", "maxDisplacement", "maxDeltaT",
            "neighbourSkin", "minVoidage", "transported", "energyCoeffs",
            "slowClock", "compositionLag", "temperatureLag",
            "densityTolerance"
        })
    );
    wordList constants({"diameter", "density", "parcelWeight"});
    constants.append(parcels.entryNames());
    warnUnknownEntries(properties.subDict("constantProperties"), constants);
    warnUnknownEntries
    (
        properties.subDict("subModels"),
        wordList
        ({
            "contactModel", "wallDistance", "dragModel", "forces",
            "mappingModel", "exchanges"
        })
    );
}


void Foam::cghs::checkConstants
(
    const dictionary& properties,
    const arena& parcels
)
{
    const particleProperties stated(properties);

    warnIfOthers
    (
        properties,
        parcels,
        "parcelWeight",
        stated.weight,
        [&](const label i) { return parcels.weights[i]; }
    );
    warnIfOthers
    (
        properties,
        parcels,
        "density",
        stated.density,
        [&](const label i) { return parcels.density(i); }
    );

    if (properties.subDict("constantProperties").found("diameter"))
    {
        warnIfOthers
        (
            properties,
            parcels,
            "diameter",
            stated.diameter(),
            [&](const label i) { return parcels.diameters[i]; }
        );
    }
}


void Foam::cghs::checkInventories
(
    const dictionary& properties,
    const arena& parcels,
    const polyMesh& mesh
)
{
    for (const entry& e : properties.subDict("boundary"))
    {
        if (e.isDict() && e.dict().found("inventory"))
        {
            checkInventory(e.dict(), properties, parcels, mesh);
        }
    }
}


void Foam::cghs::checkCount
(
    const dictionary& flows,
    const arena& parcels,
    const polyMesh& mesh,
    const word& cloudName
)
{
    const label found = returnReduce(parcels.size(), sumOp<label>());
    const label written = flows.getOrDefault<label>("nParcels", found);

    if (found != written)
    {
        FatalIOErrorInFunction(flows)
            << "Cloud " << cloudName << ": " << written << " parcels were"
            << " written, but " << found << " are found" << nl
            << "Is a folder " << mesh.time().timeName()/cloud::prefix/cloudName
            << (
                   found < written
                 ? " or a file in it missing, on one of the ranks? Restore it,"
                 : " left over from another run, on one of the ranks? Remove it,"
               )
            << " or restart from an earlier time" << nl
            << "If parcels were added or taken out on purpose remove the entry"
            << " nParcels" << nl
            << exit(FatalIOError);
    }
}
