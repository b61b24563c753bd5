/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "covariances.H"
#include "SubList.H"

Foam::cghs::covariances::covariances
(
    const label nQuantities,
    const label nPlaces
)
:
    nQuantities_(nQuantities),
    nSamples_(0),
    mean_(nPlaces*nQuantities, Zero),
    products_(nPlaces*nProducts(), Zero)
{}


void Foam::cghs::covariances::add(const UList<scalar>& sample)
{
    // As deviations from the running mean, so that what does not vary leaves
    // exactly nothing
    ++nSamples_;
    const scalar share = (nSamples_ - 1)/nSamples_;

    label entry = 0;
    for (label first = 0; first < mean_.size(); first += nQuantities_)
    {
        const label end = first + nQuantities_;

        for (label k = first; k < end; ++k)
        {
            const scalar deviation = share*(sample[k] - mean_[k]);

            for (label l = k; l < end; ++l)
            {
                products_[entry++] += deviation*(sample[l] - mean_[l]);
            }
        }
    }

    forAll(mean_, k)
    {
        mean_[k] += (sample[k] - mean_[k])/nSamples_;
    }
}


Foam::scalar Foam::cghs::covariances::form
(
    const UList<scalar>& gradient,
    const UList<scalar>& triangles,
    label entry
)
{
    scalar sum = 0;

    for (label k = 0; k < gradient.size(); ++k)
    {
        sum += sqr(gradient[k])*triangles[entry++];

        for (label l = k + 1; l < gradient.size(); ++l)
        {
            sum += 2*gradient[k]*gradient[l]*triangles[entry++];
        }
    }

    // Less than nothing by round-off
    return max(sum, scalar(0));
}


Foam::scalar Foam::cghs::covariances::squaredError
(
    const UList<scalar>& gradient,
    const label place
) const
{
    return
        form(gradient, products_, place*nProducts())
       /(nSamples_*(nSamples_ - 1));
}

// * * * * * * * * * * * * * * * Across a restart  * * * * * * * * * * * * * //

void Foam::cghs::covariances::getState
(
    const label place,
    UList<scalar>& state
) const
{
    for (label k = 0; k < nQuantities_; ++k)
    {
        state[k] = mean(k, place);
    }
    for (label e = 0; e < nProducts(); ++e)
    {
        state[nQuantities_ + e] = products_[place*nProducts() + e];
    }
}


void Foam::cghs::covariances::setState
(
    const label place,
    const UList<scalar>& state
)
{
    for (label k = 0; k < nQuantities_; ++k)
    {
        mean_[place*nQuantities_ + k] = state[k];
    }
    for (label e = 0; e < nProducts(); ++e)
    {
        products_[place*nProducts() + e] = state[nQuantities_ + e];
    }
}
