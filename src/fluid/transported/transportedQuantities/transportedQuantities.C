/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "transportedQuantities.H"
#include "species.H"
#include "cghsCloud.H"

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


bool Foam::cghs::transportedQuantities::dissipates() const
{
    for (const transported& quantity : quantities_)
    {
        if (quantity.dissipates())
        {
            return true;
        }
    }

    return false;
}


void Foam::cghs::transportedQuantities::keepFluxes
(
    const tmp<surfaceScalarField>& massFlux,
    const tmp<surfaceScalarField>& volumeFlux
)
{
    massFlux_ = massFlux;
    volumeFlux_ = volumeFlux;
}


void Foam::cghs::transportedQuantities::solve
(
    const volScalarField& alpha,
    const volScalarField& rho,
    const tmp<volScalarField>& source,
    const tmp<volScalarField>& given,
    const tmp<volScalarField>& dissipation,
    fv::optionList& options,
    const cghsCloud& cloud
)
{
    fluidFlow flow
    {
        alpha, rho, massFlux_(), volumeFlux_(), nullptr, nullptr, options,
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

    for (transported& quantity : quantities_)
    {
        quantity.solve(flow, terms);
    }

    massFlux_.clear();
    volumeFlux_.clear();
}


void Foam::cghs::transportedQuantities::report(Ostream& os) const
{
    for (const transported& quantity : quantities_)
    {
        quantity.report(os);
    }
}
