/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "softSphere.H"
#include "turningPoint.H"
#include "hardSphereImpulse.H"
#include "surfaceTable.H"
#include "frictionEntries.H"
#include "knownEntries.H"
#include "mathematicalConstants.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(softSphere, 0);
    addToRunTimeSelectionTable(contactModel, softSphere, dictionary);
    describeModel
    (
        contactModel,
        softSphere,
        "spring, dashpot and slider: the reference, in short steps"
    );

    using constant::mathematical::pi;

}
}

const Foam::Enum<Foam::cghs::softSphere::stiffnessScaling>
Foam::cghs::softSphere::stiffnessScalingNames
({
    { stiffnessScaling::unscaled, "unscaled" },
    { stiffnessScaling::proportional, "proportional" },
    { stiffnessScaling::energyDensity, "energyDensity" }
});


Foam::scalar Foam::cghs::softSphere::stiffnessOfParcel
(
    const dictionary& coeffs,
    const scalar parcelWeight
)
{
    const scalar particles = positiveScalar(coeffs, "springConstant");

    switch (stiffnessScalingNames.get("stiffnessScaling", coeffs))
    {
        case stiffnessScaling::proportional:
            return parcelWeight*particles;

        case stiffnessScaling::energyDensity:
            return Foam::cbrt(parcelWeight)*particles;

        default:
            return particles;
    }
}


Foam::scalar Foam::cghs::softSphere::restitutionOfParcel
(
    const dictionary& surface,
    const restitutionScaling& scaling,
    const scalar parcelWeight
)
{
    const scalar e = surface.get<scalar>("restitutionCoefficient");
    const scalar mu = surface.get<scalar>("frictionCoefficient");
    const scalar et = tangentialRestitution(springOf(e, mu).damping);

    // What is dampened more than critically takes little more energy and much
    // shorter steps
    return max
    (
        scaling.ofParcel(surface, restitution{e, et, mu}, parcelWeight),
        min(e, restitutionOf(1))
    );
}


Foam::scalar Foam::cghs::softSphere::restitutionOf(const scalar damping)
{
    const scalar root = sqrt(mag(1 - sqr(damping)));

    // At critical damping both branches are exp(-2)
    const scalar phase =
        root < 1e-6 ? 2
      : damping < 1 ? (pi - 2*asin(damping))/root
      : 2*acosh(damping)/root;

    return exp(-damping*phase);
}


Foam::scalar Foam::cghs::softSphere::tangentialRestitution
(
    const scalar damping
)
{
    // The mass that swings is 2/7 m_eff, as the spheres turn, so that the swing
    // takes as long as the contact does
    const scalar tangential = 7*damping/4;

    return
        tangential < 1
      ? exp(-pi*tangential/sqrt(1 - sqr(tangential)))
      : 0;
}


Foam::cghs::softSphere::springCoeffs Foam::cghs::softSphere::springOf
(
    const scalar e,
    const scalar mu
)
{
    // Restitution falls with damping, from 1 to about 1/(2 damping)^2
    const scalar damping = turningPoint
    (
        0,
        1 + 1/sqrt(e),
        [&](const scalar zeta) { return restitutionOf(zeta) > e; }
    );

    return springCoeffs{damping, mu, 0};
}


Foam::List<Foam::cghs::softSphere::springCoeffs>
Foam::cghs::softSphere::readTable
(
    const dictionary& dict,
    const scalar parcelWeight
)
{
    warnUnknownEntries
    (
        dict,
        wordList
        ({
            "springConstant", "stiffnessScaling", "restitutionScaling",
            "materials", "parcelParcel", "parcelWall"
        })
    );

    const auto scaling = restitutionScaling::New(dict);

    return readSurfaces<springCoeffs>
    (
        dict,
        [&](const dictionary& surface, const contact::surfaceType type)
        {
            warnUnknownEntries
            (
                surface,
                wordList
                ({
                    "restitutionCoefficient", "frictionCoefficient",
                    "rollingFrictionCoefficient"
                })
            );

            scalar e = scalarInRange(surface, "restitutionCoefficient", SMALL, 1);
            const scalar mu =
                scalarInRange(surface, "frictionCoefficient", 0, GREAT);

            if (type != contact::parcelWall)
            {
                e = restitutionOfParcel(surface, *scaling, parcelWeight);
            }

            springCoeffs k(springOf(e, mu));
            k.rolling = rollingFrictionFrom(surface);

            return k;
        }
    );
}


Foam::cghs::softSphere::softSphere
(
    const dictionary& dict,
    const scalar parcelWeight
)
:
    contactModel(materialsOf(dict)),
    stiffness_(stiffnessOfParcel(dict, parcelWeight)),
    coeffs_(readTable(dict, parcelWeight)),
    warned_(false)
{}


bool Foam::cghs::softSphere::needsSpin() const
{
    return anyOf(coeffs_, [](const springCoeffs& k) { return k.mu > 0; });
}


void Foam::cghs::softSphere::checkStep
(
    const scalar me,
    const scalar damping,
    const scalar deltaT
)
{
    // Of an undamped spring; what dampens hard takes no longer
    const scalar contactTime = pi*sqrt(me/stiffness_)/max(damping, scalar(1));

    if (deltaT > contactTime/20*(1 + SMALL))
    {
        warned_ = true;

        WarningInFunction
            << "The solids step is " << deltaT << " s, a contact lasts "
            << contactTime << " s" << nl
            << "    Set maxDeltaT to " << contactTime/20
            << " or less for springs to be followed" << endl;
    }
}


Foam::vector Foam::cghs::softSphere::tangentialImpulse
(
    const contact& c,
    contactMemory& memory,
    const bodies& b,
    const scalar damping,
    const scalar mu,
    const scalar deltaT
) const
{
    const scalar kt = 2.0/7.0*stiffness_;
    const scalar etat = 0.5*damping;
    const vector vt(slipVelocity(c, b, leverOf(c, b)));

    // The plane of the contact has turned a little since
    vector& xi = memory.rubbing;
    xi -= (xi & c.n)*c.n;
    xi += deltaT*vt;

    vector force(-kt*xi - etat*vt);
    const scalar limit = mu*memory.load/deltaT;
    const scalar size = mag(force);

    if (size > limit)
    {
        force *= limit/size;
        xi = -(force + etat*vt)/kt;
    }

    return deltaT*force;
}


Foam::vector Foam::cghs::softSphere::findForce
(
    const contact& c,
    contactMemory& memory,
    const bodies& b,
    const scalar deltaT
)
{
    const springCoeffs& k = coeffs_[c.surface];
    const scalar me = effectiveMass(c, b);
    const scalar eta = 2*k.damping*sqrt(stiffness_*me);

    if (!warned_)
    {
        checkStep(me, k.damping, deltaT);
    }

    memory.load =
        deltaT
       *max(scalar(0), stiffness_*c.overlap - eta*partingSpeed(c, b));

    return
        k.mu > 0
      ? tangentialImpulse(c, memory, b, eta, k.mu, deltaT)
      : vector(Zero);
}


void Foam::cghs::softSphere::sweep
(
    const label sweepi,
    contactList& list,
    bodies& b,
    const stepScales& step
)
{
    if (sweepi == 0)
    {
        list.impulses.resize(list.contacts.size());
        forAll(list.contacts, i)
        {
            list.impulses[i] =
                findForce(list.contacts[i], list.memories[i], b, step.deltaT);
        }
        return;
    }

    forAll(list.contacts, i)
    {
        const contact& c = list.contacts[i];
        const vector& rub = list.impulses[i];

        push(c, b, list.memories[i].load*c.n + rub);

        if (b.spinning())
        {
            turn(c, b, leverOf(c, b), rub);
        }

        const scalar rolling = coeffs_[c.surface].rolling;

        if (rolling > 0)
        {
            resistRolling(c, b, rolling, list.memories[i].load);
        }
    }
}
