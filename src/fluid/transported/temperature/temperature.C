/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "temperature.H"
#include "caseChecks.H"
#include "basicThermo.H"

void Foam::cghs::checkAboveZero
(
    const volScalarField& field,
    const char* meaning
)
{
    const scalar lowest = gMin(field.primitiveField());

    if (!(lowest > 0))
    {
        FatalIOErrorInFunction(fileOf(field))
            << "Entry internalField goes down to " << lowest
            << " but must be greater than zero: " << meaning << nl
            << exit(FatalIOError);
    }
}


void Foam::cghs::checkTemperature(const fvMesh& mesh)
{
    IOobject file
    (
        "T",
        mesh.time().timeName(),
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );

    if (!file.typeHeaderOk<volScalarField>(true))
    {
        FatalErrorInFunction
            << "There is no field T in " << mesh.time().timePath() << nl
            << "Write one, of the fluid's absolute temperature [K]" << nl
            << exit(FatalError);
    }

    const volScalarField T(file, mesh);
    checkAboveZero(T, "T is the absolute temperature [K], e.g. 293");

    const scalar lowest = gMin(T.primitiveField());

    if (lowest < 100)
    {
        WarningInFunction
            << "Entry internalField in " << fileOf(T).name()
            << " goes down to " << lowest << " K" << nl
            << "    If these are degrees Celsius, add 273.15" << nl << endl;
    }
}


void Foam::cghs::checkThermophysics
(
    const fvMesh& mesh,
    const dictionary& solution,
    const string& needs,
    const string& remedy
)
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
            << "Entry " << needs.c_str() << " but there is no file "
            << file.objectPath() << nl
            << "Write one, " << remedy.c_str() << nl
            << exit(FatalIOError);
    }
}
