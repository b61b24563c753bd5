/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    A column of spheres on a floor, pressed by gravity: the smallest bed.

    Each step adds n m g dt of momentum to a column of n spheres, and a
    correction passes it on to the floor. The lowest contact has to give way
    until a push carries the column,

        m overlapShare overlap/dt = n m g dt

    Besides, an impact with restitution e that meets the velocity after the
    kick of gravity throws a sphere back by e g dt too much, so that it hops
    at up to v = g dt/(1 - e), and sinks in by as much as v dt. Hence at rest

        overlap <= g dt^2 (n/overlapShare + 1/(1 - e))

    and up to twice that while the column, loaded all at once, swings in.

\*---------------------------------------------------------------------------*/

#include "contactModel.H"
#include "complaint.H"
#include "claim.H"
#include "DynamicList.H"
#include "StringStream.H"

#include <catch2/catch.hpp>

#include <algorithm>

namespace Foam
{
namespace cghs
{

namespace
{

// The spheres of the chapter's Table 1
const scalar d = 1e-3;
const scalar mass = 1.309e-6;
const scalar deltaT = 1e-4;
const vector g(0, 0, -9.81);


struct settings
{
    scalar e;
    label nSweeps;
    scalar overlapShare;

    //- How much of gravity's kick comes before the impacts, the rest after
    scalar kickBefore;

    //- Contacts from top to bottom
    bool topDown;
};


autoPtr<contactModel> modelOf(const settings& s)
{
    OStringStream text;
    text<< "contactModel hardSphere; hardSphereCoeffs { parcelParcel {"
        << " restitutionCoefficient " << s.e << ';'
        << " tangentialRestitutionCoefficient 0.95;"
        << " frictionCoefficient 0.1; }"
        << " parcelWall { $parcelParcel; }"
        << " restitutionScaling unscaled; correctionModel velocity;"
        << " velocityCoeffs { nSweeps " << s.nSweeps << ';'
        << " overlapShare " << s.overlapShare << "; velocityShare 1; } }";

    return contactModel::New(dictionaryOf(text.str().c_str()), 1);
}


//- n spheres above each other, and below them the floor as the last body
class column
{
    const settings settings_;
    autoPtr<contactModel> model_;
    const label n_;
    List<sphere> spheres_;
    List<motion> motions_;
    List<vector> spins_;
    DynamicList<contact> contacts_;

    void findContacts();
    void kick(const scalar share);
    void move();

public:

    //- Touching, or each this far above the one below
    column(const label n, const settings& s, const scalar gap = 0);

    void step();

    //- Largest overlap over the diameter
    scalar overlap() const;

    //- Height of the topmost centre over the diameter
    scalar height() const { return spheres_[n_ - 1].x.z()/d; }
};


column::column(const label n, const settings& s, const scalar gap)
:
    settings_(s),
    model_(modelOf(s)),
    n_(n),
    spheres_(n + 1),
    motions_(n + 1),
    spins_(n + 1, vector(Zero))
{
    for (label i = 0; i < n; ++i)
    {
        const scalar z = (0.5 + i)*d + (i + 1)*gap;
        spheres_[i] = sphere(vector(0, 0, z), d/2);
        motions_[i] = motion(vector(Zero), 1/mass);
    }
    spheres_[n] = sphere(vector(Zero), 0);
    motions_[n] = motion(vector(Zero), 0);
}


void column::findContacts()
{
    contacts_.clear();

    for (label i = 0; i < n_; ++i)
    {
        const bool lowest = i == 0;
        const label below = lowest ? n_ : i - 1;
        const contact c = makeContact
        (
            below,
            i,
            lowest ? contact::parcelWall : contact::parcelParcel,
            spheres_[i].x - spheres_[below].x,
            spheres_[i].r + spheres_[below].r
        );

        if (c.overlap > 0)
        {
            contacts_.append(c);
        }
    }

    if (settings_.topDown)
    {
        std::reverse(contacts_.begin(), contacts_.end());
    }
}


void column::kick(const scalar share)
{
    for (label i = 0; i < n_; ++i)
    {
        motions_[i].v += (share*deltaT)*g;
    }
}


void column::move()
{
    for (label i = 0; i < n_; ++i)
    {
        spheres_[i].x += deltaT*motions_[i].v;
    }
}


void column::step()
{
    bodies b{spheres_, motions_, spins_};
    findContacts();
    kick(settings_.kickBefore);
    model_->sweep(0, contacts_, b, deltaT);
    kick(1 - settings_.kickBefore);

    for (label sweepi = 1; sweepi < model_->nSweeps(); ++sweepi)
    {
        model_->sweep(sweepi, contacts_, b, deltaT);
    }
    move();
}


scalar column::overlap() const
{
    scalar largest = d/2 - spheres_[0].x.z();
    for (label i = 1; i < n_; ++i)
    {
        const scalar distance = mag(spheres_[i].x - spheres_[i - 1].x);
        largest = max(largest, d - distance);
    }
    return largest/d;
}


//- Largest overlap over the diameter within so many steps
scalar largestOverlap(const label n, const settings& s, const label nSteps)
{
    column spheres(n, s);
    scalar largest = 0;
    for (label i = 0; i < nSteps; ++i)
    {
        spheres.step();
        largest = max(largest, spheres.overlap());
    }
    return largest;
}


//- Mean height of the topmost sphere over so many steps
scalar meanHeight(column& spheres, const label nSteps)
{
    scalar sum = 0;
    for (label i = 0; i < nSteps; ++i)
    {
        spheres.step();
        sum += spheres.height();
    }
    return sum/nSteps;
}

}


TEST_CASE("A column under gravity stays within the bound of its overlap",
    "[correction]")
{
    claim bounded("correction.stackOverlapOverBound", 1);

    for (const label n : {1, 3, 10, 30})
    {
        for (const scalar e : {0.5, 0.95})
        {
            for (const label nSweeps : {1, 3})
            {
                for (const scalar share : {0.1, 0.3})
                {
                    const bool topDown = n % 2;
                    const scalar largest = largestOverlap
                    (
                        n, settings{e, nSweeps, share, 1, topDown}, 3000
                    );
                    const scalar atRest =
                        mag(g)*sqr(deltaT)*(n/share + 1/(1 - e))/d;

                    bounded.see(largest/(2*atRest));
                }
            }
        }
    }

    bounded.settle();
}


TEST_CASE("Ten spheres rest on each other with less than 2 % of overlap",
    "[correction]")
{
    claim three("correction.stackOfThree", 0.02);
    claim ten("correction.stackOfTen", 0.02);

    for (const bool topDown : {false, true})
    {
        const settings s{0.95, 3, 0.1, 1, topDown};
        three.see(largestOverlap(3, s, 5000));
        ten.see(largestOverlap(10, s, 5000));
    }

    three.settle();
    ten.settle();
}


TEST_CASE("A column at rest does not creep", "[correction]")
{
    claim still("correction.stackCreep", 1e-3);

    for (const bool topDown : {false, true})
    {
        column spheres(10, settings{0.5, 3, 0.1, 1, topDown});
        meanHeight(spheres, 5000);
        const scalar early = meanHeight(spheres, 5000);
        meanHeight(spheres, 20000);
        const scalar late = meanHeight(spheres, 5000);
        still.see(mag(late - early));
    }

    still.settle();
}


TEST_CASE("Without corrections a column collapses", "[correction]")
{
    // As in Fig 9: what holds the others up is the correction, not the impact
    claim collapses("correction.stackCollapsesWithout", 0);
    const settings s{0.95, 0, 0.1, 1, false};
    collapses.count(largestOverlap(10, s, 3000) > 0.3);
    collapses.settle();
}


TEST_CASE("An elastic sphere bounces as high as it fell, if impacts meet the "
    "velocity halfway through the step", "[contact]")
{
    claim kept("contact.bounceHeight", 1e-3);
    column sphere(1, settings{1, 3, 0.1, 0.5, false}, d);
    const scalar dropped = sphere.height();

    scalar highest = 0;
    for (label i = 0; i < 20000; ++i)
    {
        sphere.step();
        highest = i < 15000 ? 0 : max(highest, sphere.height());
    }

    kept.see(mag(highest - dropped)/dropped);
    kept.settle();
}

} // End namespace cghs
} // End namespace Foam
