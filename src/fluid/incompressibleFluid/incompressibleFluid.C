/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "incompressibleFluid.H"
#include "temperature.H"
#include "fvm.H"
#include "fvc.H"
#include "adjustPhi.H"
#include "findRefCell.H"
#include "checkedEntry.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(incompressibleFluid, 0);
    addToRunTimeSelectionTable(fluidModel, incompressibleFluid, cloud);
    describeModel
    (
        fluidModel,
        incompressibleFluid,
        "constant density, gas or liquid; p over the density"
    );


static dimensionedScalar densityOf(const dictionary& transportProperties)
{
    if (!transportProperties.found("rho"))
    {
        FatalIOErrorInFunction(transportProperties)
            << "Entry rho is missing: parcels have to know the density of the"
            << " fluid" << nl
            << "Add e.g. 'rho 1.2;' for air, 'rho 998;' for water [kg/m^3]"
            << nl << exit(FatalIOError);
    }

    return positiveDimensioned(transportProperties, "rho", dimDensity);
}

} // End namespace cghs
} // End namespace Foam


Foam::cghs::incompressibleFluid::incompressibleFluid
(
    fvMesh& mesh,
    const dimensionedVector& g,
    const cghsCloud& cloud
)
:
    fluidModel(mesh, g, cloud, dimPressure/dimDensity),
    alphaPhi_("alphaPhi", alphaf_*phi_),
    viscosity_(U_, phi_),
    density_(densityOf(viscosity_)),
    rho_
    (
        IOobject("rho", mesh.time().timeName(), mesh),
        mesh,
        density_
    ),
    mu_("mu", rho_*viscosity_.nu()),
    pRefCell_(0),
    pRefValue_(0),
    dilute_
    (
        transports("species")
     && cloud.properties().subDict("solution")
       .subOrEmptyDict("speciesCoeffs").getOrDefault<bool>("dilute", true)
    )
{
    setRefCell(p_, pisoDict(), pRefCell_, pRefValue_);

    restingPressure start(p_, gravity_());

    if (start.isToFind())
    {
        startAtRest(start);
    }

    turbulence_ =
        turbulenceModel::New(alpha_, U_, alphaPhi_, phi_, viscosity_);

    standIn_.reset
    (
        new standIn(turbulence_(), geometricOneField(), phi_, viscosity_)
    );
}


void Foam::cghs::incompressibleFluid::startAtRest
(
    restingPressure& start
)
{
    const scalarField& h = start.potential();
    scalar at0 = start.mean();

    if (p_.needReference())
    {
        at0 =
            pRefValue_
          - returnReduce
            (
                pRefCell_ >= 0 ? h[pRefCell_] : -GREAT,
                maxOp<scalar>()
            );
    }
    start.set(at0 + h, relativeDensity()());
}


Foam::tmp<Foam::fvVectorMatrix>
Foam::cghs::incompressibleFluid::momentumEquation()
{
    viscosity_.correct();
    mu_ = rho_*viscosity_.nu();

    return
        fvm::ddt(alpha_, U_)
      + fvm::div(alphaPhi_, U_)
      - fvm::Sp(fvc::ddt(alpha_) + fvc::div(alphaPhi_), U_)
      + turbulence_->divDevRhoReff(U_);
}


void Foam::cghs::incompressibleFluid::closeFluxes
(
    surfaceScalarField& phiHbyA
)
{
    if (p_.needReference())
    {
        adjustPhi(phiHbyA, U_, p_);
    }
}


void Foam::cghs::incompressibleFluid::addStorage(fvScalarMatrix& pEqn) const
{
    pEqn -= fvc::ddt(alpha_);
    pEqn.setReference(pRefCell_, pRefValue_);
}


Foam::tmp<Foam::volScalarField>
Foam::cghs::incompressibleFluid::contentGain
(
    const surfaceScalarField& flux
) const
{
    return fvc::ddt(alpha_) + fvc::div(flux);
}


Foam::tmp<Foam::volScalarField>
Foam::cghs::incompressibleFluid::contentSource(fv::optionList& options)
{
    return options(alpha_) & alpha_;
}


void Foam::cghs::incompressibleFluid::checkSource
(
    const volScalarField& source
) const
{
    const scalar total = fvc::domainIntegrate(source).value();
    const scalar given = fvc::domainIntegrate(mag(source)).value();

    if (p_.needReference() && mag(total) > 1e-6*given)
    {
        FatalErrorInFunction
            << "fvOptions of alpha and parcels put " << total << " m^3/s of"
            << " fluid into a mesh that has no outlet for it" << nl
            << "Give p a value at a patch, let the sources add up to zero, or"
            << " choose the fluid gas" << nl
            << exit(FatalError);
    }
}


Foam::tmp<Foam::fvVectorMatrix>
Foam::cghs::incompressibleFluid::momentumSource(fv::optionList& options)
{
    return options(U_);
}


bool Foam::cghs::incompressibleFluid::velocitySolved()
{
    turbulence_->correct();

    return true;
}


void Foam::cghs::incompressibleFluid::checkState
(
    const rhoThermo& thermo
) const
{
    const dictionary& types = thermo.subDict("thermoType");
    const word state(types.get<word>("equationOfState"));
    bool constant = state == "rhoConst";

    if (state == "icoPolynomial")
    {
        const scalarList coefficients
        (
            thermo.subDict("mixture").subDict("equationOfState")
           .get<scalarList>("rhoCoeffs<8>")
        );
        constant = true;
        for (label i = 1; i < coefficients.size(); ++i)
        {
            constant = constant && coefficients[i] == 0;
        }
    }

    if (!constant)
    {
        FatalIOErrorInFunction(types)
            << "Entry equationOfState is " << state << ", by which the density"
            << " is none that stays, but a fluid " << typeName << " has one"
            << nl
            << "Valid choices: rhoConst; icoPolynomial with rhoCoeffs<8> of"
            << " which all but the first are 0" << nl
            << exit(FatalIOError);
    }
}


void Foam::cghs::incompressibleFluid::checkThermo
(
    const rhoThermo& thermo
) const
{
    const dictionary& types = thermo.subDict("thermoType");
    const labelList cells(identity(mesh().nCells()));
    const scalarField& p = p_.primitiveField();
    const scalarField& T = thermo.T().primitiveField();
    const scalarField change
    (
        thermo.he(p + 1e5, T, cells) - thermo.he(p, T, cells)
    );
    const scalar most = gMax(mag(change)());

    if (most > 1e-9*gMax(mag(thermo.he(p, T, cells)())()))
    {
        FatalIOErrorInFunction(types)
            << "Entry energy is " << types.get<word>("energy")
            << ", which with thermo " << types.get<word>("thermo")
            << " changes with p, but p of a fluid " << typeName
            << " is over the density and no pressure" << nl
            << "Choose an energy that does not: thermo eConst with energy"
            << " sensibleInternalEnergy, or another thermo with"
            << " sensibleEnthalpy" << nl
            << exit(FatalIOError);
    }

    const scalar rho = density_.value();
    const tmp<volScalarField> rhos(thermo.rho());
    const scalar difference = gMax(mag(rhos().primitiveField() - rho)());

    if (!(difference <= 1e-6*rho))
    {
        FatalIOErrorInFunction(thermo)
            << "The density is " << gAverage(rhos().primitiveField())
            << " but entry rho in " << viscosity_.name() << " is " << rho << nl
            << "Choose the equationOfState rhoConst, and give it that rho, or"
            << " icoPolynomial with that as the first of rhoCoeffs<8>" << nl
            << exit(FatalIOError);
    }
}


Foam::fluidThermo& Foam::cghs::incompressibleFluid::thermo()
{
    if (!thermo_.valid())
    {
        checkThermophysics
        (
            mesh(),
            viscosity_,
            "rho is there, and energy is to be transported,",
            "see incompressibleFluid.H, or do not transport energy"
        );
        checkTemperature(mesh());
        thermo_ = rhoThermo::New(mesh());
        checkState(thermo_());
        checkThermo(thermo_());
    }

    return thermo_();
}


Foam::tmp<Foam::volScalarField> Foam::cghs::incompressibleFluid::mut() const
{
    return rho_*turbulence_->nut();
}
