/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    Conduction through contacts: a pair of MFiX, radii of contact, impacts
    against their equation of motion, and the scaling of parcels.

\*---------------------------------------------------------------------------*/

#include "conductionScaling.H"
#include "contactConductance.H"
#include "gasLens.H"
#include "integral.H"
#include "claim.H"

#include <catch2/catch.hpp>

#include <cmath>

namespace Foam
{
namespace cghs
{

static scalar capacity(const scalar d, const scalar rho, const scalar c)
{
    return M_PI/6*pow3(d)*rho*c;
}


// A verification case of MFiX: rates 0.010280 and 0.0041067 1/s, 408.905 K at
// the end. The radius of contact is known to one of its last digit, 14.75 um to
// 6.8e-4; what does not depend on it is known to the digits of the rates
TEST_CASE("Two spheres in contact have the rates of MFiX", "[heat]")
{
    const scalar radius = 14.75e-6;
    const scalar H = contactConductance(radius, 55, 0.84);
    const scalar C1 = capacity(3e-3, 420, 800);
    const scalar C2 = capacity(3.6e-3, 8850, 55);

    claim rates("contactConductance.ratesOfMFiX", 6.8e-4);
    rates.see(mag(H/C1/0.010280 - 1));
    rates.see(mag(H/C2/0.0041067 - 1));
    rates.settle();

    settle
    (
        "contactConductance.radiiOfMFiX",
        mag((0.010280*C1)/(0.0041067*C2) - 1),
        6.1e-5
    );
    settle
    (
        "contactConductance.mixedOfMFiX",
        mag((C1*298.15 + C2*453.15)/(C1 + C2) - 408.905),
        1e-3
    );

    // 4/(1/55 + 1/0.84) = 3.3094555874 W/m/K
    settle
    (
        "contactConductance.byHand",
        mag(H/(3.3094555874*radius) - 1),
        1e-10
    );
}


TEST_CASE("Radii of contact are those of Hertz", "[heat]")
{
    claim radii("contactConductance.radii", 1e-12);

    // E/(1 - nu^2) = 1e8 Pa each, E_e = 5e7 Pa
    const elasticity soft{9.1e7, 0.3};
    const scalar kn0 = hertzStiffness(2.5e-4, soft, soft);
    radii.see(mag(kn0/(4.0/3*std::sqrt(2.5e-4)*5e7) - 1));

    // a^3 = 3/4 F r_e/E_e
    const scalar force = 8e-4;
    const scalar a = hertzRadius(2.5e-4, hertzOverlap(force, kn0));
    radii.see(mag(pow3(a)/(0.75*force*2.5e-4/5e7) - 1));
    radii.see(mag(hertzRadius(2.5e-4, 1.6e-7)/std::sqrt(4e-11) - 1));
    radii.settle();
}


// With delta = delta_max sin(q)^2, which is smooth from touch to the deepest
// point, dt = d(delta)/v(delta), v = v0 sqrt(1 - (delta/delta_max)^(5/2))
TEST_CASE("An impact's heat is the integral over Hertz's motion", "[heat]")
{
    const scalar v = 0.3, me = 2e-7, re = 2.5e-4, kn0 = 1e6;
    const hertzImpact impact = impactOf(v, me, re, kn0);

    // All kinetic energy is in the contact
    settle
    (
        "contactConductance.impactEnergy",
        mag(0.4*kn0*std::pow(impact.overlap, 2.5)/(0.5*me*sqr(v)) - 1),
        1e-12
    );

    const auto overImpact = [&](const scalar power)
    {
        return 2*impact.overlap/v*integral
        (
            [&](const scalar q)
            {
                // (1 - s^5)/(1 - s^2) without the difference at s = 1
                const scalar s = std::sin(q);
                const scalar p = (1 + s + s*s + s*s*s + s*s*s*s)/(1 + s);
                return std::pow(s*s, power)*2*s/std::sqrt(p);
            },
            0,
            M_PI_2
        );
    };

    settle
    (
        "contactConductance.impactDuration",
        mag(overImpact(0)/impact.duration - 1),
        1e-10
    );
    const scalar radiusTime =
        hertzRadius(re, impact.overlap)*overImpact(0.5);
    settle
    (
        "contactConductance.impactHeat",
        mag(impactHeat(impact, 3, 6)/(4*2*radiusTime) - 1),
        1e-10
    );

    const hertzImpact none = impactOf(0, me, re, kn0);
    settle
    (
        "contactConductance.noImpact",
        none.overlap + none.duration + impactHeat(none, 3, 6),
        0
    );
}


TEST_CASE("Parcels conduct what their particles do", "[heat]")
{
    const scalar d = 1e-3, kappa = 0.03, layer = 0.04, s = 2e-6, gap = 1e-5;
    const scalar stress = 1e3, kappas = 1.5, v = 0.2, rho = 2500;
    const elasticity soft{1e8, 0.3};

    // By Hertz, of bodies of reduced radius re with a force on them
    const auto pressed = [&](const scalar re, const scalar force)
    {
        const scalar overlap =
            hertzOverlap(force, hertzStiffness(re, soft, soft));

        return contactConductance(hertzRadius(re, overlap), kappas, kappas);
    };

    // Of one that meets a wall, per time if its layer is as far apart as it is
    // large
    const auto hitting = [&](const scalar r)
    {
        const scalar m = 4.0/3*M_PI*pow3(r)*rho;

        return
            v/(2*r)*impactHeat
            (
                impactOf(v, m, r, hertzStiffness(r, soft, soft)),
                kappas,
                kappas
            );
    };

    // A slab of touching spheres in a cubic lattice, 1/d^2 of them on an area,
    // has the conductivity H/d; its lowest layer passes H/d^2
    struct slab { scalar lens, contact, wallLens, wallContact, wallImpact; };

    const auto slabOf = [&](const scalar W)
    {
        const scalar k = std::cbrt(W), r = k*d/2, D = 2*r, force = stress*D*D;
        const scalar atWall = wallFactor(W)/sqr(D);

        return slab
        {
            particleFluidParticle(0, r, r, layer, k*s, kappa)/D,
            pressed(r/2, force)/D,
            atWall*particleFluidWall(k*gap, r, layer, k*s, kappa),
            atWall*pressed(r, force),
            atWall*hitting(r)
        };
    };

    claim same("conductionScaling.slab", 1e-12);
    const slab fine = slabOf(1);

    for (const scalar W : {8.0, 1000.0})
    {
        const slab coarse = slabOf(W);

        same.see(mag(coarse.lens/fine.lens - 1));
        same.see(mag(coarse.contact/fine.contact - 1));
        same.see(mag(coarse.wallLens/fine.wallLens - 1));
        same.see(mag(coarse.wallContact/fine.wallContact - 1));
        same.see(mag(coarse.wallImpact/fine.wallImpact - 1));
    }
    same.settle();
}

} // End namespace cghs
} // End namespace Foam
