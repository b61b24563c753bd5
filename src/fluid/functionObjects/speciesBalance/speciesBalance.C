/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "speciesBalance.H"
#include "atomicWeights.H"
#include "cghsCloud.H"
#include "constantDictionary.H"
#include "knownEntries.H"
#include "meshNames.H"
#include "reactions.H"
#include "PstreamReduceOps.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(speciesBalance, 0);
    addToRunTimeSelectionTable(functionObject, speciesBalance, dictionary);
    describeFunction
    (
        speciesBalance,
        "species and elements in and out, conversion, yields"
    );
}
}

// * * * * * * * * * * * * * * * Construction  * * * * * * * * * * * * * * * //

Foam::cghs::speciesBalance::speciesBalance
(
    const word& name,
    const Time& time,
    const dictionary& dict
)
:
    cloudFunctionObject(name, time, dict),
    nSpecies_(0),
    substances_(),
    elements_(),
    fractions_(),
    patches_(),
    reactant_(-1),
    products_(),
    basis_(),
    passage_(),
    content_(),
    step_(-1),
    means_(*this, mesh_, typeName)
{
    read(dict);
}


bool Foam::cghs::speciesBalance::read(const dictionary& dict)
{
    warnUnknownOfFunction
    (
        dict,
        wordList({"cloud", "patches", "reactant", "products", "basis"})
    );

    cloudFunctionObject::read(dict);

    findSubstances(dict);
    findElements();
    findPatches(dict);
    findProducts(dict);

    const DynamicList<quantity> list(quantities(none(), 1));
    wordList names(list.size());
    labelList over(list.size());
    forAll(list, q)
    {
        names[q] = list[q].name;
        over[q] = list[q].over;
    }
    means_.start(names, dict, "Entries patches, reactant and products", over);

    return true;
}


const Foam::cghs::reactions* Foam::cghs::speciesBalance::reacting() const
{
    for (const exchange& e : theCloud().exchanges())
    {
        if (isA<reactions>(e))
        {
            return &refCast<const reactions>(e);
        }
    }

    return nullptr;
}


const Foam::cghs::reactionScheme* Foam::cghs::speciesBalance::scheme() const
{
    const reactions* r = reacting();

    return r ? &r->scheme() : nullptr;
}


const Foam::cghs::speciesBudgets&
Foam::cghs::speciesBalance::budgets() const
{
    return mesh_.lookupObject<speciesBudgets>(speciesBudgets::typeName);
}


void Foam::cghs::speciesBalance::findSubstances(const dictionary& dict)
{
    if
    (
        postProcess
     || !mesh_.foundObject<speciesBudgets>(speciesBudgets::typeName)
    )
    {
        FatalIOErrorInFunction(dict)
            << "There is no fluid that transports species"
            << (postProcess ? ", as balances are not written" : "") << nl
            << (
                   postProcess
                 ? "Have the function object in controlDict during the run"
                 : "Write transported (species); in the solution of the"
                   " cloud's properties"
               )
            << nl << exit(FatalIOError);
    }

    substances_ = budgets().names();
    nSpecies_ = substances_.size();

    wordList solids;
    if (scheme())
    {
        for (const word& solid : scheme()->solids().names())
        {
            solids.append("Y." + solid);
        }
    }
    substances_.append(solids);

    passage_ = std::make_shared<solidsPassage>(solids);
    parcels().watchedBy(passage_);
    content_ = solidsContent();
    step_ = mesh_.time().timeIndex();
}


Foam::scalarField& Foam::cghs::speciesBalance::fractionsOf
(
    const word& element
)
{
    const label known = elements_.find(element);

    if (known >= 0)
    {
        return fractions_[known];
    }

    elements_.append(element);
    fractions_.append(scalarField(substances_.size(), Zero));

    return fractions_.last();
}


void Foam::cghs::speciesBalance::addElements(const substances& list)
{
    const atomicWeightTable weights;

    for (const substance& s : list)
    {
        const label known = substances_.find(s.name());
        const label k =
            known >= 0 ? known : substances_.find("Y." + s.name());

        for (const word& element : s.elements().sortedToc())
        {
            fractionsOf(element)[k] =
                1e-3*s.elements()[element]*weights[element]/s.M();
        }
        if (s.elements().empty())
        {
            fractionsOf(s.name())[k] = 1;
        }
    }
}


void Foam::cghs::speciesBalance::findElements()
{
    elements_.clear();
    fractions_.clear();

    if (scheme())
    {
        addElements(scheme()->fluid());
        addElements(scheme()->solids());
    }
    else if (mesh_.foundObject<IOdictionary>("thermophysicalProperties"))
    {
        const IOdictionary thermophysics
        (
            constantDictionary(mesh_, "thermophysicalProperties")
        );
        const wordList names(budgets().names());

        if (thermophysics.found("species"))
        {
            addElements(substances(names, thermophysics, word()));
        }
    }

    if (elements_.size())
    {
        fractionsOf("mass") = 1;
    }
}


void Foam::cghs::speciesBalance::findPatches(const dictionary& dict)
{
    const wordList names(dict.getOrDefault("patches", wordList()));

    patches_.resize(names.size());
    forAll(names, i)
    {
        patches_[i] = patchNamed(names[i], "patches", dict, mesh_);
    }
}

// * * * * * * * * * * * * * Conversion and yields * * * * * * * * * * * * * //

Foam::label Foam::cghs::speciesBalance::substanceNamed
(
    const word& name,
    const word& entry,
    const dictionary& dict
) const
{
    const label k = substances_.find(name);

    if (k < 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << entry << " names " << name
            << ", which is none of the substances" << nl
            << "Valid choices: " << flatOutput(substances_) << nl
            << exit(FatalIOError);
    }

    return k;
}


void Foam::cghs::speciesBalance::findBasis(const dictionary& dict)
{
    const word basis(dict.get<word>("basis"));
    const label e = elements_.find(basis);

    if (e < 0 && basis != "mass")
    {
        wordList valid(elements_);
        valid.append(elements_.found("mass") ? wordList() : wordList({"mass"}));

        FatalIOErrorInFunction(dict)
            << "Entry basis is " << basis << nl
            << "Valid choices: " << flatOutput(valid) << nl
            << exit(FatalIOError);
    }

    basis_ = e < 0 ? scalarField(substances_.size(), 1) : fractions_[e];

    if (!(basis_[reactant_] > 0))
    {
        FatalIOErrorInFunction(dict)
            << "Entry basis is " << basis << " but the reactant "
            << substances_[reactant_] << " has none of it" << nl
            << "Choose one that it has, or mass" << nl
            << exit(FatalIOError);
    }
}


void Foam::cghs::speciesBalance::findProducts(const dictionary& dict)
{
    const wordList names(dict.getOrDefault("products", wordList()));

    reactant_ = -1;
    products_.resize(names.size());

    if (dict.found("reactant"))
    {
        reactant_ =
            substanceNamed(dict.get<word>("reactant"), "reactant", dict);
    }
    else if (names.size())
    {
        FatalIOErrorInFunction(dict)
            << "There are products, but no reactant that they come from" << nl
            << "Add an entry reactant, one of " << flatOutput(substances_)
            << nl << exit(FatalIOError);
    }

    forAll(names, i)
    {
        products_[i] = substanceNamed(names[i], "products", dict);
    }
    if (names.size())
    {
        findBasis(dict);
    }
}

// * * * * * * * * * * * * * * * * The flows * * * * * * * * * * * * * * * * //

Foam::cghs::speciesBalance::flows Foam::cghs::speciesBalance::none() const
{
    const scalarField zero(substances_.size(), Zero);

    return flows{zero, zero, zero, zero, zero, zero};
}


Foam::scalarField Foam::cghs::speciesBalance::solidsContent() const
{
    scalarField content(passage_->content(parcels()));
    reduce(content, sumOp<scalarField>());

    return content;
}


Foam::cghs::speciesBalance::flows Foam::cghs::speciesBalance::flowsNow
(
    const scalar deltaT
)
{
    flows f(none());
    const speciesBudgets& fluid = budgets();

    for (label k = 0; k < nSpecies_; ++k)
    {
        const speciesBudget& b = fluid[k];

        f.in[k] = max(b.sources, scalar(0));
        f.out[k] = max(-b.sources, scalar(0));
        forAll(b.carried, patchi)
        {
            f.in[k] += max(b.through(patchi), scalar(0));
            f.out[k] += max(-b.through(patchi), scalar(0));
        }
        f.stored[k] = b.stored;
        f.gained[k] = b.parcels;
        f.content[k] = b.mass;
    }

    const scalarField in(passage_->takeIn()/deltaT);
    const scalarField out(passage_->takeOut()/deltaT);
    const scalarField content(solidsContent());

    forAll(content, s)
    {
        const label k = nSpecies_ + s;

        f.in[k] = in[s];
        f.out[k] = out[s];
        f.stored[k] = (content[s] - content_[s])/deltaT;
        f.gained[k] = f.stored[k] - in[s] + out[s];
        f.ahead[k] = reacting()->slow().ahead()[s]/deltaT;
        f.content[k] = content[s];
    }
    content_ = content;

    return f;
}


void Foam::cghs::speciesBalance::tellSubstance
(
    const label k,
    const flows& f,
    DynamicList<quantity>& list
) const
{
    const word ofIt('(' + substances_[k] + ')');

    list.append({"in" + ofIt, f.in[k], -1});
    list.append({"out" + ofIt, f.out[k], -1});
    list.append({"stored" + ofIt, f.stored[k], -1});
    list.append({"gained" + ofIt, f.gained[k], -1});
}


void Foam::cghs::speciesBalance::tellSpecies
(
    const flows& f,
    DynamicList<quantity>& list
) const
{
    for (label k = 0; k < nSpecies_; ++k)
    {
        const word& s = substances_[k];

        tellSubstance(k, f, list);
        list.append
        (
            {
                "defect(" + s + ')',
                f.stored[k] - f.in[k] + f.out[k] - f.gained[k],
                -1
            }
        );

        for (const label patchi : patches_)
        {
            list.append
            (
                {
                    "flow(" + s + ',' + mesh_.boundary()[patchi].name() + ')',
                    budgets()[k].through(patchi),
                    -1
                }
            );
        }
    }
}


void Foam::cghs::speciesBalance::tellSolids
(
    const flows& f,
    DynamicList<quantity>& list
) const
{
    for (label k = nSpecies_; k < substances_.size(); ++k)
    {
        tellSubstance(k, f, list);
    }
}


void Foam::cghs::speciesBalance::tellElements
(
    const flows& f,
    const scalar deltaT,
    DynamicList<quantity>& list
) const
{
    forAll(elements_, e)
    {
        const scalarField& w = fractions_[e];
        const word ofIt('(' + elements_[e] + ')');

        const scalar in = sum(w*f.in);
        const scalar out = sum(w*f.out);
        const scalar stored = sum(w*f.stored);
        const scalar ahead = sum(w*f.ahead);
        const scalar defect = stored - in + out - ahead;
        const scalar scale = sum(w*f.content) + (in + out)*deltaT;

        list.append({"element.in" + ofIt, in, -1});
        list.append({"element.out" + ofIt, out, -1});
        list.append({"element.stored" + ofIt, stored, -1});
        if (reacting() && reacting()->slow().clockRuns())
        {
            list.append({"element.ahead" + ofIt, ahead, -1});
        }
        list.append({"element.defect" + ofIt, defect, -1});
        list.append
        (
            {
                "element.relative" + ofIt,
                mag(defect)*deltaT/max(scale, VSMALL),
                -1
            }
        );
    }
}


void Foam::cghs::speciesBalance::tellConversion
(
    const flows& f,
    DynamicList<quantity>& list
) const
{
    if (reactant_ < 0)
    {
        return;
    }

    const label r = reactant_;
    const auto indexOf = [&](const word& name)
    {
        label q = 0;
        while (list[q].name != name)
        {
            ++q;
        }
        return q;
    };

    list.append
    (
        {
            "conversion",
            f.in[r] - f.out[r],
            indexOf("in(" + substances_[r] + ')')
        }
    );

    if (products_.empty())
    {
        return;
    }

    scalarField made(products_.size());
    forAll(made, i)
    {
        const label p = products_[i];
        made[i] = basis_[p]*(f.out[p] - f.in[p]);
    }

    list.append({"feed", basis_[r]*f.in[r], -1});
    list.append({"made", sum(made), -1});
    const label feed = list.size() - 2;

    forAll(made, i)
    {
        const word ofIt('(' + substances_[products_[i]] + ')');

        list.append({"yield" + ofIt, made[i], feed});
        list.append({"selectivity" + ofIt, made[i], feed + 1});
    }
}


Foam::DynamicList<Foam::cghs::speciesBalance::quantity>
Foam::cghs::speciesBalance::quantities
(
    const flows& f,
    const scalar deltaT
) const
{
    DynamicList<quantity> list;

    tellSpecies(f, list);
    tellSolids(f, list);
    tellElements(f, deltaT, list);
    tellConversion(f, list);

    return list;
}


bool Foam::cghs::speciesBalance::execute()
{
    const scalar deltaT = mesh_.time().deltaTValue();
    const label step = mesh_.time().timeIndex();
    const bool known = step_ == step - 1;
    step_ = step;

    // Where steps have been left out this has what solids there are
    const flows f(flowsNow(deltaT));

    if (known)
    {
        const DynamicList<quantity> list(quantities(f, deltaT));
        forAll(list, q)
        {
            means_.now()[q] = list[q].value;
        }
        means_.add(deltaT);
    }

    return true;
}

// * * * * * * * * * * * * * * * * The table * * * * * * * * * * * * * * * * //

void Foam::cghs::speciesBalance::report(Ostream& os) const
{
    const auto value = [&](const word& name)
    {
        return means_.value(means_.names().find(name));
    };

    os  << type() << ' ' << name() << ':' << nl;
    for (const word& e : elements_)
    {
        const word ofIt('(' + e + ')');

        os  << "    " << e << ": in " << value("element.in" + ofIt)
            << " kg/s, out " << value("element.out" + ofIt)
            << " kg/s, stored " << value("element.stored" + ofIt)
            << " kg/s, defect " << value("element.defect" + ofIt)
            << " kg/s, relative " << value("element.relative" + ofIt) << nl;
    }
    if (reactant_ >= 0)
    {
        os  << "    conversion of " << substances_[reactant_] << ' '
            << value("conversion") << nl;
    }
    os  << endl;
}


bool Foam::cghs::speciesBalance::write()
{
    means_.write();
    report(Info);

    return true;
}
