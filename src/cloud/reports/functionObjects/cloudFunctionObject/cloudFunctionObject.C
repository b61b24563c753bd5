/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "cloudFunctionObject.H"
#include "cghsCloud.H"

Foam::cghs::cloudFunctionObject::cloudFunctionObject
(
    const word& name,
    const Time& time,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, time, dict),
    cloudName_()
{}


bool Foam::cghs::cloudFunctionObject::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);

    dict.readEntry("cloud", cloudName_);

    // cghsFoam -postProcess makes the cloud anew at each time, later than this
    if (!postProcess && !mesh_.foundObject<cghsCloud>(cloudName_))
    {
        FatalIOErrorInFunction(dict)
            << "There is no cghsCloud called " << cloudName_ << nl
            << "Valid choices: " << mesh_.sortedNames<cghsCloud>() << nl
            << exit(FatalIOError);
    }

    return true;
}


const Foam::cghs::cghsCloud& Foam::cghs::cloudFunctionObject::theCloud() const
{
    return mesh_.lookupObject<cghsCloud>(cloudName_);
}


const Foam::cghs::arena& Foam::cghs::cloudFunctionObject::parcels() const
{
    return theCloud().parcels();
}


Foam::labelList Foam::cghs::cloudFunctionObject::exitPatches
(
    const dictionary& dict
) const
{
    const polyBoundaryMesh& all = mesh_.boundaryMesh();
    const parcelBoundary& boundary = theCloud().transportStage().boundary();
    const wordList wanted(dict.get<wordList>("patches"));

    labelList patches(wanted.size());

    forAll(wanted, i)
    {
        patches[i] = all.findPatchID(wanted[i]);

        if (patches[i] < 0 || !boundary.escapes(patches[i]))
        {
            DynamicList<word> valid;
            forAll(all, patchi)
            {
                if (boundary.escapes(patchi))
                {
                    valid.append(all[patchi].name());
                }
            }

            FatalIOErrorInFunction(dict)
                << "Entry patches: parcels do not escape through "
                << wanted[i] << nl
                << "Valid choices: " << valid << nl
                << exit(FatalIOError);
        }
    }

    return patches;
}
