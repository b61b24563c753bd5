/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "cellSlab.H"
#include "checkedEntry.H"
#include "knownEntries.H"

Foam::vector Foam::cghs::unitVector(const dictionary& dict, const word& entry)
{
    const vector v(dict.get<vector>(entry));

    if (!(mag(v) > VSMALL))
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << entry << " is " << v
            << " but must be a direction: a vector of some length" << nl
            << exit(FatalIOError);
    }

    return v/mag(v);
}


Foam::boolList Foam::cghs::inSlab(const dictionary& dict, const fvMesh& mesh)
{
    boolList inside(mesh.nCells(), true);

    if (dict.found("slab"))
    {
        const dictionary& slab = dict.subDict("slab");
        warnUnknownEntries
        (
            slab,
            wordList({"normal", "position", "thickness"})
        );

        const vector normal(unitVector(slab, "normal"));
        const scalar position = slab.get<scalar>("position");
        const scalar half = 0.5*positiveScalar(slab, "thickness");
        const vectorField& centres = mesh.cellCentres();

        forAll(inside, celli)
        {
            inside[celli] = mag((centres[celli] & normal) - position) <= half;
        }
    }

    return inside;
}
