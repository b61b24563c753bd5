/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "windowReport.H"
#include "messageStream.H"

Foam::cghs::windowReport::windowReport(const scalar length)
:
    length_(length),
    nMeans_(0),
    nShort_(0),
    worst_(),
    fewest_(GREAT)
{}


Foam::scalar Foam::cghs::windowReport::correlationTime
(
    const blockMoments::estimate& mean
) const
{
    return length_/(2*max(mean.independent, scalar(1)));
}


void Foam::cghs::windowReport::see
(
    const word& name,
    const blockMoments::estimate& mean
)
{
    ++nMeans_;

    if (!mean.longEnough)
    {
        ++nShort_;

        if (mean.independent < fewest_)
        {
            fewest_ = mean.independent;
            worst_ = name;
        }
    }
}


void Foam::cghs::windowReport::write(const word& owner) const
{
    if (nShort_ == 0)
    {
        return;
    }

    const scalar nTimes = 2*max(fewest_, scalar(1));

    Info<< owner << ": window too short for " << nShort_ << " of " << nMeans_
        << " means: " << worst_ << " has " << label(nTimes)
        << " correlation times (" << length_/nTimes
        << " s each, or longer), at least "
        << label(2*blockErrors::leastIndependent) << " needed" << nl << endl;
}
