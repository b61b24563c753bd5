/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "incompressibleFluid.H"
#include "fvm.H"
#include "fvc.H"
#include "fvcFlux.H"
#include "constrainHbyA.H"
#include "constrainPressure.H"
#include "adjustPhi.H"
#include "findRefCell.H"
#include "fixedFluxPressureFvPatchScalarField.H"
#include "checkedEntry.H"
#include "profiling.H"

namespace Foam
{
namespace cghs
{

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


//- Where the pressure gradient is what balances the forces (fixedFluxPressure),
//  the forces are those of the cell beside: the given velocity is the result of
//  that balance, not of there being none
static void takeFromCells
(
    surfaceScalarField& flux,
    const volVectorField& field,
    const volScalarField& p
)
{
    forAll(p.boundaryField(), patchi)
    {
        if (isA<fixedFluxPressureFvPatchScalarField>(p.boundaryField()[patchi]))
        {
            const fvPatchVectorField& values = field.boundaryField()[patchi];

            flux.boundaryFieldRef()[patchi] =
                values.patchInternalField() & values.patch().Sf();
        }
    }
}


//- And the result is the given velocity, to the last digit
static void takeFromPatches
(
    surfaceScalarField& flux,
    const volVectorField& field,
    const volScalarField& p
)
{
    forAll(p.boundaryField(), patchi)
    {
        if (isA<fixedFluxPressureFvPatchScalarField>(p.boundaryField()[patchi]))
        {
            const fvPatchVectorField& values = field.boundaryField()[patchi];

            flux.boundaryFieldRef()[patchi] = values & values.patch().Sf();
        }
    }
}

} // End namespace cghs
} // End namespace Foam

// * * * * * * * * * * * * * * * Construction  * * * * * * * * * * * * * * * //

Foam::tmp<Foam::volScalarField>
Foam::cghs::incompressibleFluid::boundedVoidage(const volScalarField& theta)
{
    nClipped_ = 0;

    for (const scalar solids : theta.primitiveField())
    {
        nClipped_ += 1 - solids < minVoidage_;
    }
    reduce(nClipped_, sumOp<label>());

    return max(1 - theta, dimensionedScalar("minVoidage", dimless, minVoidage_));
}


Foam::cghs::incompressibleFluid::incompressibleFluid
(
    fvMesh& mesh,
    const dimensionedVector& g,
    const scalar minVoidage,
    const volScalarField& theta
)
:
    mesh_(mesh),
    reconstruct_(mesh),
    piso_(mesh),
    g_(g),
    minVoidage_(minVoidage),
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
        boundedVoidage(theta)
    ),
    alphaf_("alphaf", fvc::interpolate(alpha_)),
    alphaPhi_("alphaPhi", alphaf_*phi_),
    transport_(U_, phi_),
    rho_
    (
        fieldIO("rho", mesh, IOobject::NO_READ, IOobject::NO_WRITE),
        mesh,
        positiveDimensioned(transport_, "rho", dimDensity)
    ),
    mu_("mu", rho_*transport_.nu()),
    gradP_("gradP", gradPNow()),
    pRefCell_(0),
    pRefValue_(0),
    nClipped_(0),
    continuityError_(0)
{
    setRefCell(p_, piso_.dict(), pRefCell_, pRefValue_);
    mesh_.setFluxRequired(p_.name());

    turbulence_ =
        turbulenceModel::New(alpha_, U_, alphaPhi_, phi_, transport_);

    // An old value is only kept from now on if it is asked for now
    alpha_.oldTime();
    U_.oldTime();
}


Foam::autoPtr<Foam::cghs::incompressibleFluid>
Foam::cghs::incompressibleFluid::New
(
    fvMesh& mesh,
    const dimensionedVector& g,
    const cghsCloud& parcels
)
{
    typedef cghsCloud::couplingType couplingType;

    if (parcels.coupling() == couplingType::none)
    {
        return nullptr;
    }

    return autoPtr<incompressibleFluid>::New
    (
        mesh,
        g,
        scalarInRange
        (
            parcels.properties().subDict("solution"),
            "minVoidage",
            0.01,
            1
        ),
        parcels.coupling() == couplingType::twoWay
      ? parcels.solidsFraction()
      : parcels.noSolids()
    );
}

// * * * * * * * * * * * * * * * * The step  * * * * * * * * * * * * * * * * //

Foam::scalar Foam::cghs::incompressibleFluid::courantNumber() const
{
    const scalarField outflow
    (
        fvc::surfaceSum(mag(phi_))().primitiveField()
    );

    return 0.5*gMax(outflow/mesh_.V())*mesh_.time().deltaTValue();
}


void Foam::cghs::incompressibleFluid::setSolids(const volScalarField& theta)
{
    alpha_ = boundedVoidage(theta);
    alpha_.correctBoundaryConditions();

    alphaf_ = fvc::interpolate(alpha_);
    alphaPhi_ = alphaf_*phi_;
}


Foam::tmp<Foam::surfaceScalarField>
Foam::cghs::incompressibleFluid::gravityFlux
(
    const surfaceScalarField& rAUf
) const
{
    tmp<surfaceScalarField> tflux(alphaf_*rAUf*(g_ & mesh_.Sf()));
    surfaceScalarField::Boundary& flux = tflux.ref().boundaryFieldRef();

    // Where the velocity is given no force changes it, unless the pressure
    // gradient there is free to balance it
    forAll(flux, patchi)
    {
        if
        (
            U_.boundaryField()[patchi].fixesValue()
        && !isA<fixedFluxPressureFvPatchScalarField>
            (
                p_.boundaryField()[patchi]
            )
        )
        {
            flux[patchi] = 0;
        }
    }

    return tflux;
}


void Foam::cghs::incompressibleFluid::correctPressure
(
    const fvVectorMatrix& UEqn,
    const volScalarField& rAU,
    const surfaceScalarField& rAUf,
    const surfaceScalarField& gravity
)
{
    const volVectorField HbyA(constrainHbyA(rAU*UEqn.H(), U_, p_));
    const surfaceScalarField alpharAUf("alpharAUf", alphaf_*rAUf);

    surfaceScalarField phiHbyA
    (
        "phiHbyA",
        fvc::flux(HbyA) + alpharAUf*fvc::ddtCorr(U_, phi_)
    );

    if (p_.needReference())
    {
        adjustPhi(phiHbyA, U_, p_);
    }

    takeFromCells(phiHbyA, HbyA, p_);
    phiHbyA += gravity;
    constrainPressure(p_, U_, phiHbyA, alpharAUf);

    while (piso_.correctNonOrthogonal())
    {
        fvScalarMatrix pEqn
        (
            fvm::laplacian(alphaf_*alpharAUf, p_)
         ==
            fvc::ddt(alpha_) + fvc::div(alphaf_*phiHbyA)
        );

        pEqn.setReference(pRefCell_, pRefValue_);
        pEqn.solve(mesh_.solver(p_.select(piso_.finalInnerIter())));

        if (piso_.finalNonOrthogonalIter())
        {
            const surfaceScalarField pFlux(pEqn.flux()/alphaf_);

            phi_ = phiHbyA - pFlux;
            takeFromPatches(phi_, U_, p_);
            alphaPhi_ = alphaf_*phi_;

            U_ = HbyA + rAU*reconstruct_((gravity - pFlux)/rAUf);
            U_.correctBoundaryConditions();
        }
    }
}


Foam::tmp<Foam::fvVectorMatrix>
Foam::cghs::incompressibleFluid::momentumEquation()
{
    transport_.correct();
    mu_ = rho_*transport_.nu();

    return
        fvm::ddt(alpha_, U_)
      + fvm::div(alphaPhi_, U_)
      - fvm::Sp(fvc::ddt(alpha_) + fvc::div(alphaPhi_), U_)
      + turbulence_->divDevRhoReff(U_);
}


void Foam::cghs::incompressibleFluid::solve(fvVectorMatrix& UEqn)
{
    UEqn.relax();

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
                gravity/rAUf - alphaf_*fvc::snGrad(p_)*mesh_.magSf()
            )
        );
    }

    while (piso_.correct())
    {
        correctPressure(UEqn, rAU, rAUf, gravity);
    }

    continuityError_ =
        gMax
        (
            mag(fvc::ddt(alpha_) + fvc::div(alphaPhi_))().primitiveField()
        )
       *mesh_.time().deltaTValue();

    turbulence_->correct();
}


void Foam::cghs::incompressibleFluid::solve
(
    const volVectorField& drag,
    const volScalarField& response
)
{
    addProfiling(fluid, "cghs::fluid");

    const volScalarField R("dragResponseByRho", response/rho_);

    fvVectorMatrix UEqn
    (
        momentumEquation() + fvm::Sp(R, U_) == R*U_.oldTime() - drag/rho_
    );
    solve(UEqn);
}


void Foam::cghs::incompressibleFluid::solve()
{
    addProfiling(fluid, "cghs::fluid");

    tmp<fvVectorMatrix> UEqn(momentumEquation());
    solve(UEqn.ref());
}


Foam::tmp<Foam::volVectorField>
Foam::cghs::incompressibleFluid::gradPNow() const
{
    return rho_*reconstruct_(fvc::snGrad(p_)*mesh_.magSf());
}


const Foam::volVectorField& Foam::cghs::incompressibleFluid::gradP()
{
    gradP_ = gradPNow();

    return gradP_;
}


Foam::tmp<Foam::volVectorField>
Foam::cghs::incompressibleFluid::dU() const
{
    return U_ - U_.oldTime();
}


Foam::tmp<Foam::volVectorField>
Foam::cghs::incompressibleFluid::dGradP() const
{
    return gradPNow() - gradP_;
}
