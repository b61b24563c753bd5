/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "roughKineticTheory.H"
#include "roughImpacts.H"
#include "turningPoint.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(roughKineticTheory, 0);
    addToRunTimeSelectionTable
    (
        restitutionScaling,
        roughKineticTheory,
        dictionary
    );
    describeModel
    (
        restitutionScaling,
        roughKineticTheory,
        "keeps what restitution and friction take"
    );
}
}


Foam::scalar Foam::cghs::roughKineticTheory::loss
(
    const restitution& r,
    const scalar e
)
{
    return roughImpacts(e, r.et, r.mu).dissipation();
}


Foam::scalar Foam::cghs::roughKineticTheory::mostDissipative
(
    const restitution& r
)
{
    // By golden section: the loss has one maximum, at e = 0 unless impacts slide
    // much
    const scalar share = 0.5*(sqrt(5.0) - 1);
    scalar low = 0, high = 1;

    for (label i = 0; i < 60; ++i)
    {
        const scalar a = high - share*(high - low);
        const scalar b = low + share*(high - low);

        if (loss(r, a) < loss(r, b))
        {
            low = a;
        }
        else
        {
            high = b;
        }
    }

    return low;
}


Foam::scalar Foam::cghs::roughKineticTheory::ofParcel
(
    const dictionary& dict,
    const restitution& particle,
    const scalar W
) const
{
    if (W == 1)
    {
        return particle.e;
    }

    const scalar asked = cbrt(W)*loss(particle, particle.e);

    const scalar low = min(mostDissipative(particle), particle.e);
    const scalar most = loss(particle, low);

    if (most < asked*(1 - 1e-6))
    {
        if (warned_.insert(dict.name()))
        {
            WarningInFunction
                << "Entry restitutionScaling roughKineticTheory for " << dict.name()
                << nl << "    parcelWeight " << W << " is above "
                << pow3(most/loss(particle, particle.e))
                << ", the largest at which impacts of parcels can take as much"
                << " energy as those of particles" << nl
                << "    Parcels have restitutionCoefficient " << low
                << ", by which they take " << 100*most/asked << " % of it" << nl
                << "    Lower parcelWeight to keep all of it" << nl << endl;
        }

        return low;
    }

    return turningPoint
    (
        low,
        particle.e,
        [&](const scalar e) { return loss(particle, e) > asked; }
    );
}
