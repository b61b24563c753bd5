/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "solidsYield.H"
#include "surfaceInterpolate.H"
#include "Time.H"

namespace Foam
{
namespace cghs
{
    //- w: share of what is ahead that is paid back in a step
    constexpr scalar repaid = 0.25;
}
}


Foam::cghs::solidsYield::solidsYield
(
    const fvMesh& mesh,
    const bool twoWay,
    const labelUList& plates
)
:
    mesh_(mesh),
    plates_(plates)
{
    if (twoWay)
    {
        ahead_.reset
        (
            new surfaceScalarField
            (
                IOobject
                (
                    "solidsAhead",
                    mesh.time().timeName(),
                    mesh,
                    IOobject::READ_IF_PRESENT,
                    IOobject::AUTO_WRITE
                ),
                mesh,
                dimensionedScalar(dimVolume, Zero)
            )
        );
    }
}


Foam::tmp<Foam::surfaceScalarField>
Foam::cghs::solidsYield::passing(const surfaceScalarField& field) const
{
    tmp<surfaceScalarField> tfaces(new surfaceScalarField(field));

    for (fvsPatchScalarField& patch : tfaces.ref().boundaryFieldRef())
    {
        if (!patch.coupled())
        {
            patch = 0;
        }
    }
    for (const label patchi : plates_)
    {
        tfaces.ref().boundaryFieldRef()[patchi] = 0;
    }

    return tfaces;
}


void Foam::cghs::solidsYield::start
(
    const volScalarField& byVelocity,
    const volScalarField& byGradient,
    const surfaceScalarField& phi,
    const surfaceScalarField& gradient
)
{
    share_.reset(new surfaceScalarField(fvc::interpolate(byVelocity)));
    byFlux_.reset(new surfaceScalarField(passing(share_())));
    byGradient_.reset
    (
        new surfaceScalarField(passing(fvc::interpolate(byGradient)()))
    );
    phi0_.reset(new surfaceScalarField("phi0", phi));
    gradient0_.reset(new surfaceScalarField("gradient0", gradient));
    flux_.reset(new surfaceScalarField("solidsYield", 0*phi));
}


Foam::tmp<Foam::surfaceScalarField>
Foam::cghs::solidsYield::repayment() const
{
    return ahead_()*(repaid/mesh_.time().deltaT());
}


Foam::tmp<Foam::surfaceScalarField> Foam::cghs::solidsYield::mobility
(
    const surfaceScalarField& alpharAUf
) const
{
    return byFlux_()*alpharAUf + byGradient_();
}


Foam::tmp<Foam::surfaceScalarField> Foam::cghs::solidsYield::rest
(
    const surfaceScalarField& phi
) const
{
    return
        byFlux_()*(phi - phi0_()) + byGradient_()*gradient0_() - repayment();
}


void Foam::cghs::solidsYield::update
(
    const surfaceScalarField& phi,
    const surfaceScalarField& gradient
)
{
    flux_() =
        byFlux_()*(phi - phi0_()) - byGradient_()*(gradient - gradient0_());
}


Foam::tmp<Foam::surfaceScalarField> Foam::cghs::solidsYield::flux() const
{
    return flux_() - repayment();
}


void Foam::cghs::solidsYield::finish()
{
    ahead_() += flux()*mesh_.time().deltaT();

    for
    (
        autoPtr<surfaceScalarField>* field
      : {&share_, &byFlux_, &byGradient_, &phi0_, &gradient0_, &flux_}
    )
    {
        field->clear();
    }
}
