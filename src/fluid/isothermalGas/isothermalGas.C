/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "isothermalGas.H"
#include "fvm.H"
#include "fvc.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(isothermalGas, 0);
    addToRunTimeSelectionTable(fluidModel, isothermalGas, cloud);


//- Stop unless a field that the case gives is above zero
static void checkAboveZero(const volScalarField& field, const char* meaning)
{
    const scalar lowest = gMin(field.primitiveField());

    if (!(lowest > 0))
    {
        FatalIOErrorInFunction(fluidModel::fileOf(field))
            << "Entry internalField goes down to " << lowest
            << " but must be greater than zero: " << meaning << nl
            << exit(FatalIOError);
    }
}


//- Before thermodynamics divide by it
static void checkTemperature(const fvMesh& mesh)
{
    checkAboveZero
    (
        volScalarField
        (
            IOobject
            (
                "T",
                mesh.time().timeName(),
                mesh,
                IOobject::MUST_READ,
                IOobject::NO_WRITE,
                false
            ),
            mesh
        ),
        "T is the absolute temperature [K], e.g. 293"
    );
}


static void checkFile(const fvMesh& mesh, const dictionary& solution)
{
    IOobject file
    (
        basicThermo::dictName,
        mesh.time().constant(),
        mesh,
        IOobject::MUST_READ
    );

    if (!file.typeHeaderOk<IOdictionary>(true))
    {
        FatalIOErrorInFunction(solution)
            << "Entry " << fluidModel::typeName << " is "
            << isothermalGas::typeName << " but there is no file "
            << file.objectPath() << nl
            << "Write one, see isothermalGas.H, or choose incompressible" << nl
            << exit(FatalIOError);
    }
}


//- The gas of the case's dictionary. Its density is psi p, with psi that does
//  not depend on p
static autoPtr<psiThermo> idealGas
(
    const fvMesh& mesh,
    const dictionary& solution
)
{
    checkFile(mesh, solution);
    checkTemperature(mesh);

    autoPtr<psiThermo> thermo(psiThermo::New(mesh));

    if (thermo->type().find("perfectGas") == std::string::npos)
    {
        FatalIOErrorInFunction(thermo->subDict("thermoType"))
            << "Entry equationOfState is "
            << thermo->subDict("thermoType").get<word>("equationOfState")
            << " but a fluid " << isothermalGas::typeName
            << " must be an ideal gas" << nl
            << "Valid choices: perfectGas" << nl
            << exit(FatalIOError);
    }

    return thermo;
}

} // End namespace cghs
} // End namespace Foam

// * * * * * * * * * * * * * * * Construction  * * * * * * * * * * * * * * * //

Foam::cghs::isothermalGas::isothermalGas
(
    fvMesh& mesh,
    const dimensionedVector& g,
    const cghsCloud& parcels
)
:
    fluidModel(mesh, g, parcels, dimPressure),
    thermo_(idealGas(mesh, parcels.properties().subDict("solution"))),
    rho_
    (
        IOobject
        (
            "rho",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        ),
        thermo_->psi()*p_
    ),
    rhof_("rhof", fvc::interpolate(rho_)),
    mu_("mu", thermo_->mu()),
    alphaRhoPhi_("alphaRhoPhi", contentf()*phi_),
    mass_(massNow()),
    massDefect_(0)
{
    checkAboveZero(p_, "p is the absolute pressure [Pa], e.g. 101325");

    if (pressureIsToFind())
    {
        startAtRest();
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
}


void Foam::cghs::isothermalGas::startAtRest()
{
    const scalarField& psi = thermo_->psi().primitiveField();
    scalarField p
    (
        meanPressure()*exp(psi*gravity_->potential().primitiveField())
    );

    if (p_.needReference())
    {
        // A closed gas keeps its mass
        const scalarField room(mesh().V()*alpha_.primitiveField()*psi);
        p *= gSum(room*p_.primitiveField())/gSum(room*p);
    }

    startWith(p, rho_);
    pressureSolved();
    contentFlux() = contentf()*phi_;
    mass_ = massNow();
}


Foam::scalar Foam::cghs::isothermalGas::massNow() const
{
    return fvc::domainIntegrate(alpha_*rho_).value();
}

// * * * * * * * * * * * * * * * * The step  * * * * * * * * * * * * * * * * //

Foam::tmp<Foam::fvVectorMatrix> Foam::cghs::isothermalGas::momentumEquation()
{
    // With the density at the end of the step before, as after a restart
    alphaRhoPhi_ = contentf()*phi_;

    return
        fvm::ddt(alpha_, rho_, U_)
      + fvm::div(alphaRhoPhi_, U_)
      - fvm::Sp(fvc::ddt(alpha_, rho_) + fvc::div(alphaRhoPhi_), U_)
      + turbulence_->divDevRhoReff(U_);
}


void Foam::cghs::isothermalGas::addStorage(fvScalarMatrix& pEqn) const
{
    pEqn -= fvm::ddt(alpha_, thermo_->psi(), p_);
}


void Foam::cghs::isothermalGas::pressureSolved()
{
    rho_ = thermo_->psi()*p_;
    rhof_ = fvc::interpolate(rho_);
}


Foam::tmp<Foam::volScalarField>
Foam::cghs::isothermalGas::contentGain
(
    const surfaceScalarField& flux
) const
{
    return fvc::ddt(alpha_, rho_) + fvc::div(flux);
}


Foam::scalar Foam::cghs::isothermalGas::fullContent() const
{
    return gAverage(rho_.primitiveField());
}


Foam::tmp<Foam::volScalarField>
Foam::cghs::isothermalGas::contentSource(fv::optionList& options)
{
    return options(rho_) & rho_;
}


Foam::tmp<Foam::fvVectorMatrix>
Foam::cghs::isothermalGas::momentumSource(fv::optionList& options)
{
    return options(rho_, U_);
}


void Foam::cghs::isothermalGas::finishStep()
{
    const scalar lowest = gMin(p_.primitiveField());

    if (!(lowest > 0))
    {
        FatalErrorInFunction
            << "The pressure of the gas has fallen to " << lowest
            << " Pa: the run has gone out of hand." << nl
            << "Lower maxCo or maxDeltaT, or raise nCorrectors of PISO" << nl
            << exit(FatalError);
    }

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

    turbulence_->correct();
}


void Foam::cghs::isothermalGas::report(Ostream& os) const
{
    fluidModel::report(os);

    os  << "gas:    " << mass_ << " kg, of which " << massDefect_
        << " kg from nowhere" << nl;
}
