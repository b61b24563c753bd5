/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    What holds for impacts of parcels over the whole product of restitution
    coefficients, friction, ratios of mass and radius, and weights W. The bodies
    of a parcel of W particles are W^(1/3) times as large and W times as heavy.

\*---------------------------------------------------------------------------*/

#include "contactModel.H"
#include "twoBodies.H"
#include "balance.H"
#include "complaint.H"
#include "claim.H"

#include <catch2/catch.hpp>

#include <sstream>

namespace Foam
{
namespace cghs
{

namespace
{

//- One corner of the product
struct corner
{
    impactCoeffs k;
    scalar massRatio;
    scalar radiusRatio;
    scalar W;

    //- Restitution of the parcels (Eq 57)
    scalar enOfParcel() const { return pow(k.en, sqrt(W)); }
};


autoPtr<contactModel> modelOf(const corner& c)
{
    std::ostringstream text;
    text.precision(17);
    text<< "contactModel hardSphere; hardSphereCoeffs { parcelParcel {"
        << " restitutionCoefficient " << c.k.en << ';'
        << " tangentialRestitutionCoefficient " << c.k.et << ';'
        << " frictionCoefficient " << c.k.mu << "; }"
        << " parcelWall { $parcelParcel; } restitutionScaling logarithmic;"
        << " correctionModel none; }";

    return contactModel::New(dictionaryOf(text.str().c_str()), c.W);
}


//- Two parcels that approach, at random but for the ratios
twoBodies parcelsOf(const corner& c, sampler& random)
{
    const scalar r = 1e-3*cbrt(c.W), m = 1e-5*c.W;
    const scalar distance =
        (1 + c.radiusRatio)*r - random.between(0, 0.3)*r;

    twoBodies pair;
    pair.spheres[0] = sphere(Zero, r);
    pair.spheres[1] = sphere(distance*random.direction(), c.radiusRatio*r);
    pair.motions[0] = motion(random.direction(), 1/m);
    pair.motions[1] = motion(random.direction(), 1/(c.massRatio*m));
    pair.spins[0] = (random.between(0, 3)/r)*random.direction();
    pair.spins[1] =
        (random.between(0, 3)/(c.radiusRatio*r))*random.direction();
    pair.setContact();
    pair.setNormalSpeed(-mag(pair.normalSpeed()));
    return pair;
}


void impact(const corner& c, twoBodies& pair)
{
    auto model = modelOf(c);
    bodies b(pair.view());
    for (label sweepi = 0; sweepi < model->nSweeps(); ++sweepi)
    {
        model->sweep(sweepi, pair, b, stepScales{1e-4, 0, 1e-4});
    }
}


//- Visit(corner, before, after) for all corners
template<class Visitor>
void forEachCorner(const label seed, const Visitor& visit)
{
    const label nSamples = 4;
    sampler random(seed);

    for (const scalar en : {0.0, 0.5, 0.94, 1.0})
    for (const scalar et : {0.0, 0.33, 1.0})
    for (const scalar mu : {0.0, 0.1, 1.0})
    for (const scalar massRatio : {1.0, 10.0, 1000.0})
    for (const scalar radiusRatio : {1.0, 3.0, 10.0})
    for (const scalar W : {1.0, 27.0, 1000.0})
    {
        const corner c{{en, et, mu}, massRatio, radiusRatio, W};
        for (label i = 0; i < nSamples; ++i)
        {
            const twoBodies before(parcelsOf(c, random));
            twoBodies after(before);
            impact(c, after);
            visit(c, before, after);
        }
    }
}

}


TEST_CASE("Parcels of all weights, sizes and coefficients keep momenta, and "
    "gain no energy", "[contact]")
{
    claim linear("properties.linearMomentum", 1e-14);
    claim angular("properties.angularMomentum", 1e-14);
    claim rise("properties.energyRise", 1e-14);

    forEachCorner(91, [&](const corner&, twoBodies before, twoBodies after)
    {
        const bodies b(before.view());
        const bodies a(after.view());
        const scalar was = kineticEnergy(b);

        linear.see
        (
            mag(linearMomentum(a) - linearMomentum(b))/momentumScale(b)
        );
        angular.see
        (
            mag(angularMomentum(a) - angularMomentum(b))
           /angularMomentumScale(b)
        );
        rise.see(max((kineticEnergy(a) - was)/was, scalar(0)));
    });

    linear.settle();
    angular.settle();
    rise.settle();
}


TEST_CASE("Parcels of all sizes part with the restitution of their weight",
    "[contact]")
{
    claim restitution("properties.restitution", 1e-13);

    forEachCorner
    (
        92,
        [&](const corner& c, const twoBodies& before, const twoBodies& after)
        {
            restitution.see
            (
                mag
                (
                    after.normalSpeed()
                  + c.enOfParcel()*before.normalSpeed()
                )
               /before.speedScale()
            );
        }
    );

    restitution.settle();
}


TEST_CASE("The weight changes the restitution, and nothing else", "[contact]")
{
    claim same("properties.likeParticles", 1e-13);

    forEachCorner(93, [&](corner c, const twoBodies& before, twoBodies after)
    {
        // Particles of the parcels' own restitution, moving alike
        twoBodies particles(before);
        const scalar k = cbrt(c.W);
        forAll(particles.motions, i)
        {
            particles.spheres[i].x /= k;
            particles.spheres[i].r /= k;
            particles.motions[i].invMass *= c.W;
            particles.spins[i] *= k;
        }
        particles.contacts[0].overlap /= k;
        c.k.en = c.enOfParcel();
        c.W = 1;
        impact(c, particles);

        forAll(after.motions, i)
        {
            const vector spin(after.spins[i]*k - particles.spins[i]);
            same.see
            (
                (
                    mag(after.motions[i].v - particles.motions[i].v)
                  + particles.spheres[i].r*mag(spin)
                )
               /before.speedScale()
            );
        }
    });

    same.settle();
}

} // End namespace cghs
} // End namespace Foam
