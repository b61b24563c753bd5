/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "page.H"
#include "checkedEntry.H"

namespace Foam
{
namespace cghs
{

//- No random packing of equal spheres is denser [-]
constexpr scalar randomClosePacking = 0.64;

//- Cells over the limit that are no matter of single parcels [-]
constexpr scalar fewCells = 0.01;


//- By the centres of the parcels
static scalarField centredFractions(const caseView& view)
{
    const arena& parcels = view.cloud.parcels();
    scalarField fractions(view.mesh.nCells(), Zero);

    for (label i = 0; i < parcels.size(); ++i)
    {
        fractions[parcels.cells[i]] += parcels.volume(i);
    }
    return fractions/view.mesh.cellVolumes();
}


static label nAbove(const scalarField& values, const scalar limit)
{
    label n = 0;
    for (const scalar value : values)
    {
        n += value > limit;
    }
    return returnReduce(n, sumOp<label>());
}


static void checkCells(const caseView& view, findings& found)
{
    const scalarField centred(centredFractions(view));
    const label nOccupied = nAbove(centred, 0);

    page::line
    (
        "cells with centres of parcels",
        textOf
        (
            nOccupied, ", solids fraction up to ", gMax(centred), ", ",
            nAbove(centred, randomClosePacking), " above ", randomClosePacking
        )
    );

    if (!view.fluid.valid() || !view.twoWay())
    {
        return;
    }

    const tmp<volScalarField> theta
    (
        view.cloud.momentumExchange().solidsFraction()
    );
    const label nCrowded =
        returnReduce
        (
            view.cloud.momentumExchange().nCrowdedCells(),
            maxOp<label>()
        );
    const scalar minVoidage = view.solution().get<scalar>("minVoidage");

    page::line
    (
        "as the fluid sees it",
        textOf
        (
            "solids fraction up to ", gMax(theta().primitiveField()), ", ",
            nCrowded, " cells had more than 1 - minVoidage"
        )
    );

    if (nCrowded > fewCells*nOccupied)
    {
        found.warn
        (
            place(view.propertiesFile(), "minVoidage", minVoidage),
            textOf
            (
                nCrowded, " of ", nOccupied, " cells with parcels hold more"
                " than ", 1 - minVoidage, ": the rest goes to cells about them"
            ),
            "spread more by the mapping, take larger cells, or fill with fewer"
            " parcels"
        );
    }
}


//- The solids as a whole
static void checkVessel
(
    const caseView& view,
    const parcelKind& sum,
    findings& found
)
{
    const scalar solids = sum.mass/sum.rho;
    const scalar fraction = solids/view.volume();

    page::line
    (
        "mean solids fraction of the mesh",
        textOf(fraction, " of ", view.volume(), " m3")
    );
    page::line
    (
        "height if it all settled",
        textOf
        (
            solids/looselyPacked/view.crossSection(), " m of ", view.height()
        )
    );

    if (fraction > randomClosePacking)
    {
        found.fail
        (
            place
            (
                view.startTime + "/lagrangian/" + view.cloud.name(),
                "mass",
                textOf(sum.mass, " kg")
            ),
            textOf
            (
                "the parcels take ", fraction, " of the mesh, but a random"
                " packing holds ", randomClosePacking, ": they overlap"
            ),
            "fill with fewer parcels, by fillParcels"
        );
    }
}


//- A valve keeps the inventory; is there enough, and room for it?
static void checkValve
(
    const dictionary& valve,
    const word& patch,
    const caseView& view,
    const UList<parcelKind>& kinds,
    findings& found
)
{
    scalar rho = 0;
    for (const parcelKind& k : kinds)
    {
        rho = max(rho, k.rho);
    }

    const scalar inventory = valve.get<scalar>("inventory");
    const scalar most = looselyPacked*view.volume()*rho;
    const scalar mass = sumOf(kinds).mass;
    const place where
    (
        view.propertiesFile(),
        "boundary." + patch + ".inventory",
        inventory
    );

    page::line
    (
        "inventory kept by " + patch,
        textOf
        (
            inventory, " kg; there are ", mass, ", the vessel holds about ",
            most, " settled"
        )
    );
    if (inventory > most)
    {
        found.warn
        (
            where,
            textOf
            (
                "the vessel holds about ", most, " kg of settled solids: the"
                " valve opens when it is full, or never"
            ),
            textOf("an inventory of about half of it, ", 0.5*most)
        );
    }
    if (inventory > mass && view.cloud.feeders().empty())
    {
        found.warn
        (
            where,
            textOf
            (
                "there are only ", mass, " kg and nothing feeds more: the valve"
                " never opens"
            ),
            "an inventory below the mass that is there, a feeder, or rebound"
        );
    }
}


//- What fillParcels was asked for, of one kind of entry in all regions; below
//  zero if regions differ
static scalar requested(const dictionary& regions, const word& entry)
{
    scalar sum = 0;
    for (const Foam::entry& e : regions)
    {
        if (!e.isDict() || !e.dict().found(entry))
        {
            return -1;
        }
        sum += e.dict().get<scalar>(entry);
    }
    return sum;
}


static void checkRequest
(
    const scalar asked,
    const scalar there,
    const scalar tolerance,
    const word& entry,
    findings& found
)
{
    if (asked < 0)
    {
        return;
    }
    page::line
    (
        "fillParcels asked for, there are",
        textOf(entry, ' ', asked, ", ", there)
    );
    if (mag(asked - there) > tolerance)
    {
        found.warn
        (
            place("system/fillParcelsDict", entry, asked),
            textOf
            (
                "there are ", there, ": the file has been changed since"
                " fillParcels was run, or it was not run"
            ),
            "run fillParcels again, if its file is to hold"
        );
    }
}


//- At time 0, before anything has come or gone
static void checkFilling
(
    const caseView& view,
    const parcelKind& sum,
    findings& found
)
{
    const IOobject file
    (
        "fillParcelsDict",
        view.runTime.caseSystem(),
        view.runTime,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );

    if
    (
        view.runTime.value() > 0
     || !IOobject(file).typeHeaderOk<IOdictionary>()
    )
    {
        return;
    }

    const IOdictionary fill(file);
    const dictionary& regions = fill.subDict("regions");
    const scalar n = max(regions.size(), 1);

    checkRequest
    (
        requested(regions, "number"), sum.nParcels, 0.5, "number", found
    );
    checkRequest
    (
        requested(regions, "mass"),
        sum.mass,
        n*sum.mass/max(sum.nParcels, 1) + 1e-6*sum.mass,
        "mass",
        found
    );
}

} // End namespace cghs
} // End namespace Foam


void Foam::cghs::checkPacking
(
    const caseView& view,
    const UList<parcelKind>& kinds,
    findings& found
)
{
    page::title("Packing");

    const parcelKind sum(sumOf(kinds));
    if (sum.nParcels > 0)
    {
        checkCells(view, found);
        checkVessel(view, sum, found);
    }
    else
    {
        page::line("parcels", "none yet");
    }

    for (const entry& e : view.cloud.properties().subDict("boundary"))
    {
        if (e.isDict() && e.dict().found("inventory"))
        {
            checkValve(e.dict(), e.keyword(), view, kinds, found);
        }
    }
    checkFilling(view, sum, found);
}
