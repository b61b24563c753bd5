/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "page.H"
#include "meshFreedom.H"

namespace Foam
{
namespace cghs
{

//- More of the mesh in cells smaller than a parcel is no matter of some corner
//  of it [-]
constexpr scalar fewSmallCells = 0.05;

//- Of a vessel, an opening: parcels that have to find their way [-]
constexpr scalar leastAcross = 3;


static void printKinds(const UList<parcelKind>& kinds)
{
    page::head
    (
        List<string>
        ({
            "d [m]", "W", "d_parcel [m]", "rho [kg/m3]", "parcels",
            "particles", "mass [kg]"
        })
    );

    const parcelKind sum(sumOf(kinds));
    for (const parcelKind& k : kinds)
    {
        page::row
        (
            k.nParcels > 0 ? "" : "to come",
            List<string>
            ({
                page::number(k.d),
                page::number(k.W),
                page::number(k.parcelDiameter()),
                page::number(k.rho),
                Foam::name(label(k.nParcels)),
                page::number(k.nParticles),
                page::number(k.mass)
            })
        );
    }
    page::line("parcels", Foam::name(label(sum.nParcels)));
    page::line("real particles", page::number(sum.nParticles));
    page::line("mass of solids [kg]", page::number(sum.mass));
}


//- The share of the mesh in cells smaller than d
static scalar shareBelow
(
    const scalarField& sizes,
    const caseView& view,
    const scalar d
)
{
    scalar below = 0;
    forAll(sizes, celli)
    {
        if (sizes[celli] < d)
        {
            below += view.mesh.cellVolumes()[celli];
        }
    }
    return returnReduce(below, sumOp<scalar>())/view.volume();
}


static void checkCells
(
    const caseView& view,
    const scalar d,
    findings& found
)
{
    const scalarField sizes(view.cellSizes());
    const scalar least = gMin(sizes);
    const scalar share = shareBelow(sizes, view, d);

    page::line
    (
        "cells",
        Foam::name(returnReduce(view.mesh.nCells(), sumOp<label>()))
    );
    page::line
    (
        "cell sizes, least mean most [m]",
        textOf(least, "  ", gAverage(sizes), "  ", gMax(sizes))
    );
    page::line("least cell over largest parcel", page::number(least/d));

    if (!view.fluid.valid() || share <= fewSmallCells)
    {
        return;
    }

    const word mapping(view.subModels().get<word>("mappingModel"));
    const string meaning
    (
        textOf
        (
            "parcels of ", d, " m are larger than cells in ", 100*share,
            " % of the mesh"
        )
    );
    const string resolves
    (
        " (Eq 53 of the method asks for parcels no larger than cells)"
    );

    if (mapping == "centroid")
    {
        found.warn
        (
            place(view.propertiesFile(), "mappingModel", mapping),
            meaning + ": one of them fills its cell and leaves those about it"
            " empty" + resolves,
            textOf
            (
                "choose mappingModel diffusion with a width of 3 or more,"
                " cells above ", d, " m, or a parcelWeight smaller by ",
                pow3(d/least)
            )
        );
    }
    else
    {
        found.takeNote
        (
            place(view.propertiesFile(), "mappingModel", mapping),
            meaning + resolves,
            "none needed where the width of the mapping is some parcels"
        );
    }
}


//- Of a patch [m]: its length in two dimensions, else the root of its area
static scalar openingOf(const fvPatch& patch, const caseView& view)
{
    const scalar area = gSum(patch.magSf());
    const scalar thickness = view.thickness();

    return thickness > 0 ? area/thickness : sqrt(area);
}


//- Patches that parcels have to pass, and the vessel itself
static void checkWays
(
    const caseView& view,
    const scalar d,
    findings& found
)
{
    const vector free(freedom(view.mesh));
    const vector span(view.mesh.bounds().span());
    scalar narrowest = GREAT;

    for (direction c = 0; c < 3; ++c)
    {
        narrowest = free[c] > 0 ? min(narrowest, span[c]) : narrowest;
    }
    page::line("vessel's least extent over parcel", page::number(narrowest/d));

    if (view.touching() && narrowest < leastAcross*d)
    {
        found.warn
        (
            place
            (
                view.propertiesFile(),
                "parcelWeight",
                view.constants().get<scalar>("parcelWeight")
            ),
            textOf
            (
                "parcels of ", d, " m are in a vessel only ", narrowest,
                " m wide, less than ", leastAcross, " of them"
            ),
            "lower parcelWeight, or make a two-dimensional mesh with empty"
            " patches"
        );
    }

    for (const label patchi : view.exits())
    {
        const fvPatch& patch = view.mesh.boundary()[patchi];
        const scalar opening = openingOf(patch, view);

        page::line
        (
            "opening " + patch.name() + " over parcel",
            page::number(opening/d)
        );
        if (opening < d)
        {
            found.warn
            (
                place
                (
                    view.propertiesFile(),
                    "boundary." + patch.name(),
                    textOf(opening, " m")
                ),
                textOf
                (
                    "parcels of ", d, " m are to leave by an opening that is"
                    " smaller than they are"
                ),
                "lower parcelWeight, or widen the patch"
            );
        }
    }
}

} // End namespace cghs
} // End namespace Foam


void Foam::cghs::checkParcels
(
    const caseView& view,
    const UList<parcelKind>& kinds,
    findings& found
)
{
    page::title("Parcels");
    printKinds(kinds);

    if (view.cloud.empty() && view.cloud.feeders().empty())
    {
        found.takeNote
        (
            place(view.propertiesFile(), "feeding", "none"),
            "there are no parcels, and none will come",
            "run fillParcels, or add a feeder, if there are to be any"
        );
        return;
    }

    const scalar d = largestParcel(kinds);
    if (d > 0)
    {
        checkCells(view, d, found);
        checkWays(view, d, found);
    }
}
