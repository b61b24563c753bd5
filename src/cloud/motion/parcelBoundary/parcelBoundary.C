/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "parcelBoundary.H"
#include "contact.H"
#include "cyclicAMIPolyPatch.H"
#include "cyclicPolyPatch.H"
#include "emptyPolyPatch.H"
#include "knownEntries.H"
#include "patchParts.H"
#include "processorCyclicPolyPatch.H"
#include "symmetryPlanePolyPatch.H"
#include "symmetryPolyPatch.H"
#include "wedgePolyPatch.H"

const Foam::Enum<Foam::cghs::parcelBoundary::action>
Foam::cghs::parcelBoundary::actionNames
({
    { action::rebound, "rebound" },
    { action::escape, "escape" },
    { action::valve, "inventoryValve" }
});

// * * * * * * * * * * * * * * * * The input * * * * * * * * * * * * * * * * //

bool Foam::cghs::parcelBoundary::isPlate
(
    const cyclicPolyPatch& patch,
    const dictionary& dict
) const
{
    const entry* e = dict.findEntry(patch.name(), keyType::LITERAL);

    if (!e)
    {
        return false;
    }

    // All of its faces may be between ranks
    bool apart = false;

    for (const label parti : patchParts(mesh_, patch.index()))
    {
        const polyPatch& part = mesh_.boundaryMesh()[parti];

        apart =
            apart
         || (part.size() && refCast<const coupledPolyPatch>(part).separated());
    }

    if (returnReduce(apart, orOp<bool>()))
    {
        WarningInFunction
            << "The entry for patch " << patch.name() << " in " << dict.name()
            << " has no effect: parcels pass periodic sides" << nl
            << "    Only a plate within the mesh, of a cyclic pair in one place as"
            << " createBaffles makes it, can hold parcels" << nl << endl;
        return false;
    }

    if (e->isDict() || e->get<word>() != actionNames[action::rebound])
    {
        FatalIOErrorInFunction(dict)
            << "The entry for the cyclic patch " << patch.name()
            << " must be rebound" << nl
            << "Parcels pass cyclic patches; rebound makes a plate of one that"
            << " holds them, and lets the fluid pass. Without an entry they pass"
            << nl << exit(FatalIOError);
    }

    const word& other = patch.neighbPatchName();

    if (!dict.findEntry(other, keyType::LITERAL))
    {
        FatalIOErrorInFunction(dict)
            << "Patch " << patch.name() << " is told to hold parcels, but "
            << other << ", which is its other side, is not" << nl
            << "Both sides of a plate hold them: add the entry " << other << ' '
            << actionNames[action::rebound] << nl << exit(FatalIOError);
    }

    return true;
}


Foam::cghs::parcelBoundary::action Foam::cghs::parcelBoundary::chosen
(
    const dictionary& dict,
    const word& patch
) const
{
    if (!dict.found(patch))
    {
        FatalIOErrorInFunction(dict)
            << "No entry for patch " << patch << nl
            << "State what parcels do there, one of " << actionNames << nl
            << exit(FatalIOError);
    }

    const word name
    (
        dict.isDict(patch)
      ? dict.subDict(patch).get<word>("type")
      : dict.get<word>(patch)
    );

    if (!actionNames.found(name))
    {
        FatalIOErrorInFunction(dict)
            << "Unknown action " << name << " for patch " << patch << nl
            << "Valid choices: " << actionNames << nl << exit(FatalIOError);
    }

    return actionNames[name];
}


void Foam::cghs::parcelBoundary::readActions(const dictionary& dict)
{
    List<word> names(mesh_.boundaryMesh().names());
    names.append(mesh_.boundaryMesh().groupPatchIDs().toc());
    warnUnknownEntries(dict, names);


    const polyBoundaryMesh& patches = mesh_.boundaryMesh();

    forAll(patches, patchi)
    {
        const polyPatch& pp = patches[patchi];

        if (isA<emptyPolyPatch>(pp))
        {
            actions_[patchi] = action::none;
        }
        else if (isA<processorCyclicPolyPatch>(pp))
        {
            // Parts of a periodic patch, which comes before them
            actions_[patchi] =
                actions_
                [
                    refCast<const processorCyclicPolyPatch>(pp).referPatchID()
                ];
        }
        else if (isA<cyclicPolyPatch>(pp))
        {
            actions_[patchi] =
                isPlate(refCast<const cyclicPolyPatch>(pp), dict)
              ? action::rebound
              : action::coupled;
        }
        else if (isA<processorPolyPatch>(pp))
        {
            actions_[patchi] = action::coupled;
        }
        else if (isA<symmetryPolyPatch>(pp) || isA<symmetryPlanePolyPatch>(pp))
        {
            actions_[patchi] = action::mirror;
        }
        else if (isA<wedgePolyPatch>(pp))
        {
            actions_[patchi] = action::axis;
        }
        else if (isA<cyclicAMIPolyPatch>(pp))
        {
            FatalIOErrorInFunction(dict)
                << "Patch " << pp.name() << " is of type " << pp.type()
                << ", which parcels cannot pass" << nl
                << "Make its two sides match and use cyclic" << nl
                << exit(FatalIOError);
        }
        else
        {
            actions_[patchi] = chosen(dict, pp.name());
        }
    }
}


Foam::cghs::parcelBoundary::parcelBoundary
(
    const polyMesh& mesh,
    const dictionary& dict
)
:
    mesh_(mesh),
    actions_(mesh.boundaryMesh().size(), action::none)
{
    readActions(dict);
}

// * * * * * * * * * * * * * * * * * Public  * * * * * * * * * * * * * * * * //

Foam::List<Foam::labelPair> Foam::cghs::parcelBoundary::wallPatches() const
{
    DynamicList<labelPair> patches;

    // Those between ranks are parts of these
    for (label patchi = 0; patchi < mesh_.boundaryMesh().nNonProcessor(); ++patchi)
    {
        if (stops(patchi))
        {
            patches.append
            (
                labelPair
                (
                    patchi,
                    actions_[patchi] == action::mirror
                  ? contact::parcelMirror
                  : contact::parcelWall
                )
            );
        }
    }

    return List<labelPair>(std::move(patches));
}


Foam::labelList Foam::cghs::parcelBoundary::plates() const
{
    DynamicList<label> patches;

    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (pp.coupled() && actions_[pp.index()] == action::rebound)
        {
            patches.append(pp.index());
        }
    }

    return labelList(std::move(patches));
}
