/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "heap.H"

namespace Foam
{
namespace cghs
{

static void findContacts(bodyScene& heap)
{
    for (label i = 0; i < heap.size(); ++i)
    {
        for (label j = i + 1; j < heap.size(); ++j)
        {
            const vector d(heap.spheres[j].x - heap.spheres[i].x);
            const scalar radii = heap.spheres[i].r + heap.spheres[j].r;

            if (mag(d) < radii)
            {
                const label slot = heap.contacts.size();
                heap.contacts.append
                (
                    makeContact(i, j, contact::parcelParcel, slot, d, radii)
                );
            }
        }
    }
}

}
}


Foam::cghs::bodyScene Foam::cghs::randomHeap(sampler& random)
{
    const scalar box = 6e-3;
    bodyScene heap(40);

    forAll(heap.spheres, i)
    {
        const scalar r = random.acrossDecades(2e-4, 2e-3);
        const vector x(random.inBox(vector::zero, vector::uniform(box)));
        const scalar speed = random.acrossDecades(1e-3, 1);

        heap.spheres[i] = sphere(x, r);
        heap.motions[i] = motion(speed*random.direction(), 1/(1e4*pow3(r)));
        heap.spins[i] = (speed/r)*random.direction();
    }

    findContacts(heap);
    return heap;
}
