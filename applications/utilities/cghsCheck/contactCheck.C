/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "page.H"
#include "softSphere.H"
#include "surfaceTable.H"

namespace Foam
{
namespace cghs
{

//- A parcel of less hardly rebounds: what follows may be meant, seldom is [-]
constexpr scalar leastRestitution = 0.1;


//- As the contact model of the case has it
static scalar ofParcel
(
    const dictionary& pair,
    const restitutionScaling& scaling,
    const scalar W,
    const caseView& view
)
{
    if (view.contactModelName() == softSphere::typeName)
    {
        return softSphere::restitutionOfParcel(pair, scaling, W);
    }

    const restitution particles
    {
        pair.get<scalar>("restitutionCoefficient"),
        pair.getOrDefault<scalar>("tangentialRestitutionCoefficient", 0),
        pair.getOrDefault<scalar>("frictionCoefficient", 0)
    };
    return scaling.ofParcel(pair, particles, W);
}


//- The restitution of a pair of kinds, as particles and as parcels have it
static void checkPair
(
    const string& name,
    const dictionary& pair,
    const restitutionScaling& scaling,
    const scalar W,
    const caseView& view,
    findings& found
)
{
    const scalar e = pair.get<scalar>("restitutionCoefficient");
    const scalar scaled = ofParcel(pair, scaling, W, view);

    page::line(name, textOf(e, " of particles, ", scaled, " of parcels"));

    const place where
    (
        view.propertiesFile(),
        "restitutionCoefficient",
        textOf(e, " (", name, ')')
    );

    if (!(scaled >= 0 && scaled <= 1))
    {
        found.fail
        (
            where,
            textOf(scaling.type(), " makes ", scaled, " of it, not in [0, 1]"),
            "lower parcelWeight, or choose another restitutionScaling"
        );
    }
    else if (scaled < leastRestitution && e > 5*leastRestitution)
    {
        found.warn
        (
            where,
            textOf
            (
                scaling.type(), " makes ", scaled,
                " of it at a parcelWeight of ", W,
                ": parcels do not rebound at all"
            ),
            "lower parcelWeight, or choose another restitutionScaling: see"
            " doc/theory.md for what each keeps"
        );
    }
}


static void checkPairs
(
    const dictionary& coeffs,
    const scalar W,
    const caseView& view,
    findings& found
)
{
    const autoPtr<restitutionScaling> scaling(restitutionScaling::New(coeffs));
    const wordList materials(materialsOf(coeffs));
    const dictionary& pairs = coeffs.subDict("parcelParcel");

    page::line("restitutionScaling", scaling->type());
    page::line("parcelWeight that it takes", page::number(W));

    if (materials.empty())
    {
        checkPair("restitution", pairs, scaling(), W, view, found);
    }
    forAll(materials, a)
    {
        for (label b = a; b < materials.size(); ++b)
        {
            checkPair
            (
                "restitution " + materials[a] + '-' + materials[b],
                pairDict(pairs, materials[a], materials[b]),
                scaling(),
                W,
                view,
                found
            );
        }
    }
}


//- Nothing moves them but what they hit
static void checkGravity(const caseView& view, findings& found)
{
    page::line("gravity [m/s^2]", textOf(view.g));

    const bool solids = !view.cloud.empty() || view.cloud.feeders().size();

    if (mag(view.g) == 0 && solids)
    {
        found.warn
        (
            place("constant/g", "value", textOf(view.g)),
            "there is no gravity: parcels do not fall, and no bed forms",
            "give the gravity, e.g. (0 -9.81 0), unless there is to be none"
        );
    }
}

} // End namespace cghs
} // End namespace Foam


void Foam::cghs::checkContact
(
    const caseView& view,
    const UList<parcelKind>& kinds,
    findings& found
)
{
    page::title("Contact and gravity");

    const dictionary& coeffs = view.coeffsOf("contactModel");

    page::line("contactModel", view.contactModelName());
    if (coeffs.found("restitutionScaling"))
    {
        checkPairs
        (
            coeffs,
            view.constants().get<scalar>("parcelWeight"),
            view,
            found
        );
    }
    checkGravity(view, found);
}
