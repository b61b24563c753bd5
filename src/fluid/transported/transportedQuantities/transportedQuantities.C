/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "transportedQuantities.H"
#include "species.H"
#include "cghsCloud.H"
#include <algorithm>

Foam::cghs::transportedQuantities::transportedQuantities
(
    const dictionary& solution
)
:
    names_(transported::selected(solution))
{}


void Foam::cghs::transportedQuantities::make
(
    const dictionary& solution,
    fluidModel& fluid
)
{
    for (const word& name : names_)
    {
        quantities_.append(transported::New(name, solution, fluid));
    }
}


const Foam::cghs::transported&
Foam::cghs::transportedQuantities::withField(const word& name) const
{
    wordList known;

    for (const transported& quantity : quantities_)
    {
        known.append(quantity.fieldNames());

        if (known.found(name))
        {
            return quantity;
        }
    }

    FatalErrorInFunction
        << "The fluid has no field " << name << " for parcels" << nl
        << "Known are: " << flatOutput(known) << nl
        << "Name what has it in the entry " << transported::typeName
        << " in the solution of the cloud's properties, e.g. (energy); G comes"
        << " with radiation yes in its energyCoeffs, mass fractions with"
        << " species" << nl
        << exit(FatalError);

    return quantities_.first();
}


const Foam::volScalarField&
Foam::cghs::transportedQuantities::field(const word& name) const
{
    return withField(name).field(name);
}


Foam::tmp<Foam::volScalarField>
Foam::cghs::transportedQuantities::change(const word& name) const
{
    const transported& quantity = withField(name);

    if (!quantity.potentials().found(name))
    {
        FatalErrorInFunction
            << "The change of " << name << " is not known, only that of "
            << flatOutput(quantity.potentials()) << nl
            << exit(FatalError);
    }

    return quantity.change(name);
}


const Foam::cghs::species*
Foam::cghs::transportedQuantities::mixing() const
{
    for (const transported& quantity : quantities_)
    {
        const species* composition = dynamic_cast<const species*>(&quantity);

        if (composition && composition->mixes())
        {
            return composition;
        }
    }

    return nullptr;
}


bool Foam::cghs::transportedQuantities::any
(
    const std::function<bool(const transported&)>& says
) const
{
    return std::any_of(quantities_.begin(), quantities_.end(), says);
}


bool Foam::cghs::transportedQuantities::dissipates() const
{
    return any([](const transported& q) { return q.dissipates(); });
}


bool Foam::cghs::transportedQuantities::takesPressure() const
{
    return any([](const transported& q) { return q.takesPressure(); });
}


bool Foam::cghs::transportedQuantities::solve
(
    const volScalarField& alpha,
    const volScalarField& rho,
    const surfaceScalarField& massFlux,
    const surfaceScalarField& volumeFlux,
    const tmp<volScalarField>& source,
    const tmp<volScalarField>& given,
    const tmp<volScalarField>& dissipation,
    fv::optionList& options,
    const cghsCloud& cloud,
    const std::function<bool()>& goOn
)
{
    fluidFlow flow
    {
        alpha, rho, massFlux, volumeFlux, nullptr, nullptr, options,
        nullptr, mixing()
    };

    if (source.valid())
    {
        flow.source = source;
    }
    if (given.valid())
    {
        flow.given = given;
    }
    if (dissipation.valid())
    {
        flow.dissipation = dissipation;
    }

    const auto terms = [&](const word& name)
    {
        return cloud.isFelt() ? cloud.terms(name) : exchangeTerms();
    };

    forAll(quantities_, i)
    {
        if (i && !goOn())
        {
            return false;
        }

        quantities_[i].solve(flow, terms);
    }

    return true;
}


void Foam::cghs::transportedQuantities::takeBack()
{
    for (transported& quantity : quantities_)
    {
        quantity.takeBack();
    }
}


void Foam::cghs::transportedQuantities::finishStep()
{
    for (transported& quantity : quantities_)
    {
        quantity.finishStep();
    }
}


Foam::List<Foam::cghs::figure>
Foam::cghs::transportedQuantities::errors() const
{
    List<figure> list;
    for (const transported& quantity : quantities_)
    {
        list.append(quantity.errors());
    }
    return list;
}


void Foam::cghs::transportedQuantities::report(Ostream& os) const
{
    for (const transported& quantity : quantities_)
    {
        quantity.report(os);
    }
}
