/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "fluidModel.H"
#include "selectModel.H"
#include "balancedWalls.H"
#include "caseChecks.H"
#include "species.H"
#include "fvm.H"
#include "fvc.H"
#include "fvcFlux.H"
#include "constrainHbyA.H"
#include "constrainPressure.H"
#include "fixedGradientFvPatchFields.H"
#include "checkedEntry.H"
#include "profiling.H"
#include "modelList.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(fluidModel, 0);
    defineRunTimeSelectionTable(fluidModel, cloud);
    describeFamily(fluidModel, "the fluid in the voidage: solution");


static IOobject fieldIO
(
    const word& name,
    const fvMesh& mesh,
    const IOobject::readOption read,
    const IOobject::writeOption write
)
{
    return IOobject(name, mesh.time().timeName(), mesh, read, write);
}


//- Let patches that give a gradient have that of their values
static void takeGradients(volScalarField& field)
{
    for (fvPatchScalarField& there : field.boundaryFieldRef())
    {
        if (isA<fixedGradientFvPatchScalarField>(there))
        {
            refCast<fixedGradientFvPatchScalarField>(there).gradient() =
                (there - there.patchInternalField())
               *there.patch().deltaCoeffs();
        }
    }
}


//- The solids that the fluid takes notice of
static tmp<volScalarField> solidsMet(const cghsCloud& cloud)
{
    return
        cloud.coupling() == cghsCloud::couplingType::twoWay
      ? cloud.momentumExchange().solidsFraction()
      : cloud.momentumExchange().noSolids();
}

} // End namespace cghs
} // End namespace Foam

// * * * * * * * * * * * * * * * Construction  * * * * * * * * * * * * * * * //

Foam::tmp<Foam::volScalarField>
Foam::cghs::fluidModel::boundedVoidage(const volScalarField& theta) const
{
    return max(1 - theta, dimensionedScalar("minVoidage", dimless, minVoidage_));
}


Foam::cghs::fluidModel::fluidModel
(
    fvMesh& mesh,
    const dimensionedVector& g,
    const cghsCloud& cloud,
    const dimensionSet& pressure
)
:
    mesh_(mesh),
    reconstruct_(mesh),
    yield_
    (
        mesh,
        cloud.coupling() == cghsCloud::couplingType::twoWay,
        cloud.plates()
    ),
    piso_(mesh),
    frozen_(piso_.frozenFlow()),
    g_(g),
    transported_(cloud.properties().subDict("solution")),
    minVoidage_
    (
        scalarInRange
        (
            cloud.properties().subDict("solution"),
            "minVoidage",
            0.01,
            1
        )
    ),
    gradP_
    (
        fieldIO("gradP", mesh, IOobject::NO_READ, IOobject::NO_WRITE),
        mesh,
        dimensionedVector(dimPressure/dimLength, Zero)
    ),
    continuityError_(0),
    nPasses_(0),
    options_(nullptr),
    U_
    (
        fieldIO("U", mesh, IOobject::MUST_READ, IOobject::AUTO_WRITE),
        mesh
    ),
    p_
    (
        fieldIO("p", mesh, IOobject::MUST_READ, IOobject::AUTO_WRITE),
        mesh
    ),
    phi_
    (
        fieldIO("phi", mesh, IOobject::READ_IF_PRESENT, IOobject::AUTO_WRITE),
        fvc::flux(U_)
    ),
    alpha_
    (
        fieldIO("alpha", mesh, IOobject::READ_IF_PRESENT, IOobject::AUTO_WRITE),
        boundedVoidage(solidsMet(cloud))
    ),
    alphaf_("alphaf", fvc::interpolate(alpha_))
{
    checkTransient(mesh);
    checkPressure(p_, pressure);
    checkSolids(alpha_, cloud);
    if (frozen_)
    {
        checkFrozen(pisoDict(), cloud);
    }
    balanceWalls(p_, U_);
    mesh_.setFluxRequired(p_.name());
    gravity_.reset(new faceGravity(p_, g_));

    // An old value is only kept from now on if it is asked for now
    alpha_.oldTime();
    U_.oldTime();
}


Foam::autoPtr<Foam::cghs::fluidModel>
Foam::cghs::fluidModel::New
(
    fvMesh& mesh,
    const dimensionedVector& g,
    const cghsCloud& cloud
)
{
    if (cloud.coupling() == cghsCloud::couplingType::none)
    {
        return nullptr;
    }

    const dictionary& solution = cloud.properties().subDict("solution");
    word modelType(solution.getOrDefault<word>(typeName, "incompressible"));

    // Its name when it could be nothing else
    if (modelType == "isothermalGas")
    {
        modelType = "gas";
    }

    autoPtr<fluidModel> fluid
    (
        constructorNamed<fluidModel>
        (
            modelType,
            solution,
            *cloudConstructorTablePtr_
        )(mesh, g, cloud)
    );

    fluid->transported_.make(solution, fluid());
    if (fluid->frozen_ && !fluid->transported_.empty())
    {
        checkFrozenDensity(solution, fluid->densityStays());
    }
    fluid->options_ = &fv::options::New(mesh);

    return fluid;
}

// * * * * * * * * * * * * * * * * The step  * * * * * * * * * * * * * * * * //

Foam::scalar Foam::cghs::fluidModel::courantNumber() const
{
    const scalarField outflow
    (
        fvc::surfaceSum(mag(phi_))().primitiveField()
    );

    return 0.5*gMax(outflow/mesh_.V())*mesh_.time().deltaTValue();
}


void Foam::cghs::fluidModel::setSolids(const volScalarField& theta)
{
    alpha_ = boundedVoidage(theta);
    alpha_.correctBoundaryConditions();

    alphaf_ = fvc::interpolate(alpha_);
    contentFlux() = contentf()*phi_;
}


void Foam::cghs::fluidModel::setYield
(
    const volScalarField& byVelocity,
    const volScalarField& byGradient
)
{
    yield_.start
    (
        byVelocity,
        momentumDensity()*byGradient,
        phi_,
        faceGradP()
    );
}


Foam::cghs::fluidModel::momentumSystem::momentumSystem
(
    const fvVectorMatrix& UEqn,
    const surfaceScalarField& content,
    const surfaceScalarField& gravity
)
:
    UEqn(UEqn),
    rAU("rAU", 1/UEqn.A()),
    rAUf("rAUf", fvc::interpolate(rAU)),
    forces(content*rAUf*gravity)
{}


Foam::tmp<Foam::surfaceScalarField>
Foam::cghs::fluidModel::faceGradP() const
{
    return fvc::snGrad(p_)*mesh_.magSf();
}


Foam::tmp<Foam::surfaceScalarField> Foam::cghs::fluidModel::wholeFlux()
{
    tmp<surfaceScalarField> tflux(new surfaceScalarField(contentFlux()));

    if (yield_.active())
    {
        tflux.ref() += carriedContentf()/alphaf_*yield_.flux();
    }

    return tflux;
}


void Foam::cghs::fluidModel::addOptions(fvVectorMatrix& UEqn)
{
    optionSource_ = contentSource(*options_);
    optionSource_.ref().rename("contentSource");

    // The equation is that of u, not of c u: what comes in is not yet as fast
    UEqn += fvm::Sp(posPart(optionSource_()), U_);
    UEqn -= momentumSource(*options_);

    source_ = new volScalarField(optionSource_());
}


void Foam::cghs::fluidModel::addParcelMass(fvVectorMatrix& UEqn)
{
    const dimensionedScalar rho0(momentumDensity());

    addTo
    (
        source_,
        tmp<volScalarField>((parcelMass_.in() - parcelMass_.out())/rho0)
    );

    UEqn += fvm::Sp(parcelMass_.in()/rho0, U_);
    UEqn -= parcelMass_.momentum()/rho0;
}


void Foam::cghs::fluidModel::addSources(fvVectorMatrix& UEqn)
{
    source_.clear();
    optionSource_.clear();

    if (options_->size())
    {
        addOptions(UEqn);
    }
    if (parcelMass_.any())
    {
        addParcelMass(UEqn);
    }
    if (source_.valid())
    {
        checkSource(source_());
    }
}


void Foam::cghs::fluidModel::predictVelocity(const fvVectorMatrix& UEqn)
{
    Foam::solve
    (
        UEqn
     ==
        reconstruct_
        (
            contentf()*gravity_->inGradients() - alphaf_*faceGradP()
        )
    );
}


Foam::tmp<Foam::surfaceScalarField> Foam::cghs::fluidModel::predictedFlux
(
    const volVectorField& HbyA,
    const surfaceScalarField& content,
    const surfaceScalarField& rAUf,
    const surfaceScalarField& forces
)
{
    surfaceScalarField inertia(content*rAUf);

    if (nPasses_ > 1)
    {
        // It is the step at most. Between unlike gases the mean of 1/A is that
        // of the light one, content that of the heavy one: what the fluxes
        // differ by from U would grow from step to step
        inertia = min(inertia, mesh_.time().deltaT());
    }

    tmp<surfaceScalarField> tflux
    (
        new surfaceScalarField
        (
            "phiHbyA",
            fvc::flux(HbyA) + inertia*fvc::ddtCorr(U_, phi_)
        )
    );
    surfaceScalarField& phiHbyA = tflux.ref();

    closeFluxes(phiHbyA);

    // Where the pressure gradient is free, the forces are those of the cell
    // beside: the given velocity is the result of their balance, not of there
    // being none
    setBalancedFlux
    (
        phiHbyA,
        p_,
        HbyA,
        [](const fvPatchVectorField& values)
        {
            return values.patchInternalField();
        }
    );
    phiHbyA += forces;

    return tflux;
}


Foam::tmp<Foam::fvScalarMatrix> Foam::cghs::fluidModel::pressureEquation
(
    const surfaceScalarField& mobility,
    const surfaceScalarField& predicted
)
{
    tmp<fvScalarMatrix> tpEqn
    (
        fvm::laplacian(mobility, p_) == fvc::div(predicted)
    );
    addStorage(tpEqn.ref());

    if (source_.valid())
    {
        tpEqn.ref() += source_();
    }

    return tpEqn;
}


void Foam::cghs::fluidModel::takeFluxes
(
    const surfaceScalarField& phiHbyA,
    const surfaceScalarField& content,
    const surfaceScalarField& gradient,
    const surfaceScalarField& pFlux
)
{
    // The result where p balances the forces is the given velocity, to the last
    // digit
    phi_ = phiHbyA - pFlux;
    setBalancedFlux
    (
        phi_,
        p_,
        U_,
        [](const fvPatchVectorField& values)
            -> const fvPatchVectorField& { return values; }
    );
    contentFlux() = content*phi_;

    if (yield_.active())
    {
        yield_.update(phi_, gradient);
    }
}


void Foam::cghs::fluidModel::correctPressure
(
    const momentumSystem& system
)
{
    const volScalarField& rAU = system.rAU;
    const surfaceScalarField& rAUf = system.rAUf;
    const surfaceScalarField& forces = system.forces;
    const volVectorField HbyA(constrainHbyA(rAU*system.UEqn.H(), U_, p_));
    const tmp<surfaceScalarField> tcontentf(carriedContentf());
    const surfaceScalarField& content = tcontentf();
    const tmp<surfaceScalarField> tflux
    (
        predictedFlux(HbyA, content, rAUf, forces)
    );
    const surfaceScalarField& phiHbyA = tflux();
    surfaceScalarField alpharAUf("alpharAUf", alphaf_*rAUf);

    if (yield_.active())
    {
        alpharAUf += yield_.share()*rAUf;
    }
    constrainPressure(p_, U_, phiHbyA, alpharAUf);

    surfaceScalarField mobility("mobility", content*alpharAUf);
    surfaceScalarField predicted("predicted", content*phiHbyA);

    if (yield_.active())
    {
        const surfaceScalarField filling(content/alphaf_);

        mobility += filling*yield_.mobility(alpharAUf);
        predicted += filling*yield_.rest(phiHbyA);
    }

    while (piso_.correctNonOrthogonal())
    {
        tmp<fvScalarMatrix> tpEqn(pressureEquation(mobility, predicted));
        fvScalarMatrix& pEqn = tpEqn.ref();

        pEqn.solve(mesh_.solver(p_.select(piso_.finalInnerIter())));

        if (piso_.finalNonOrthogonalIter())
        {
            const surfaceScalarField gradient(pEqn.flux()/mobility);
            const surfaceScalarField pFlux(alpharAUf*gradient);

            takeFluxes(phiHbyA, content, gradient, pFlux);
            pressureSolved();

            U_ = HbyA + rAU*reconstruct_((forces - pFlux)/rAUf);
            U_.correctBoundaryConditions();
            options_->correct(U_);
        }
    }
}


void Foam::cghs::fluidModel::measureContinuity()
{
    tmp<volScalarField> defect(contentGain(wholeFlux()));

    if (source_.valid())
    {
        defect.ref() -= source_();
    }

    continuityError_ =
        gMax(mag(defect().primitiveField())())
       *mesh_.time().deltaTValue()/fullContent();
}


bool Foam::cghs::fluidModel::pass
(
    const momentumSystem& system,
    const cghsCloud& cloud
)
{
    while (piso_.correct())
    {
        correctPressure(system);
    }

    if (!velocitySolved())
    {
        return false;
    }
    if (transported_.empty())
    {
        return true;
    }

    const bool done = solveTransported
    (
        momentumDensity()*wholeFlux(),
        cloud,
        [&]() { return nPasses_ > 1 || compositionFits(); }
    );

    return done && fits();
}


void Foam::cghs::fluidModel::startAgain
(
    const momentumSystem& system,
    const cghsCloud& cloud
)
{
    U_ == U_.oldTime();
    p_ == p_.oldTime();
    takeGradients(p_);
    phi_ == phi_.oldTime();

    if (yield_.active())
    {
        yield_.update(phi_, faceGradP());
    }

    transported_.takeBack();

    const tmp<surfaceScalarField> flux(displace(volumeFlux(), source_));

    U_.correctBoundaryConditions();

    if (piso_.momentumPredictor())
    {
        predictVelocity(system.UEqn);
    }

    solveTransported(flux, cloud, []() { return true; });
}


void Foam::cghs::fluidModel::makeStep
(
    const momentumSystem& system,
    const cghsCloud& cloud
)
{
    constexpr label most = 20;

    nPasses_ = 1;

    while (!pass(system, cloud) && nPasses_ < most)
    {
        if (nPasses_ == 1)
        {
            startAgain(system, cloud);
        }

        follow();
        transported_.takeBack();
        ++nPasses_;
    }
}


void Foam::cghs::fluidModel::solveFor
(
    fvVectorMatrix& UEqn,
    const cghsCloud& cloud
)
{
    addSources(UEqn);

    UEqn.relax();
    options_->constrain(UEqn);

    momentumSystem system(UEqn, contentf(), gravity_->inFluxes());

    if (piso_.momentumPredictor())
    {
        predictVelocity(UEqn);
    }
    if (yield_.active())
    {
        system.forces += yield_.before()*system.rAUf;
    }

    makeStep(system, cloud);
    measureContinuity();

    if (yield_.active())
    {
        yield_.finish();
    }

    transported_.finishStep();
    finishStep();
}


void Foam::cghs::fluidModel::tellGain
(
    const fvVectorMatrix& exchange,
    momentum& solids
) const
{
    const vectorField& U = U_.primitiveField();
    const vectorField& U0 = U_.oldTime().primitiveField();
    const vectorField& source = exchange.source();
    const scalarField& diag = exchange.diag();
    vector gained(Zero);
    scalar exchanged = 0;

    forAll(U, celli)
    {
        gained += source[celli] - diag[celli]*U[celli];
        exchanged +=
            mag(source[celli] - diag[celli]*U0[celli])
          + diag[celli]*mag(U[celli] - U0[celli]);
    }

    const scalar scale =
        momentumDensity().value()*mesh_.time().deltaTValue();

    solids.setGain(scale*gained, scale*exchanged);
}


void Foam::cghs::fluidModel::solveBeside
(
    const volVectorField& drag,
    const volScalarField& response,
    cghsCloud& cloud
)
{
    addProfiling(fluid, "cghs::fluid");

    const volScalarField R("dragResponse", response/momentumDensity());
    const fvVectorMatrix exchange
    (
        fvm::Sp(R, U_) == R*U_.oldTime() - drag/momentumDensity()
    );

    fvVectorMatrix UEqn(momentumEquation() + exchange);
    solveFor(UEqn, cloud);

    tellGain(exchange, cloud.momentumExchange());
}


void Foam::cghs::fluidModel::solveAlone(const cghsCloud& cloud)
{
    addProfiling(fluid, "cghs::fluid");

    tmp<fvVectorMatrix> UEqn(momentumEquation());
    solveFor(UEqn.ref(), cloud);
}


void Foam::cghs::fluidModel::solveInFrozenFlow(const cghsCloud& cloud)
{
    if (transported_.empty())
    {
        return;
    }

    addProfiling(fluid, "cghs::fluid");

    nPasses_ = 1;
    parcelMass_ = massTerms();

    solveTransported
    (
        momentumDensity()*wholeFlux(),
        cloud,
        []() { return true; }
    );
    measureContinuity();
    transported_.finishStep();
}


void Foam::cghs::fluidModel::solve(cghsCloud& cloud)
{
    if (frozen_)
    {
        solveInFrozenFlow(cloud);
    }
    else if (cloud.isFelt())
    {
        momentum& solids = cloud.momentumExchange();

        parcelMass_ = feelsMass() ? cloud.massGiven() : massTerms();

        setSolids(solids.solidsFraction());
        setYield(solids.yieldToVelocity(), solids.yieldToGradient());

        const volScalarField response(solids.dragResponse());

        solveBeside
        (
            solids.drag(mesh_.time().deltaTValue(), U_, rho(), response),
            response,
            cloud
        );
    }
    else
    {
        parcelMass_ = massTerms();
        solveAlone(cloud);
    }
}


Foam::tmp<Foam::surfaceScalarField> Foam::cghs::fluidModel::volumeFlux() const
{
    tmp<surfaceScalarField> tflux(alphaf_*phi_);

    if (yield_.active())
    {
        tflux.ref() += yield_.flux();
    }

    return tflux;
}


Foam::tmp<Foam::volScalarField>
Foam::cghs::fluidModel::dissipation(const cghsCloud& cloud) const
{
    tmp<volScalarField> power(viscousStress() && fvc::grad(U_));

    if (cloud.isFelt())
    {
        power.ref() +=
            cloud.momentumExchange().dissipation(cloud.parcels());
    }

    return power;
}


bool Foam::cghs::fluidModel::solveTransported
(
    const tmp<surfaceScalarField>& massFlux,
    const cghsCloud& cloud,
    const std::function<bool()>& goOn
)
{
    tmp<volScalarField> massSource;

    if (optionSource_.valid())
    {
        massSource = momentumDensity()*optionSource_();
    }

    tmp<volScalarField> given;

    if (parcelMass_.any())
    {
        given = parcelMass_.in() - parcelMass_.out();
    }

    tmp<volScalarField> heating;

    if (transported_.dissipates())
    {
        heating = dissipation(cloud);
    }

    const bool done = transported_.solve
    (
        alpha_,
        rho(),
        massFlux(),
        volumeFlux()(),
        massSource,
        given,
        heating,
        *options_,
        cloud,
        goOn
    );

    if (done)
    {
        transportedSolved();
    }

    return done;
}


const Foam::surfaceScalarField*
Foam::cghs::fluidModel::speciesWeights() const
{
    const species* mixing = transported_.mixing();

    return mixing ? &mixing->weights() : nullptr;
}


Foam::scalar Foam::cghs::fluidModel::totalSource() const
{
    return source_.valid() ? fvc::domainIntegrate(source_()).value() : 0;
}


Foam::tmp<Foam::volVectorField> Foam::cghs::fluidModel::gradPNow() const
{
    // That of a fluid at rest is known without any scheme
    const surfaceScalarField rhof(contentf()/alphaf_);

    return
        momentumDensity()
       *(
            relativeDensity()*g_
          + reconstruct_(faceGradP() - rhof*gravity_->inGradients())
        );
}


const Foam::volVectorField& Foam::cghs::fluidModel::gradP()
{
    gradP_ = gradPNow();

    return gradP_;
}


const Foam::volScalarField&
Foam::cghs::fluidModel::field(const word& name) const
{
    return transported_.field(name);
}


Foam::tmp<Foam::volScalarField>
Foam::cghs::fluidModel::change(const word& name) const
{
    return transported_.change(name);
}


Foam::tmp<Foam::volVectorField> Foam::cghs::fluidModel::dU() const
{
    return U_ - U_.oldTime();
}


Foam::tmp<Foam::volVectorField> Foam::cghs::fluidModel::dGradP() const
{
    return gradPNow() - gradP_;
}

// * * * * * * * * * * * * * * * * Reports * * * * * * * * * * * * * * * * * //

Foam::List<Foam::cghs::figure> Foam::cghs::fluidModel::errors() const
{
    List<figure> list
    ({
        {"Courant", courantNumber()},
        {"volumeDefect", continuityError_}
    });
    list.append(transported_.errors());

    return list;
}


void Foam::cghs::fluidModel::report(Ostream& os) const
{
    os  << "fluid:  Courant number " << courantNumber()
        << ", volume defect " << continuityError_ << nl;

    transported_.report(os);
}
