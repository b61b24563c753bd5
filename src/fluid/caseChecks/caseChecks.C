/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "caseChecks.H"
#include "cghsCloud.H"
#include "localIOdictionary.H"

Foam::dictionary Foam::cghs::fileOf(const volScalarField& field)
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


void Foam::cghs::checkTransient(const fvMesh& mesh)
{
    const fvSchemes& schemes = mesh;

    if (schemes.steady())
    {
        FatalIOErrorInFunction(schemes.subDict("ddtSchemes"))
            << "Entry default is steadyState, but parcels move in time" << nl
            << "Choose a scheme of transient flow: Euler, backward or"
            << " CrankNicolson" << nl
            << exit(FatalIOError);
    }
}


void Foam::cghs::checkPressure
(
    const volScalarField& p,
    const dimensionSet& wanted
)
{
    if (p.dimensions() != wanted)
    {
        FatalIOErrorInFunction(fileOf(p))
            << "Entry dimensions is " << p.dimensions()
            << " but must be " << wanted << " for the fluid that is chosen"
            << nl << "Mend p, or choose another fluid in the solution of the"
            << " cloud's properties: incompressible takes p over the density,"
            << " gas p" << nl
            << exit(FatalIOError);
    }
}


void Foam::cghs::checkSolids
(
    const volScalarField& alpha,
    const cghsCloud& cloud
)
{
    const scalar lowest = gMin(alpha.primitiveField());

    if (cloud.empty() && lowest < 1 - SMALL)
    {
        FatalIOErrorInFunction(fileOf(alpha))
            << "alpha goes down to " << lowest << ", so there have been solids,"
            << " but the cloud " << cloud.name() << " has no parcels in "
            << alpha.time().timePath()/cloud::prefix/cloud.name() << nl
            << "Restore that folder, or restart from a time that has it, or"
            << " fill the mesh with fillParcels; or remove alpha to begin"
            << " without solids" << nl
            << exit(FatalIOError);
    }
}


void Foam::cghs::checkFrozen(const dictionary& piso, const cghsCloud& cloud)
{
    if (cloud.coupling() == cghsCloud::couplingType::twoWay)
    {
        FatalIOErrorInFunction(piso)
            << "Entry frozenFlow is yes, but the flow has to give way to the"
            << " parcels of " << cloud.name() << ": their coupling is twoWay"
            << nl << "Choose coupling oneWay in the solution of "
            << cloud.name() << "Properties, or frozenFlow no" << nl
            << exit(FatalIOError);
    }
}


void Foam::cghs::checkFrozenDensity
(
    const dictionary& solution,
    const bool stays
)
{
    if (!stays)
    {
        FatalIOErrorInFunction(solution)
            << "Entry transported is "
            << solution.get<wordList>("transported") << ", by which the"
            << " density of a gas changes, but its flow is to stay as it is:"
            << " frozenFlow is yes in PISO" << nl
            << "Transport nothing, choose fluid incompressible, or frozenFlow"
            << " no" << nl
            << exit(FatalIOError);
    }
}
