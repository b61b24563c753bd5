/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    The contact models as a cloud uses them: selected from a dictionary, swept
    over a list of contacts.

\*---------------------------------------------------------------------------*/

#include "contactModel.H"
#include "twoBodies.H"
#include "complaint.H"
#include "claim.H"

#include <catch2/catch.hpp>

namespace Foam
{
namespace cghs
{

namespace
{

const impactCoeffs ofPairs{0.9, 0.33, 0.1};
const impactCoeffs ofWalls{0.5, 0.1, 0.6};

const char* const subModels =
    "contactModel hardSphere;"
    "hardSphereCoeffs"
    "{"
    "    parcelParcel"
    "    {"
    "        restitutionCoefficient 0.9;"
    "        tangentialRestitutionCoefficient 0.33;"
    "        frictionCoefficient 0.1;"
    "    }"
    "    parcelWall"
    "    {"
    "        restitutionCoefficient 0.5;"
    "        tangentialRestitutionCoefficient 0.1;"
    "        frictionCoefficient 0.6;"
    "    }"
    "    restitutionScaling unscaled;"
    "    correctionModel velocity;"
    "    velocityCoeffs { nSweeps 3; overlapShare 0.1; velocityShare 1; }"
    "}";


//- No gravity: whatever approaches collides
const stepScales step{1e-4, 0};


bodyScene disjointPairs(const label n)
{
    sampler random(51);
    bodyScene all;
    for (label i = 0; i < n; ++i)
    {
        all.add(randomPair(random));
        all.add(randomWall(random));
    }
    return all;
}


void sweep(contactModel& model, const label sweepi, bodyScene& scene)
{
    bodies b(scene.view());
    model.sweep(sweepi, scene, b, step);
}


//- All sweeps of a step
void sweep(contactModel& model, bodyScene& scene)
{
    for (label sweepi = 0; sweepi < model.nSweeps(); ++sweepi)
    {
        sweep(model, sweepi, scene);
    }
}


scalar partingSpeed(twoBodies& pair)
{
    return partingSpeed(pair.touch(), pair.view());
}

}


TEST_CASE("The first sweep is one impact each, by the surfaces' coefficients",
    "[contact]")
{
    claim same("contact.hardSphereSweep", 0);
    auto model = contactModel::New(dictionaryOf(subModels), 1);

    bodyScene swept(disjointPairs(500));
    bodyScene collided(swept);
    sweep(*model, 0, swept);

    bodies b(collided.view());
    for (const contact& c : collided.contacts)
    {
        const bool wall = c.surface == contact::parcelWall;
        collide(c, b, wall ? ofWalls : ofPairs);
    }

    same.count(swept.movesLike(collided));
    same.settle();
}


TEST_CASE("Contacts without common bodies may be resolved in any order",
    "[contact]")
{
    claim same("contact.orderOfDisjointContacts", 0);
    auto model = contactModel::New(dictionaryOf(subModels), 1);
    sampler random(52);
    const bodyScene start(disjointPairs(200));
    bodyScene first(start);
    sweep(*model, first);

    for (label trial = 0; trial < 20; ++trial)
    {
        bodyScene other(start);
        const labelList order(random.shuffled(start.contacts.size()));
        forAll(order, i)
        {
            other.contacts[i] = start.contacts[order[i]];
        }
        sweep(*model, other);
        same.count(first.movesLike(other));
    }

    same.settle();
}


TEST_CASE("A pair collides once, however long it overlaps", "[contact]")
{
    claim once("contact.oncePerApproach", 0);
    auto model = contactModel::New(dictionaryOf(subModels), 1);
    bodyScene pairs(disjointPairs(200));

    sweep(*model, 0, pairs);
    const bodyScene after(pairs);
    sweep(*model, 0, pairs);

    once.count(after.movesLike(pairs));
    once.settle();
}


TEST_CASE("The sweeps are one of impacts and those of the correction",
    "[contact]")
{
    claim number("contact.numberOfSweeps", 0);
    claim worked("contact.correctionTally", 1e-14);
    auto model = contactModel::New(dictionaryOf(subModels), 1);
    number.see(mag(model->nSweeps() - 4));

    // Two corrections: the first has something to do, the second adds nothing
    sampler random(53);
    twoBodies pair(randomPair(random));
    pair.setNormalSpeed(-pair.touch().overlap/step.deltaT);
    const scalar vn = partingSpeed(pair);
    const scalar gain = 0.1*pair.touch().overlap/step.deltaT - vn;
    const scalar work =
        0.5*pair.normalMass()*(sqr(vn + gain) - sqr(vn));
    sweep(*model, 1, pair);
    sweep(*model, 2, pair);
    worked.see(mag(model->tally().correctionWork - work)/mag(work));

    number.settle();
    worked.settle();
}


TEST_CASE("Corrections run through the list there and back", "[contact]")
{
    claim same("contact.firstCorrectionForwards", 0);
    auto model = contactModel::New(dictionaryOf(subModels), 1);

    // Three in a row, pressed together: the result tells who came first
    bodyScene row(3);
    for (label i = 0; i < 3; ++i)
    {
        row.spheres[i] = sphere(vector(i*1.9e-3, 0, 0), 1e-3);
        row.motions[i] = motion(vector(0.1*(1 - i), 0, 0), 1);
    }
    for (label i = 0; i < 2; ++i)
    {
        const vector d(row.spheres[i + 1].x - row.spheres[i].x);
        row.contacts.append
        (
            makeContact(i, i + 1, contact::parcelParcel, i, d, 2e-3)
        );
    }

    // The last pair parts as corrected, the first has been disturbed since
    const scalar part = 0.1*1e-4/step.deltaT;
    sweep(*model, 1, row);
    const scalar first = row.motions[1].v.x() - row.motions[0].v.x();
    const scalar last = row.motions[2].v.x() - row.motions[1].v.x();

    same.count(mag(last - part) < 1e-12 && mag(first - part) > 1e-3);
    same.settle();
}


TEST_CASE("Spin is asked for only where something turns the parcels",
    "[contact]")
{
    claim needed("contact.needsSpin", 0);
    dictionary dict(dictionaryOf(subModels));
    dictionary& coeffs = dict.subDict("hardSphereCoeffs");
    dictionary& pairs = coeffs.subDict("parcelParcel");
    dictionary& walls = coeffs.subDict("parcelWall");

    needed.count(contactModel::New(dict, 1)->needsSpin());
    pairs.set("frictionCoefficient", 0);
    needed.count(contactModel::New(dict, 1)->needsSpin());
    walls.set("frictionCoefficient", 0);
    needed.count(!contactModel::New(dict, 1)->needsSpin());
    pairs.set("frictionCoefficient", 0.1);
    needed.count(contactModel::New(dict, 1)->needsSpin());

    needed.settle();
}


TEST_CASE("Without friction no spins are touched, for there are none",
    "[contact]")
{
    claim smooth("contact.sweepWithoutSpins", 1e-14);
    dictionary dict(dictionaryOf(subModels));
    dictionary& coeffs = dict.subDict("hardSphereCoeffs");
    coeffs.subDict("parcelParcel").set("frictionCoefficient", 0);
    coeffs.subDict("parcelWall").set("frictionCoefficient", 0);
    auto model = contactModel::New(dict, 1);

    sampler random(54);
    twoBodies pair(randomPair(random));
    pair.setNormalSpeed(-pair.touch().overlap/step.deltaT);
    const scalar vn = partingSpeed(pair);
    pair.spins.clear();
    sweep(*model, 0, pair);

    smooth.see(mag(partingSpeed(pair) + 0.9*vn)/mag(vn));
    smooth.settle();
}


TEST_CASE("The restitution of pairs and walls is that of parcels of W",
    "[contact]")
{
    claim scaled("contact.scaledRestitution", 1e-13);
    dictionary dict(dictionaryOf(subModels));
    dict.subDict("hardSphereCoeffs").set("restitutionScaling", "logarithmic");
    const scalar W = 27;
    auto model = contactModel::New(dict, W);

    sampler random(55);
    for (label i = 0; i < 100; ++i)
    {
        twoBodies pair(i % 2 ? randomPair(random) : randomWall(random));
        const scalar e =
            i % 2 ? pow(ofPairs.en, sqrt(W)) : ofWalls.en;
        const scalar scale = pair.speedScale();
        const scalar vn = partingSpeed(pair);
        sweep(*model, 0, pair);

        scaled.see(mag(partingSpeed(pair) + e*vn)/scale);
    }

    scaled.settle();
}


TEST_CASE("The model 'none' wants no contacts, no spin and no sweeps",
    "[contact]")
{
    claim idle("contact.noneIsIdle", 0);
    auto model = contactModel::New(dictionaryOf("contactModel none;"), 1);

    idle.count(!model->needsContacts());
    idle.count(!model->needsSpin());
    idle.count(model->nSweeps() == 0);
    idle.settle();
}

} // End namespace cghs
} // End namespace Foam
