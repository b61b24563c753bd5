/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Application
    cghsReactor

Description
    A stirred vessel of fluid and parcels with the reactions of a case, without
    a mesh: what the kinetics make of a feed, in seconds, before a run in three
    dimensions. Fluid and solids are well mixed; each parcel has a composition
    and a temperature of its own, so that residence times are spread.

    All of it is integrated together, however stiff; gas keeps its pressure.

Usage
    cghsReactor

    It reads constant/reactions (see reactionScheme.H), the species of
    constant/thermophysicalProperties, and constant/reactorProperties:

        energy          yes;            // no: temperatures stay
        volume          6.0;            // of fluid and solids [m^3]
        p               140e3;          // of a gas; a liquid has rho instead
        fluid           { T 912; Y { N2 1; } }          // at the start
        inflow          { massFlowRate 1.74; T 573; Y { O2 0.23; N2 0.77; } }

        solids                          // or none
        {
            inventory       4950;       // to be kept [kg]
            nParcels        1000;
            d               60e-6;
            rho             1500;       // to find the room of the fluid
            heatTransfer    500;        // fluid to surface [W/m^2/K]
            massTransfer    0.1;        // through films, if a law asks [m/s]: a
                                        // constant, as there is no slip here
            T               912;
            Y               { C 0.0036; H 0.0003; catalyst 0.9961; }
            feed            { massFlowRate 22.7; T 753; Y { ... } }
        }

        walls           { conductance 0; T 300; }       // [W/K]; or none
        tolerances      { relative 1e-3; absolute 1e-8; }   // the default

    and deltaT, endTime and writeInterval of system/controlDict. In a step
    parcels are fed, and those that are too much go out; then all reacts. That
    is of the first order in deltaT: what comes in reacts for the whole step.

    In postProcessing/cghsReactor/<start>: reactor.dat, a row for each step; and
    parcels_<time>.csv at times of writing, a row for each parcel.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "checkedEntry.H"
#include "constantDictionary.H"
#include "drivingUnit.H"
#include "stirredCell.H"
#include "massFractions.H"
#include "parcelInventory.H"
#include "reactorBalance.H"
#include "progress.H"

using namespace Foam;
using namespace Foam::cghs;


//- Volume of an amount of the fluid [m^3]
struct fluidVolume
{
    const substances& list;
    const dictionary& properties;
    const bool isGas;

    scalar operator()(const scalarField& n, const scalar T) const
    {
        return
            isGas
          ? sum(n)*molarR*T/properties.get<scalar>("p")
          : list.massOf(n)/properties.get<scalar>("rho");
    }
};


static autoPtr<OFstream> openTable
(
    const fileName& folder,
    const reactionScheme& scheme
)
{
    autoPtr<OFstream> table(new OFstream(folder/"reactor.dat"));
    OFstream& os = table();

    os.precision(10);
    os  << "# Time  T of fluid [K]  T of solids [K]  mass of solids [kg]"
        << "  mean age [s]  then mass fractions of the fluid's species:";
    for (const word& name : scheme.fluid().names())
    {
        os  << "  " << name.c_str();
    }
    os  << "  and of solids:";
    for (const word& name : scheme.solids().names())
    {
        os  << "  " << name.c_str();
    }
    os  << endl;
    return table;
}


int main(int argc, char *argv[])
{
    argList::addNote
    (
        "A stirred vessel with the reactions of a case, without a mesh."
    );
    argList::noParallel();

    #include "setRootCase.H"
    #include "createTime.H"


    // ---- What reacts, and the vessel --------------------------------------

    const IOdictionary properties
    (
        constantDictionary(runTime, "reactorProperties")
    );
    const IOdictionary thermophysics
    (
        constantDictionary(runTime, "thermophysicalProperties")
    );
    const IOdictionary reactions(constantDictionary(runTime, "reactions"));

    const bool energetic = properties.get<bool>("energy");
    const reactionScheme scheme(reactions, thermophysics, energetic);
    scheme.report(Info);

    const substances& species = scheme.fluid();
    const bool isGas = properties.found("p");
    const scalar p = isGas ? positiveScalar(properties, "p") : 0;
    const fluidVolume volumeOf = {species, properties, isGas};

    stirredCell vessel
    (
        scheme,
        reactingCell::readTolerances(properties.subOrEmptyDict("tolerances"))
    );

    if (properties.found("walls"))
    {
        const dictionary& walls = properties.subDict("walls");
        vessel.walls
        (
            walls.get<scalar>("conductance"),
            positiveScalar(walls, "T")
        );
    }


    // ---- Solids and fluid at the start ------------------------------------

    parcelInventory parcels
    (
        properties.found("solids")
      ? parcelInventory(properties.subDict("solids"), scheme)
      : parcelInventory(scheme)
    );

    const scalar volume = positiveScalar(properties, "volume");
    const auto room = [&]
    {
        const scalar left = volume - parcels.volume();
        if (!(left > 0))
        {
            FatalIOErrorInFunction(properties)
                << "Entry volume is " << volume << " m^3 but the solids alone"
                << " take " << parcels.volume() << " m^3" << nl
                << "Raise it, or lower inventory" << nl
                << exit(FatalIOError);
        }
        return left;
    };

    const dictionary& start = properties.subDict("fluid");
    scalar fluidT = positiveScalar(start, "T");
    scalarField fluid(amountsPerMass(start, species));
    fluid *= room()/volumeOf(fluid, fluidT);

    if (properties.found("inflow"))
    {
        const dictionary& inflow = properties.subDict("inflow");
        const scalar T = positiveScalar(inflow, "T");
        const scalarField amounts
        (
            positiveScalar(inflow, "massFlowRate")
           *amountsPerMass(inflow, species)
        );
        vessel.flow(amounts, T, room(), volumeOf(amounts, T));
    }


    // ---- The balance, and tables ------------------------------------------

    reactorBalance::content passed =
    {
        scalarField(species.size(), 0),
        scalarField(scheme.solids().size(), 0),
        0
    };
    reactorBalance balance
    (
        scheme,
        {
            fluid,
            parcels.amounts(),
            parcels.enthalpy()
          + (energetic ? species.enthalpyOf(fluid, fluidT) : scalar(0))
        }
    );

    const fileName folder
    (
        runTime.path()/"postProcessing"/"cghsReactor"/runTime.timeName()
    );
    mkDir(folder);
    autoPtr<OFstream> table(openTable(folder, scheme));
    progress pace(runTime);

    scalar h = runTime.deltaTValue();
    scalar parcelSteps = 0;
    scalar internalSteps = 0;

    while (runTime.loop())
    {
        const scalar deltaT = runTime.deltaTValue();


        // ---- Feed, and react ----------------------------------------------

        parcels.feed(deltaT);
        vessel.room(room());
        vessel.start(fluid, fluidT, p, room());
        parcels.give(vessel);

        if (!vessel.react(deltaT, h))
        {
            FatalErrorInFunction
                << "The reactions could not be integrated from "
                << runTime.value() - deltaT << " to " << runTime.value()
                << " s: " << vessel.steps() << " steps, "
                << vessel.refusals() << " of them refused" << nl
                << "Look at the rates' units and at " << folder << nl
                << exit(FatalError);
        }

        vessel.warnOfRanges();
        parcels.take(vessel, deltaT);
        fluid = SubList<scalar>(vessel.fluidState(), species.size());
        fluidT = vessel.fluidTemperature();
        parcelSteps += parcels.size();
        internalSteps += vessel.steps();


        // ---- Balance ------------------------------------------------------

        const scalarField through(vessel.cameIn() - vessel.wentOut());
        forAll(species, k)
        {
            passed.fluid[k] += through[k];
        }
        if (energetic)
        {
            passed.enthalpy += through.last() + vessel.fromWalls();
        }

        reactorBalance::content all(passed);
        all.solids = parcels.amountsIn();
        all.enthalpy += parcels.enthalpyIn();
        balance.set
        (
            {
                fluid,
                parcels.amounts(),
                parcels.enthalpy()
              + (energetic ? vessel.fluidState().last() : 0)
            },
            all
        );


        // ---- Report and write ---------------------------------------------

        OFstream& os = table();
        os  << runTime.value() << tab << fluidT << tab << parcels.meanT()
            << tab << parcels.mass() << tab << parcels.meanAge();
        const scalar fluidMass = species.massOf(fluid);
        forAll(species, k)
        {
            os  << tab << fluid[k]*species[k].M()/fluidMass;
        }
        const scalarField n(parcels.amounts());
        const scalar solidMass = max(parcels.mass(), VSMALL);
        forAll(n, s)
        {
            os  << tab << n[s]*scheme.solids()[s].M()/solidMass;
        }
        os  << endl;

        if (runTime.writeTime())
        {
            Info<< nl << "Time = " << runTime.timeName() << nl
                << "T of fluid " << fluidT << " K, of solids "
                << parcels.meanT() << " K; " << parcels.size()
                << " parcels, mean age " << parcels.meanAge() << " s; "
                << internalSteps/runTime.timeIndex()
                << " steps of chemistry a step" << nl;
            balance.report(Info);
            pace.report(Info);

            OFstream list(folder/"parcels_" + runTime.timeName() + ".csv");
            list.precision(10);
            parcels.write(list);
            runTime.printExecutionTime(Info);
        }
    }

    Info<< "Largest relative defect of the balance " << balance.worst() << nl
        << "Processor time of a parcel and step "
        << 1e6*runTime.elapsedCpuTime()/max(parcelSteps, scalar(1)) << " us"
        << nl << nl << "End" << nl << endl;

    return 0;
}
