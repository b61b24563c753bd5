/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "composition.H"
#include "caseChecks.H"
#include "constantDictionary.H"
#include "basicThermo.H"
#include "PtrList.H"

namespace Foam
{
namespace cghs
{

static IOobject fileOfField(const word& name, const fvMesh& mesh)
{
    return IOobject
    (
        name,
        mesh.time().timeName(),
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
}


//- Stop if the sum is not one. where: in the cells or at a patch
static void checkSum
(
    const scalarField& sum,
    const word& species,
    const wordList& names,
    const fvMesh& mesh,
    const string& where
)
{
    constexpr scalar tolerance = 1e-5;

    const scalar least = gMin(sum);
    const scalar most = gMax(sum);

    if (returnReduce(sum.size(), sumOp<label>()) == 0)
    {
        return;
    }

    if (!(least >= 1 - tolerance && most <= 1 + tolerance))
    {
        const volScalarField shown(fileOfField(species, mesh), mesh);

        FatalIOErrorInFunction(fileOf(shown))
            << "The mass fractions of " << flatOutput(names) << " sum to "
            << (most > 1 + tolerance ? most : least) << ' ' << where.c_str()
            << ", but must sum to 1" << nl
            << "Mend the fields of the species, e.g. that of the inert one"
            << nl << exit(FatalIOError);
    }
}

} // End namespace cghs
} // End namespace Foam


void Foam::cghs::checkFields
(
    const fvMesh& mesh,
    const wordList& species,
    const dictionary& dict
)
{
    forAll(species, i)
    {
        const word& name = species[i];

        if (species.find(name) != i)
        {
            FatalIOErrorInFunction(dict)
                << "Entry species is " << flatOutput(species) << ": it names "
                << name << " twice" << nl
                << "Name each species once" << nl
                << exit(FatalIOError);
        }

        if (!fileOfField(name, mesh).typeHeaderOk<volScalarField>(true))
        {
            FatalIOErrorInFunction(dict)
                << "Entry species is " << flatOutput(species)
                << " but there is no field " << name << " in "
                << mesh.time().timePath() << nl
                << "Write one, of the mass fraction of that species [-]" << nl
                << exit(FatalIOError);
        }

        const volScalarField Y(fileOfField(name, mesh), mesh);
        const scalar least = gMin(Y.primitiveField());

        if (Y.dimensions() != dimless || !(least > -1e-3))
        {
            FatalIOErrorInFunction(fileOf(Y))
                << "Field " << name << " has dimensions " << Y.dimensions()
                << " and goes down to " << least
                << ", but a mass fraction has none and is not below zero" << nl
                << exit(FatalIOError);
        }
    }
}


void Foam::cghs::checkSum(const fvMesh& mesh, const wordList& species)
{
    PtrList<volScalarField> Y(species.size());
    forAll(species, i)
    {
        Y.set(i, new volScalarField(fileOfField(species[i], mesh), mesh));
    }

    const word& shown = species.last();
    scalarField sum(mesh.nCells(), Zero);
    for (const volScalarField& field : Y)
    {
        sum += field.primitiveField();
    }
    checkSum(sum, shown, species, mesh, "in a cell");

    forAll(mesh.boundary(), patchi)
    {
        if (mesh.boundary()[patchi].coupled())
        {
            continue;
        }

        scalarField there(mesh.boundary()[patchi].size(), Zero);
        for (const volScalarField& field : Y)
        {
            there += field.boundaryField()[patchi];
        }
        checkSum
        (
            there,
            shown,
            species,
            mesh,
            "at the patch " + mesh.boundary()[patchi].name()
        );
    }
}


Foam::wordList Foam::cghs::checkMixture(const fvMesh& mesh)
{
    const IOdictionary properties
    (
        constantDictionary(mesh, basicThermo::dictName)
    );
    const dictionary& types = properties.subDict("thermoType");
    const word mixture(types.get<word>("mixture"));

    if (mixture != "multiComponentMixture")
    {
        FatalIOErrorInFunction(types)
            << "Entry mixture is " << mixture << " but species are to be"
            << " transported" << nl
            << "Valid choices: multiComponentMixture, with an entry species"
            << " and a dictionary for each, see species.H" << nl
            << exit(FatalIOError);
    }

    const wordList species(properties.get<wordList>("species"));

    for (const word& name : species)
    {
        if (!properties.isDict(name))
        {
            FatalIOErrorInFunction(properties)
                << "Entry species is " << flatOutput(species)
                << " but there is no dictionary " << name << nl
                << "Add one, with specie, thermodynamics and transport" << nl
                << exit(FatalIOError);
        }
    }

    checkFields(mesh, species, properties);
    checkSum(mesh, species);

    return species;
}
