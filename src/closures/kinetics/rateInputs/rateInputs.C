/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "rateInputs.H"

namespace Foam
{
namespace cghs
{

// That there is one of the fluid, and one of a particle
static const rateArgument fluidTemperature =
{
    rateArgument::fluidTemperature, -1
};
static const rateArgument temperature = {rateArgument::temperature, -1};


static bool isOfFluid(const rateArgument& what)
{
    return
        what.what == rateArgument::fluid
     || what.what == rateArgument::fluidTemperature;
}


//- In the fluid there is one temperature
static rateArgument meant(const rateArgument& what, const reaction& r)
{
    return
        r.inFluid() && what.what == rateArgument::temperature
      ? fluidTemperature
      : what;
}


static bool changesSolids(const reaction& r)
{
    return sum(mag(r.equation().solidGain())) > 0;
}


static bool takesFluid(const PtrList<reaction>& reactions)
{
    for (const reaction& r : reactions)
    {
        if (r.takesFluid())
        {
            return true;
        }
    }
    return false;
}

} // End namespace cghs
} // End namespace Foam

// * * * * * * * * * * * * * * * Construction  * * * * * * * * * * * * * * * //

Foam::cghs::rateInputs::rateInputs(const reactionScheme& scheme)
:
    scheme_(scheme),
    nOfFluid_(0),
    nViews_(0),
    nSeen_(0),
    totalView_(-1),
    temperatureView_(-1),
    nRows_(0),
    temperatureRow_(-1),
    inParticles_(scheme.inParticles().size()),
    inFluid_(scheme.inFluid().size())
{
    seeFluid(scheme.inParticles());
    if (scheme.energetic())
    {
        // By convection, too
        temperatureView_ = inputs_[placeOf(fluidTemperature)].view;
    }
    if (takesFluid(scheme.inParticles()))
    {
        seeTotal();
    }
    nSeen_ = nViews_;

    seeFluid(scheme.inFluid());
    if (scheme.inFluid().size())
    {
        // They are as fast as there is room for them
        seeTotal();
    }
    nOfFluid_ = inputs_.size();

    place(scheme.inParticles(), inParticles_);
    place(scheme.inFluid(), inFluid_);
    if (scheme.energetic())
    {
        placeOf(temperature);
    }
    findChanging();
    findActive();
}


Foam::label Foam::cghs::rateInputs::placeOf(const rateArgument& what)
{
    forAll(inputs_, p)
    {
        const rateArgument& known = inputs_[p].what;
        if (known.what == what.what && known.index == what.index)
        {
            return p;
        }
    }

    const bool changes =
        what.what == rateArgument::fluid
     || (what.what == rateArgument::fluidTemperature && scheme_.energetic());

    inputs_.append({what, changes ? nViews_++ : -1, -1});
    return inputs_.size() - 1;
}


void Foam::cghs::rateInputs::seeFluid(const PtrList<reaction>& reactions)
{
    for (const reaction& r : reactions)
    {
        const UList<rateArgument>* const lists[] =
        {
            &r.law().arguments(), &r.limits()
        };
        for (const UList<rateArgument>* list : lists)
        {
            for (const rateArgument& a : *list)
            {
                if (isOfFluid(meant(a, r)))
                {
                    placeOf(meant(a, r));
                }
            }
        }
    }
}


void Foam::cghs::rateInputs::seeTotal()
{
    if (totalView_ < 0)
    {
        totalView_ = nViews_++;
    }
}


void Foam::cghs::rateInputs::place
(
    const PtrList<reaction>& reactions,
    List<places>& found
)
{
    forAll(reactions, i)
    {
        const reaction& r = reactions[i];
        for (const rateArgument& a : r.law().arguments())
        {
            found[i].arguments.append(placeOf(meant(a, r)));
        }
        for (const rateArgument& a : r.limits())
        {
            found[i].limits.append(placeOf(a));
        }
    }
}


bool Foam::cghs::rateInputs::changes
(
    const rateArgument& what,
    const reaction& r
) const
{
    const substances& solids = scheme_.solids();
    const scalarField& gain = r.equation().solidGain();

    switch (what.what)
    {
        case rateArgument::solid: return gain[what.index] != 0;
        case rateArgument::mass: return solids.massOf(gain) != 0;
        case rateArgument::diameter:
        {
            return
                scheme_.constantDensity() && solids.volumeOf(gain) != 0;
        }
        case rateArgument::temperature:
        {
            // By its heat capacity and what it holds of heat
            return scheme_.energetic() && changesSolids(r);
        }
        case rateArgument::fluid:
        case rateArgument::fluidTemperature:
        case rateArgument::film: break;
    }
    return false;
}


void Foam::cghs::rateInputs::findChanging()
{
    forAll(scheme_.inParticles(), r)
    {
        if (changesSolids(scheme_.inParticles()[r]))
        {
            changing_.append(r);
        }
    }
}


void Foam::cghs::rateInputs::findActive()
{
    const PtrList<reaction>& reactions = scheme_.inParticles();
    boolList acts(reactions.size(), false);

    for (label p = nOfFluid_; p < inputs_.size(); ++p)
    {
        input& in = inputs_[p];
        const bool isT = in.what.what == rateArgument::temperature;

        bool any = isT && scheme_.energetic();
        forAll(reactions, r)
        {
            const bool does = changes(in.what, reactions[r]);
            acts[r] = acts[r] || does;
            any = any || does;
        }
        if (any)
        {
            in.row = nRows_++;
            temperatureRow_ = isT ? in.row : temperatureRow_;
        }
    }

    forAll(acts, r)
    {
        if (acts[r])
        {
            active_.append(r);
        }
    }
    if (scheme_.energetic())
    {
        active_.append(reactions.size());
    }
}
