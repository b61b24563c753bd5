/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "springs.H"
#include "complaint.H"
#include "mathematicalConstants.H"

#include <sstream>

using Foam::constant::mathematical::pi;

namespace Foam
{
namespace cghs
{

static std::string surfaceEntries(const scalar e, const scalar mu)
{
    std::ostringstream text;
    text.precision(17);
    text<< "{ restitutionCoefficient " << e
        << "; frictionCoefficient " << mu << "; }";
    return text.str();
}


//- The contact of the pair as it now is
static void renewContact(twoBodies& pair)
{
    const contact& old = pair.contacts[0];
    pair.contacts[0] = makeContact
    (
        0,
        1,
        contact::surfaceType(old.surface),
        0,
        pair.spheres[1].x - pair.spheres[0].x,
        pair.spheres[0].r + pair.spheres[1].r
    );
}

}
}


Foam::autoPtr<Foam::cghs::contactModel> Foam::cghs::springs::model() const
{
    std::ostringstream text;
    text.precision(17);
    text<< "contactModel softSphere; softSphereCoeffs { springConstant " << k
        << "; stiffnessScaling " << stiffnessScaling
        << "; restitutionScaling " << restitutionScaling
        << "; parcelParcel " << surfaceEntries(e, mu)
        << " parcelWall " << surfaceEntries(eWall, mu) << '}';

    return contactModel::New(dictionaryOf(text.str().c_str()), W);
}


Foam::scalar Foam::cghs::springs::frequency(const twoBodies& pair) const
{
    return sqrt(k/pair.normalMass());
}


Foam::scalar Foam::cghs::springs::dampingRate(const twoBodies& pair) const
{
    // The overlap of a contact that does not pull is that of the oscillator
    // until its force is zero, which is at an angle of 2 asin(b/w) before pi
    const scalar e = restitution(pair);
    scalar low = 0, high = 0.99;

    while (high - low > 1e-14)
    {
        const scalar share = 0.5*(low + high);
        const scalar angle = pi - 2*asin(share);
        const bool tooLively = exp(-share*angle/sqrt(1 - sqr(share))) > e;
        (tooLively ? low : high) = share;
    }

    return low*frequency(pair);
}


Foam::scalar Foam::cghs::springs::contactTime(const twoBodies& pair) const
{
    // When the force has ended the spheres part freely
    const scalar w = frequency(pair), b = dampingRate(pair);
    const scalar early = 2*asin(b/w);

    return (pi - early + sin(early))/sqrt(sqr(w) - sqr(b));
}


void Foam::cghs::sweepAll
(
    contactModel& model,
    bodyScene& scene,
    const scalar deltaT
)
{
    bodies b(scene.view());
    for (label sweepi = 0; sweepi < model.nSweeps(); ++sweepi)
    {
        model.sweep(sweepi, scene, b, stepScales{deltaT, 0, deltaT});
    }
}


Foam::cghs::encounter Foam::cghs::meet
(
    const springs& s,
    twoBodies& pair,
    const scalar deltaT
)
{
    auto model = s.model();
    encounter met;
    pair.memories.clear();
    pair.memories.append(contactMemory());

    do
    {
        sweepAll(*model, pair, deltaT);

        const contactMemory& memory = pair.memories[0];
        met.pull = min(met.pull, memory.load);
        met.rubbing = max
        (
            met.rubbing,
            mag(pair.impulses[0])/max(s.mu*memory.load, VSMALL)
        );

        forAll(pair.spheres, i)
        {
            pair.spheres[i].x += deltaT*pair.motions[i].v;
        }
        renewContact(pair);
        met.duration += deltaT;
        met.deepest = max(met.deepest, pair.touch().overlap);
    }
    while (pair.touch().overlap > 0);

    return met;
}


Foam::cghs::twoBodies Foam::cghs::touching
(
    const springs& s,
    sampler& random,
    const scalar slipShare
)
{
    twoBodies pair(random.below(2) ? randomPair(random) : randomWall(random));
    pair.separateToTouch();
    pair.spins = Zero;

    const scalar r0 = pair.spheres[0].r, r1 = pair.spheres[1].r;
    const scalar smaller = pair.hasWall() ? max(r0, r1) : min(r0, r1);
    const scalar speed = 1e-3*smaller*s.frequency(pair);

    const vector n(pair.touch().n);
    const vector aside(random.direction() ^ n);
    const vector vc(speed*(slipShare*aside/mag(aside) - n));

    // Seen from the centre of mass, or from the wall
    motion& a = pair.motions[0];
    motion& b = pair.motions[1];
    a.v = -pair.normalMass()*a.invMass*vc;
    b.v = pair.normalMass()*b.invMass*vc;

    return pair;
}
