/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    Syamlal and O'Brien's law made to have a given drag, and the velocities at
    which particles are carried.

\*---------------------------------------------------------------------------*/

#include "dragSamples.H"
#include "fluidisation.H"
#include "SyamlalOBrien.H"
#include "claim.H"

#include <catch2/catch.hpp>

namespace Foam
{
namespace cghs
{

TEST_CASE("Syamlal and O'Brien's law is calibrated to a drag", "[drag]")
{
    claim found("drag.calibration", 1e-10);
    claim meets("drag.calibrationJoins", 1e-12);
    for (const bool voidageInRe : {true, false})
    {
        for (const scalar C2 : {0.2, 0.8, 1.5})
        {
            const SyamlalOBrien known(2.65, C2, voidageInRe);

            for (const scalar e : {0.38, 0.42, 0.5})
            {
                for (const scalar u : {0.03, 0.3, 3.0})
                {
                    const slipFlow f(air.past(e, u, 5e-4));
                    const scalar D = known.coefficient(f);
                    const SyamlalOBrien law
                    (
                        SyamlalOBrien::calibrated(D, f, voidageInRe)
                    );

                    found.see(mag(law.C2()/C2 - 1));
                    found.see(mag(law.coefficient(f)/D - 1));
                    meets.see
                    (
                        mag
                        (
                            law.C2()*pow(0.85, 1.28)/pow(0.85, law.C1())
                          - 1
                        )
                    );
                }
            }
        }
    }
    found.settle();
    meets.settle();

    // Published examples of such pairs
    claim pairs("drag.calibrationPairs", 2e-3);
    for (const scalar C2 : {0.8, 0.281632})
    {
        const slipFlow f(air.past(0.45, 0.2, 3e-4));
        const scalar D = SyamlalOBrien(1, C2, false).coefficient(f);
        const scalar C1 = SyamlalOBrien::calibrated(D, f, false).C1();
        pairs.see(mag(C1/(C2 == 0.8 ? 2.65 : 9.07696) - 1));
    }
    pairs.settle();
}


TEST_CASE("Carrying velocities balance drag and weight", "[drag]")
{
    const List<particleInFluid> particles
    ({
        {75e-6, 1500, 1.2, 1.8e-5, 9.81},
        {2.5e-3, 2526, 1.2, 1.8e-5, 9.81},
        {3e-4, 1340, 1000, 1e-3, 9.81},
        {1e-3, 900, 1000, 1e-3, 1.6}
    });

    claim balanced("drag.carryingVelocity", 1e-12);
    for (const word& name : lawsWithDrag())
    {
        const autoPtr<dragModel> law(dragLawOf(name));
        for (const particleInFluid& p : particles)
        {
            // Away from the laws' jumps in Re
            for (const scalar e : {0.42, 0.7, 1.0})
            {
                const scalar U = carryingVelocity(*law, p, e);
                const scalar D = law->coefficient(p.flow(e, U/e));
                balanced.see(mag(D/balancingD(p, e, U) - 1));
            }
        }
    }
    balanced.settle();

    // Ergun's equation in the superficial velocity is quadratic
    claim ergun("drag.ergunMinimumFluidisation", 1e-12);
    const autoPtr<dragModel> gidaspow(dragLawOf("Gidaspow"));
    for (const particleInFluid& p : particles)
    {
        const scalar e = 0.42;
        const scalar a = 1.75/pow3(e);
        const scalar b = 150*(1 - e)/pow3(e);
        const scalar Re = (sqrt(sqr(b) + 4*a*p.Ar()) - b)/(2*a);
        const scalar U = carryingVelocity(*gidaspow, p, e);
        ergun.see(mag(p.Re(U)/Re - 1));
    }
    ergun.settle();
}

} // End namespace cghs
} // End namespace Foam
