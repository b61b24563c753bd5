/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    Contacts of spheres as they are worked out from positions and radii.

\*---------------------------------------------------------------------------*/

#include "contact.H"
#include "claim.H"
#include "sampler.H"
#include "labelList.H"

#include <catch2/catch.hpp>

namespace Foam
{
namespace cghs
{

TEST_CASE("A contact's normal points from the first to the second", "[contact]")
{
    claim length("contact.normalLength", 1e-15);
    claim place("contact.normalSpansDistance", 1e-15);
    claim depth("contact.overlap", 1e-15);
    sampler random(11);

    for (label i = 0; i < 2000; ++i)
    {
        const vector d(random.acrossDecades(1e-9, 1)*random.direction());
        const scalar radii = mag(d)*random.between(1, 2);
        const contact c = makeContact(3, 7, contact::parcelParcel, 5, d, radii);

        length.see(mag(mag(c.n) - 1));
        place.see(mag(mag(d)*c.n - d)/mag(d));
        depth.see(mag(c.overlap + mag(d) - radii)/radii);
    }

    length.settle();
    place.settle();
    depth.settle();
}


TEST_CASE("Coincident spheres have a normal all the same", "[contact]")
{
    claim normal("contact.coincidentNormal", 1e-15);
    claim depth("contact.coincidentOverlap", 0);

    // From none at all to the smallest distance that a double can hold
    for (const scalar distance : {0.0, 5e-324, 1e-305, 1e-200, 1e-160})
    {
        const vector d(0, distance, 0);
        const contact c = makeContact(0, 1, contact::parcelParcel, 0, d, 2e-3);

        normal.see(mag(mag(c.n) - 1));
        depth.see(mag(c.overlap - 2e-3));
    }

    normal.settle();
    depth.settle();
}

} // End namespace cghs
} // End namespace Foam
