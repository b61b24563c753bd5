/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "Gao.H"
#include "sphereDrag.H"
#include "checkedEntry.H"
#include "knownEntries.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(Gao, 0);
    addToRunTimeSelectionTable(dragModel, Gao, dictionary);
}
}


Foam::cghs::Gao::Gao(const dictionary& dict)
:
    effectiveDiameter_(positiveScalar(dict, "effectiveDiameter")),
    effectiveDiameterInD_(dict.get<bool>("effectiveDiameterInD")),
    blendWidth_(scalarInRange(dict, "blendWidth", 0, 0.09))
{
    warnUnknownEntries
    (
        dict,
        wordList({"effectiveDiameter", "effectiveDiameterInD", "blendWidth"})
    );
}


Foam::scalar Foam::cghs::Gao::clusterD
(
    const scalar e,
    const scalar u,
    const scalar d,
    const scalar rho,
    const scalar mu
) const
{
    const scalar L = effectiveDiameterInD_ ? effectiveDiameter_ : d;
    const scalar CdRe =
        singleSphereCdRe(reynolds(e, u, effectiveDiameter_, rho, mu));

    // e rho u = Re_e mu/d_e
    return
        5.0/72.0*CdRe*mu
       /(effectiveDiameter_*L*pow(solidsFraction(e), 0.293));
}


Foam::scalar Foam::cghs::Gao::D
(
    const scalar e,
    const scalar u,
    const scalar d,
    const scalar rho,
    const scalar mu
) const
{
    const auto ergun = [&]{ return ergunD(e, u, d, rho, mu); };
    const auto clusters = [&]{ return clusterD(e, u, d, rho, mu); };
    const auto wenYu = [&]{ return wenYuD(e, u, d, rho, mu); };
    const auto single = [&]
    {
        return 0.75*singleSphereCdRe(reynolds(e, u, d, rho, mu))*mu/sqr(d);
    };

    const scalar b = blendWidth_;

    const auto dilute = [&]
    {
        return blended(e, 0.99, min(b, scalar(0.02)), wenYu, single);
    };
    const auto aboveErgun = [&]
    {
        return blended(e, 0.933, b, clusters, dilute);
    };

    return blended(e, 0.8, b, ergun, aboveErgun);
}
