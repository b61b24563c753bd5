/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "gas.H"
#include "temperature.H"
#include "composition.H"
#include "psiReactionThermo.H"
#include "fvm.H"
#include "fvc.H"
#include "EulerDdtScheme.H"
#include "fixedValueFvPatchFields.H"
#include "zeroGradientFvPatchFields.H"
#include "sharedWeights.H"
#include "carriedDensity.H"
#include "checkedEntry.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(gas, 0);
    addToRunTimeSelectionTable(fluidModel, gas, cloud);
    describeModel
    (
        fluidModel,
        gas,
        "ideal gas, isothermal or with energy and species; p in Pa"
    );


//- The gas of the case's dictionary. Its density is psi p, with psi that does
//  not depend on p
static autoPtr<psiThermo> idealGas
(
    const fvMesh& mesh,
    const dictionary& solution
)
{
    checkThermophysics
    (
        mesh,
        solution,
        fluidModel::typeName + (" is " + gas::typeName),
        "see gas.H, or choose incompressible"
    );
    checkTemperature(mesh);

    autoPtr<psiThermo> thermo;

    if (transported::selected(solution).found("species"))
    {
        checkMixture(mesh);
        thermo.reset(psiReactionThermo::New(mesh).ptr());
    }
    else
    {
        thermo = psiThermo::New(mesh);
    }

    if (thermo->type().find("perfectGas") == std::string::npos)
    {
        FatalIOErrorInFunction(thermo->subDict("thermoType"))
            << "Entry equationOfState is "
            << thermo->subDict("thermoType").get<word>("equationOfState")
            << " but a fluid " << gas::typeName
            << " must be an ideal gas" << nl
            << "Valid choices: perfectGas" << nl
            << exit(FatalIOError);
    }

    return thermo;
}


//- Let coupled patches know what is beyond: decomposePar does not where ranks
//  meet at cyclic faces
static void meetNeighbours(volScalarField& field)
{
    volScalarField::Boundary& patches = field.boundaryFieldRef();
    const label nRequests = Pstream::nRequests();

    for (fvPatchScalarField& there : patches)
    {
        if (there.coupled())
        {
            there.initEvaluate(Pstream::commsTypes::nonBlocking);
        }
    }

    Pstream::waitRequests(nRequests);

    for (fvPatchScalarField& there : patches)
    {
        if (there.coupled())
        {
            there.evaluate(Pstream::commsTypes::nonBlocking);
        }
    }
}

//- After a restart, take mass fractions as they were written. The mixture
//  divides them by their sum when it reads them: the last digits would be others
static void takeWritten(PtrList<volScalarField>& Y)
{
    const fvMesh& mesh = Y[0].mesh();

    if (mesh.time().startTimeIndex() == 0)
    {
        return;
    }

    PtrList<volScalarField> written(Y.size());
    scalarField sum(mesh.nCells(), Zero);

    forAll(Y, k)
    {
        const IOobject io
        (
            Y[k].name(),
            mesh.time().timeName(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        );
        if (!IOobject(io).typeHeaderOk<volScalarField>(true))
        {
            return;
        }
        written.set(k, new volScalarField(io, mesh));
        sum += written[k].primitiveField();
    }

    if (gMax(mag(sum - 1)()) < 1e-12)
    {
        forAll(Y, k)
        {
            Y[k] == written[k];
        }
    }
}

} // End namespace cghs
} // End namespace Foam

// * * * * * * * * * * * * * * * Construction  * * * * * * * * * * * * * * * //

Foam::cghs::gas::densityLag Foam::cghs::gas::readLag
(
    const dictionary& solution
)
{
    const auto read = [&](const word& entry, const scalar ifNone)
    {
        const scalar value = solution.getOrDefault<scalar>(entry, ifNone);
        checkRange(solution, entry, value, scalar(1e-8), scalar(GREAT));

        return value;
    };

    return densityLag
    {
        read("compositionLag", 0.05),
        read("temperatureLag", 0.5),
        read("densityTolerance", 1e-3)
    };
}


Foam::cghs::gas::gas
(
    fvMesh& mesh,
    const dimensionedVector& g,
    const cghsCloud& cloud
)
:
    fluidModel(mesh, g, cloud, dimPressure),
    thermo_(idealGas(mesh, cloud.properties().subDict("solution"))),
    mixture_(startMixture()),
    rho_
    (
        IOobject
        (
            "rho",
            mesh.time().timeName(),
            mesh,
            psiChanges()
          ? IOobject::READ_IF_PRESENT
          : IOobject::NO_READ,
            IOobject::AUTO_WRITE
        ),
        thermo_->psi()*p_
    ),
    lag_(readLag(cloud.properties().subDict("solution"))),
    rhof_("rhof", fvc::interpolate(rho_)),
    mu_("mu", thermo_->mu()),
    alphaRhoPhi_("alphaRhoPhi", contentf()*phi_),
    mass_(massNow()),
    massDefect_(0)
{
    checkAboveZero(p_, "p is the absolute pressure [Pa], e.g. 101325");

    restingPressure start(p_, gravity_());

    if (start.isToFind())
    {
        startAtRest(start);
    }

    turbulence_ =
        turbulenceModel::New
        (
            alpha_,
            rho_,
            U_,
            alphaRhoPhi_,
            phi_,
            thermo_()
        );

    standIn_.reset(new standIn(turbulence_(), rho_, phi_, thermo_()));

    p_.oldTime();
    rho_.oldTime();
    thermo_->psi().oldTime();

    if (psiChanges())
    {
        // psi follows T and composition before the next pressure does. The
        // density is the state between steps, and its mass is kept
        psiOfRho_.reset(new volScalarField("psiOfRho", rho_/p_));
        psiOfRho_->oldTime();
    }
}


Foam::basicSpecieMixture* Foam::cghs::gas::startMixture()
{
    basicSpecieMixture* mixture = nullptr;

    meetNeighbours(thermo_->T());

    if (transports("species"))
    {
        mixture = &refCast<psiReactionThermo>(thermo_()).composition();
        takeWritten(mixture->Y());

        for (volScalarField& Y : mixture->Y())
        {
            meetNeighbours(Y);
        }
    }

    if (mixture || Pstream::parRun())
    {
        keepTemperature();
    }

    return mixture;
}


void Foam::cghs::gas::startAtRest(restingPressure& start)
{
    const scalarField& psi = thermo_->psi().primitiveField();
    scalarField p(start.mean()*exp(psi*start.potential()));

    if (p_.needReference())
    {
        // A closed gas keeps its mass
        const scalarField room(mesh().V()*alpha_.primitiveField()*psi);
        p *= gSum(room*p_.primitiveField())/gSum(room*p);
    }

    start.set(p, rho_);
    pressureSolved();
    contentFlux() = contentf()*phi_;
    mass_ = massNow();
}


Foam::scalar Foam::cghs::gas::massNow() const
{
    return fvc::domainIntegrate(alpha_*rho_).value();
}

// * * * * * * * * * * * * * * * * The step  * * * * * * * * * * * * * * * * //

Foam::tmp<Foam::fvVectorMatrix> Foam::cghs::gas::momentumEquation()
{
    // With the density at the end of the step before, as after a restart
    alphaRhoPhi_ = contentf()*phi_;

    if (psiOfRho_.valid())
    {
        psiOfRho_() = thermo_->psi();
    }

    return
        fvm::ddt(alpha_, rho_, U_)
      + fvm::div(alphaRhoPhi_, U_)
      - fvm::Sp(fvc::ddt(alpha_, rho_) + fvc::div(alphaRhoPhi_), U_)
      + turbulence_->divDevRhoReff(U_);
}


void Foam::cghs::gas::addStorage(fvScalarMatrix& pEqn) const
{
    tmp<fvScalarMatrix> tstorage(fvm::ddt(alpha_, psi(), p_));

    if (slope_.valid())
    {
        // The same at the p that there is, but another slope
        fvScalarMatrix& storage = tstorage.ref();
        const scalarField steeper
        (
            storage.diag()*(slope_()/psi() - 1)().primitiveField()
        );

        storage.diag() += steeper;
        storage.source() += steeper*pBefore_().primitiveField();
    }

    pEqn -= tstorage;
}


void Foam::cghs::gas::pressureSolved()
{
    if (slope_.valid())
    {
        psiOfRho_() = (psi()*pBefore_() + slope_()*(p_ - pBefore_()))/p_;
        pBefore_() == p_;
    }

    rho_ = psi()*p_;
    setFaces();
}


Foam::tmp<Foam::volScalarField>
Foam::cghs::gas::contentGain
(
    const surfaceScalarField& flux
) const
{
    return fvc::ddt(alpha_, rho_) + fvc::div(flux);
}


Foam::scalar Foam::cghs::gas::fullContent() const
{
    return gAverage(rho_.primitiveField());
}


Foam::tmp<Foam::volScalarField>
Foam::cghs::gas::contentSource(fv::optionList& options)
{
    return options(rho_) & rho_;
}


Foam::tmp<Foam::fvVectorMatrix>
Foam::cghs::gas::momentumSource(fv::optionList& options)
{
    return options(rho_, U_);
}


bool Foam::cghs::gas::velocitySolved()
{
    const scalar lowest = gMin(p_.primitiveField());

    if (!(lowest > 0))
    {
        if (nPasses() == 1 && psiChanges())
        {
            return false;
        }

        FatalErrorInFunction
            << "The pressure of the gas has fallen to " << lowest
            << " Pa: the run has gone out of hand." << nl
            << "Lower maxCo or maxDeltaT, or raise nCorrectors of PISO" << nl
            << exit(FatalError);
    }

    turbulence_->correct();

    return true;
}


void Foam::cghs::gas::finishStep()
{
    scalar outflow = 0;
    for (const fvsPatchScalarField& flux : alphaRhoPhi_.boundaryField())
    {
        if (!flux.coupled())
        {
            outflow += sum(flux);
        }
    }
    reduce(outflow, sumOp<scalar>());

    const scalar before = mass_;
    mass_ = massNow();
    massDefect_ +=
        mass_ - before
      + (outflow - totalSource())*mesh().time().deltaTValue();

    if (psiChanges())
    {
        mu_ = thermo_->mu();
    }
    if (nPasses() > 1)
    {
        warnOfMisfit();
        slope_.clear();
        pBefore_.clear();
        carriedRhof_.clear();
        mixingFlux_.clear();
    }
}


void Foam::cghs::gas::keepTemperature()
{
    const volScalarField& p = thermo_->p();
    const volScalarField& T = thermo_->T();
    volScalarField& he = thermo_->he();

    he.primitiveFieldRef() =
        thermo_->he
        (
            p.primitiveField(),
            T.primitiveField(),
            identity(mesh().nCells())
        );
    forAll(T.boundaryField(), patchi)
    {
        he.boundaryFieldRef()[patchi] ==
            thermo_->he
            (
                p.boundaryField()[patchi],
                T.boundaryField()[patchi],
                patchi
            );
    }

    thermo_->correct();
}


void Foam::cghs::gas::transportedSolved()
{
    if (mixture_ && !transports("energy"))
    {
        keepTemperature();
    }
    if (carriedRhof_.valid())
    {
        mixingFlux_.reset(new surfaceScalarField("mixingFlux", phi_));
    }
}


// * * * * * * Density that follows what is transported * * * * * * * * * * * //

void Foam::cghs::gas::setFaces()
{
    rhof_ = fvc::interpolate(rho_);

    if (carriedRhof_.valid())
    {
        const surfaceScalarField* byMass = speciesWeights();

        carriedRhof_() = surfaceInterpolationScheme<scalar>::interpolate
        (
            rho_,
            byMass
          ? mixingWeights(rho_, *byMass, mixingFlux_())
          : donorWeights(rho_, phi_)
        );
    }
}


Foam::scalar Foam::cghs::gas::misfit() const
{
    return
        gMax
        (
            mag
            (
                thermo_->psi().primitiveField()
               /psiOfRho_().primitiveField()
              - 1
            )()
        );
}


Foam::scalar Foam::cghs::gas::answered(const scalar change) const
{
    const scalarField& psi = thermo_->psi().primitiveField();

    return change*gMax(psi)/gMin(psi);
}


bool Foam::cghs::gas::compositionFits() const
{
    if (!mixture_)
    {
        return true;
    }

    // Moles per mass
    scalarField now(mesh().nCells(), Zero);
    scalarField before(mesh().nCells(), Zero);

    forAll(mixture_->Y(), k)
    {
        const volScalarField& Y = mixture_->Y(k);

        now += Y.primitiveField()/mixture_->W(k);
        before += Y.oldTime().primitiveField()/mixture_->W(k);
    }

    return answered(gMax(mag(before/now - 1)())) <= lag_.composition;
}


bool Foam::cghs::gas::fits() const
{
    if (nPasses() > 1)
    {
        return misfit() <= lag_.tolerance;
    }

    return
        !psiChanges()
     || (
            answered(misfit())
         <= (transports("energy") ? lag_.temperature : lag_.composition)
        );
}


void Foam::cghs::gas::warnOfMisfit() const
{
    static bool warned = false;
    const scalar left = misfit();

    if (warned || left <= lag_.tolerance)
    {
        return;
    }

    warned = true;
    WarningInFunction
        << "After " << nPasses() << " passes of a step the density still"
        << " differs by " << left << " from that of composition and T, but"
        << " densityTolerance is " << lag_.tolerance << nl
        << "    Pressures and velocities may be wrong at that time. Take"
        << " shorter steps, or Gauss upwind for div(alphaRhoPhi,"
        << (mixture_ ? word("Yi_h") : thermo_->he().name()) << ')' << nl
        << "    This is said once, passes are in the log of each step"
        << nl << endl;
}


Foam::tmp<Foam::volScalarField> Foam::cghs::gas::compressibility() const
{
    return
        enthalpyTakesPressure()
      ? psi()/thermo_->gamma()
      : 1*psi();
}


void Foam::cghs::gas::follow()
{
    // What swings between two states comes to rest between them
    const scalar share = nPasses() < 12 ? 1 : 0.5;

    psiOfRho_() += share*(thermo_->psi() - psiOfRho_());
    rho_ = psi()*p_;
    slope_.reset(new volScalarField("slope", compressibility()));
    setFaces();
    pBefore_.reset(new volScalarField("pBefore", p_));
}


Foam::tmp<Foam::surfaceScalarField> Foam::cghs::gas::displace
(
    const surfaceScalarField& volumeFlux,
    const tmp<volScalarField>& source
)
{
    rho_ == rho_.oldTime();
    setFaces();

    // From now on: passes follow
    carriedRhof_.reset(new surfaceScalarField("carriedRhof", rhof_));

    wordList types(rho_.boundaryField().types());

    forAll(types, patchi)
    {
        if (!rho_.boundaryField()[patchi].coupled())
        {
            types[patchi] =
                gSum(volumeFlux.boundaryField()[patchi]) < 0
              ? fixedValueFvPatchScalarField::typeName
              : zeroGradientFvPatchScalarField::typeName;
        }
    }

    volScalarField moved
    (
        IOobject("moved", rho_.time().timeName(), rho_.mesh()),
        rho_,
        types
    );
    moved.oldTime() == rho_.oldTime();
    mesh().setFluxRequired(moved.name());

    fvScalarMatrix equation
    (
        fv::EulerDdtScheme<scalar>(rho_.mesh()).fvmDdt(alpha_, moved)
      + sharedWeights::convection(volumeFlux, moved, donorWeights(rho_, phi_))
    );

    if (source.valid())
    {
        equation -= source();
    }

    equation.solve
    (
        mesh().solver(mixture_ ? word("Yi") : thermo_->he().name())
    );
    rho_ == moved;

    return equation.flux();
}


Foam::tmp<Foam::volScalarField> Foam::cghs::gas::mut() const
{
    return rho_*turbulence_->nut();
}


Foam::List<Foam::cghs::figure> Foam::cghs::gas::errors() const
{
    List<figure> list(fluidModel::errors());
    list.append({"gasDefect", mag(massDefect_)/max(mass_, VSMALL)});

    return list;
}


void Foam::cghs::gas::report(Ostream& os) const
{
    fluidModel::report(os);

    os  << "gas:    " << mass_ << " kg, of which " << massDefect_
        << " kg from nowhere" << nl;

    if (nPasses() > 1)
    {
        os  << "        " << nPasses() << " passes, psi to " << misfit() << nl;
    }
}
