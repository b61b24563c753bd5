/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "shrinkingCore.H"
#include "unreactedCore.H"
#include "knownEntries.H"
#include "mathematicalConstants.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(shrinkingCore, 0);
    addToRunTimeSelectionTable(kineticLaw, shrinkingCore, dictionary);
    describeModel
    (
        kineticLaw,
        shrinkingCore,
        "through film, ash and at the core's surface"
    );


// Thickness of a layer that has nothing beside it, over the radius
static const scalar leastLayer = 1e-5;

// A film is no worse [m/s]
static const scalar leastFilm = 1e-30;

} // End namespace cghs
} // End namespace Foam


Foam::cghs::shrinkingCore::shrinkingCore
(
    const dictionary& dict,
    const reactionEquation& equation
)
:
    coefficient_(0),
    hasFilm_(false),
    film_(0),
    hasLayer_(dict.found("layer")),
    fresh_(0),
    D_(0),
    diameterAt_(need(dict, rateArgument::diameter)),
    fluidAt_(-1),
    filmAt_(-1),
    solidAt_(-1),
    temperatureAt_(-1)
{
    const label k = fluidReactant(dict, "reactant", equation);
    coefficient_ = equation.fluidReactants()[k];
    fluidAt_ = need(dict, rateArgument::fluid, k);

    readFilm(dict);
    readLayer(dict, equation);
    readSurface(dict);

    if (!hasFilm_ && D_ == 0 && !surface_.valid())
    {
        FatalIOErrorInFunction(dict)
            << "Nothing resists: neither a film, nor D of a layer, nor a"
            << " surface is given, and the rate is infinite" << nl
            << "Add film yes; or surface { A ...; Ea ...; } or D to the layer"
            << nl << exit(FatalIOError);
    }
}


void Foam::cghs::shrinkingCore::readFilm(const dictionary& dict)
{
    const token t(dict.lookup("film"));

    if (t.isNumber())
    {
        film_ = t.number();
        checkPositive(dict, "film", film_);
        hasFilm_ = true;
        return;
    }

    hasFilm_ = dict.get<bool>("film");
    if (hasFilm_)
    {
        filmAt_ = need(dict, rateArgument::film);
    }
}


void Foam::cghs::shrinkingCore::readLayer
(
    const dictionary& dict,
    const reactionEquation& equation
)
{
    if (!hasLayer_)
    {
        return;
    }

    dictionary layer(dict.subDict("layer"));
    warnUnknownEntries(layer, wordList({"solid", "fresh", "D"}));

    // What complains about a reactant shows the equation
    layer.add("equation", dict.get<string>("equation"));
    const label s = solidReactant(layer, "solid", equation);
    solidAt_ = need(dict, rateArgument::solid, s);
    fresh_ = positiveScalar(layer, "fresh")/equation.solids()[s].M();
    if (layer.found("D"))
    {
        D_ = positiveScalar(layer, "D");
    }
}


void Foam::cghs::shrinkingCore::readSurface(const dictionary& dict)
{
    if (dict.found("surface"))
    {
        warnUnknownEntries(dict.subDict("surface"), arrhenius::entries());
        surface_.reset(new arrhenius(dict.subDict("surface")));
        if (surface_->varies())
        {
            temperatureAt_ = need(dict, rateArgument::temperature);
        }
    }
}


Foam::wordList Foam::cghs::shrinkingCore::entries() const
{
    return wordList({"reactant", "film", "layer", "surface"});
}


bool Foam::cghs::shrinkingCore::follows(const rateArgument& reactant) const
{
    // The film alone does not know what is left
    return
        isArgument(fluidAt_, reactant)
     || (isArgument(solidAt_, reactant) && (D_ > 0 || surface_.valid()));
}


template<class Number>
Number Foam::cghs::shrinkingCore::conductance(const Number* x) const
{
    const Number film
    (
        filmAt_ < 0 ? Number(film_) : Number(x[filmAt_] + leastFilm)
    );
    if (D_ == 0 && !surface_.valid())
    {
        return film;
    }

    // Without a layer there is nothing but core
    const Number R(0.5*x[diameterAt_]);
    const unreactedCore<Number> core
    (
        hasLayer_
      ? unreactedCore<Number>(x[solidAt_], x[diameterAt_], fresh_)
      : unreactedCore<Number>(Number(1))
    );
    const Number radius(hasLayer_ ? core.radius : Number(1));
    const Number section(hasLayer_ ? core.section : Number(1));

    if (surface_.valid())
    {
        const Number k(surface_()(argumentOr(x, temperatureAt_, 300)));
        Number before(0);
        if (hasFilm_)
        {
            before += section/film;
        }
        if (D_ > 0)
        {
            before += R*core.g*core.layer()/D_;
        }
        return section*k/(1 + k*before);
    }

    return
        hasFilm_
      ? Number(radius*D_/(R*core.layer() + radius*D_/film))
      : Number(radius*D_/(R*(core.layer() + leastLayer)));
}


template<class Number>
Number Foam::cghs::shrinkingCore::law(const Number* x) const
{
    using constant::mathematical::pi;

    const Number& d = x[diameterAt_];
    return conductance(x)*x[fluidAt_]*d*d*(pi/coefficient_);
}
