/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "species.H"
#include "composition.H"
#include "sharedWeights.H"
#include "splittingError.H"
#include "fluidModel.H"
#include "fluidThermo.H"
#include "basicSpecieMixture.H"
#include "knownEntries.H"
#include "profiling.H"
#include "fvm.H"
#include "fvc.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"
#include <algorithm>

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(species, 0);
    addToRunTimeSelectionTable(transported, species, fluid);
    describeModel
    (
        transported,
        species,
        "mass fractions of a mixture, or dilute ones in a liquid"
    );
}
}

// * * * * * * * * * * * * * * * Construction  * * * * * * * * * * * * * * * //

Foam::cghs::species::species(const dictionary& dict, fluidModel& fluid)
:
    fluid_(fluid),
    mixture_(fluid.mixture()),
    own_(mixture_ ? PtrList<volScalarField>() : readFields(dict)),
    Y_(mixture_ ? mixture_->Y() : own_),
    names_(readNames(dict)),
    inert_(readInert(dict)),
    diffusivity_(diffusivityModel::New(dict, solvedNames())),
    diffusivityf_(Y_.size()),
    gradients_(Y_.size()),
    budgets_(names_, fluid.U().mesh()),
    splittingError_(0)
{
    warnUnknownEntries
    (
        dict,
        mixture_
      ? wordList({"inertSpecie", "diffusivityModel"})
      : wordList({"species", "dilute", "diffusivityModel"})
    );

    for (volScalarField& Y : Y_)
    {
        Y.mesh().setFluxRequired(Y.name());
        Y.oldTime();
    }
}


Foam::PtrList<Foam::volScalarField> Foam::cghs::species::readFields
(
    const dictionary& dict
) const
{
    const fvMesh& mesh = fluid_.U().mesh();
    const wordList names(dict.get<wordList>("species"));

    checkFields(mesh, names, dict);

    PtrList<volScalarField> fields(names.size());
    forAll(names, k)
    {
        fields.set
        (
            k,
            new volScalarField
            (
                IOobject
                (
                    names[k],
                    mesh.time().timeName(),
                    mesh,
                    IOobject::MUST_READ,
                    IOobject::AUTO_WRITE
                ),
                mesh
            )
        );
    }

    return fields;
}


Foam::wordList Foam::cghs::species::readNames(const dictionary& dict) const
{
    wordList names(Y_.size());
    forAll(names, k)
    {
        names[k] = Y_[k].name();
    }

    return names;
}


Foam::label Foam::cghs::species::readInert(const dictionary& dict) const
{
    if (!mixture_)
    {
        return -1;
    }

    const word name(dict.get<word>("inertSpecie"));
    const label inert = names_.find(name);

    if (inert < 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry inertSpecie is " << name
            << ", which is none of the species of the gas" << nl << nl
            << "Valid choices:" << nl << names_ << nl
            << exit(FatalIOError);
    }

    return inert;
}


Foam::wordList Foam::cghs::species::solvedNames() const
{
    DynamicList<word> solved;

    forAll(names_, k)
    {
        if (k != inert_)
        {
            solved.append(names_[k]);
        }
    }

    return wordList(solved);
}

// * * * * * * * * * * * * * * * * The step  * * * * * * * * * * * * * * * * //

void Foam::cghs::species::checkGiven
(
    const fluidFlow& flow,
    const UList<exchangeTerms>& terms
) const
{
    if (!mixture_)
    {
        return;
    }

    scalar scale = 0;
    scalarField sum(Y_[0].size(), Zero);

    forAll(terms, k)
    {
        if (terms[k].any())
        {
            sum += terms[k].given().primitiveField();
            scale += gSumMag(terms[k].given().primitiveField());
        }
        if
        (
            terms[k].responds()
         && gMax(terms[k].response().primitiveField()) > 0
        )
        {
            FatalErrorInFunction
                << "Parcels respond to " << names_[k] << " in a gas: its"
                << " continuity is solved before " << names_[k]
                << " has changed" << nl
                << "Let exchange::terms of species give without a response"
                << nl << exit(FatalError);
        }
    }

    if (flow.given.valid())
    {
        sum -= flow.given().primitiveField();
        scale += gSumMag(flow.given().primitiveField());
    }

    const scalar misfit = gSumMag(sum);

    // What goes forth and back by reactions has rounding of its own
    const scalar rounding =
        1e-12*gSum(flow.alpha.primitiveField()*flow.rho.primitiveField())
       /flow.rho.time().deltaTValue();

    if (misfit > 1e-9*scale + rounding)
    {
        FatalErrorInFunction
            << "What parcels give to the species " << flatOutput(names_)
            << " is not the mass that they give: both differ by "
            << misfit/scale << " of it" << nl
            << "Let exchange::massGiven be the sum of exchange::terms of all"
            << " species, the inert one too" << nl
            << exit(FatalError);
    }
}


Foam::tmp<Foam::surfaceScalarField> Foam::cghs::species::weights
(
    const fluidFlow& flow
) const
{
    DynamicList<const volScalarField*> fields;

    forAll(Y_, k)
    {
        if (k != inert_)
        {
            fields.append(&Y_[k]);
        }
    }
    if (mixture_ && fluid_.transports("energy"))
    {
        fields.append(&fluid_.thermo().he());
    }

    return
        sharedWeights::ofFields
        (
            fields,
            flow.massFlux,
            "div(alphaRhoPhi,Yi_h)"
        );
}


Foam::tmp<Foam::volScalarField>
Foam::cghs::species::bare(const fluidFlow& flow) const
{
    bool given = false;

    for (const word& name : names_)
    {
        given = given || flow.options.appliesToField(name);
    }

    return
        flow.source.valid() && given
      ? posPart(flow.source())
      : tmp<volScalarField>();
}


Foam::tmp<Foam::volScalarField>
Foam::cghs::species::closed(const fluidFlow& flow) const
{
    tmp<volScalarField> closed
    (
        fvc::ddt(flow.alpha, flow.rho) + fvc::div(flow.massFlux)
    );

    if (flow.given.valid())
    {
        closed.ref() -= flow.given();
    }

    const tmp<volScalarField> S(bare(flow));
    if (S.valid())
    {
        closed.ref() -= S();
    }

    return closed;
}


void Foam::cghs::species::solve
(
    const label k,
    const fluidFlow& flow,
    const volScalarField& closed,
    const exchangeTerms& terms
)
{
    volScalarField& Y = Y_[k];
    const word diffusion("laplacian(diffusivity,Yi)");
    const surfaceScalarField& Gamma = diffusivityf_[k];

    fvScalarMatrix YEqn
    (
        fvm::ddt(flow.alpha, flow.rho, Y)
      + sharedWeights::convection(flow.massFlux, Y, weights_())
      - fvm::Sp(closed, Y)
      - fvm::laplacian(Gamma, Y, diffusion)
    );

    tmp<fvScalarMatrix> gradient;
    if (mixture_ && fluid_.transports("energy"))
    {
        // With what a mesh that is not orthogonal makes explicit as above
        gradient = fvm::laplacian(Y, diffusion);
    }

    tmp<fvScalarMatrix> options;
    if (flow.options.size())
    {
        options = flow.options(flow.alpha, flow.rho, Y);
        YEqn -= options();
    }

    if (terms.any())
    {
        YEqn -= terms.given();
    }
    if (terms.responds())
    {
        YEqn += fvm::Sp(terms.response(), Y);
        YEqn -= terms.response()*Y.oldTime();
    }

    YEqn.relax();
    flow.options.constrain(YEqn);
    YEqn.solve(Y.mesh().solver("Yi"));
    flow.options.correct(Y);

    if (gradient.valid())
    {
        gradients_.set(k, gradient().flux().ptr());
    }

    addUp(k, flow, terms);
    addSources(budgets_[k], k, flow, options);
}


void Foam::cghs::species::closeSum()
{
    volScalarField& inert = Y_[inert_];

    inert.primitiveFieldRef() = 1;
    forAll(Y_, k)
    {
        if (k != inert_)
        {
            inert.primitiveFieldRef() -= Y_[k].primitiveField();
        }
    }
    inert.correctBoundaryConditions();

    forAll(inert.boundaryField(), patchi)
    {
        fvPatchScalarField& there = inert.boundaryFieldRef()[patchi];

        if (there.coupled())
        {
            continue;
        }

        scalarField rest(there.size(), 1);
        forAll(Y_, k)
        {
            if (k != inert_)
            {
                rest -= Y_[k].boundaryField()[patchi];
            }
        }
        there == rest;
    }
}


void Foam::cghs::species::solve
(
    const fluidFlow& flow,
    const givenTerms& given
)
{
    addProfiling(species, "cghs::species");

    List<exchangeTerms> terms(Y_.size());
    forAll(Y_, k)
    {
        terms[k] = given(names_[k]);
    }
    checkGiven(flow, terms);

    weights_ = weights(flow);

    const volScalarField open(closed(flow));
    const volScalarField mut(fluid_.mut());

    forAll(Y_, k)
    {
        budgets_[k].scale = 0;
        if (k != inert_)
        {
            diffusivityf_.set
            (
                k,
                fvc::interpolate
                (
                    diffusivity_->diffusivity
                    (
                        names_[k], flow.alpha, flow.rho, fluid_.mu(), mut
                    )
                ).ptr()
            );
            solve(k, flow, open, terms[k]);
        }
    }

    if (inert_ >= 0)
    {
        closeSum();
        addUpInert(flow);
    }
    weigh(flow);
    measureSplitting(flow, terms);
}


void Foam::cghs::species::measureSplitting
(
    const fluidFlow& flow,
    const List<exchangeTerms>& terms
)
{
    splittingError_ = 0;
    if
    (
        std::none_of
        (
            terms.begin(),
            terms.end(),
            [](const exchangeTerms& t) { return t.any() || t.responds(); }
        )
    )
    {
        return;
    }

    const fvMesh& mesh = flow.alpha.mesh();
    const scalar deltaT = mesh.time().deltaTValue();
    const scalarField& V = mesh.V();
    const scalarField content
    (
        flow.alpha.primitiveField()*flow.rho.primitiveField()*V
    );
    const scalarField before
    (
        flow.alpha.oldTime().primitiveField()
       *flow.rho.oldTime().primitiveField()*V
    );

    splittingError error(flow.massFlux, content, deltaT);
    forAll(Y_, k)
    {
        if (!terms[k].any() && !terms[k].responds())
        {
            continue;
        }

        const scalarField& old = Y_[k].oldTime().primitiveField();
        scalarField taken(V.size(), Zero);
        if (terms[k].any())
        {
            taken -= deltaT*V*terms[k].given().primitiveField();
        }
        if (terms[k].responds())
        {
            taken +=
                deltaT*V*terms[k].response().primitiveField()
               *(Y_[k].primitiveField() - old);
        }
        error.note(before*old, taken);
    }
    splittingError_ = error.mean();
}


void Foam::cghs::species::takeBack()
{
    for (volScalarField& Y : Y_)
    {
        Y == Y.oldTime();
    }
}


void Foam::cghs::species::finishStep()
{
    for (speciesBudget& b : budgets_)
    {
        b.missing += b.defect()*fluid_.rho().time().deltaTValue();
    }
}

// * * * * * * * * * * * * * * * For energy  * * * * * * * * * * * * * * * * //

Foam::tmp<Foam::surfaceScalarField> Foam::cghs::species::overInert
(
    const label k,
    const bool enthalpy
) const
{
    const fluidThermo& thermo = fluid_.thermo();
    const auto ofOne = [&](const label i, const scalar p, const scalar T)
    {
        return enthalpy ? mixture_->Hs(i, p, T) : mixture_->HE(i, p, T);
    };
    const auto set = [&]
    (
        scalarField& values,
        const scalarField& p,
        const scalarField& T
    )
    {
        forAll(values, i)
        {
            values[i] = ofOne(k, p[i], T[i]) - ofOne(inert_, p[i], T[i]);
        }
    };

    volScalarField difference
    (
        IOobject("overInert", Y_[k].time().timeName(), Y_[k].mesh()),
        Y_[k].mesh(),
        dimensionedScalar(dimEnergy/dimMass, Zero)
    );
    const volScalarField& p = thermo.p();
    const volScalarField& T = thermo.T();

    set(difference.primitiveFieldRef(), p.primitiveField(), T.primitiveField());
    forAll(p.boundaryField(), patchi)
    {
        set
        (
            difference.boundaryFieldRef()[patchi],
            p.boundaryField()[patchi],
            T.boundaryField()[patchi]
        );
    }

    return fvc::interpolate(difference);
}


Foam::tmp<Foam::surfaceScalarField> Foam::cghs::species::carriedEnergy
(
    const surfaceScalarField& conduction,
    const bool enthalpy
) const
{
    tmp<surfaceScalarField> sum
    (
        new surfaceScalarField
        (
            IOobject
            (
                "carriedEnergy",
                conduction.time().timeName(),
                conduction.mesh()
            ),
            conduction.mesh(),
            dimensionedScalar(dimPower, Zero)
        )
    );

    forAll(Y_, k)
    {
        if (k != inert_)
        {
            const tmp<surfaceScalarField> he(overInert(k, false));

            sum.ref() += conduction*he()*gradients_[k];
            sum.ref() -=
                diffusivityf_[k]*gradients_[k]
               *(enthalpy ? overInert(k, true) : he);
        }
    }

    return sum;
}

// * * * * * * * * * * * * * * * * Reports * * * * * * * * * * * * * * * * * //

Foam::scalar Foam::cghs::species::add
(
    speciesBudget& b,
    const volScalarField& density
)
{
    b.scale += fvc::domainIntegrate(mag(density)).value();

    return fvc::domainIntegrate(density).value();
}


void Foam::cghs::species::addBoundary
(
    speciesBudget& b,
    const volScalarField& Y,
    const surfaceScalarField& flux,
    const surfaceScalarField& diffusivityf
)
{
    b.carried = Zero;
    b.diffused = Zero;
    scalarField outflow(b.carried.size(), Zero);

    for (const fvPatchScalarField& there : Y.boundaryField())
    {
        const label patchi = there.patch().index();

        if (there.coupled() || there.empty())
        {
            continue;
        }

        const scalarField carried(-flux.boundaryField()[patchi]*there);

        b.carried[patchi] = sum(carried);
        outflow[patchi] = -sum(negPart(carried));
        b.diffused[patchi] =
            sum
            (
                diffusivityf.boundaryField()[patchi]*there.snGrad()
               *there.patch().magSf()
            );
    }
    reduce(b.carried, sumOp<scalarField>());
    reduce(b.diffused, sumOp<scalarField>());
    reduce(outflow, sumOp<scalarField>());

    b.outflow = sum(outflow);
    b.inflow = sum(b.carried) + b.outflow;
    b.walls = sum(b.diffused);
    b.scale += b.inflow + b.outflow + mag(b.walls);
}


void Foam::cghs::species::addUp
(
    const label k,
    const fluidFlow& flow,
    const exchangeTerms& terms
)
{
    const volScalarField& Y = Y_[k];
    speciesBudget& b = budgets_[k];

    b.stored = add(b, fvc::ddt(flow.alpha, flow.rho, Y)());
    addBoundary(b, Y, flow.massFlux, diffusivityf_[k]);

    b.parcels = terms.any() ? add(b, terms.given()) : 0;
    if (terms.responds())
    {
        b.parcels -= add(b, (terms.response()*(Y - Y.oldTime()))());
    }
}


void Foam::cghs::species::addSources
(
    speciesBudget& b,
    const label k,
    const fluidFlow& flow,
    const tmp<fvScalarMatrix>& options
)
{
    b.sources = options.valid() ? add(b, (options() & Y_[k])()) : 0;

    if (flow.source.valid())
    {
        tmp<volScalarField> carried(flow.source()*Y_[k]);
        const tmp<volScalarField> S(bare(flow));
        if (S.valid())
        {
            carried.ref() -= S()*Y_[k];
        }
        b.sources += add(b, carried());
    }
}


void Foam::cghs::species::addUpInert(const fluidFlow& flow)
{
    const volScalarField& Y = Y_[inert_];
    speciesBudget& b = budgets_[inert_];
    const surfaceScalarField none(0*mag(flow.massFlux)/Y.mesh().magSf());

    b.stored = add(b, fvc::ddt(flow.alpha, flow.rho, Y)());
    addBoundary(b, Y, flow.massFlux, none);

    b.parcels = flow.given.valid() ? add(b, flow.given()) : 0;
    b.sources = flow.source.valid() ? add(b, flow.source()) : 0;
    b.walls = 0;
    b.diffused = Zero;
    forAll(budgets_, k)
    {
        if (k != inert_)
        {
            b.diffused -= budgets_[k].diffused;
            b.parcels -= budgets_[k].parcels;
            b.sources -= budgets_[k].sources;
            b.walls -= budgets_[k].walls;
        }
    }
}


void Foam::cghs::species::weigh(const fluidFlow& flow)
{
    forAll(Y_, k)
    {
        budgets_[k].mass =
            fvc::domainIntegrate(flow.alpha*flow.rho*Y_[k]).value();
    }
}


Foam::List<Foam::cghs::figure> Foam::cghs::species::errors() const
{
    // Of one that is nearly used up there is nothing to hold its own against
    scalar worst = 0;
    scalar scale = VSMALL;
    for (const speciesBudget& b : budgets_)
    {
        worst = max(worst, mag(b.defect()));
        scale = max(scale, b.scale);
    }
    return List<figure>
    ({
        {"speciesDefect", worst/scale},
        {"splittingError", splittingError_}
    });
}


void Foam::cghs::species::report(Ostream& os) const
{
    forAll(Y_, k)
    {
        const speciesBudget& b = budgets_[k];
        const scalarField& Y = Y_[k].primitiveField();

        os  << "species " << names_[k] << ": stored " << b.stored
            << " kg/s, in " << b.inflow << " kg/s, out " << b.outflow
            << " kg/s, walls " << b.walls << " kg/s, parcels " << b.parcels
            << " kg/s, sources " << b.sources << " kg/s" << nl
            << "        defect " << b.defect() << " kg/s, relative "
            << b.relativeDefect() << "; " << b.mass
            << " kg, from nowhere " << b.missing << " kg; Y from "
            << gMin(Y) << " to " << gMax(Y) << nl;
    }
}

// * * * * * * * * * * * * * What parcels meet * * * * * * * * * * * * * * * //

Foam::wordList Foam::cghs::species::fieldNames() const
{
    wordList names(names_);

    if (mixture_ && !fluid_.transports("energy"))
    {
        names.append(fluid_.thermo().T().name());
    }

    return names;
}


const Foam::volScalarField&
Foam::cghs::species::field(const word& name) const
{
    const label k = names_.find(name);

    return k >= 0 ? Y_[k] : fluid_.thermo().T();
}


Foam::tmp<Foam::volScalarField>
Foam::cghs::species::change(const word& name) const
{
    const volScalarField& Y = Y_[names_.find(name)];

    return Y - Y.oldTime();
}
