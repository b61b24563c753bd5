/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "Gao.H"
#include "sphereDrag.H"
#include "checkedEntry.H"
#include "knownEntries.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(Gao, 0);
    addToRunTimeSelectionTable(dragModel, Gao, dictionary);
    describeModel
    (
        dragModel,
        Gao,
        "Gao et al. 2009: turbulent beds of FCC catalyst"
    );
}
}


Foam::cghs::Gao::Gao(const dictionary& dict)
:
    effectiveDiameter_(positiveScalar(dict, "effectiveDiameter")),
    effectiveDiameterInD_(dict.get<bool>("effectiveDiameterInD")),
    blendWidth_(scalarInRange(dict, "blendWidth", 0, 0.09)),
    clustersThroughout_(dict.getOrDefault("clustersThroughout", false))
{
    warnUnknownEntries
    (
        dict,
        wordList
        ({
            "effectiveDiameter", "effectiveDiameterInD", "blendWidth",
            "clustersThroughout"
        })
    );
}


Foam::scalar Foam::cghs::Gao::clusterD(const slipFlow& f) const
{
    slipFlow pastCluster(f);
    pastCluster.d = effectiveDiameter_;

    const scalar L = effectiveDiameterInD_ ? effectiveDiameter_ : f.d;
    const scalar CdRe = singleSphereCdRe(superficialRe(pastCluster));

    // e rho u = Re_e mu/d_e
    return
        5.0/72.0*CdRe*f.mu
       /(effectiveDiameter_*L*pow(solidsFraction(f.e), 0.293));
}


Foam::scalar Foam::cghs::Gao::D(const slipFlow& f) const
{
    const auto ergun = [&]{ return ergunD(f); };
    const auto clusters = [&]{ return clusterD(f); };

    slipFlow apart(f);
    if (clustersThroughout_)
    {
        apart.d = effectiveDiameter_;
    }
    const auto wenYu = [&]{ return wenYuD(apart); };
    const auto single = [&]
    {
        return
            0.75*singleSphereCdRe(superficialRe(apart))*f.mu/sqr(apart.d);
    };

    const scalar b = blendWidth_;

    const auto dilute = [&]
    {
        return blended(f.e, 0.99, min(b, scalar(0.02)), wenYu, single);
    };
    const auto aboveErgun = [&]
    {
        return blended(f.e, 0.933, b, clusters, dilute);
    };

    return blended(f.e, 0.8, b, ergun, aboveErgun);
}
