/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "page.H"
#include "Function1.H"
#include "basicSpecieMixture.H"
#include "fluidThermo.H"

namespace Foam
{
namespace cghs
{

//- By which mass fractions may miss 1 [-]
constexpr scalar sumTolerance = 1e-3;


//- What comes in with the fluid of a patch: sum of (mass flow times q)
static scalar carriedIn
(
    const caseView& view,
    const label patchi,
    const volScalarField& q
)
{
    const fvPatch& patch = view.mesh.boundary()[patchi];

    return -gSum
    (
        view.fluid->rho().boundaryField()[patchi]
       *view.fluid->alpha().boundaryField()[patchi]
       *(view.fluid->U().boundaryField()[patchi] & patch.Sf())
       *q.boundaryField()[patchi]
    );
}


static wordList speciesOf(const caseView& view)
{
    if (!view.fluid->transports("species"))
    {
        return wordList();
    }
    if (view.fluid->mixture())
    {
        return view.fluid->mixture()->species();
    }
    return view.solution().subOrEmptyDict("speciesCoeffs")
       .getOrDefault("species", wordList());
}


static void printInlets(const UList<inlet>& inlets, const caseView& view)
{
    const bool hasT = view.mesh.foundObject<volScalarField>("T");

    page::head
    (
        List<string>
        ({
            "area [m2]", "U [m/s]", "[m3/s]", "[kg/s]", "T [K]"
        })
    );

    for (const inlet& it : inlets)
    {
        page::row
        (
            it.name,
            List<string>
            ({
                page::number(it.area),
                page::number(it.velocity()),
                page::number(it.volumeFlow),
                page::number(it.massFlow),
                hasT
              ? page::number
                (
                    carriedIn
                    (
                        view,
                        it.patch,
                        view.mesh.lookupObject<volScalarField>("T")
                    )/it.massFlow
                )
              : string("-")
            })
        );
    }
}


//- Mass in of each species; of a gas they sum to one at each inlet
static void checkSpecies
(
    const UList<inlet>& inlets,
    const caseView& view,
    findings& found
)
{
    const wordList species(speciesOf(view));
    scalarField sums(inlets.size(), Zero);

    for (const word& name : species)
    {
        scalar flow = 0;
        forAll(inlets, i)
        {
            const scalar in =
                carriedIn(view, inlets[i].patch, view.fluid->field(name));

            flow += in;
            sums[i] += in/inlets[i].massFlow;
        }
        page::line(name + " in [kg/s]", page::number(flow));
    }

    if (species.empty() || !view.fluid->mixture())
    {
        return;
    }
    forAll(inlets, i)
    {
        if (mag(sums[i] - 1) > sumTolerance)
        {
            found.fail
            (
                place("the fields of the species", inlets[i].name, sums[i]),
                "the mass fractions that come in do not sum to 1",
                "mend the conditions of the species there, e.g. of the inert"
                " one"
            );
        }
    }
}


//- The range that all thermophysics of a case are made for [K]: only janaf says
static scalarMinMax thermoRange(const dictionary& thermo)
{
    scalarMinMax range(0, GREAT);

    if (thermo.subDict("thermoType").get<word>("thermo") != "janaf")
    {
        return range;
    }
    for (const entry& e : thermo)
    {
        if (e.isDict() && e.dict().isDict("thermodynamics"))
        {
            const dictionary& dict = e.dict().subDict("thermodynamics");
            range.min() =
                max(range.min(), dict.getOrDefault<scalar>("Tlow", 0));
            range.max() =
                min(range.max(), dict.getOrDefault<scalar>("Thigh", GREAT));
        }
    }
    return range;
}


static void checkTemperature
(
    const UList<inlet>& inlets,
    const caseView& view,
    findings& found
)
{
    // As the file has it: thermophysics cut off what is beyond their range
    const volScalarField T
    (
        IOobject
        (
            "T",
            view.startTime,
            view.mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        ),
        view.mesh
    );
    const scalarMinMax range(thermoRange(view.fluid->thermo()));

    for (const inlet& it : inlets)
    {
        const scalar Tin = carriedIn(view, it.patch, T)/it.massFlow;

        if (Tin < range.min() || Tin > range.max())
        {
            found.warn
            (
                place("the field T", it.name, Tin),
                textOf
                (
                    "thermophysicalProperties are made for ", range.min(),
                    " to ", range.max(), " K"
                ),
                "mend T there, or Tlow and Thigh with coefficients for it"
            );
        }
    }
}


static void checkEnergy
(
    const UList<inlet>& inlets,
    const caseView& view,
    findings& found
)
{
    if (!view.fluid->transports("energy"))
    {
        return;
    }

    const volScalarField& he = view.fluid->thermo().he();
    scalar flow = 0;

    for (const inlet& it : inlets)
    {
        flow += carriedIn(view, it.patch, he);
    }
    page::line(he.name() + " in [W]", page::number(flow));
    checkTemperature(inlets, view, found);
}


static void checkOutlet
(
    const UList<inlet>& inlets,
    const caseView& view,
    findings& found
)
{
    const bool out = hasOutlet(view);
    page::line("outlet of the fluid", out ? "yes" : "none");

    if (out || inlets.empty())
    {
        return;
    }

    const place where("the field p", inlets.first().name, "no value anywhere");
    const string remedy
    (
        "give p a value at an outlet, with U zeroGradient or"
        " pressureInletOutletVelocity there"
    );

    if (view.solution().getOrDefault<word>("fluid", "incompressible")
     == "incompressible")
    {
        found.fail
        (
            where,
            "fluid comes in and there is no outlet for it: no pressure closes"
            " continuity",
            remedy
        );
    }
    else
    {
        found.warn
        (
            where,
            "gas comes in and there is no outlet for it: the pressure rises",
            remedy
        );
    }
}


//- [kg/s] now
static scalar rateOf(const dictionary& feeder, const caseView& view)
{
    return
        feeder.found("massFlowRate")
      ? Function1<scalar>::New("massFlowRate", feeder)
       ->value(view.runTime.value())
      : 0;
}


//- Solids that are fed need a way out, or room until the run ends
static void checkFeeders
(
    const caseView& view,
    const UList<parcelKind>& kinds,
    findings& found
)
{
    const dictionary& feeding =
        view.cloud.properties().subOrEmptyDict("feeding");
    scalar rate = 0;

    for (const entry& e : feeding)
    {
        if (e.isDict())
        {
            const scalar fed = rateOf(e.dict(), view);
            rate += fed;
            page::line
            (
                "solids by " + e.keyword(),
                e.dict().found("recycle")
              ? string("recycled")
              : textOf(fed, " kg/s")
            );
        }
    }

    const scalar left = view.runTime.endTime().value() - view.runTime.value();
    scalar rho = 0, mass = 0;
    for (const parcelKind& k : kinds)
    {
        rho = max(rho, k.rho);
        mass += k.mass;
    }
    const scalar room = looselyPacked*view.volume()*rho - mass;

    if (view.exits().empty() && rate*left > room)
    {
        found.warn
        (
            place(view.propertiesFile(), "feeding", textOf(rate, " kg/s")),
            textOf
            (
                "no patch lets parcels out: the vessel is full after ",
                room/rate, " s"
            ),
            "let a patch escape or be an inventoryValve in boundary"
        );
    }
}

} // End namespace cghs
} // End namespace Foam


void Foam::cghs::checkFlows
(
    caseView& view,
    const UList<parcelKind>& kinds,
    const UList<inlet>& inlets,
    findings& found
)
{
    page::title("Flows in and out");

    if (view.fluid.valid())
    {
        if (inlets.size())
        {
            printInlets(inlets, view);
            checkSpecies(inlets, view, found);
            checkEnergy(inlets, view, found);
        }
        else
        {
            page::line("inlets of the fluid", "none at the start");
        }
        checkOutlet(inlets, view, found);
    }
    checkFeeders(view, kinds, found);
}
