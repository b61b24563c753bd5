/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "reactingCell.H"
#include "checkedEntry.H"
#include "drivingUnit.H"
#include "mathematicalConstants.H"

#include <algorithm>
#include <cmath>

namespace Foam
{
namespace cghs
{

// Temperatures that a state may have [K]
static const scalar coldest = 1;
static const scalar hottest = 2e4;

// An error over what is tolerated. A step that has run away may leave amounts
// that cancel to nothing: it is not good then, and nothing is divided by that
static inline scalar over(const scalar error, const scalar tolerated)
{
    return error < GREAT*tolerated ? error/tolerated : GREAT;
}

// An amount that counts as none [mol, mol/m^3]: rates may fall from all to
// nothing within it, and even squares of that slope are numbers
static const scalar nothing = 1e-30;

// What amounts may be below zero by rounding, over all of them
static const scalar rounding = 1e-13;


//- What n substances of a list gain by reactions, in a matrix with a row for
//  each of them
static void setGains
(
    scalarField& matrix,
    const PtrList<reaction>& reactions,
    const label nColumns
)
{
    forAll(reactions, r)
    {
        const scalarField& gain = reactions[r].equation().fluidGain();
        forAll(gain, k)
        {
            matrix[k*nColumns + r] = gain[k];
        }
    }
}

} // End namespace cghs
} // End namespace Foam

// * * * * * * * * * * * * * * * Construction  * * * * * * * * * * * * * * * //

Foam::cghs::reactingCell::reactingCell
(
    const reactionScheme& scheme,
    const tolerances& tolerated
)
:
    scheme_(scheme),
    nFluid_(scheme.fluid().size()),
    nEnergies_(scheme.energetic() ? 1 : 0),
    G0_((nFluid_ + nEnergies_)*scheme.inFluid().size(), 0),
    now_(nullptr),
    fluidT_(0),
    total_(0),
    startTotal_(0),
    dTdz_(nFluid_ + nEnergies_, 0),
    tolerances_(tolerated),
    nSolids_(scheme.solids().size()),
    nReactions_(scheme.inParticles().size()),
    inputs_(scheme),
    values_(inputs_.list().size(), 0),
    slopes_(inputs_.nRows()*inputs_.active().size(), 0),
    views_(inputs_.nViews()*(nFluid_ + nEnergies_), 0),
    integrator_(arrowIntegrator::New(inputs_.active().size())),
    G_((nFluid_ + nEnergies_)*(nReactions_ + nEnergies_), 0),
    z_(nFluid_ + nEnergies_, 0),
    p_(0),
    volume_(0),
    concentration_(nFluid_, 0),
    fluidH_(nFluid_, 0),
    fluidCp_(nFluid_, 0),
    massGain_(nReactions_, 0),
    volumeGain_(nReactions_, 0),
    carriers_(nReactions_),
    warned_(false),
    n_(nSolids_, 0),
    dn_(nSolids_, 0),
    looked_(-1),
    h_(nSolids_, 0)
{
    setGains(G_, scheme.inParticles(), nReactions_ + nEnergies_);
    setGains(G0_, scheme.inFluid(), scheme.inFluid().size());

    for (label r = 0; r < nReactions_; ++r)
    {
        const scalarField& gain =
            scheme.inParticles()[r].equation().solidGain();

        massGain_[r] = scheme.solids().massOf(gain);
        if (scheme.constantDensity())
        {
            volumeGain_[r] = scheme.solids().volumeOf(gain);
        }
        if (!scheme.inParticles()[r].law().ranges().empty())
        {
            ranged_.append(r);
            asked_.append(askedRange());
        }
    }

    const UList<label>& changing = inputs_.changing();
    solidGain_.resize(nSolids_*changing.size());
    forAll(changing, c)
    {
        const reaction& r = scheme.inParticles()[changing[c]];
        for (label s = 0; s < nSolids_; ++s)
        {
            solidGain_[s*changing.size() + c] = r.equation().solidGain()[s];
        }
    }
    lookedX_.resize(changing.size() + nEnergies_);

    if (nEnergies_)
    {
        // The fluid has less of the enthalpy that a parcel gets
        G_.last() = -1;
        findCarriers();
    }
}


Foam::cghs::reactingCell::tolerances
Foam::cghs::reactingCell::readTolerances(const dictionary& dict)
{
    const tolerances t =
    {
        dict.getOrDefault<scalar>("relative", 1e-3),
        dict.getOrDefault<scalar>("absolute", 1e-8)
    };
    checkRange(dict, "relative", t.relative, scalar(1e-12), scalar(0.1));
    checkRange(dict, "absolute", t.absolute, scalar(1e-16), scalar(0.1));
    return t;
}


void Foam::cghs::reactingCell::findCarriers()
{
    for (label r = 0; r < nReactions_; ++r)
    {
        const reaction& reaction = scheme_.inParticles()[r];
        const reactionEquation& equation = reaction.equation();

        for (label k = 0; k < nFluid_; ++k)
        {
            const carrier c =
            {
                k,
                equation.fluidReactants()[k],
                equation.fluidProducts()[k]
              - reaction.heatToFluid()*equation.fluidGain()[k]
            };
            if (c.in != 0 || c.out != 0)
            {
                carriers_[r].append(c);
            }
        }
    }
}


void Foam::cghs::reactingCell::start
(
    const UList<scalar>& amounts,
    const scalar T,
    const scalar p,
    const scalar volume
)
{
    looked_ = -1;
    bodies_.clear();
    amounts_.clear();
    enthalpy_.clear();
    T_.clear();

    p_ = p;
    volume_ = volume;
    fluidT_ = T;

    startTotal_ = 0;
    forAll(amounts, k)
    {
        z_[k] = amounts[k];
        startTotal_ += amounts[k];
    }
    if (nEnergies_)
    {
        z_[nFluid_] = scheme_.fluid().enthalpyOf(amounts, T);
    }
}


void Foam::cghs::reactingCell::add
(
    const body& parcel,
    const UList<scalar>& amounts
)
{
    bodies_.append(parcel);
    T_.append(parcel.T);

    amounts_.append(amounts);
    enthalpy_.append
    (
        nEnergies_ ? scheme_.solids().enthalpyOf(amounts, parcel.T) : scalar(0)
    );
    bodies_.last().amount = sum(amounts);

    scalar C = 0;
    for (label s = 0; nEnergies_ && s < nSolids_; ++s)
    {
        C += amounts[s]*scheme_.solids()[s].Cp(parcel.T);
    }
    bodies_.last().capacity = C;
}

// * * * * * * * * * * * * * * * * * The time  * * * * * * * * * * * * * * * //

bool Foam::cghs::reactingCell::react(const scalar deltaT, scalar& h)
{
    if (!integrator_->integrate(*this, z_, deltaT, h))
    {
        return false;
    }

    for (label k = 0; k < nFluid_; ++k)
    {
        z_[k] = max(z_[k], scalar(0));
    }
    share(z_.cdata());

    forAll(bodies_, i)
    {
        const scalar* x = integrator_->extents(i);
        look(i, x);
        forAll(n_, s)
        {
            amounts_[i*nSolids_ + s] = max(n_[s], scalar(0));
        }
        noteRanges(amounts(i));
        if (nEnergies_)
        {
            enthalpy_[i] += x[nReactions_];
        }
    }
    looked_ = -1;
    return true;
}


void Foam::cghs::reactingCell::noteRanges(const UList<scalar>& amounts)
{
    forAll(ranged_, k)
    {
        const kineticLaw& law = scheme_.inParticles()[ranged_[k]].law();
        asked_[k].note(law.asked(amounts));
    }
}


void Foam::cghs::reactingCell::warnOfRanges()
{
    // One warning for all reactions: most schemes have one such range
    for (label k = 0; k < ranged_.size() && !warned_; ++k)
    {
        const reaction& r = scheme_.inParticles()[ranged_[k]];

        warned_ = asked_[k].warn
        (
            "Reaction " + r.name(),
            r.law().ranges(),
            scalarMinMax(0, r.law().upTo())
        );
    }
}


bool Foam::cghs::reactingCell::rests()
{
    share(z_.cdata());

    forAll(scheme_.inFluid(), r)
    {
        if (fluidRate(r) != 0)
        {
            return false;
        }
    }

    const scalarField none(nReactions_ + nEnergies_, 0);
    forAll(bodies_, i)
    {
        look(i, none.cdata());
        for (label r = 0; r < nReactions_; ++r)
        {
            if (rateIn(i, r) != 0)
            {
                return false;
            }
        }
    }
    return true;
}


Foam::scalarField Foam::cghs::reactingCell::speeds(const label r)
{
    share(z_.cdata());

    const scalarField none(nReactions_ + nEnergies_, 0);
    scalarField all(bodies_.size());
    forAll(all, i)
    {
        look(i, none.cdata());
        all[i] = bodies_[i].W*rateIn(i, r);
    }
    return all;
}


Foam::scalar Foam::cghs::reactingCell::enthalpyTaken(const label i) const
{
    scalar H = 0;
    for (label r = 0; r < nReactions_; ++r)
    {
        scalar byT, byFluidT;
        H += extent(i, r)*enthalpyTaken(r, T_[i], byT, byFluidT);
    }
    return H;
}


Foam::scalar Foam::cghs::reactingCell::fluidCapacity() const
{
    scalar C = 0;
    for (label k = 0; k < nFluid_; ++k)
    {
        C += z_[k]*fluidCp_[k];
    }
    return C;
}

// * * * * * * * * * * * * * * * *  The state  * * * * * * * * * * * * * * * //

Foam::scalar Foam::cghs::reactingCell::temperatureOf
(
    const substances& list,
    const scalar* n,
    const scalar H,
    const scalar guess,
    const scalar least,
    const scalar otherwise
)
{
    if (list.straight())
    {
        scalar missing = H;
        scalar C = 0;
        forAll(list, k)
        {
            missing -= n[k]*list[k].h(0);
            C += n[k]*list[k].Cp(0);
        }
        return
            C > least ? min(max(missing/C, coldest), hottest) : otherwise;
    }

    scalar T = guess;
    for (label pass = 0; pass < 50; ++pass)
    {
        scalar missing = H;
        scalar C = 0;
        forAll(list, k)
        {
            missing -= n[k]*list[k].h(T);
            C += n[k]*list[k].Cp(T);
        }
        if (!(C > least))
        {
            return otherwise;
        }

        const scalar next = min(max(T + missing/C, coldest), hottest);
        const scalar change = mag(next - T);
        T = next;

        // Polynomials have a small jump where they change: no less will do
        if (change < 1e-12*T)
        {
            break;
        }
    }
    return T;
}


void Foam::cghs::reactingCell::addGains(const scalar* x, scalarField& n) const
{
    const label nChanging = inputs_.changing().size();
    const scalar* gain = solidGain_.cdata();
    const label* changing = inputs_.changing().cdata();
    for (scalar& each : n)
    {
        scalar sum = 0;
        for (label c = 0; c < nChanging; ++c)
        {
            sum += *gain++*x[changing[c]];
        }
        each += sum;
    }
}


void Foam::cghs::reactingCell::look(const label i, const scalar* x) const
{
    // What the others do does not change it
    bool known = i == looked_;
    scalar* looked = lookedX_.data();
    for (const label c : inputs_.changing())
    {
        known = known && *looked == x[c];
        *looked++ = x[c];
    }
    if (nEnergies_)
    {
        known = known && *looked == x[nReactions_];
        *looked = x[nReactions_];
    }
    if (known)
    {
        return;
    }
    looked_ = i;

    std::copy_n(&amounts_[i*nSolids_], nSolids_, n_.begin());
    addGains(x, n_);

    if (nEnergies_)
    {
        T_[i] = temperatureOf
        (
            scheme_.solids(),
            n_.cdata(),
            enthalpy_[i] + x[nReactions_],
            T_[i],
            leastCapacity(i),
            fluidT_
        );
    }

    for (label p = inputs_.nOfFluid(); p < values_.size(); ++p)
    {
        values_[p] = valueOf(inputs_.list()[p].what, i);
    }
}


Foam::scalar Foam::cghs::reactingCell::diameter(const label i) const
{
    if (!scheme_.constantDensity())
    {
        return bodies_[i].d;
    }

    const scalar V = max(scheme_.solids().volumeOf(n_), VSMALL)/bodies_[i].W;
    return std::cbrt(6*V/constant::mathematical::pi);
}


Foam::scalar Foam::cghs::reactingCell::fluidVolume() const
{
    return p_ > 0 ? total_*molarR*fluidT_/p_ : volume_;
}


void Foam::cghs::reactingCell::share(const scalar* z)
{
    now_ = z;
    total_ = 0;
    for (label k = 0; k < nFluid_; ++k)
    {
        total_ += z[k];
    }

    // What a step tries may be anything
    total_ = max(total_, 1e-12*startTotal_ + nothing);

    if (nEnergies_)
    {
        fluidT_ = fluidTemperatureOf(z, fluidT_);

        scalar C = VSMALL;
        for (label k = 0; k < nFluid_; ++k)
        {
            fluidH_[k] = scheme_.fluid()[k].h(fluidT_);
            fluidCp_[k] = scheme_.fluid()[k].Cp(fluidT_);
            C += z[k]*fluidCp_[k];
        }
        for (label k = 0; k < nFluid_; ++k)
        {
            dTdz_[k] = -fluidH_[k]/C;
        }
        dTdz_[nFluid_] = 1/C;
    }

    const scalar V = fluidVolume();
    for (label k = 0; k < nFluid_; ++k)
    {
        concentration_[k] = z[k]/V;
    }
    for (label p = 0; p < inputs_.nOfFluid(); ++p)
    {
        const rateArgument& what = inputs_.list()[p].what;
        values_[p] =
            what.what == rateArgument::fluid
          ? concentration_[what.index]
          : fluidT_;
    }
}


const Foam::UList<Foam::scalar>& Foam::cghs::reactingCell::views()
{
    views_ = 0;
    for (label p = 0; p < inputs_.nOfFluid(); ++p)
    {
        if (inputs_.list()[p].view >= 0)
        {
            findView(inputs_.list()[p]);
        }
    }
    if (inputs_.totalView() >= 0)
    {
        std::fill_n
        (
            &views_[inputs_.totalView()*(nFluid_ + nEnergies_)], nFluid_, 1
        );
    }
    return views_;
}


void Foam::cghs::reactingCell::findView(const rateInputs::input& in)
{
    const label nShared = nFluid_ + nEnergies_;
    scalar* slopes = &views_[in.view*nShared];

    if (in.what.what == rateArgument::fluidTemperature)
    {
        std::copy(dTdz_.begin(), dTdz_.end(), slopes);
        return;
    }

    // Of a concentration
    if (p_ > 0)
    {
        const scalar c = concentration_[in.what.index];
        for (label j = 0; j < nShared; ++j)
        {
            slopes[j] = -c/fluidT_*dTdz_[j] - (j < nFluid_ ? c/total_ : 0);
        }
    }
    slopes[in.what.index] += 1/fluidVolume();
}

// * * * * * * * * * * * * * * * * The rates * * * * * * * * * * * * * * * * //

Foam::scalar Foam::cghs::reactingCell::valueOf
(
    const rateArgument& what,
    const label i
) const
{
    switch (what.what)
    {
        case rateArgument::temperature: return T_[i];
        case rateArgument::diameter: return diameter(i);
        case rateArgument::mass:
        {
            return scheme_.solids().massOf(n_)/bodies_[i].W;
        }
        case rateArgument::film: return bodies_[i].film;
        case rateArgument::solid: return n_[what.index]/bodies_[i].W;
        case rateArgument::fluid:
        case rateArgument::fluidTemperature: break;
    }
    return 0;
}


Foam::scalar Foam::cghs::reactingCell::limit
(
    const reaction& r,
    const rateArgument& reactant,
    const label i,
    scalar& derivative
) const
{
    const bool fluid = reactant.what == rateArgument::fluid;
    const scalar n = max
    (
        fluid ? concentration_[reactant.index] : n_[reactant.index],
        scalar(0)
    );
    const scalar small =
        r.vanishing()
       *(fluid ? total_/fluidVolume() : bodies_[i].amount) + nothing;

    // Squares of what is so small may be no numbers
    const scalar sum = n + small;
    derivative = small/sum/sum;
    return n/sum;
}


Foam::scalar Foam::cghs::reactingCell::lasting
(
    const reaction& r,
    scalar& derivative
) const
{
    derivative = 0;
    if (!isGas() || !r.takesFluid())
    {
        return 1;
    }

    // A gas of nothing else is as dense to its end
    const scalar small = r.vanishing()*startTotal_ + nothing;
    const scalar sum = max(total_, scalar(0)) + small;
    derivative = small/sum/sum;
    return max(total_, scalar(0))/sum;
}


Foam::scalar Foam::cghs::reactingCell::rate
(
    const reaction& r,
    const rateInputs::places& places,
    const label i
) const
{
    scalar x[kineticLaw::maxArguments];
    gather(places, x);

    scalar ignored;
    scalar result = r.law().rate(x)*lasting(r, ignored);
    for (const rateArgument& reactant : r.limits())
    {
        scalar derivative;
        result *= limit(r, reactant, i, derivative);
    }
    return result;
}


void Foam::cghs::reactingCell::addDerivative
(
    const label place,
    const scalar slope,
    scalar* fx,
    scalar* fq
) const
{
    const rateInputs::input& in = inputs_.list()[place];
    if (in.view >= 0)
    {
        fq[in.view] += slope;
    }
    if (in.row >= 0)
    {
        const label nActive = inputs_.active().size();
        const scalar* slopes = &slopes_[in.row*nActive];
        for (label j = 0; j < nActive; ++j)
        {
            fx[j] += slope*slopes[j];
        }
    }
}


Foam::scalar Foam::cghs::reactingCell::rate
(
    const reaction& r,
    const rateInputs::places& places,
    const label i,
    const scalar times,
    scalar* fx,
    scalar* fq
) const
{
    scalar x[kineticLaw::maxArguments];
    scalar dx[kineticLaw::maxArguments];
    gather(places, x);
    const scalar free = r.law().rate(x, dx);

    const UList<rateArgument>& limits = r.limits();
    scalar byTotal;
    const scalar lasts = lasting(r, byTotal);
    scalar all = lasts;
    byTotal *= times*free;
    forAll(limits, l)
    {
        scalar slope;
        const scalar one = limit(r, limits[l], i, slope);
        all *= one;
        byTotal *= one;

        // The others as they are
        slope *= times*free*lasts;
        forAll(limits, m)
        {
            scalar ignored;
            slope *= m == l ? 1 : limit(r, limits[m], i, ignored);
        }

        // That of a solid is by all particles, an input by one
        if (limits[l].what == rateArgument::solid)
        {
            slope *= bodies_[i].W;
        }
        addDerivative(places.limits[l], slope, fx, fq);
    }

    forAll(places.arguments, a)
    {
        addDerivative(places.arguments[a], times*all*dx[a], fx, fq);
    }
    if (byTotal != 0)
    {
        fq[inputs_.totalView()] += byTotal;
    }
    return times*free*all;
}


Foam::scalar Foam::cghs::reactingCell::enthalpyTaken
(
    const label r,
    const scalar T,
    scalar& byT,
    scalar& byFluidT
) const
{
    const substances& fluid = scheme_.fluid();
    const scalar share = scheme_.inParticles()[r].heatToFluid();

    scalar q = 0;
    byT = 0;
    byFluidT = 0;
    for (const carrier& c : carriers_[r])
    {
        q += c.in*fluidH_[c.k] - c.out*fluid[c.k].h(T);
        byT -= c.out*fluid[c.k].Cp(T);
        byFluidT += c.in*fluidCp_[c.k];
    }
    if (share > 0)
    {
        const substances& solids = scheme_.solids();
        const scalarField& gains =
            scheme_.inParticles()[r].equation().solidGain();
        forAll(solids, s)
        {
            const scalar gain = share*gains[s];
            q += gain*solids[s].h(T);
            byT += gain*solids[s].Cp(T);
        }
    }
    return q;
}


void Foam::cghs::reactingCell::rates
(
    const label i,
    const scalar* x,
    scalar* f
)
{
    look(i, x);

    scalar power = nEnergies_*bodies_[i].conductance*(fluidT_ - T_[i]);
    for (label r = 0; r < nReactions_; ++r)
    {
        f[r] = bodies_[i].W*rateIn(i, r);
        if (nEnergies_)
        {
            scalar byT, byFluidT;
            power += f[r]*enthalpyTaken(r, T_[i], byT, byFluidT);
        }
    }
    if (nEnergies_)
    {
        f[nReactions_] = power;
    }
}


void Foam::cghs::reactingCell::findTemperatureSlopes
(
    const label i,
    scalar* slopes
)
{
    const substances& solids = scheme_.solids();
    const UList<label>& active = inputs_.active();
    const label nChanging = inputs_.changing().size();

    scalar C = 0;
    forAll(solids, s)
    {
        h_[s] = solids[s].h(T_[i]);
        C += n_[s]*solids[s].Cp(T_[i]);
    }
    if (!(C > leastCapacity(i)))
    {
        std::fill_n(slopes, active.size(), 0);
        return;
    }

    // What changes a particle changes its T: these are the active ones
    for (label c = 0; c < nChanging; ++c)
    {
        scalar taken = 0;
        forAll(h_, s)
        {
            taken += solidGain_[s*nChanging + c]*h_[s];
        }
        slopes[c] = -taken/C;
    }
    slopes[nChanging] = 1/C;
}


Foam::scalar Foam::cghs::reactingCell::slope
(
    const rateArgument& what,
    const label r,
    const label i
) const
{
    switch (what.what)
    {
        case rateArgument::solid:
        {
            const reaction& one = scheme_.inParticles()[r];
            return one.equation().solidGain()[what.index]/bodies_[i].W;
        }
        case rateArgument::mass: return massGain_[r]/bodies_[i].W;
        case rateArgument::diameter:
        {
            const scalar V = scheme_.solids().volumeOf(n_);
            return V > VSMALL ? diameter(i)*volumeGain_[r]/(3*V) : 0;
        }
        case rateArgument::temperature:
        case rateArgument::fluid:
        case rateArgument::fluidTemperature:
        case rateArgument::film: break;
    }
    return 0;
}


void Foam::cghs::reactingCell::findSlopes(const label i)
{
    const UList<label>& active = inputs_.active();

    for (label p = inputs_.nOfFluid(); p < values_.size(); ++p)
    {
        const rateInputs::input& in = inputs_.list()[p];
        if (in.row < 0)
        {
            continue;
        }

        scalar* slopes = &slopes_[in.row*active.size()];
        if (in.row == inputs_.temperatureRow())
        {
            findTemperatureSlopes(i, slopes);
            continue;
        }
        for (label j = 0; j + nEnergies_ < active.size(); ++j)
        {
            slopes[j] = slope(in.what, active[j], i);
        }
    }
}


void Foam::cghs::reactingCell::derivatives
(
    const label i,
    const scalar* x,
    scalar* f,
    scalar* fx,
    scalar* fq
)
{
    const label a = inputs_.active().size();
    const label m = inputs_.nSeen();
    std::fill_n(fx, nExtents()*a, 0);
    std::fill_n(fq, nExtents()*m, 0);

    look(i, x);
    findSlopes(i);

    for (label r = 0; r < nReactions_; ++r)
    {
        f[r] = rate
        (
            scheme_.inParticles()[r],
            inputs_.inParticles(r),
            i,
            bodies_[i].W,
            fx + r*a,
            fq + r*m
        );
    }
    if (nEnergies_)
    {
        addEnergy(i, f, fx, fq);
    }
}


void Foam::cghs::reactingCell::addEnergy
(
    const label i,
    scalar* f,
    scalar* fx,
    scalar* fq
) const
{
    const label a = inputs_.active().size();
    const label m = inputs_.nSeen();
    const scalar k = bodies_[i].conductance;
    scalar* ex = fx + nReactions_*a;
    scalar* eq = fq + nReactions_*m;

    f[nReactions_] = k*(fluidT_ - T_[i]);
    scalar byT = -k;
    scalar byFluidT = k;

    for (label r = 0; r < nReactions_; ++r)
    {
        scalar qByT, qByFluidT;
        const scalar q = enthalpyTaken(r, T_[i], qByT, qByFluidT);
        f[nReactions_] += f[r]*q;
        byT += f[r]*qByT;
        byFluidT += f[r]*qByFluidT;

        for (label c = 0; c < a; ++c)
        {
            ex[c] += fx[r*a + c]*q;
        }
        for (label c = 0; c < m; ++c)
        {
            eq[c] += fq[r*m + c]*q;
        }
    }

    const scalar* slopes = &slopes_[inputs_.temperatureRow()*a];
    for (label c = 0; c < a; ++c)
    {
        ex[c] += byT*slopes[c];
    }
    eq[inputs_.temperatureView()] += byFluidT;
}


void Foam::cghs::reactingCell::ownRates(scalar* f)
{
    const scalar V = fluidVolume();
    forAll(scheme_.inFluid(), r)
    {
        f[r] = V*fluidRate(r);
    }
}


void Foam::cghs::reactingCell::ownDerivatives(scalar* f, scalar* fq)
{
    const label v = nViews();
    const scalar V = fluidVolume();
    std::fill_n(fq, scheme_.inFluid().size()*v, 0);

    forAll(scheme_.inFluid(), r)
    {
        scalar* row = fq + r*v;
        f[r] = rate
        (
            scheme_.inFluid()[r], inputs_.inFluid(r), -1, V, nullptr, row
        );

        if (p_ > 0)
        {
            // A gas takes the volume that it needs
            row[inputs_.totalView()] += f[r]/total_;
            if (nEnergies_)
            {
                row[inputs_.temperatureView()] += f[r]/fluidT_;
            }
        }
    }
}

// * * * * * * * * * * * * * * What is good enough * * * * * * * * * * * * * //

Foam::scalar Foam::cghs::reactingCell::error
(
    const label i,
    const scalar* x,
    const scalar* dx
) const
{
    const substances& solids = scheme_.solids();
    const scalar least = tolerances_.absolute*bodies_[i].amount + VSMALL;

    look(i, x);
    dn_ = 0;
    addGains(dx, dn_);

    scalar worst = 0;
    scalar dH = nEnergies_ ? dx[nReactions_] : 0;
    scalar C = tolerances_.absolute*bodies_[i].capacity + VSMALL;
    forAll(solids, s)
    {
        const scalar dn = dn_[s];
        worst = max
        (
            worst,
            over(mag(dn), least + tolerances_.relative*mag(n_[s]))
        );
        if (nEnergies_)
        {
            dH -= dn*solids[s].h(T_[i]);
            C += n_[s]*solids[s].Cp(T_[i]);
        }
    }
    return
        nEnergies_
      ? max(worst, over(mag(dH), C*tolerances_.relative*T_[i]))
      : worst;
}


Foam::scalar Foam::cghs::reactingCell::sharedError
(
    const scalar* z,
    const scalar* dz
) const
{
    const substances& fluid = scheme_.fluid();
    const scalar least = tolerances_.absolute*startTotal_ + nothing;

    scalar T = fluidT_;
    scalar dH = 0;
    scalar C = VSMALL;
    if (nEnergies_)
    {
        T = fluidTemperatureOf(z, T);
        dH = dz[nFluid_];
    }

    scalar worst = 0;
    for (label k = 0; k < nFluid_; ++k)
    {
        worst = max
        (
            worst,
            over(mag(dz[k]), least + tolerances_.relative*mag(z[k]))
        );
        if (nEnergies_)
        {
            dH -= dz[k]*fluid[k].h(T);
            C += z[k]*fluid[k].Cp(T);
        }
    }
    return
        nEnergies_
      ? max(worst, over(mag(dH), C*tolerances_.relative*T))
      : worst;
}


bool Foam::cghs::reactingCell::allows(const label i, const scalar* x) const
{
    look(i, x);
    return
        (n_.empty() || min(n_) >= -rounding*bodies_[i].amount)
     && T_[i] > coldest && T_[i] < hottest;
}


bool Foam::cghs::reactingCell::allowsShared(const scalar* z) const
{
    scalar least = 0;
    for (label k = 0; k < nFluid_; ++k)
    {
        least = min(least, z[k]);
    }

    if (nEnergies_)
    {
        const scalar T = fluidTemperatureOf(z, fluidT_);
        if (!(T > coldest && T < hottest))
        {
            return false;
        }
    }
    return least >= -rounding*startTotal_;
}
