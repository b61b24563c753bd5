/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "energy.H"
#include "fluidModel.H"
#include "psiThermo.H"
#include "species.H"
#include "sharedWeights.H"
#include "caseChecks.H"
#include "knownEntries.H"
#include "profiling.H"
#include "syncTools.H"
#include "fvm.H"
#include "fvc.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(energy, 0);
    addToRunTimeSelectionTable(transported, energy, fluid);
    describeModel(transported, energy, "enthalpy or internal energy");


//- Make a convection carry the same through both sides of a coupled face, the
//  mean of what its scheme has chosen for them: what is upwind or not where a
//  field is uniform to the last digit (v1912's limiters take zero for positive)
static tmp<fvScalarMatrix> joinSides(tmp<fvScalarMatrix> tconvection)
{
    fvScalarMatrix& convection = tconvection.ref();
    const fvMesh& mesh = convection.psi().mesh();
    const label nFaces = mesh.nFaces() - mesh.nInternalFaces();
    scalarField own(nFaces, Zero);
    scalarField other(nFaces, Zero);

    const auto sideOf = [&](scalarField& all, const fvPatch& patch)
    {
        return SubField<scalar>
        (
            all,
            patch.size(),
            patch.start() - mesh.nInternalFaces()
        );
    };

    for (const fvPatch& patch : mesh.boundary())
    {
        if (pairsFaces(patch))
        {
            sideOf(own, patch) = convection.internalCoeffs()[patch.index()];
            sideOf(other, patch) = convection.boundaryCoeffs()[patch.index()];
        }
    }

    // There own is what is other here
    syncTools::swapBoundaryFaceList(mesh, own);
    syncTools::swapBoundaryFaceList(mesh, other);

    for (const fvPatch& patch : mesh.boundary())
    {
        if (pairsFaces(patch))
        {
            scalarField& in = convection.internalCoeffs()[patch.index()];
            scalarField& out = convection.boundaryCoeffs()[patch.index()];

            in = 0.5*(in + sideOf(other, patch));
            out = 0.5*(out + sideOf(own, patch));
        }
    }

    return tconvection;
}

} // End namespace cghs
} // End namespace Foam

// * * * * * * * * * * * * * * * Construction  * * * * * * * * * * * * * * * //

Foam::cghs::energy::energy(const dictionary& dict, fluidModel& fluid)
:
    fluid_(fluid),
    thermo_(fluid.thermo()),
    he_(thermo_.he()),
    conductivity_(conductivityModel::New(dict)),
    pressureWork_(readPressureWork(dict)),
    viscousDissipation_(dict.getOrDefault<bool>("viscousDissipation", false)),
    radiation_
    (
        dict.getOrDefault<bool>("radiation", false)
      ? readRadiation()
      : autoPtr<radiation::radiationModel>()
    ),
    Cp_("Cp", thermo_.Cpv()),
    kappa_("kappa", thermo_.kappa()),
    dT_("dT", 0*thermo_.T())
{
    warnUnknownEntries
    (
        dict,
        wordList
        ({
            "conductivityModel", "pressureWork", "viscousDissipation",
            "radiation"
        })
    );
    thermo_.validate("cghsFoam", "h", "e");
    restart();
    he_.writeOpt() = IOobject::AUTO_WRITE;
    he_.oldTime();

    // A gas may make its step once more
    if (isA<psiThermo>(thermo_))
    {
        thermo_.T().oldTime();
    }
}


bool Foam::cghs::energy::readPressureWork(const dictionary& dict) const
{
    const bool isPressure = thermo_.p().dimensions() == dimPressure;
    const bool wanted = dict.getOrDefault<bool>("pressureWork", isPressure);

    if (wanted && !isPressure)
    {
        FatalIOErrorInFunction(dict)
            << "Entry pressureWork is yes but p is over the density: the"
            << " pressure does no work on a fluid that is incompressible" << nl
            << "Remove the entry, or choose the fluid gas" << nl
            << exit(FatalIOError);
    }

    return wanted;
}


Foam::autoPtr<Foam::radiation::radiationModel>
Foam::cghs::energy::readRadiation() const
{
    autoPtr<radiation::radiationModel> model
    (
        radiation::radiationModel::New(thermo_.T())
    );

    if (!he_.mesh().foundObject<volScalarField>("G"))
    {
        FatalIOErrorInFunction(model())
            << "Entry radiationModel is " << model->type()
            << ", which has no incident radiation G" << nl
            << "Valid choices: P1, fvDOM. Or have no radiation in energyCoeffs"
            << nl << exit(FatalIOError);
    }

    const word scatter(model->getOrDefault<word>("scatterModel", "none"));
    if (model->type() == "P1" && scatter == "none")
    {
        FatalIOErrorInFunction(model())
            << "Entry scatterModel is none: P1 has no solution where there are"
            << " no parcels and the gas is transparent" << nl
            << "Choose the scatterModel parcels, with a small background" << nl
            << exit(FatalIOError);
    }

    const label every = model->getOrDefault<label>("solverFreq", 1);
    if (every != 1)
    {
        FatalIOErrorInFunction(model())
            << "Entry solverFreq is " << every << " but must be 1: parcels"
            << " receive in each step what G has" << nl
            << exit(FatalIOError);
    }

    return model;
}


void Foam::cghs::energy::restart()
{
    const fvMesh& mesh = he_.mesh();
    IOobject file
    (
        he_.name(),
        mesh.time().timeName(),
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );

    if (!file.typeHeaderOk<volScalarField>(true))
    {
        return;
    }

    const scalarField written
    (
        "internalField",
        fileOf(he_),
        mesh.nCells()
    );
    const scalarField misfit
    (
        mag(written - he_.primitiveField())
       /(Cp_.primitiveField()*thermo_.T().primitiveField())
    );
    const scalar most = gMax(misfit);

    if (most > 1e-3)
    {
        WarningInFunction
            << "Entry internalField in " << file.objectPath()
            << " is not that of the temperature: the largest difference is "
            << 100*most << " % of Cp T" << nl
            << "    T is taken. Remove " << he_.name()
            << " where T has been changed" << nl << endl;
        return;
    }

    he_.primitiveFieldRef() = written;
    he_.correctBoundaryConditions();
}

// * * * * * * * * * * * * * * * * The step  * * * * * * * * * * * * * * * * //

Foam::tmp<Foam::volScalarField>
Foam::cghs::energy::pressurePower(const fluidFlow& flow) const
{
    const volScalarField& p = thermo_.p();
    tmp<volScalarField> power
    (
        enthalpy()
      ? flow.alpha*fvc::ddt(p)
      : -p*fvc::ddt(flow.alpha)
      - fvc::div(flow.volumeFlux*fvc::interpolate(p))
    );

    if (viscousDissipation_)
    {
        // What viscosity makes heat of is counted where it does
        power.ref() +=
            fvc::div(flow.volumeFlux*fvc::interpolate(p))
          - p*fvc::div(flow.volumeFlux);
    }

    return power;
}


Foam::tmp<Foam::volScalarField>
Foam::cghs::energy::bare(const fluidFlow& flow) const
{
    return
        flow.source.valid() && flow.options.appliesToField(he_.name())
      ? posPart(flow.source())
      : tmp<volScalarField>();
}


Foam::tmp<Foam::fvScalarMatrix> Foam::cghs::energy::transport
(
    const fluidFlow& flow,
    const volScalarField& conduction
)
{
    const word scheme("div(alphaRhoPhi," + he_.name() + ')');
    volScalarField closed
    (
        fvc::ddt(flow.alpha, flow.rho) + fvc::div(flow.massFlux)
    );

    const tmp<volScalarField> S(bare(flow));
    if (S.valid())
    {
        closed -= S();
    }
    if (flow.given.valid())
    {
        closed -= flow.given();
    }

    return
        fvm::ddt(flow.alpha, flow.rho, he_)
      + (
            flow.mixing
          ? sharedWeights::convection
            (
                flow.massFlux,
                he_,
                flow.mixing->weights()
            )
          : joinSides(fvm::div(flow.massFlux, he_, scheme))
        )
      - fvm::Sp(closed, he_)
      - (
            flow.mixing
          ? fvm::laplacian
            (
                fvc::interpolate(conduction),
                he_,
                "laplacian(conduction," + he_.name() + ')'
            )
          : fvm::laplacian(conduction, he_)
        );
}


Foam::tmp<Foam::surfaceScalarField>
Foam::cghs::energy::carriedByDiffusion
(
    const fluidFlow& flow,
    const volScalarField& conduction
) const
{
    return
        flow.mixing
      ? flow.mixing->carriedEnergy
        (
            fvc::interpolate(conduction),
            enthalpy() || pressureWork_
        )
      : tmp<surfaceScalarField>();
}


Foam::cghs::energy::tangent
Foam::cghs::energy::start(const fluidFlow& flow) const
{
    tangent at
    {
        volScalarField("tangent:T", thermo_.T()),
        volScalarField("tangent:he", he_.oldTime()),
        volScalarField("tangent:Cp", Cp_),
        0
    };

    if (flow.mixing)
    {
        at.he = thermo_.he(thermo_.p(), thermo_.T());
        at.Cp = thermo_.Cpv();
    }

    return at;
}


bool Foam::cghs::energy::advance
(
    tangent& at,
    const volScalarField& response
) const
{
    constexpr label most = 5;
    constexpr scalar tolerance = 1e-6;

    const labelList cells(identity(he_.mesh().nCells()));
    const scalarField& p = thermo_.p().primitiveField();
    const scalarField T
    (
        thermo_.T().primitiveField() + dT_.primitiveField()
    );
    const scalarField he(thermo_.he(p, T, cells));
    const scalarField misfit
    (
        pos(response.primitiveField() - VSMALL)
       *mag(he - he_.primitiveField())/(at.Cp.primitiveField()*T)
    );

    if (++at.pass == most || gMax(misfit) < tolerance)
    {
        return false;
    }

    const scalarField h(1e-4*T);
    at.T.primitiveFieldRef() = T;
    at.he.primitiveFieldRef() = he;
    at.Cp.primitiveFieldRef() =
        (thermo_.he(p, T + h, cells) - thermo_.he(p, T - h, cells))/(2*h);

    return true;
}


void Foam::cghs::energy::solve
(
    const fluidFlow& flow,
    const givenTerms& given
)
{
    addProfiling(energy, "cghs::energy");

    exchangeTerms terms(given(type()));
    if (terms.any() && !terms.responds())
    {
        terms.response = 0*terms.given()/thermo_.T();
    }

    const volScalarField conduction
    (
        "conduction",
        conductivity_->conductivity(flow.alpha, kappa_, Cp_, fluid_.mut())/Cp_
    );
    fvScalarMatrix others(transport(flow, conduction));
    tmp<volScalarField> power;
    tmp<fvScalarMatrix> sources;

    if (pressureWork_)
    {
        power = pressurePower(flow);
        others -= power();
    }

    if (viscousDissipation_)
    {
        others -= flow.dissipation();
    }

    const tmp<surfaceScalarField> carried
    (
        carriedByDiffusion(flow, conduction)
    );

    if (carried.valid())
    {
        others += fvc::div(carried());
    }

    tmp<fvScalarMatrix> radiated;

    if (radiation_.valid())
    {
        radiation_->correct();
        radiated = radiation_->Sh(thermo_, he_);
        others -= radiated();
    }

    if (flow.options.size())
    {
        sources = flow.options(flow.alpha, flow.rho, he_);
        others -= sources();
    }

    tangent at(start(flow));

    do
    {
        fvScalarMatrix heEqn(others);

        if (terms.any())
        {
            const volScalarField slope(terms.response()/at.Cp);

            heEqn += fvm::Sp(slope, he_);
            heEqn -=
                terms.given() + slope*at.he
              - terms.response()*(at.T - thermo_.T());
        }

        heEqn.relax();
        flow.options.constrain(heEqn);
        heEqn.solve();
        flow.options.correct(he_);

        dT_ = at.T - thermo_.T() + (he_ - at.he)/at.Cp;
    }
    while (terms.any() && advance(at, terms.response()));

    balance_ = balance();
    addStored(flow);
    addBoundary(flow, conduction, carried);

    if (terms.any())
    {
        balance_.parcels = add(terms.given()) - add(terms.response()*dT_);
    }

    if (pressureWork_)
    {
        balance_.pressure = add(power());
    }

    if (viscousDissipation_)
    {
        balance_.viscosity = add(flow.dissipation());
    }

    if (radiated.valid())
    {
        balance_.radiation = add(radiated() & he_);
    }

    if (sources.valid())
    {
        balance_.sources = add(sources() & he_);
    }

    if (flow.source.valid())
    {
        tmp<volScalarField> carried(flow.source()*he_);
        const tmp<volScalarField> S(bare(flow));
        if (S.valid())
        {
            carried.ref() -= S()*he_;
        }
        balance_.sources += add(carried());
    }

    update();
}


void Foam::cghs::energy::update()
{
    thermo_.correct();

    const volScalarField& T = thermo_.T();
    const scalar lowest = gMin(T.primitiveField());

    if (!(lowest > 0))
    {
        FatalErrorInFunction
            << "The temperature of the fluid has fallen to " << lowest
            << " K: the run has gone out of hand." << nl
            << "Lower maxCo or maxDeltaT, choose a bounded scheme for"
            << " div(alphaRhoPhi," << he_.name() << "), e.g. Gauss upwind,"
            << " or raise minVoidage" << nl
            << exit(FatalError);
    }
}


void Foam::cghs::energy::takeBack()
{
    he_ == he_.oldTime();
    thermo_.T() == thermo_.T().oldTime();
}


void Foam::cghs::energy::finishStep()
{
    Cp_ = thermo_.Cpv();
    kappa_ = thermo_.kappa();
}

// * * * * * * * * * * * * * * * * Reports * * * * * * * * * * * * * * * * * //

Foam::scalar Foam::cghs::energy::add(const volScalarField& density)
{
    balance_.scale += fvc::domainIntegrate(mag(density)).value();

    return fvc::domainIntegrate(density).value();
}


void Foam::cghs::energy::addStored(const fluidFlow& flow)
{
    const tmp<volScalarField> rate(fvc::ddt(flow.alpha, flow.rho, he_));

    balance_.stored = add(rate());
}


void Foam::cghs::energy::addBoundary
(
    const fluidFlow& flow,
    const volScalarField& conduction,
    const tmp<surfaceScalarField>& carriedFlux
)
{
    scalar scale = 0;

    for (const fvPatchScalarField& he : he_.boundaryField())
    {
        const label patchi = he.patch().index();

        if (he.coupled() || he.empty())
        {
            continue;
        }

        const scalarField carried
        (
            -flow.massFlux.boundaryField()[patchi]*he
        );
        scalarField conducted
        (
            conduction.boundaryField()[patchi]*he.snGrad()*he.patch().magSf()
        );
        if (carriedFlux.valid())
        {
            conducted -= carriedFlux().boundaryField()[patchi];
        }

        balance_.inflow += sum(carried);
        balance_.walls += sum(conducted);
        scale += sum(mag(carried)) + sum(mag(conducted));
    }

    reduce(balance_.inflow, sumOp<scalar>());
    reduce(balance_.walls, sumOp<scalar>());
    balance_.scale += returnReduce(scale, sumOp<scalar>());
}


Foam::List<Foam::cghs::figure> Foam::cghs::energy::errors() const
{
    return List<figure>({{"energyDefect", balance_.relativeDefect()}});
}


void Foam::cghs::energy::report(Ostream& os) const
{
    const scalarField& T = thermo_.T().primitiveField();

    os  << "energy: stored " << balance_.stored
        << " W, inflow " << balance_.inflow
        << " W, walls " << balance_.walls
        << " W, parcels " << balance_.parcels
        << " W, sources " << balance_.sources
        << " W, pressure " << balance_.pressure
        << " W, radiation " << balance_.radiation
        << " W, viscosity " << balance_.viscosity << " W" << nl
        << "        energy from nowhere " << balance_.defect()
        << " W, relative " << balance_.relativeDefect()
        << "; T from " << gMin(T) << " to " << gMax(T) << " K" << nl;
}

// * * * * * * * * * * * * * What parcels meet * * * * * * * * * * * * * * * //

Foam::wordList Foam::cghs::energy::fieldNames() const
{
    wordList names({thermo_.T().name(), Cp_.name(), kappa_.name()});

    if (radiation_.valid())
    {
        names.append("G");
    }

    return names;
}


const Foam::volScalarField&
Foam::cghs::energy::field(const word& name) const
{
    return
        name == "G" ? he_.mesh().lookupObject<volScalarField>(name)
      : name == Cp_.name() ? Cp_
      : name == kappa_.name() ? kappa_
      : thermo_.T();
}
