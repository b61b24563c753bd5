/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "twoBodies.H"

namespace Foam
{
namespace cghs
{

//- One in ten of the samples
static bool rarely(sampler& random)
{
    return random.below(10) == 0;
}


//- Surface speeds by spin up to 10 times this speed
static vector randomSpin(sampler& random, const scalar v, const scalar r)
{
    const vector axis(random.direction());
    const scalar share = rarely(random) ? 0 : random.between(0, 10);
    return (share*v/r)*axis;
}


//- Distance of two bodies that overlap by up to 30 % of the smaller radius, or
//  barely touch
static scalar randomDistance
(
    sampler& random,
    const scalar sumOfRadii,
    const scalar smallerRadius
)
{
    const scalar share = rarely(random) ? 0 : random.between(0, 0.3);
    return sumOfRadii - share*smallerRadius;
}


//- Make the bodies approach; some of them grazing, some without slip
static void makeApproach(twoBodies& pair, sampler& random)
{
    const scalar vn = -mag(pair.normalSpeed());
    const scalar share = rarely(random) ? 1e-6 : 1;

    pair.setNormalSpeed(share*vn);

    if (rarely(random))
    {
        pair.setContactVelocity(vn*pair.touch().n);
    }
}

}
}


bool Foam::cghs::twoBodies::hasWall() const
{
    return motions[0].invMass == 0 || motions[1].invMass == 0;
}


void Foam::cghs::twoBodies::setContact()
{
    contact c = makeContact
    (
        0,
        1,
        hasWall() ? contact::parcelWall : contact::parcelParcel,
        0,
        spheres[1].x - spheres[0].x,
        spheres[0].r + spheres[1].r
    );

    // Rounding may part those that barely touch
    c.overlap = max(c.overlap, scalar(0));

    contacts.clear();
    contacts.append(c);
}


void Foam::cghs::twoBodies::separateToTouch()
{
    const scalar radii = spheres[0].r + spheres[1].r;

    spheres[1].x = spheres[0].x + radii*touch().n;
    contacts[0].overlap = 0;
}


void Foam::cghs::twoBodies::setContactVelocity(const vector& vc)
{
    motions[0].v += contactVelocity() - vc;
}


void Foam::cghs::twoBodies::setNormalSpeed(const scalar vn)
{
    motions[0].v += (normalSpeed() - vn)*touch().n;
}


Foam::vector Foam::cghs::twoBodies::touchingPoint() const
{
    const scalar share = spheres[0].r/(spheres[0].r + spheres[1].r);
    return spheres[0].x + share*(spheres[1].x - spheres[0].x);
}


Foam::vector Foam::cghs::twoBodies::contactVelocity() const
{
    const vector x(touchingPoint());

    return
        motions[1].v + (spins[1] ^ (x - spheres[1].x))
      - motions[0].v - (spins[0] ^ (x - spheres[0].x));
}


Foam::scalar Foam::cghs::twoBodies::normalMass() const
{
    return 1/(motions[0].invMass + motions[1].invMass);
}


Foam::scalar Foam::cghs::twoBodies::tangentialMass() const
{
    const vector x(touchingPoint());
    scalar inverse = 0;

    forAll(motions, i)
    {
        if (motions[i].invMass > 0)
        {
            // An impulse at the arm moves the centre, and turns the sphere
            const scalar arm = mag(x - spheres[i].x);
            const scalar inertiaOverMass = 0.4*sqr(spheres[i].r);
            inverse += motions[i].invMass*(1 + sqr(arm)/inertiaOverMass);
        }
    }

    return 1/inverse;
}


Foam::scalar Foam::cghs::twoBodies::speedScale() const
{
    scalar scale = 0;
    forAll(motions, i)
    {
        scale += mag(motions[i].v) + spheres[i].r*mag(spins[i]);
    }
    return scale;
}


Foam::cghs::twoBodies Foam::cghs::randomPair(sampler& random)
{
    const scalar r0 = random.acrossDecades(1e-5, 1e-2);
    const scalar r1 = r0*random.acrossDecades(0.1, 10);
    const scalar m0 = random.acrossDecades(1e-9, 1e-3);
    const scalar m1 = m0*random.acrossDecades(1e-3, 1e3);
    const scalar v0 = random.acrossDecades(1e-3, 10);
    const scalar v1 = v0*random.acrossDecades(0.1, 10);

    const vector x0((10*r0)*random.direction());
    const scalar distance = randomDistance(random, r0 + r1, min(r0, r1));

    twoBodies pair;
    pair.spheres[0] = sphere(x0, r0);
    pair.spheres[1] = sphere(x0 + distance*random.direction(), r1);
    pair.motions[0] = motion(v0*random.direction(), 1/m0);
    pair.motions[1] = motion(v1*random.direction(), 1/m1);
    pair.spins[0] = randomSpin(random, v0, r0);
    pair.spins[1] = randomSpin(random, v1, r1);
    pair.setContact();
    makeApproach(pair, random);

    return pair;
}


Foam::cghs::twoBodies Foam::cghs::randomWall(sampler& random)
{
    const scalar r = random.acrossDecades(1e-5, 1e-2);
    const scalar m = random.acrossDecades(1e-9, 1e-3);
    const scalar v = random.acrossDecades(1e-3, 10);

    const vector x((10*r)*random.direction());
    const scalar distance = randomDistance(random, r, r);
    const scalar vWall = rarely(random) ? v : 0;

    // The wall is always the second
    const label parcel = 0;
    const label wall = 1;

    twoBodies pair;
    pair.spheres[parcel] = sphere(x, r);
    pair.spheres[wall] = sphere(x + distance*random.direction(), 0);
    pair.motions[parcel] = motion(v*random.direction(), 1/m);
    pair.motions[wall] = motion(vWall*random.direction(), 0);
    pair.spins[parcel] = randomSpin(random, v, r);
    pair.setContact();
    makeApproach(pair, random);

    return pair;
}


Foam::cghs::twoBodies Foam::cghs::afterImpact
(
    const twoBodies& pair,
    const impactCoeffs& coeffs
)
{
    twoBodies after(pair);
    bodies b(after.view());
    collide(after.touch(), b, coeffs);
    return after;
}


Foam::vector Foam::cghs::impulseBetween
(
    const twoBodies& before,
    const twoBodies& after
)
{
    const bool firstIsLighter =
        before.motions[0].invMass > before.motions[1].invMass;

    const label lighter = firstIsLighter ? 0 : 1;
    const scalar sign = firstIsLighter ? -1 : 1;

    return
        (sign*before.motions[lighter].mass())
       *(after.motions[lighter].v - before.motions[lighter].v);
}


Foam::scalar Foam::cghs::largestDifference
(
    const twoBodies& p,
    const twoBodies& q
)
{
    scalar largest = 0;
    forAll(p.motions, i)
    {
        const scalar r = p.spheres[i].r;
        largest = max(largest, mag(p.motions[i].v - q.motions[i].v));
        largest = max(largest, r*mag(p.spins[i] - q.spins[i]));
    }
    return largest;
}
