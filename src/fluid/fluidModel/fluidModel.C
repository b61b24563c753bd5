/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "fluidModel.H"
#include "fvm.H"
#include "fvc.H"
#include "fvcFlux.H"
#include "constrainHbyA.H"
#include "constrainPressure.H"
#include "fixedFluxPressureFvPatchScalarField.H"
#include "zeroGradientFvPatchFields.H"
#include "basicSymmetryFvPatchField.H"
#include "checkedEntry.H"
#include "localIOdictionary.H"
#include "profiling.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(fluidModel, 0);
    defineRunTimeSelectionTable(fluidModel, cloud);


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


//- The solids that the fluid takes notice of
static tmp<volScalarField> solidsMet(const cghsCloud& parcels)
{
    return
        parcels.coupling() == cghsCloud::couplingType::twoWay
      ? parcels.momentumExchange().solidsFraction()
      : parcels.momentumExchange().noSolids();
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
    const cghsCloud& parcels,
    const dimensionSet& pressure
)
:
    mesh_(mesh),
    reconstruct_(mesh),
    yield_
    (
        mesh,
        parcels.coupling() == cghsCloud::couplingType::twoWay
    ),
    piso_(mesh),
    g_(g),
    transportedNames_
    (
        transported::selected(parcels.properties().subDict("solution"))
    ),
    minVoidage_
    (
        scalarInRange
        (
            parcels.properties().subDict("solution"),
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
        boundedVoidage(solidsMet(parcels))
    ),
    alphaf_("alphaf", fvc::interpolate(alpha_))
{
    checkTransient();
    checkPressure(pressure);
    checkSolids(parcels);
    balanceWalls();
    mesh_.setFluxRequired(p_.name());
    gravity_.reset(new faceGravity(p_, g_));

    // An old value is only kept from now on if it is asked for now
    alpha_.oldTime();
    U_.oldTime();
}


Foam::dictionary Foam::cghs::fluidModel::fileOf(const volScalarField& field)
{
    return localIOdictionary
    (
        IOobject
        (
            field.name(),
            field.time().timeName(),
            field.mesh(),
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        ),
        field.type()
    );
}


void Foam::cghs::fluidModel::checkPressure(const dimensionSet& wanted) const
{
    if (p_.dimensions() != wanted)
    {
        FatalIOErrorInFunction(fileOf(p_))
            << "Entry dimensions is " << p_.dimensions()
            << " but must be " << wanted << " for the "
            << typeName << " that is chosen" << nl
            << "Mend p, or choose another " << typeName
            << " in the solution of the cloud's properties: incompressible"
            << " takes p over the density, gas p" << nl
            << exit(FatalIOError);
    }
}


void Foam::cghs::fluidModel::checkTransient() const
{
    const fvSchemes& schemes = mesh_;

    if (schemes.steady())
    {
        FatalIOErrorInFunction(schemes.subDict("ddtSchemes"))
            << "Entry default is steadyState, but parcels move in time" << nl
            << "Choose a scheme of transient flow: Euler, backward or"
            << " CrankNicolson" << nl
            << exit(FatalIOError);
    }
}


void Foam::cghs::fluidModel::checkSolids(const cghsCloud& parcels) const
{
    const scalar lowest = gMin(alpha_.primitiveField());

    if (parcels.empty() && lowest < 1 - SMALL)
    {
        FatalIOErrorInFunction(fileOf(alpha_))
            << "alpha goes down to " << lowest << ", so there have been solids,"
            << " but the cloud " << parcels.name() << " has no parcels in "
            << mesh_.time().timePath()/cloud::prefix/parcels.name() << nl
            << "Restore that folder, or restart from a time that has it, or fill"
            << " the mesh with fillParcels; or remove alpha to begin without"
            << " solids" << nl
            << exit(FatalIOError);
    }
}


void Foam::cghs::fluidModel::balanceWalls()
{
    DynamicList<word> balanced;

    forAll(mesh_.boundary(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        const fvPatchVectorField& U = U_.boundaryField()[patchi];
        const bool given =
            (U.fixesValue() && !U.assignable())
         || isA<basicSymmetryFvPatchField<vector>>(U);

        if
        (
            given
         && p_.boundaryField()[patchi].type()
         == zeroGradientFvPatchScalarField::typeName
        )
        {
            p_.boundaryFieldRef().set
            (
                patchi,
                new fixedFluxPressureFvPatchScalarField
                (
                    patch,
                    p_.internalField()
                )
            );
            fvPatchScalarField& p = p_.boundaryFieldRef()[patchi];
            p == p.patchInternalField();
            balanced.append(patch.name());
        }
    }

    if (balanced.size())
    {
        Info<< "p is zeroGradient at " << flatOutput(balanced)
            << ", where U is given: it is taken as fixedFluxPressure, so that"
            << " it balances weight and drag in the cells beside" << nl << endl;
    }
}


bool Foam::cghs::fluidModel::pressureIsToFind() const
{
    return
        mesh_.time().timeIndex() == 0
     && gMax(p_.primitiveField()) == gMin(p_.primitiveField());
}


Foam::scalar Foam::cghs::fluidModel::meanPressure() const
{
    scalar sumP = 0;
    scalar area = 0;

    for (const fvPatchScalarField& p : p_.boundaryField())
    {
        if (p.fixesValue() && !p.coupled())
        {
            sumP += sum(p.patch().magSf()*p);
            area += sum(p.patch().magSf());
        }
    }
    reduce(sumP, sumOp<scalar>());
    reduce(area, sumOp<scalar>());

    return area > 0 ? sumP/area : gAverage(p_.primitiveField());
}


void Foam::cghs::fluidModel::startWith
(
    const scalarField& p,
    const volScalarField& density
)
{
    p_.primitiveFieldRef() = p;

    for (fvPatchScalarField& pp : p_.boundaryFieldRef())
    {
        const label patchi = pp.patch().index();

        if (faceGravity::balances(pp))
        {
            refCast<fixedFluxPressureFvPatchScalarField>(pp).updateSnGrad
            (
                density.boundaryField()[patchi]
               *gravity_->potential().boundaryField()[patchi].snGrad()
            );
        }
    }
    p_.correctBoundaryConditions();
}


Foam::autoPtr<Foam::cghs::fluidModel>
Foam::cghs::fluidModel::New
(
    fvMesh& mesh,
    const dimensionedVector& g,
    const cghsCloud& parcels
)
{
    if (parcels.coupling() == cghsCloud::couplingType::none)
    {
        return nullptr;
    }

    const dictionary& solution = parcels.properties().subDict("solution");
    word modelType(solution.getOrDefault<word>(typeName, "incompressible"));

    // Its name when it could be nothing else
    if (modelType == "isothermalGas")
    {
        modelType = "gas";
    }
    const auto constructor = cloudConstructorTablePtr_->cfind(modelType);

    if (!constructor.found())
    {
        FatalIOErrorInFunction(solution)
            << "Unknown " << typeName << ' ' << modelType << nl << nl
            << "Valid choices:" << nl
            << cloudConstructorTablePtr_->sortedToc() << nl
            << exit(FatalIOError);
    }

    autoPtr<fluidModel> fluid(constructor()(mesh, g, parcels));

    for (const word& name : fluid->transportedNames_)
    {
        fluid->transported_.append(transported::New(name, solution, fluid()));
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
        tflux.ref() += contentf()/alphaf_*yield_.flux();
    }

    return tflux;
}


template<class Velocity>
void Foam::cghs::fluidModel::setBalancedFlux
(
    surfaceScalarField& flux,
    const volVectorField& field,
    const Velocity& velocity
) const
{
    forAll(field.boundaryField(), patchi)
    {
        if (pressureBalances(patchi))
        {
            const fvPatchVectorField& values = field.boundaryField()[patchi];

            flux.boundaryFieldRef()[patchi] =
                velocity(values) & values.patch().Sf();
        }
    }
}


Foam::tmp<Foam::surfaceScalarField>
Foam::cghs::fluidModel::gravityFlux(const surfaceScalarField& rAUf) const
{
    return contentf()*rAUf*gravity_->inFluxes();
}


void Foam::cghs::fluidModel::correctPressure
(
    const fvVectorMatrix& UEqn,
    const volScalarField& rAU,
    const surfaceScalarField& rAUf,
    const surfaceScalarField& held
)
{
    const volVectorField HbyA(constrainHbyA(rAU*UEqn.H(), U_, p_));
    surfaceScalarField alpharAUf("alpharAUf", alphaf_*rAUf);
    const tmp<surfaceScalarField> tcontentf(contentf());
    const surfaceScalarField& content = tcontentf();

    surfaceScalarField phiHbyA
    (
        "phiHbyA",
        fvc::flux(HbyA) + content*rAUf*fvc::ddtCorr(U_, phi_)
    );

    closeFluxes(phiHbyA);

    // Where the pressure gradient is free, the forces are those of the cell
    // beside: the given velocity is the result of their balance, not of there
    // being none
    setBalancedFlux
    (
        phiHbyA,
        HbyA,
        [](const fvPatchVectorField& values)
        {
            return values.patchInternalField();
        }
    );
    phiHbyA += held;

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
        fvScalarMatrix pEqn
        (
            fvm::laplacian(mobility, p_) == fvc::div(predicted)
        );
        addStorage(pEqn);

        if (source_.valid())
        {
            pEqn += source_();
        }

        pEqn.solve(mesh_.solver(p_.select(piso_.finalInnerIter())));

        if (piso_.finalNonOrthogonalIter())
        {
            const surfaceScalarField gradient(pEqn.flux()/mobility);
            const surfaceScalarField pFlux(alpharAUf*gradient);

            // The result at such a patch is the given velocity, to the last
            // digit
            phi_ = phiHbyA - pFlux;
            setBalancedFlux
            (
                phi_,
                U_,
                [](const fvPatchVectorField& values)
                    -> const fvPatchVectorField& { return values; }
            );
            contentFlux() = content*phi_;

            if (yield_.active())
            {
                yield_.update(phi_, gradient);
            }

            pressureSolved();

            U_ = HbyA + rAU*reconstruct_((held - pFlux)/rAUf);
            U_.correctBoundaryConditions();
            options_->correct(U_);
        }
    }
}


void Foam::cghs::fluidModel::addSources(fvVectorMatrix& UEqn)
{
    source_ = contentSource(*options_);
    source_.ref().rename("contentSource");

    // The equation is that of u, not of c u: what comes in is not yet as fast
    UEqn += fvm::Sp(posPart(source_()), U_);
    UEqn -= momentumSource(*options_);
}


void Foam::cghs::fluidModel::solve(fvVectorMatrix& UEqn)
{
    if (options_->size())
    {
        addSources(UEqn);
    }

    UEqn.relax();
    options_->constrain(UEqn);

    const volScalarField rAU("rAU", 1/UEqn.A());
    const surfaceScalarField rAUf("rAUf", fvc::interpolate(rAU));
    const surfaceScalarField gravity(gravityFlux(rAUf));

    if (piso_.momentumPredictor())
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

    surfaceScalarField held(gravity);

    if (yield_.active())
    {
        held += yield_.before()*rAUf;
    }

    while (piso_.correct())
    {
        correctPressure(UEqn, rAU, rAUf, held);
    }

    tmp<volScalarField> defect(contentGain(wholeFlux()));
    if (source_.valid())
    {
        defect.ref() -= source_();
    }
    continuityError_ =
        gMax(mag(defect().primitiveField())())
       *mesh_.time().deltaTValue()/fullContent();

    if (transported_.size())
    {
        keepFluxes();
    }

    if (yield_.active())
    {
        yield_.finish();
    }

    finishStep();
}


void Foam::cghs::fluidModel::solve
(
    const volVectorField& drag,
    const volScalarField& response
)
{
    addProfiling(fluid, "cghs::fluid");

    const volScalarField R("dragResponse", response/momentumDensity());

    fvVectorMatrix UEqn
    (
        momentumEquation() + fvm::Sp(R, U_)
     == R*U_.oldTime() - drag/momentumDensity()
    );
    solve(UEqn);
}


void Foam::cghs::fluidModel::solve()
{
    addProfiling(fluid, "cghs::fluid");

    tmp<fvVectorMatrix> UEqn(momentumEquation());
    solve(UEqn.ref());
}


void Foam::cghs::fluidModel::solve(cghsCloud& parcels)
{
    if (parcels.loads())
    {
        momentum& solids = parcels.momentumExchange();

        setSolids(solids.solidsFraction());
        setYield(solids.yieldToVelocity(), solids.yieldToGradient());

        const volScalarField response(solids.dragResponse());

        solve
        (
            solids.drag(mesh_.time().deltaTValue(), U_, rho(), response),
            response
        );
    }
    else
    {
        solve();
    }

    if (transported_.size())
    {
        solveTransported(parcels);
    }
}


void Foam::cghs::fluidModel::keepFluxes()
{
    massFlux_ = momentumDensity()*wholeFlux();
    volumeFlux_ = alphaf_*phi_;

    if (yield_.active())
    {
        volumeFlux_.ref() += yield_.flux();
    }
}


void Foam::cghs::fluidModel::solveTransported(const cghsCloud& parcels)
{
    for (transported& quantity : transported_)
    {
        fluidFlow flow
        {
            alpha_, rho(), massFlux_(), volumeFlux_(), nullptr, *options_
        };

        if (source_.valid())
        {
            flow.source = momentumDensity()*source_();
        }

        quantity.solve
        (
            flow,
            parcels.loads()
          ? parcels.terms(quantity.type())
          : exchangeTerms()
        );
    }

    massFlux_.clear();
    volumeFlux_.clear();
    transportedSolved();
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


const Foam::cghs::transported&
Foam::cghs::fluidModel::withField(const word& name) const
{
    wordList known;

    for (const transported& quantity : transported_)
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
        << " with radiation yes in its energyCoeffs" << nl
        << exit(FatalError);

    return transported_.first();
}


const Foam::volScalarField&
Foam::cghs::fluidModel::field(const word& name) const
{
    return withField(name).field(name);
}


Foam::tmp<Foam::volScalarField>
Foam::cghs::fluidModel::change(const word& name) const
{
    const transported& quantity = withField(name);

    if (quantity.potential() != name)
    {
        FatalErrorInFunction
            << "The change of " << name << " is not known, only that of "
            << quantity.potential() << nl
            << exit(FatalError);
    }

    return quantity.change();
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

void Foam::cghs::fluidModel::report(Ostream& os) const
{
    os  << "fluid:  Courant number " << courantNumber()
        << ", volume defect " << continuityError_ << nl;

    for (const transported& quantity : transported_)
    {
        quantity.report(os);
    }
}
