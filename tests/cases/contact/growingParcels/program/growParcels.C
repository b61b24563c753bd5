/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Application
    growParcels

Description
    Parcels of all sizes that move, collide, grow and shrink, as a stage that
    changes sizes lets them. In each step the contacts that the contact stage
    has found are held against asking each of each.

    The mesh is a box from the origin with walls or periodic sides.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "polyMesh.H"
#include "contactStage.H"
#include "hardSphereImpulse.H"
#include "transport.H"
#include "meshFreedom.H"
#include "Random.H"
#include "IStringStream.H"

namespace Foam
{
namespace cghs
{

constexpr label nParcels = 1200;
constexpr label nSteps = 100;
constexpr scalar deltaT = 1e-4;
constexpr scalar density = 2500;

//- Radii, and how much of itself a parcel grows or shrinks in a step
constexpr scalar smallest = 4e-4;
constexpr scalar largest = 4e-3;
constexpr scalar growth = 0.01;


//- Impacts of what touches, and of nothing else
class impactOfAll
:
    public contactModel
{
public:

    virtual bool needsContacts() const { return true; }

    virtual bool needsSpin() const { return false; }

    virtual label nSweeps() const { return 1; }

    virtual void sweep
    (
        const label,
        contactList& list,
        bodies& b,
        const stepScales&
    )
    {
        for (const contact& c : list.contacts)
        {
            collide(c, b, impactCoeffs{0.9, 0.9, 0});
        }
    }
};


//- All parcels are drawn on all ranks, and kept where they are
static void scatter(const polyMesh& mesh, arena& parcels)
{
    const locator cells(mesh);
    const boundBox& box = mesh.bounds();
    Random random(1);

    for (label id = 0; id < nParcels; ++id)
    {
        const vector x(random.position(box.min(), box.max()));
        const vector v(random.position(vector::one, -vector::one));
        const scalar share = random.sample01<scalar>();
        const label celli = cells.find(x);

        if (celli != -1)
        {
            const label i = parcels.append(1);
            parcels.spheres[i].x = x;
            parcels.motions[i].v = 0.02*v;
            parcels.cells[i] = celli;
            parcels.ids[i] = id;

            // Many small ones: equal numbers by octave
            parcels.setSize
            (
                i, 2*smallest*pow(largest/smallest, share), 1, density
            );
        }
    }
}


//- Each parcel grows for a while and then shrinks. Returns the largest increase
//  of a radius on all ranks
static scalar grow(arena& parcels, const label step)
{
    scalar increase = 0;

    for (label i = 0; i < parcels.size(); ++i)
    {
        const scalar before = parcels.spheres[i].r;
        const scalar rate = growth*sin(0.1*step + parcels.ids[i]);

        parcels.setSize(i, parcels.diameters[i]*(1 + rate), 1, density);
        increase = max(increase, parcels.spheres[i].r - before);
    }

    return returnReduce(increase, maxOp<scalar>());
}


static List<sphere> all(const arena& parcels)
{
    List<List<sphere>> spheres(Pstream::nProcs());
    spheres[Pstream::myProcNo()] =
        SubList<sphere>(parcels.spheres, parcels.size());
    Pstream::gatherList(spheres);
    Pstream::scatterList(spheres);

    List<sphere> joined;
    for (const List<sphere>& part : spheres)
    {
        joined.append(part);
    }
    return joined;
}


//- How many contacts there are in a box that ends at span, each asked of each
static label nContacts
(
    const List<sphere>& spheres,
    const vector& span,
    const bool periodic
)
{
    label n = 0;

    forAll(spheres, i)
    {
        const sphere& s = spheres[i];

        for (direction d = 0; d < 3 && !periodic; ++d)
        {
            n += (s.x[d] < s.r) + (s.x[d] > span[d] - s.r);
        }

        for (label j = i + 1; j < spheres.size(); ++j)
        {
            vector apart(spheres[j].x - s.x);

            for (direction d = 0; d < 3 && periodic; ++d)
            {
                apart[d] -= span[d]*std::round(apart[d]/span[d]);
            }

            n += magSqr(apart) < sqr(s.r + spheres[j].r);
        }
    }

    return n;
}


//- The momentum of all parcels [kg m/s]
static vector momentum(const arena& parcels)
{
    vector sum(Zero);
    for (label i = 0; i < parcels.size(); ++i)
    {
        sum += parcels.motions[i].mass()*parcels.motions[i].v;
    }
    return returnReduce(sum, sumOp<vector>());
}

} // End namespace cghs
} // End namespace Foam


using namespace Foam;
using namespace Foam::cghs;

int main(int argc, char *argv[])
{
    #include "setRootCase.H"
    #include "createTime.H"
    #include "createPolyMesh.H"

    const dictionary boundary(IStringStream("\".*\" rebound;")());
    const vector span
    (
        returnReduce(mesh.bounds().max(), maxOp<vector>())
    );

    const List<vector> periods(cghs::periods(mesh));

    arena parcels(false, false);
    scatter(mesh, parcels);

    transport motion(mesh, boundary);
    contactStage contacts
    (
        autoPtr<contactModel>(new impactOfAll),
        wallDistance::New(dictionary()),
        0.5,
        mesh,
        motion.boundary().wallPatches(),
        periods,
        vector(0, 0, -9.81)
    );

    label nFound = 0;
    label nWrong = 0;
    scalar momentumError = 0;

    for (label step = 0; step < nSteps; ++step)
    {
        if (contacts.stale())
        {
            motion.settle(parcels);
            contacts.rebuild(parcels);
        }

        const List<sphere> spheres(all(parcels));
        const vector before(momentum(parcels));

        contacts.impacts(parcels, deltaT);
        contacts.correct(parcels, deltaT);

        momentumError =
            max(momentumError, mag(momentum(parcels) - before)/mag(before));

        const label found =
            returnReduce(contacts.tally().nContacts, sumOp<label>());

        nWrong += mag(found - nContacts(spheres, span, periods.size()));
        nFound += found;

        contacts.moved(motion.move(parcels, deltaT).maxDistance, deltaT);
        contacts.resized(grow(parcels, step));
    }

    Info<< "parcels " << all(parcels).size() << nl
        << "contacts " << nFound << nl
        << "wrong " << nWrong << nl
        << "momentum " << momentumError << nl
        << "listShare " << scalar(contacts.nBuilds())/nSteps << nl
        << "End" << endl;

    return 0;
}
