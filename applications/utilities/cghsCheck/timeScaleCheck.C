/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "page.H"
#include "fluidisation.H"
#include "heat.H"
#include "noDrag.H"
#include "softSphere.H"
#include "fluidThermo.H"

namespace Foam
{
namespace cghs
{

//- A contact of soft spheres is to last that many steps
constexpr scalar stepsOfContact = 20;

//- What gravity alone may move a parcel in a solids step, g dt^2, of d, before
//  those at rest overlap: as the solver has it
constexpr scalar muchFall = 0.05;
constexpr scalar goodFall = 0.02;


//- rho_p/D of a kind that falls freely, or where there is no gravity has a slip
//  of 1 m/s [s]
static scalar dragTime
(
    const particleInFluid& p,
    const dragModel& law,
    const scalar e
)
{
    const scalar slip = p.g > 0 ? carryingVelocity(law, p, e)/e : 1;

    return p.rhoP/law.coefficient(p.flow(e, slip));
}


//- The exchange of heat of the case, or none
static const heat* heatOf(const caseView& view)
{
    for (const exchange& x : view.cloud.exchanges())
    {
        if (isA<heat>(x))
        {
            return &refCast<const heat>(x);
        }
    }
    return nullptr;
}


//- Of the solids, by the parcels that are there [J/kg/K]; 0 without any
static scalar capacityOf(const heat& h, const caseView& view)
{
    const bool any = view.cloud.parcels().size() && h.Cp().known();

    return returnReduce(any ? h.Cp()(0) : 0, maxOp<scalar>());
}


//- rho_p Cp d^2/(6 Nu kappa) of a kind that does not move [s]
static scalar heatTime
(
    const particleInFluid& p,
    const scalar solidCp,
    const heatTransferModel& law,
    const fluidThermo& thermo
)
{
    const scalar kappa = gAverage(thermo.kappa()().primitiveField());
    const scalar Cp = gAverage(thermo.Cp()().primitiveField());
    const scalar Nu =
        law.nusselt(heatedFlow(p.flow(wenYuVoidage, 0), Cp, kappa));

    return Nu > 0 ? p.rhoP*solidCp*sqr(p.d)/(6*Nu*kappa) : GREAT;
}


static void printDragTimes
(
    const caseView& view,
    const UList<parcelKind>& kinds
)
{
    const autoPtr<dragModel> law(dragModel::New(view.subModels()));
    if (isA<noDrag>(law()))
    {
        return;
    }
    for (const parcelKind& k : kinds)
    {
        const particleInFluid p(view.particle(k.d, k.rho));

        page::line
        (
            textOf("drag relaxation at ", k.d, " m"),
            textOf
            (
                dragTime(p, law(), 1), " s alone, ",
                dragTime(p, law(), wenYuVoidage),
                " s packed (drag is implicit in any step)"
            )
        );
    }
}


static void printHeatTimes
(
    const caseView& view,
    const UList<parcelKind>& kinds
)
{
    const heat* h = heatOf(view);
    const scalar Cp = h ? capacityOf(*h, view) : 0;
    if (!(Cp > 0))
    {
        return;
    }

    const autoPtr<heatTransferModel> law
    (
        heatTransferModel::New(view.subModels().subDict("heatCoeffs"))
    );
    for (const parcelKind& k : kinds)
    {
        const particleInFluid p(view.particle(k.d, k.rho));
        const scalar time = heatTime(p, Cp, law(), view.fluid->thermo());

        page::line
        (
            textOf("heat relaxation at ", k.d, " m"),
            time < GREAT ? textOf(time, " s") : string("no convection")
        );
    }
}


//- The shortest contact of soft spheres [s], GREAT of others: that of the
//  lightest kind
static scalar contactTime
(
    const caseView& view,
    const UList<parcelKind>& kinds
)
{
    if (view.contactModelName() != softSphere::typeName)
    {
        return GREAT;
    }

    const scalar stiffness = softSphere::stiffnessOfParcel
    (
        view.coeffsOf("contactModel"),
        view.constants().get<scalar>("parcelWeight")
    );
    scalar least = GREAT;

    for (const parcelKind& k : kinds)
    {
        least = min
        (
            least,
            constant::mathematical::pi*sqrt(0.5*k.parcelMass()/stiffness)
        );
    }
    return least;
}


static void checkContactTime
(
    const caseView& view,
    const UList<parcelKind>& kinds,
    const scalar step,
    findings& found
)
{
    const scalar tc = contactTime(view, kinds);
    if (tc == GREAT)
    {
        return;
    }

    page::line("contact of soft spheres", textOf(tc, " s"));

    if (step > tc/stepsOfContact)
    {
        found.warn
        (
            place
            (
                view.propertiesFile(),
                "maxDeltaT",
                view.solution().get<scalar>("maxDeltaT")
            ),
            textOf
            (
                "solids steps of ", step, " s are longer than a twentieth of"
                " the contact of ", tc, " s: springs gain energy"
            ),
            textOf
            (
                "a maxDeltaT of ", tc/stepsOfContact,
                ", or a lower springConstant"
            )
        );
    }
}


//- How far parcels at rest fall in a step
static void checkFall
(
    const caseView& view,
    const scalar d,
    const scalar step,
    findings& found
)
{
    const scalar fall = mag(view.g)*sqr(step)/d;

    page::line
    (
        "fall from rest in a solids step",
        textOf(100*fall, " % of a parcel")
    );
    if (view.touching() && fall > muchFall)
    {
        found.takeNote
        (
            place
            (
                view.propertiesFile(),
                "maxDeltaT",
                view.solution().get<scalar>("maxDeltaT")
            ),
            textOf
            (
                "gravity alone moves parcels at rest by ", 100*fall,
                " % of their diameter in a solids step: they may overlap"
            ),
            textOf
            (
                "watch the overlaps in the log; ",
                std::sqrt(goodFall*d/mag(view.g)), " s gives ", 100*goodFall,
                " %"
            )
        );
    }
}


static void checkFluidStep
(
    const caseView& view,
    findings& found
)
{
    const scalar deltaT = view.runTime.controlDict().get<scalar>("deltaT");
    const scalar Courant = view.fluid->courantNumber();

    page::line
    (
        "fluid step",
        textOf(deltaT, " s at first, Courant number ", Courant)
    );
    page::line
    (
        "fluid step at most",
        view.adjusts()
      ? textOf
        (
            view.longestFluidStep(), " s, maxCo ", view.largestCourant()
        )
      : string("as at first: adjustTimeStep is off")
    );

    if (!view.adjusts() && Courant > 1)
    {
        found.warn
        (
            place("system/controlDict", "deltaT", deltaT),
            textOf
            (
                "the Courant number is ", Courant, " at the start, and"
                " adjustTimeStep is off"
            ),
            textOf
            (
                "set adjustTimeStep yes and maxCo 1, or a deltaT below ",
                deltaT/Courant
            )
        );
    }
}

} // End namespace cghs
} // End namespace Foam


void Foam::cghs::checkTimeScales
(
    const caseView& view,
    const UList<parcelKind>& kinds,
    const UList<inlet>& inlets,
    findings& found
)
{
    page::title("Time scales");

    if (view.fluid.valid())
    {
        printDragTimes(view, kinds);
        printHeatTimes(view, kinds);
        checkFluidStep(view, found);
    }
    if (kinds.empty())
    {
        return;
    }

    const scalar d = smallestParcel(kinds);
    const scalar flow =
        view.fluid.valid() ? meanVelocity(inlets, view) : 0;
    const scalar longest = view.longestFluidStep();
    const scalar atRest =
        min(view.solidsStep(d, view.largestSpeed()), longest);

    page::line("solids step now", textOf(atRest, " s"));
    page::line
    (
        "solids step at the flow's speed",
        textOf(min(view.solidsStep(d, flow), longest), " s")
    );
    checkContactTime(view, kinds, atRest, found);
    checkFall(view, d, atRest, found);
}
