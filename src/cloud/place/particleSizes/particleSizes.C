/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "particleSizes.H"
#include "distributionModel.H"
#include "fixedValue.H"

namespace Foam
{
namespace cghs
{

static autoPtr<distributionModel> distributionOf
(
    const dictionary& dict,
    const particleProperties& particle,
    Random& random
)
{
    if (dict.found("sizeDistribution"))
    {
        return
            distributionModel::New(dict.subDict("sizeDistribution"), random);
    }

    dictionary fixed;
    fixed.add("value", particle.diameter());
    return autoPtr<distributionModel>
    (
        new distributionModels::fixedValue(fixed, random)
    );
}

} // End namespace cghs
} // End namespace Foam


Foam::cghs::particleSizes::particleSizes
(
    const dictionary& dict,
    const particleProperties& particle,
    Random& random
)
:
    dict_(dict),
    distribution_(distributionOf(dict, particle, random))
{}


Foam::cghs::particleSizes::~particleSizes()
{}


Foam::scalar Foam::cghs::particleSizes::draw() const
{
    const scalar d = distribution_->sample();

    if (!(d > 0))
    {
        FatalIOErrorInFunction(dict_)
            << "The sizeDistribution gave a diameter of " << d
            << " but diameters must be greater than zero" << nl
            << "Raise its smallest value" << nl
            << exit(FatalIOError);
    }

    return d;
}


Foam::scalar Foam::cghs::particleSizes::largest() const
{
    return distribution_->maxValue();
}
