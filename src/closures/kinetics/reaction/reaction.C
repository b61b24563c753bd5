/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "reaction.H"
#include "checkedEntry.H"
#include "knownEntries.H"
#include "HashSet.H"

namespace Foam
{
namespace cghs
{

//- What the rate depends on that only particles have
static wordHashSet ofParticles(const kineticLaw& law)
{
    wordHashSet found;
    for (const rateArgument& a : law.arguments())
    {
        switch (a.what)
        {
            case rateArgument::diameter: found.insert("diameter"); break;
            case rateArgument::mass: found.insert("mass"); break;
            case rateArgument::film: found.insert("film"); break;
            case rateArgument::solid: found.insert("solids"); break;

            // In the fluid there is one temperature
            case rateArgument::temperature:
            case rateArgument::fluidTemperature:
            case rateArgument::fluid: break;
        }
    }
    return found;
}

} // End namespace cghs
} // End namespace Foam


Foam::cghs::reaction::reaction
(
    const word& name,
    const dictionary& dict,
    const substances& fluid,
    const substances& solids
)
:
    name_(name),
    equation_(dict, fluid, solids),
    law_(kineticLaw::New(dict, equation_)),
    heatToFluid_(dict.getOrDefault<scalar>("heatToFluid", 0)),
    vanishing_(dict.getOrDefault<scalar>("vanishing", 1e-6)),
    takesFluid_(sum(equation_.fluidGain()) < 0)
{
    checkRange(dict, "heatToFluid", heatToFluid_, scalar(0), scalar(1));
    checkPositive(dict, "vanishing", vanishing_);

    if (inFluid() && equation_.hasSolid())
    {
        FatalIOErrorInFunction(dict)
            << "Reaction " << name << " happens in the fluid, by its entry of,"
            << " but its equation has solids" << nl
            << "Count its rate by particles, or leave the solids out" << nl
            << exit(FatalIOError);
    }
    const wordHashSet particles(ofParticles(law_()));

    if (inFluid() && particles.size())
    {
        FatalIOErrorInFunction(dict)
            << "Reaction " << name << " happens in the fluid, by its entry of,"
            << " but its rate depends on " << flatOutput(particles.sortedToc())
            << " of particles" << nl
            << "Count its rate by particles, or let it depend on species and T"
            << nl
            << exit(FatalIOError);
    }

    warnUnknown(dict);
    findLimits();
}


void Foam::cghs::reaction::warnUnknown(const dictionary& dict) const
{
    const wordList ofLaw(law_->entries());
    if (ofLaw.size())
    {
        wordList known
        ({
            "equation", "lumped", "remainder", "rate", "heatToFluid",
            "vanishing"
        });
        known.append(ofLaw);

        // Others may be a user's variables, or those of a law of his own
        warnUnknownEntries(dict, known, true);
    }
}


void Foam::cghs::reaction::findLimits()
{
    const scalarField gain(equation_.fluidGain());
    forAll(gain, k)
    {
        const rateArgument reactant = {rateArgument::fluid, k};
        if (gain[k] < 0 && !law_->follows(reactant))
        {
            limits_.append(reactant);
        }
    }
    forAll(equation_.solidGain(), s)
    {
        const rateArgument reactant = {rateArgument::solid, s};
        if (equation_.solidGain()[s] < 0 && !law_->follows(reactant))
        {
            limits_.append(reactant);
        }
    }
}
