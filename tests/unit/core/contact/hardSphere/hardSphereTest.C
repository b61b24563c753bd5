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


//- Many pairs of bodies, none of which touches another pair
struct crowd
{
    List<sphere> spheres;
    List<motion> motions;
    List<vector> spins;
    List<contact> contacts;

    bodies view() { return bodies{spheres, motions, spins}; }

    void add(const twoBodies& pair)
    {
        contact c = pair.touch;
        c.a += spheres.size();
        c.b += spheres.size();
        contacts.append(c);
        spheres.append(pair.spheres);
        motions.append(pair.motions);
        spins.append(pair.spins);
    }
};


crowd disjointPairs(const label n)
{
    sampler random(51);
    crowd all;
    for (label i = 0; i < n; ++i)
    {
        all.add(randomPair(random));
        all.add(randomWall(random));
    }
    return all;
}


bool sameMotion(const crowd& p, const crowd& q)
{
    forAll(p.motions, i)
    {
        if (p.motions[i].v != q.motions[i].v || p.spins[i] != q.spins[i])
        {
            return false;
        }
    }
    return true;
}

}


TEST_CASE("The first sweep is one impact each, by the surfaces' coefficients",
    "[contact]")
{
    claim same("contact.hardSphereSweep", 0);
    auto model = contactModel::New(dictionaryOf(subModels), 1);

    crowd swept(disjointPairs(500));
    crowd collided(swept);

    bodies b(swept.view());
    model->sweep(0, swept.contacts, b, 1e-4);

    bodies reference(collided.view());
    for (const contact& c : collided.contacts)
    {
        const bool wall = c.surface == contact::parcelWall;
        collide(c, reference, wall ? ofWalls : ofPairs);
    }

    same.count(sameMotion(swept, collided));
    same.settle();
}


TEST_CASE("Contacts without common bodies may be resolved in any order",
    "[contact]")
{
    claim same("contact.orderOfDisjointContacts", 0);
    auto model = contactModel::New(dictionaryOf(subModels), 1);
    sampler random(52);
    const crowd start(disjointPairs(200));
    crowd first(start);
    bodies b(first.view());

    for (label sweepi = 0; sweepi < model->nSweeps(); ++sweepi)
    {
        model->sweep(sweepi, first.contacts, b, 1e-4);
    }

    for (label trial = 0; trial < 20; ++trial)
    {
        crowd other(start);
        const List<contact> list
        (
            start.contacts,
            random.shuffled(start.contacts.size())
        );
        bodies o(other.view());

        for (label sweepi = 0; sweepi < model->nSweeps(); ++sweepi)
        {
            model->sweep(sweepi, list, o, 1e-4);
        }
        same.count(sameMotion(first, other));
    }

    same.settle();
}


TEST_CASE("A pair collides once a step, however long it overlaps", "[contact]")
{
    claim once("contact.oncePerApproach", 0);
    auto model = contactModel::New(dictionaryOf(subModels), 1);
    crowd pairs(disjointPairs(200));
    bodies b(pairs.view());

    model->sweep(0, pairs.contacts, b, 1e-4);
    const crowd after(pairs);
    model->sweep(0, pairs.contacts, b, 1e-4);

    once.count(sameMotion(after, pairs));
    once.settle();
}


TEST_CASE("The sweeps are one of impacts and those of the correction",
    "[contact]")
{
    claim number("contact.numberOfSweeps", 0);
    claim worked("contact.correctionTally", 1e-14);
    auto model = contactModel::New(dictionaryOf(subModels), 1);
    number.see(mag(model->nSweeps() - 4));

    // An overlap that still approaches is what corrections are for
    sampler random(53);
    crowd pair;
    pair.add(randomPair(random));
    bodies b(pair.view());
    const scalar vn = partingSpeed(pair.contacts[0], b);
    const scalar deltaT = 1e-4;
    model->sweep(1, pair.contacts, b, deltaT);

    const scalar gain = 0.1*pair.contacts[0].overlap/deltaT - vn;
    const scalar work =
        0.5*effectiveMass(pair.contacts[0], b)*(sqr(vn + gain) - sqr(vn));
    worked.see(mag(model->tally().correctionWork - work)/mag(work));

    number.settle();
    worked.settle();
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
    crowd pair;
    pair.add(randomPair(random));
    List<vector> noSpins;
    bodies b{pair.spheres, pair.motions, noSpins};
    const scalar vn = partingSpeed(pair.contacts[0], b);
    model->sweep(0, pair.contacts, b, 1e-4);

    smooth.see(mag(partingSpeed(pair.contacts[0], b) + 0.9*vn)/mag(vn));
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
        crowd pair;
        pair.add(i % 2 ? randomPair(random) : randomWall(random));
        const scalar e = i % 2 ? ofPairs.en : ofWalls.en;
        bodies b(pair.view());
        const scalar vn = partingSpeed(pair.contacts[0], b);
        model->sweep(0, pair.contacts, b, 1e-4);
        const scalar rebound = partingSpeed(pair.contacts[0], b);

        scaled.see
        (
            mag(rebound + pow(e, sqrt(W))*vn)
           /(mag(pair.motions[0].v) + mag(pair.motions[1].v))
        );
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
