/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "sampler.H"
#include "mathematicalConstants.H"

Foam::scalar Foam::cghs::sampler::between
(
    const scalar low,
    const scalar high
)
{
    // 53 random bits, as many as the mantissa has
    const scalar share = scalar(engine_() >> 11)/scalar(std::uint64_t(1) << 53);
    return low + (high - low)*share;
}


Foam::scalar Foam::cghs::sampler::acrossDecades
(
    const scalar low,
    const scalar high
)
{
    return exp(between(log(low), log(high)));
}


Foam::label Foam::cghs::sampler::below(const label n)
{
    return min(label(between(0, n)), n - 1);
}


Foam::vector Foam::cghs::sampler::direction()
{
    const scalar z = between(-1, 1);
    const scalar angle = between(0, constant::mathematical::twoPi);
    const scalar r = sqrt(1 - sqr(z));
    const vector n(r*cos(angle), r*sin(angle), z);
    return n/mag(n);
}


Foam::vector Foam::cghs::sampler::inBox(const vector& low, const vector& high)
{
    const scalar x = between(low.x(), high.x());
    const scalar y = between(low.y(), high.y());
    const scalar z = between(low.z(), high.z());
    return vector(x, y, z);
}


Foam::tensor Foam::cghs::sampler::rotation()
{
    const vector x(direction());
    vector y(x ^ direction());
    y /= mag(y);
    return tensor(x, y, x ^ y);
}


Foam::labelList Foam::cghs::sampler::shuffled(const label n)
{
    labelList numbers(n);
    for (label i = 0; i < n; ++i)
    {
        const label k = below(i + 1);
        numbers[i] = numbers[k];
        numbers[k] = i;
    }
    return numbers;
}
