/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "stirredCell.H"

#include <algorithm>

namespace Foam
{
namespace cghs
{

// Time in which a gas that has no room leaves, over that of the flow
static const scalar settling = 1e-3;

} // End namespace cghs
} // End namespace Foam


Foam::cghs::stirredCell::stirredCell
(
    const reactionScheme& scheme,
    const tolerances& tolerated
)
:
    reactingCell(scheme, tolerated),
    nReactions_(scheme.inFluid().size()),
    inflow_(nReactions_),
    outflow_(inflow_ + 1),
    wall_(outflow_ + nShared()),
    gives_(nShared()*(wall_ + nEnergies_), 0),
    nBaseViews_(reactingCell::nViews()),
    allViews_((nBaseViews_ + nShared())*nShared(), 0),
    flows_(false),
    V_(0),
    volumeRate_(0),
    wallConductance_(0),
    wallT_(0)
{
    const label n = wall_ + nEnergies_;
    for (label k = 0; k < nShared(); ++k)
    {
        for (label r = 0; r < nReactions_; ++r)
        {
            gives_[k*n + r] = G0_[k*nReactions_ + r];
        }
        gives_[k*n + outflow_ + k] = -1;
        allViews_[(nBaseViews_ + k)*nShared() + k] = 1;
    }
    if (nEnergies_)
    {
        gives_[nFluid_*n + wall_] = 1;
    }
}


void Foam::cghs::stirredCell::flow
(
    const UList<scalar>& amounts,
    const scalar T,
    const scalar V,
    const scalar volumeRate
)
{
    const label n = wall_ + nEnergies_;

    flows_ = volumeRate > 0;
    V_ = V;
    volumeRate_ = volumeRate;

    forAll(amounts, k)
    {
        gives_[k*n + inflow_] = amounts[k];
    }
    if (nEnergies_)
    {
        gives_[nFluid_*n + inflow_] =
            scheme_.fluid().enthalpyOf(amounts, T);
    }
}


void Foam::cghs::stirredCell::walls(const scalar conductance, const scalar T)
{
    wallConductance_ = conductance;
    wallT_ = T;
}


Foam::scalar Foam::cghs::stirredCell::outRate() const
{
    if (!flows_)
    {
        return 0;
    }
    if (!isGas())
    {
        return volumeRate_/V_;
    }

    return
        max(fluidVolume()/V_ - 1, scalar(0))*volumeRate_/(settling*V_);
}


void Foam::cghs::stirredCell::flowRates(scalar* f) const
{
    const scalar q = outRate();
    f[inflow_] = flows_ ? 1 : 0;
    for (label k = 0; k < nShared(); ++k)
    {
        f[outflow_ + k] = q*now_[k];
    }
    if (nEnergies_)
    {
        f[wall_] = wallConductance_*(wallT_ - fluidT_);
    }
}


void Foam::cghs::stirredCell::ownRates(scalar* f)
{
    reactingCell::ownRates(f);
    flowRates(f);
}


const Foam::UList<Foam::scalar>& Foam::cghs::stirredCell::views()
{
    const UList<scalar>& base = reactingCell::views();
    std::copy(base.begin(), base.end(), allViews_.begin());
    return allViews_;
}


void Foam::cghs::stirredCell::ownDerivatives(scalar* f, scalar* fq)
{
    reactingCell::ownDerivatives(f, fq);
    flowRates(f);

    const label n = nShared();
    const label v = nViews();
    std::fill(fq + inflow_*v, fq + nOwn()*v, 0);

    // By z, row by row
    const auto byShared = [&](const label process)
    {
        return fq + process*v + nBaseViews_;
    };

    const scalar q = outRate();
    for (label k = 0; k < n; ++k)
    {
        byShared(outflow_ + k)[k] = q;
    }

    if (isGas() && q > 0)
    {
        const scalar byVolume = volumeRate_/(settling*sqr(V_));
        for (label j = 0; j < n; ++j)
        {
            const scalar dV =
                fluidVolume()
               *((j < nFluid_ ? 1/total_ : 0) + dTdz_[j]/fluidT_);

            for (label k = 0; k < n; ++k)
            {
                byShared(outflow_ + k)[j] += now_[k]*byVolume*dV;
            }
        }
    }
    if (nEnergies_)
    {
        for (label j = 0; j < n; ++j)
        {
            byShared(wall_)[j] = -wallConductance_*dTdz_[j];
        }
    }
}


Foam::scalarField Foam::cghs::stirredCell::cameIn() const
{
    const label n = wall_ + nEnergies_;
    scalarField in(nShared());
    forAll(in, k)
    {
        in[k] = gives_[k*n + inflow_]*ownExtent(inflow_);
    }
    return in;
}


Foam::scalarField Foam::cghs::stirredCell::wentOut() const
{
    scalarField out(nShared());
    forAll(out, k)
    {
        out[k] = ownExtent(outflow_ + k);
    }
    return out;
}


Foam::scalar Foam::cghs::stirredCell::fromWalls() const
{
    return nEnergies_ ? ownExtent(wall_) : 0;
}
