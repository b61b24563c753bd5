/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Application
    giveHeat

Description
    A fluid at rest whose energy is given heat as parcels will: given W/m^3
    and a response W/m^3/K, the same everywhere or rising with x, steps of the
    case's deltaT. Prints after each step the temperature and the balance.

    constant/heat: given, response, slope [1/m]

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "cghsCloud.H"
#include "fluidModel.H"
#include "fluidThermo.H"
#include "transported.H"

using namespace Foam::cghs;

//- value (1 + slope x)
static tmp<volScalarField> graded
(
    const word& name,
    const fvMesh& mesh,
    const dictionary& dict,
    const dimensionSet& dimensions
)
{
    auto field = tmp<volScalarField>::New
    (
        IOobject(name, mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimensions, Zero)
    );
    field.ref().primitiveFieldRef() =
        dict.get<scalar>(name)
       *(
            1
          + dict.get<scalar>("slope")
           *mesh.C().primitiveField().component(vector::X)
        );
    return field;
}


int main(int argc, char *argv[])
{
    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"
    #include "readGravitationalAcceleration.H"

    const IOdictionary heat
    (
        IOobject("heat", runTime.constant(), mesh, IOobject::MUST_READ)
    );
    const dimensionSet power(dimPower/dimVolume);

    cghsCloud parcels(mesh, "parcels", g.value());
    autoPtr<fluidModel> fluid(fluidModel::New(mesh, g, parcels));
    autoPtr<transported> energy
    (
        transported::New
        (
            "energy",
            parcels.properties().subDict("solution"),
            fluid()
        )
    );
    const surfaceScalarField massFlux
    (
        "massFlux",
        fvc::interpolate(fluid->rho())*fvc::flux(fluid->U())
    );
    const surfaceScalarField volumeFlux("volumeFlux", fvc::flux(fluid->U()));

    scalar misfit = 0;

    while (runTime.loop())
    {
        const volScalarField T0("T0", energy->field("T"));
        const volScalarField Cp0("Cp0", energy->field("Cp"));
        const volScalarField he0("he0", fluid->thermo().he());

        const auto terms = [&](const word&)
        {
            exchangeTerms ofStep;
            ofStep.given = graded("given", mesh, heat, power);
            ofStep.response =
                graded("response", mesh, heat, power/dimTemperature);
            return ofStep;
        };
        const exchangeTerms givenNow(terms("energy"));

        const fluidFlow flow
        {
            fluid->alpha(), fluid->rho(), massFlux, volumeFlux, nullptr,
            nullptr, fv::options::New(mesh), nullptr, nullptr
        };
        energy->solve(flow, terms);
        energy->report(Info);

        // What parcels would receive, and what the fluid has
        const tmp<volScalarField> gained
        (
            fluid->alpha()*fluid->rho()*(fluid->thermo().he() - he0)
           /runTime.deltaT()
        );
        const tmp<volScalarField> taken
        (
            givenNow.given() - givenNow.response()*energy->change("T")
        );
        misfit = max
        (
            misfit,
            gMax(mag(gained() - taken())().primitiveField())
           /gMax(mag(givenNow.given())().primitiveField())
        );

        runTime.write();
    }

    Info<< "misfit " << misfit << nl << "End" << endl;

    return 0;
}
