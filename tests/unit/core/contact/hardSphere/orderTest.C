/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    Impacts and corrections are swept one contact after the other, so the order
    of the list decides what each parcel does. What it must not decide is

    - momentum and angular momentum, to round-off;
    - by random orders, the energy that is left, but for chance: three standard
      deviations of 1/sqrt(n) for n contacts; and its shares along x, y and z,
      which are a third, but for chance: three of sqrt(4/(27 N)) for N spheres;
    - by orders that are sorted along x, more than a tenth of either: impacts run
      on along such a list, up to 7 % more energy is left than by random orders,
      and up to 0.43 of it along x.

    Beds are cubic lattices of 1000 spheres that overlap by 0 to 4 % with random
    velocities and spins, all impacts of which come in the same step: nothing
    that flows is as bad. What single spheres do differs altogether.

\*---------------------------------------------------------------------------*/

#include "contactModel.H"
#include "bodyScene.H"
#include "balance.H"
#include "sampler.H"
#include "complaint.H"
#include "claim.H"

#include <catch2/catch.hpp>

#include <algorithm>
#include <sstream>
#include <string>

namespace Foam
{
namespace cghs
{

namespace
{

const scalar d = 1e-3;
const scalar deltaT = 1e-4;
const label side = 10;


bodyScene lattice(sampler& random)
{
    const vector jitter(vector::uniform(0.01*d));
    bodyScene bed(side*side*side);

    forAll(bed.spheres, i)
    {
        const vector cell(i % side, (i/side) % side, i/side/side);
        bed.spheres[i] =
            sphere(0.98*d*cell + random.inBox(-jitter, jitter), d/2);
        bed.motions[i] = motion(0.1*random.direction(), 1e6);
        bed.spins[i] = (0.1/d)*random.direction();
    }

    for (label i = 0; i < bed.size(); ++i)
    {
        for (label j = i + 1; j < bed.size(); ++j)
        {
            const vector apart(bed.spheres[j].x - bed.spheres[i].x);
            if (mag(apart) < d)
            {
                const label slot = bed.contacts.size();
                bed.contacts.append
                (
                    makeContact(i, j, contact::parcelParcel, slot, apart, d)
                );
            }
        }
    }
    bed.memories.resize(bed.contacts.size(), contactMemory());
    return bed;
}


autoPtr<contactModel> modelOf
(
    const scalar e,
    const scalar mu,
    const std::string& correction
)
{
    std::ostringstream text;
    text<< "contactModel hardSphere; hardSphereCoeffs { parcelParcel {"
        << " restitutionCoefficient " << e << ';'
        << " tangentialRestitutionCoefficient 0.33;"
        << " frictionCoefficient " << mu << "; }"
        << " parcelWall { $parcelParcel; } restitutionScaling unscaled;"
        << " correctionModel " << correction << ';'
        << " velocityCoeffs"
        << " { nSweeps 3; overlapShare 0.1; velocityShare 1; }"
        << " accumulatedImpulseCoeffs { nSweeps 3; overlapShare 0.2;"
        << " overlapAllowed 0.005; restingSteps 2; } }";

    return contactModel::New(dictionaryOf(text.str().c_str()), 1);
}


//- The bed after a step in which contacts were swept in this order
bodyScene afterStep
(
    contactModel& model,
    const bodyScene& bed,
    const labelList& order
)
{
    bodyScene after(bed);
    forAll(order, i)
    {
        after.contacts[i] = bed.contacts[order[i]];
    }
    if (!model.needsMemory())
    {
        after.memories.clear();
    }

    bodies b(after.view());
    for (label sweepi = 0; sweepi < model.nSweeps(); ++sweepi)
    {
        model.sweep(sweepi, after, b, stepScales{deltaT, 0, deltaT});
    }
    return after;
}


//- Contacts by rising place along x
labelList sorted(const bodyScene& bed)
{
    labelList order(identity(bed.contacts.size()));
    std::sort(order.begin(), order.end(), [&](const label i, const label j)
    {
        const vector& x = bed.spheres[bed.contacts[i].a].x;
        const vector& y = bed.spheres[bed.contacts[j].a].x;
        return x.x() < y.x() || (x.x() == y.x() && i < j);
    });
    return order;
}


labelList reversed(labelList order)
{
    std::reverse(order.begin(), order.end());
    return order;
}


//- Energy of translation by direction, over the mass
vector energies(const bodyScene& bed)
{
    vector sum(Zero);
    for (const motion& m : bed.motions)
    {
        sum += cmptMultiply(m.v, m.v);
    }
    return sum;
}


//- What is left of many beds
struct remainder
{
    scalar energy = 0;
    vector parts = Zero;

    void add(bodyScene& bed)
    {
        energy += kineticEnergy(bed.view());
        parts += energies(bed);
    }

    //- Largest departure of a direction's share from a third
    scalar anisotropy() const
    {
        const scalar all = parts.x() + parts.y() + parts.z();
        return cmptMax(cmptMag(parts/all - vector::uniform(1.0/3.0)));
    }
};

}


TEST_CASE("The order of contacts does not change the totals", "[contact]")
{
    const label nBeds = 10;
    sampler random(101);
    List<bodyScene> beds(nBeds);
    label n = 0, N = 0;
    for (bodyScene& bed : beds)
    {
        bed = lattice(random);
        n += bed.contacts.size();
        N += bed.size();
    }

    claim linear("order.linearMomentum", 1e-14);
    claim angular("order.angularMomentum", 1e-14);
    claim chance("order.energyOfRandomOrders", 3/sqrt(scalar(n)));
    claim share("order.sharesOfRandomOrders", 3*sqrt(4.0/27.0/N));
    claim sortedEnergy("order.energyOfSortedOrders", 0.1);
    claim sortedShare("order.sharesOfSortedOrders", 0.1);

    for (const char* correction : {"none", "velocity", "accumulatedImpulse"})
    for (const scalar e : {0.5, 0.9, 1.0})
    for (const scalar mu : {0.0, 0.3})
    {
        auto model = modelOf(e, mu, correction);
        remainder left[4];

        for (bodyScene& bed : beds)
        {
            const label size = bed.contacts.size();
            const labelList along(sorted(bed));
            const labelList orders[4] =
            {
                random.shuffled(size),
                random.shuffled(size),
                along,
                reversed(along)
            };

            for (label k = 0; k < 4; ++k)
            {
                bodyScene after(afterStep(*model, bed, orders[k]));
                const bodies b(bed.view());
                const bodies a(after.view());

                linear.see
                (
                    mag(linearMomentum(a) - linearMomentum(b))
                   /momentumScale(b)
                );
                angular.see
                (
                    mag(angularMomentum(a) - angularMomentum(b))
                   /angularMomentumScale(b)
                );
                left[k].add(after);
            }
        }

        for (label k = 0; k < 4; ++k)
        {
            const scalar change = mag(left[k].energy/left[0].energy - 1);
            (k < 2 ? chance : sortedEnergy).see(change);
            (k < 2 ? share : sortedShare).see(left[k].anisotropy());
        }
    }

    linear.settle();
    angular.settle();
    chance.settle();
    share.settle();
    sortedEnergy.settle();
    sortedShare.settle();
}

} // End namespace cghs
} // End namespace Foam
