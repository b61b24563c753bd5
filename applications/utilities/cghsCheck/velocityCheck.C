/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "page.H"
#include "noDrag.H"

namespace Foam
{
namespace cghs
{

//- Velocities of a kind of parcels [m/s]
struct bounds
{
    scalar Umf = GREAT;
    scalar Ut = GREAT;
};


//- A row for each kind. The least of all
static bounds printVelocities
(
    const caseView& view,
    const UList<parcelKind>& kinds,
    const dragModel& law
)
{
    page::head
    (
        List<string>
        ({
            "d [m]", "Ar", "U_mf [m/s]", "U_t [m/s]", "Wen-Yu U_mf"
        })
    );

    bounds least;
    for (const parcelKind& k : kinds)
    {
        const particleInFluid p(view.particle(k.d, k.rho));
        const scalar Umf = carryingVelocity(law, p, wenYuVoidage);
        const scalar Ut = carryingVelocity(law, p, 1);

        least.Umf = min(least.Umf, Umf);
        least.Ut = min(least.Ut, Ut);
        page::row
        (
            "",
            List<string>
            ({
                page::number(k.d),
                page::number(p.Ar()),
                page::number(Umf),
                page::number(Ut),
                page::number(wenYuMinimumFluidisation(p))
            })
        );
    }
    return least;
}


static bool heavier(const UList<parcelKind>& kinds, const caseView& view)
{
    for (const parcelKind& k : kinds)
    {
        if (k.rho <= view.rho())
        {
            return false;
        }
    }
    return kinds.size();
}


static string namesOf(const UList<inlet>& inlets)
{
    string names;
    for (const inlet& it : inlets)
    {
        names += (names.empty() ? "" : " ") + it.name;
    }
    return names;
}


//- The flow as a whole against what it is to do with the solids
static void compare
(
    const caseView& view,
    const UList<inlet>& inlets,
    const bounds& least,
    findings& found
)
{
    const scalar U = meanVelocity(inlets, view);
    const place where
    (
        "the field U",
        namesOf(inlets),
        textOf(U, " m/s over the mean cross-section")
    );

    page::line("superficial velocity [m/s]", page::number(U));
    page::line("over the least U_mf", page::number(U/least.Umf));
    page::line("over the least U_t", page::number(U/least.Ut));

    if (view.cloud.empty())
    {
        return;
    }
    if (U < least.Umf && view.cloud.feeders().empty())
    {
        found.warn
        (
            where,
            textOf
            (
                "the flow at the start is below the least U_mf, ", least.Umf,
                " m/s: if it stays so the bed is not fluidised"
            ),
            "none needed for a packed bed or a flow that grows; otherwise raise"
            " U at the inlets"
        );
    }
    if (U > least.Ut && view.exits().empty())
    {
        found.warn
        (
            where,
            textOf
            (
                "the flow is above the least U_t, ", least.Ut,
                " m/s, and no patch lets parcels out: they gather where the"
                " fluid leaves"
            ),
            "let the outlet escape in boundary of " + view.propertiesFile()
          + ", or lower U at the inlets"
        );
    }
    else if (U > least.Ut && view.cloud.feeders().empty())
    {
        found.warn
        (
            where,
            textOf
            (
                "the flow is above the least U_t, ", least.Ut,
                " m/s, and nothing feeds parcels: it carries them out in ",
                "about ", view.height()/(U - least.Ut), " s"
            ),
            "add a feeder, e.g. one that recycles, or lower U at the inlets"
        );
    }
}

} // End namespace cghs
} // End namespace Foam


void Foam::cghs::checkVelocities
(
    const caseView& view,
    const UList<parcelKind>& kinds,
    const UList<inlet>& inlets,
    findings& found
)
{
    page::title("Velocities");
    page::line
    (
        "density, viscosity of the fluid",
        textOf(view.rho(), " kg/m3, ", view.mu(), " kg/m/s")
    );

    const autoPtr<dragModel> law(dragModel::New(view.subModels()));
    page::line("dragModel", law->type());

    for (const inlet& it : inlets)
    {
        page::line
        (
            "superficial velocity at " + it.name,
            textOf(it.velocity(), " m/s")
        );
    }

    if (isA<noDrag>(law()) || mag(view.g) == 0 || !heavier(kinds, view))
    {
        page::line("U_mf, U_t", "nothing is carried");
        return;
    }

    const bounds least(printVelocities(view, kinds, law()));
    if (inlets.size())
    {
        compare(view, inlets, least, found);
    }
}
