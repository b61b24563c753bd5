/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "kernelRing.H"
#include "lanes.H"

namespace Foam
{
namespace cghs
{

static label wholeRegisters(const label n)
{
    return laneCount*((n + laneCount - 1)/laneCount);
}

} // End namespace cghs
} // End namespace Foam


Foam::cghs::kernelRing::kernelRing(const label maxSize)
:
    room_(wholeRegisters(maxSize)),
    size_(0),
    images_(nullptr),
    numbers_(nNumbers_*room_, Zero),
    slots_(room_, Zero),
    weights_(room_, Zero),
    shares_(room_, Zero),
    sharers_(room_, Zero)
{}


inline void Foam::cghs::kernelRing::set(const label i, const kernel& k)
{
    // The mixed parts of the shape stand for two each
    const scalar numbers[nNumbers_] =
    {
        k.centre.x(), k.centre.y(), k.centre.z(),
        k.shape.xx(), 2*k.shape.xy(), 2*k.shape.xz(),
        k.shape.yy(), 2*k.shape.yz(), k.shape.zz(),
        k.factor
    };

    scalar* to = numbers_.begin() + i;

    for (label j = 0; j < nNumbers_; ++j)
    {
        to[j*room_] = numbers[j];
    }

    slots_[i] = k.slot;
}


void Foam::cghs::kernelRing::copy
(
    const UList<kernel>& kernels,
    const UList<label>& images
)
{
    images_ = images.cdata();
    size_ = wholeRegisters(images.size());

    forAll(images, i)
    {
        set(i, kernels[images[i]]);
    }

    for (label i = images.size(); i < size_; ++i)
    {
        set(i, kernel{Zero, Zero, 0, 0});
    }
}


CGHS_FOR_EACH_PROCESSOR
Foam::scalar Foam::cghs::kernelRing::weigh(const point& x)
{
    typedef lanes<laneCount> L;
    typedef L::real real;

    const real px = L::uniform(x.x());
    const real py = L::uniform(x.y());
    const real pz = L::uniform(x.z());
    const real none{};

    const scalar* from = numbers_.cdata();
    scalar* to = weights_.begin();
    const label room = room_;
    real sum{};

    for (label i = 0; i < size_; i += laneCount)
    {
        const scalar* k = from + i;
        const real dx = px - L::load(k);
        const real dy = py - L::load(k + room);
        const real dz = pz - L::load(k + 2*room);

        const real ofX =
            L::load(k + 3*room)*dx
          + L::load(k + 4*room)*dy
          + L::load(k + 5*room)*dz;
        const real ofY = L::load(k + 6*room)*dy + L::load(k + 7*room)*dz;
        const real rSqr = dx*ofX + dy*ofY + dz*dz*L::load(k + 8*room);

        const real rest = L::larger(1 - rSqr, none);
        const real weight = L::load(k + 9*room)*rest*rest*rest;

        L::store(to + i, weight);
        sum += weight;
    }

    scalar total = 0;

    for (label l = 0; l < laneCount; ++l)
    {
        total += sum[l];
    }

    return total;
}


Foam::label Foam::cghs::kernelRing::share(const point& x)
{
    const scalar sum = weigh(x);

    if (sum < VSMALL)
    {
        return 0;
    }

    const scalar scale = 1/sum;
    const scalar* const weights = weights_.cdata();
    const label* const slots = slots_.cdata();
    scalar* const shares = shares_.begin();
    label* const sharers = sharers_.begin();
    label n = 0;

    // Without a branch, which could not be foretold
    for (label i = 0; i < size_; ++i)
    {
        shares[n] = weights[i]*scale;
        sharers[n] = slots[i];
        n += weights[i] > 0;
    }

    return n;
}
