/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Application
    fluidisationVelocities

Description
    The minimum fluidisation velocity U_mf and the terminal velocity U_t of a
    case's particles by each drag law, to choose a law by; and Syamlal and
    O'Brien's coefficients for a U_mf that was measured. Needs no mesh.

    A law takes its coefficients from <law>Coeffs in subModels where the case
    has them, else those that it was published with. A law that has neither is
    named below the table.

Usage
    fluidisationVelocities [OPTIONS]

      - -cloud name     the properties are in constant/<name>Properties
      - -voidage e      at U_mf; 0.415 unless given, where 14 e^3 = 1, as Wen
                        and Yu found it to be
      - -rho value      density of the fluid [kg/m^3], and
      - -mu value       its viscosity [kg/m/s], if not those of
                        transportProperties
      - -diameter d     of the particles [m], if not the case's
      - -measured U     calibrate SyamlalOBrien to this U_mf [m/s]
      - -slips list     write the drag coefficient D of all laws at these slips
                        [m/s] to dragCoefficients.csv in
                        postProcessing/fluidisationVelocities
      - -voidages list  and at these voidages; 0.3, 0.31, ... 1 unless given

    e.g.  fluidisationVelocities -voidage 0.42 -slips '(0.1 0.3)'

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "IOmanip.H"
#include "OFstream.H"
#include "OStringStream.H"
#include "OSspecific.H"
#include "uniformDimensionedFields.H"
#include "checkedEntry.H"
#include "cloudProperties.H"
#include "fluidisation.H"
#include "SyamlalOBrien.H"
#include "noDrag.H"

using namespace Foam;
using namespace Foam::cghs;

//- A law and where its coefficients are from
struct candidate
{
    word name;
    word source;
    autoPtr<dragModel> law;
};


static void addOptions()
{
    argList::addNote
    (
        "Minimum fluidisation and terminal velocities of a case's particles,"
        " by each drag law"
    );
    argList::noParallel();
    argList::addOption("cloud", "name", "name of the cloud, default parcels");
    argList::addOption("voidage", "e", "voidage at U_mf, default 0.415");
    argList::addOption("rho", "value", "density of the fluid [kg/m^3]");
    argList::addOption("mu", "value", "viscosity of the fluid [kg/m/s]");
    argList::addOption("diameter", "d", "diameter of the particles [m]");
    argList::addOption("measured", "U", "calibrate SyamlalOBrien to this U_mf");
    argList::addOption("slips", "list", "write D at these slips [m/s]");
    argList::addOption("voidages", "list", "write D at these voidages");
}


//- An option's value. Stop unless low < value <= high
static scalar optionInRange
(
    const argList& args,
    const word& option,
    const scalar deflt,
    const scalar low,
    const scalar high
)
{
    const scalar value = args.get<scalar>(option, deflt);

    if (!(value > low && value <= high))
    {
        FatalErrorInFunction
            << "Option -" << option << " is " << value
            << " but must be above " << low << " and at most " << high << nl
            << exit(FatalError);
    }

    return value;
}


static IOobject constantFile(const Time& runTime, const word& name)
{
    return IOobject
    (
        name,
        runTime.constant(),
        runTime,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
}


//- Density and viscosity, of the options or else of a Newtonian fluid
static void readFluid
(
    const argList& args,
    const Time& runTime,
    particleInFluid& p
)
{
    p.rho = optionInRange(args, "rho", 1, 0, GREAT);
    p.mu = optionInRange(args, "mu", 1, 0, GREAT);

    if (args.found("rho") && args.found("mu"))
    {
        return;
    }

    const IOdictionary dict(constantFile(runTime, "transportProperties"));

    if (!args.found("rho"))
    {
        p.rho = positiveDimensioned(dict, "rho", dimDensity).value();
    }
    if (!args.found("mu"))
    {
        const word model(dict.get<word>("transportModel"));

        if (model != "Newtonian")
        {
            FatalIOErrorInFunction(dict)
                << "Entry transportModel is " << model
                << ", but only Newtonian has one viscosity" << nl
                << "Give the viscosity by the option -mu" << nl
                << exit(FatalIOError);
        }

        p.mu = p.rho*positiveDimensioned(dict, "nu", dimViscosity).value();
    }
}


static scalar readGravity(const Time& runTime)
{
    const uniformDimensionedVectorField g(constantFile(runTime, "g"));

    if (!(mag(g.value()) > 0))
    {
        FatalErrorInFunction
            << "There is no gravity in " << g.objectPath()
            << ": nothing has to be carried" << nl
            << exit(FatalError);
    }

    return mag(g.value());
}


//- SyamlalOBrien with the U_mf that was measured, and its entries to copy
static candidate calibrate
(
    const dictionary& subModels,
    const particleInFluid& p,
    const scalar e,
    const scalar U
)
{
    const bool voidageInRe =
        subModels.subOrEmptyDict("SyamlalOBrienCoeffs")
       .getOrDefault("voidageInRe", SyamlalOBrien().voidageInRe());

    const SyamlalOBrien law
    (
        SyamlalOBrien::calibrated
        (
            balancingD(p, e, U), p.flow(e, U/e), voidageInRe
        )
    );

    if (!(law.C2() > 0))
    {
        const SyamlalOBrien lowest(1, SMALL, voidageInRe);

        FatalErrorInFunction
            << "No C2 gives SyamlalOBrien a U_mf of " << U << " m/s at voidage "
            << e << nl
            << "The lowest there is " << carryingVelocity(lowest, p, e)
            << " m/s; give another -voidage" << nl
            << exit(FatalError);
    }

    Info<< nl << "For U_mf = " << U << " m/s at voidage " << e << ':' << nl
        << nl
        << "    SyamlalOBrienCoeffs" << nl
        << "    {" << nl
        << "        C1  " << law.C1() << ';' << nl
        << "        C2  " << law.C2() << ';' << nl
        << "        voidageInRe  " << Switch(voidageInRe) << ';' << nl
        << "    }" << endl;

    return candidate
    {
        "calibrated",
        "measured",
        autoPtr<dragModel>(new SyamlalOBrien(law))
    };
}


//- All laws with a drag and with coefficients. Names those without
static PtrList<candidate> gather(const dictionary& subModels)
{
    PtrList<candidate> laws;

    for (const word& name : dragModel::names())
    {
        autoPtr<dragModel> law(dragModel::NewOrPublished(name, subModels));

        if (law.valid())
        {
            const bool own = subModels.found(name + "Coeffs");

            laws.append
            (
                new candidate{name, own ? "case" : "published", std::move(law)}
            );
        }
        else if (name != noDrag::typeName)
        {
            Info<< "Without " << name << ": it needs " << name
                << "Coeffs in subModels" << endl;
        }
    }

    return laws;
}


//- A line if a velocity is beyond what the law is made for
static void tellRange
(
    const candidate& c,
    const word& symbol,
    const scalar e,
    const scalar Re
)
{
    const flowRange range(c.law->range());

    if (e < range.voidage.min())
    {
        Info<< c.name << ": " << symbol << " is at voidage " << e
            << ", the law is made for " << range.voidage.min() << " to 1" << nl;
    }
    if (Re > range.Re.max())
    {
        Info<< c.name << ": " << symbol << " is at Re " << Re
            << ", the law is made for up to " << range.Re.max() << nl;
    }
}


static void printRow
(
    const string& name,
    const string& source,
    const UList<scalar>& values
)
{
    OStringStream row;
    row.precision(6);

    row << setw(20) << name.c_str() << setw(13) << source.c_str();

    for (const scalar value : values)
    {
        row << setw(13) << value;
    }

    Info<< row.str().c_str() << nl;
}


static void printTable
(
    const PtrList<candidate>& laws,
    const word& lawOfCase,
    const particleInFluid& p,
    const scalar e
)
{
    Info<< nl << "                 law coefficients"
        << "   U_mf [m/s]        Re_mf    U_t [m/s]         Re_t" << nl;

    for (const candidate& c : laws)
    {
        const scalar Umf = carryingVelocity(*c.law, p, e);
        const scalar Ut = carryingVelocity(*c.law, p, 1);

        printRow
        (
            (c.name == lawOfCase ? "* " : "") + c.name,
            c.source,
            List<scalar>({Umf, p.Re(Umf), Ut, p.Re(Ut)})
        );
    }

    const scalar Umf = wenYuMinimumFluidisation(p);
    printRow
    (
        "Wen and Yu's U_mf",
        "correlation",
        List<scalar>({Umf, p.Re(Umf)})
    );

    Info<< nl << "* of this case" << nl;

    for (const candidate& c : laws)
    {
        tellRange(c, "U_mf", e, p.Re(carryingVelocity(*c.law, p, e)));
        tellRange(c, "U_t", 1, p.Re(carryingVelocity(*c.law, p, 1)));
    }
}


static scalarList defaultVoidages()
{
    scalarList voidages(71);

    forAll(voidages, i)
    {
        voidages[i] = (30 + i)/100.0;
    }

    return voidages;
}


//- D of all laws [kg/m^3/s], one line a voidage and slip
static void writeCoefficients
(
    const fileName& path,
    const PtrList<candidate>& laws,
    const particleInFluid& p,
    const UList<scalar>& voidages,
    const UList<scalar>& slips
)
{
    mkDir(path.path());
    OFstream file(path);

    file<< "voidage,slip";
    for (const candidate& c : laws)
    {
        file<< ',' << c.name.c_str();
    }
    file<< nl;

    for (const scalar e : voidages)
    {
        for (const scalar u : slips)
        {
            file<< e << ',' << u;
            for (const candidate& c : laws)
            {
                file<< ',' << c.law->coefficient(p.flow(e, u));
            }
            file<< nl;
        }
    }

    Info<< nl << "Drag coefficients [kg/m^3/s] are in " << path << endl;
}


int main(int argc, char *argv[])
{
    addOptions();

    #include "setRootCase.H"
    #include "createTime.H"

    // That of the case is for its files
    Sout.precision(6);

    const IOdictionary properties
    (
        readCloudProperties(runTime, args.get<word>("cloud", "parcels"))
    );
    const dictionary& subModels = properties.subDict("subModels");


    // ---- The particle and its fluid ---------------------------------------

    const particleProperties particle(properties);
    const scalar e = optionInRange(args, "voidage", wenYuVoidage, 0.25, 0.85);

    particleInFluid p;
    p.d =
        args.found("diameter")
      ? optionInRange(args, "diameter", 1, 0, GREAT)
      : particle.diameter();
    p.rhoP = particle.density;
    p.g = readGravity(runTime);
    readFluid(args, runTime, p);

    Info<< "Particles of " << p.d << " m, " << p.rhoP
        << " kg/m^3, in a fluid of " << p.rho << " kg/m^3, " << p.mu
        << " kg/m/s" << nl
        << "Ar = " << p.Ar() << ", U_mf at voidage " << e << nl
        << "A parcel, of " << particle.weight
        << " particles here, has the velocities of one of them" << nl
        << endl;


    // ---- The laws ---------------------------------------------------------

    PtrList<candidate> laws(gather(subModels));

    if (args.found("measured"))
    {
        const scalar U = optionInRange(args, "measured", 1, 0, GREAT);
        laws.append(new candidate(calibrate(subModels, p, e, U)));
    }

    printTable(laws, subModels.getOrDefault("dragModel", word::null), p, e);

    if (args.found("slips"))
    {
        writeCoefficients
        (
            runTime.path()/"postProcessing/fluidisationVelocities"
           /"dragCoefficients.csv",
            laws,
            p,
            args.found("voidages")
          ? args.getList<scalar>("voidages")
          : defaultVoidages(),
            args.getList<scalar>("slips")
        );
    }

    Info<< nl << "End" << nl << endl;

    return 0;
}
