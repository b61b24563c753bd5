/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "transport.H"
#include "patchParts.H"
#include "emptyPolyPatch.H"
#include "cyclicPolyPatch.H"
#include "processorPolyPatch.H"
#include "processorCyclicPolyPatch.H"
#include "cyclicAMIPolyPatch.H"
#include "symmetryPolyPatch.H"
#include "symmetryPlanePolyPatch.H"
#include "wedgePolyPatch.H"
#include "contact.H"
#include "knownEntries.H"
#include "meshTools.H"
#include "PstreamBuffers.H"
#include "globalMeshData.H"
#include "SubField.H"
#include "PstreamReduceOps.H"
#include "profiling.H"

#include <algorithm>

const Foam::Enum<Foam::cghs::transport::action>
Foam::cghs::transport::actionNames
({
    { action::rebound, "rebound" },
    { action::escape, "escape" },
    { action::valve, "inventoryValve" }
});

// * * * * * * * * * * * * * * * * The input * * * * * * * * * * * * * * * * //

bool Foam::cghs::transport::isPlate
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


void Foam::cghs::transport::readActions(const dictionary& dict)
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
        else if (!dict.found(pp.name()))
        {
            FatalIOErrorInFunction(dict)
                << "No entry for patch " << pp.name() << nl
                << "State what parcels do there, one of "
                << actionNames << nl
                << exit(FatalIOError);
        }
        else
        {
            const word name
            (
                dict.isDict(pp.name())
              ? dict.subDict(pp.name()).get<word>("type")
              : dict.get<word>(pp.name())
            );

            if (!actionNames.found(name))
            {
                FatalIOErrorInFunction(dict)
                    << "Unknown action " << name << " for patch " << pp.name()
                    << nl << "Valid choices: " << actionNames << nl
                    << exit(FatalIOError);
            }

            actions_[patchi] = actionNames[name];
        }
    }
}


Foam::List<Foam::labelPair> Foam::cghs::transport::wallPatches() const
{
    DynamicList<labelPair> patches;

    // Those between ranks are parts of these
    for (label patchi = 0; patchi < mesh_.boundaryMesh().nNonProcessor(); ++patchi)
    {
        if
        (
            actions_[patchi] == action::rebound
         || actions_[patchi] == action::valve
        )
        {
            patches.append(labelPair(patchi, contact::parcelWall));
        }
        else if (actions_[patchi] == action::mirror)
        {
            patches.append(labelPair(patchi, contact::parcelMirror));
        }
    }

    return List<labelPair>(std::move(patches));
}


Foam::labelList Foam::cghs::transport::plates() const
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


Foam::vector Foam::cghs::transport::freedom(const polyMesh& mesh)
{
    const Vector<label>& d = mesh.solutionD();

    return vector(d.x() > 0, d.y() > 0, d.z() > 0);
}


Foam::List<Foam::vector> Foam::cghs::transport::periods(const polyMesh& mesh)
{
    DynamicList<vector> own;

    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        const coupledPolyPatch* coupled = isA<coupledPolyPatch>(pp);

        if (!coupled || pp.empty())
        {
            continue;
        }

        if (!coupled->parallel())
        {
            FatalErrorInFunction
                << "Patch " << pp.name() << " couples by a rotation; parcels"
                << " can only pass periodic patches that are parallel" << nl
                << exit(FatalError);
        }

        if (coupled->separated())
        {
            own.append(coupled->separation()[0]);
        }
    }

    List<List<vector>> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = own;
    Pstream::gatherList(all);
    Pstream::scatterList(all);

    // Each period is met from both sides, and by many ranks
    DynamicList<vector> different;
    for (const List<vector>& ofRank : all)
    {
        for (const vector& p : ofRank)
        {
            bool known = false;
            for (const vector& q : different)
            {
                known =
                    known || min(mag(p - q), mag(p + q)) < 1e-6*mag(p);
            }

            if (!known)
            {
                different.append(p);
            }
        }
    }

    return List<vector>(std::move(different));
}

// * * * * * * * * * * * * * * * * The boundary  * * * * * * * * * * * * * * //

namespace Foam
{
namespace cghs
{

//- Send each rank its list, empty it, and return what has come from each
template<class Type>
static List<List<Type>> post(List<DynamicList<Type>>& sent)
{
    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
    List<List<Type>> came(sent.size());

    forAll(sent, rank)
    {
        if (sent[rank].size())
        {
            UOPstream os(rank, buffers);
            os << List<Type>(sent[rank]);
            sent[rank].clear();
        }
    }

    labelList sizes;
    buffers.finishedSends(sizes);

    forAll(came, rank)
    {
        if (sizes[rank])
        {
            UIPstream is(rank, buffers);
            is >> came[rank];
        }
    }
    return came;
}

} // End namespace cghs
} // End namespace Foam


void Foam::cghs::transport::reflect
(
    arena& parcels,
    const label i,
    const wedgePolyPatch& wedge
)
{
    // Parcels stay in the middle plane, which the plane of the patch cuts in the
    // axis
    const point middle(mesh_.bounds().centre());
    const point& onPatch = wedge.faceCentres()[0];
    const vector& n = wedge.faceNormals()[0];
    vector radial(wedge.axis() ^ wedge.centreNormal());

    const point onAxis
    (
        middle + ((n & (onPatch - middle))/(n & radial))*radial
    );

    if ((radial & (onPatch - onAxis)) < 0)
    {
        radial = -radial;
    }

    const scalar r = (parcels.spheres[i].x - onAxis) & radial;

    if (r < 0)
    {
        vector& v = parcels.motions[i].v;
        parcels.spheres[i].x -= (2*r)*radial;
        v -= 2*min(v & radial, scalar(0))*radial;
    }
}


void Foam::cghs::transport::turnBack
(
    arena& parcels,
    const label i,
    const label facei
)
{
    const vector n(locator_.outwardNormal(facei));
    sphere& s = parcels.spheres[i];
    motion& m = parcels.motions[i];

    // To just inside the face, by the way it came in
    const scalar out = (s.x - mesh_.faceCentres()[facei]) & n;
    s.x -= (out + 1e-3*s.r)*n;

    m.v -= max(m.v & n, scalar(0))*n;

    ++nPenetrated_;
}


void Foam::cghs::transport::passCyclic
(
    arena& parcels,
    const label i,
    const label facei
) const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const cyclicPolyPatch& here =
        refCast<const cyclicPolyPatch>(patches[patches.whichPatch(facei)]);
    const cyclicPolyPatch& there = here.neighbPatch();
    const label k = here.whichFace(facei);

    parcels.spheres[i].x += there.faceCentres()[k] - here.faceCentres()[k];
    parcels.cells[i] = there.faceCells()[k];
}


void Foam::cghs::transport::noteEscape
(
    const arena& parcels,
    const label i,
    const label patchi
)
{
    ++nEscaped_;
    massEscaped_[patchi] += parcels.motions[i].mass();
    parcels.noteOut(i, patchi);

    if (keepsDepartures_)
    {
        departures_.append
        (
            departure
            {
                parcels.diameters[i],
                parcels.weights[i],
                parcels.density(i),
                parcels.ids[i],
                patchi,
                parcels.row(i)
            }
        );
    }
}


Foam::cghs::transport::fate Foam::cghs::transport::settleOne
(
    arena& parcels,
    const label i,
    label& facei
)
{
    constexpr label patience = 100;

    for (label step = 0; step < patience; ++step)
    {
        facei = locator_.follow(parcels.spheres[i].x, parcels.cells[i]);

        if (facei == -1)
        {
            return fate::stays;
        }

        const label patchi = mesh_.boundaryMesh().whichPatch(facei);

        switch (actions_[patchi])
        {
            case action::rebound:
            case action::valve:
            case action::mirror:
                turnBack(parcels, i, facei);
                break;

            case action::axis:
                reflect
                (
                    parcels,
                    i,
                    refCast<const wedgePolyPatch>(mesh_.boundaryMesh()[patchi])
                );
                break;

            case action::escape:
                return fate::leaves;

            case action::coupled:
                if (isA<processorPolyPatch>(mesh_.boundaryMesh()[patchi]))
                {
                    return fate::passes;
                }
                passCyclic(parcels, i, facei);
                break;

            case action::none:
                return fate::stays;
        }
    }

    return fate::stays;
}


Foam::label Foam::cghs::transport::settleFrom
(
    arena& parcels,
    const label first,
    DynamicList<label>& entries,
    bool& anySent
)
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const labelList& procNeighbours =
        mesh_.globalData().processorPatchNeighbours();

    boolList keep(parcels.size(), true);
    List<DynamicList<label>> sent(Pstream::nProcs());
    List<DynamicList<passage>> passages(Pstream::nProcs());
    label nLost = 0;

    for (label i = first; i < parcels.size(); ++i)
    {
        label facei;
        const fate next = settleOne(parcels, i, facei);

        if
        (
            next == fate::passes
         && entries.size()
         && facei == entries[i - first]
        )
        {
            continue;
        }

        switch (next)
        {
            case fate::stays:
                break;

            case fate::leaves:
                keep[i] = false;
                ++nLost;
                noteEscape(parcels, i, patches.whichPatch(facei));
                break;

            case fate::passes:
            {
                const label patchi = patches.whichPatch(facei);
                const processorPolyPatch& pp =
                    refCast<const processorPolyPatch>(patches[patchi]);

                keep[i] = false;
                ++nLost;
                sent[pp.neighbProcNo()].append(i);
                passages[pp.neighbProcNo()].append
                (
                    passage
                    {
                        procNeighbours[patchi],
                        pp.whichFace(facei),
                        parcels.spheres[i].x - mesh_.faceCentres()[facei]
                    }
                );
                break;
            }
        }
    }

    if (!Pstream::parRun())
    {
        if (nLost)
        {
            parcels.thin(keep);
        }
        anySent = false;
        return parcels.size();
    }

    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);

    forAll(sent, rank)
    {
        if (sent[rank].size())
        {
            UOPstream os(rank, buffers);
            os << passages[rank];
            parcels.pack(sent[rank], os);
        }
    }

    labelList sizes;
    buffers.finishedSends(sizes);

    if (nLost)
    {
        parcels.thin(keep);
    }

    const label firstNew = parcels.size();
    entries.clear();
    const labelList& procPatches = mesh_.globalData().processorPatches();

    forAll(sizes, rank)
    {
        if (!sizes[rank])
        {
            continue;
        }

        UIPstream is(rank, buffers);
        const List<passage> came(is);
        label i = parcels.size();
        parcels.unpack(is);

        for (const passage& p : came)
        {
            const polyPatch& pp = patches[procPatches[p.patch]];

            parcels.cells[i] = pp.faceCells()[p.face];
            entries.append(pp.start() + p.face);

            // Between the two sides of a period the centres differ
            if (isA<processorCyclicPolyPatch>(pp))
            {
                parcels.spheres[i].x = pp.faceCentres()[p.face] + p.offset;
            }
            ++i;
        }
    }

    anySent = returnReduce(parcels.size() > firstNew, orOp<bool>());
    return firstNew;
}


void Foam::cghs::transport::settle(arena& parcels)
{
    parcels.dismissGuests();
    parcels.visiting.clear();

    label first = 0;
    bool anySent = true;
    DynamicList<label> entries;

    for (label round = 0; anySent && round < patience_; ++round)
    {
        first = settleFrom(parcels, first, entries, anySent);
    }
}


bool Foam::cghs::transport::toOtherRank(const label facei) const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const polyPatch& pp = patches[patches.whichPatch(facei)];

    return isA<processorPolyPatch>(pp) && !isA<processorCyclicPolyPatch>(pp);
}


void Foam::cghs::transport::sendOn
(
    visitor v,
    const label facei,
    List<DynamicList<visitor>>& sent
) const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const label patchi = patches.whichPatch(facei);
    const processorPolyPatch& pp =
        refCast<const processorPolyPatch>(patches[patchi]);

    v.patch = mesh_.globalData().processorPatchNeighbours()[patchi];
    v.face = pp.whichFace(facei);
    sent[pp.neighbProcNo()].append(v);
}


void Foam::cghs::transport::host
(
    const UList<visitor>& came,
    List<DynamicList<visitor>>& sent,
    List<DynamicList<label>>& cells,
    List<DynamicList<label>>& guests
)
{
    const labelList& procPatches = mesh_.globalData().processorPatches();

    for (const visitor& v : came)
    {
        const polyPatch& pp = mesh_.boundaryMesh()[procPatches[v.patch]];

        label celli = pp.faceCells()[v.face];
        const label facei = locator_.follow(v.x, celli);

        // Not back by the face that it came in by, see settleFrom
        if
        (
            facei != -1
         && facei != pp.start() + v.face
         && toOtherRank(facei)
        )
        {
            sendOn(v, facei, sent);
        }
        else
        {
            cells[v.rank].append(celli);
            guests[v.rank].append(v.parcel);
        }
    }
}


void Foam::cghs::transport::findVisits
(
    arena& parcels,
    const UList<labelPair>& beyond
)
{
    const label nRanks = Pstream::nProcs();
    List<DynamicList<visitor>> sent(nRanks);
    List<DynamicList<label>> cells(nRanks);
    List<DynamicList<label>> guests(nRanks);

    for (const labelPair& p : beyond)
    {
        const label i = p.first();

        sendOn
        (
            visitor{Pstream::myProcNo(), i, -1, -1, parcels.spheres[i].x},
            p.second(),
            sent
        );
    }

    bool any = true;
    for (label round = 0; any && round < patience_; ++round)
    {
        const List<List<visitor>> came(post(sent));

        any = false;
        for (const List<visitor>& ofRank : came)
        {
            host(ofRank, sent, cells, guests);
        }
        for (const List<visitor>& toRank : sent)
        {
            any = any || toRank.size();
        }
        reduce(any, orOp<bool>());
    }

    labelListList hosted(nRanks);
    forAll(hosted, rank)
    {
        hosted[rank] = std::move(cells[rank]);
    }
    parcels.visiting.set
    (
        parcels.cells,
        mesh_.nCells(),
        post(guests),
        std::move(hosted)
    );
}


bool Foam::cghs::transport::enters(const vector& x, label& celli)
{
    const label facei = locator_.follow(x, celli);

    return
        facei == -1
     || actions_[mesh_.boundaryMesh().whichPatch(facei)] == action::coupled;
}


void Foam::cghs::transport::release
(
    arena& parcels,
    const labelUList& exits
)
{
    boolList keep(parcels.size(), true);

    forAll(exits, i)
    {
        if (exits[i] != -1)
        {
            keep[i] = false;
            if (exits[i] == nowhere)
            {
                parcels.noteOut(i, nowhere);
            }
            else
            {
                noteEscape(parcels, i, exits[i]);
            }
        }
    }

    parcels.thin(keep);
}


Foam::List<Foam::cghs::departure>
Foam::cghs::transport::collectDepartures()
{
    List<List<departure>> ofRanks(Pstream::nProcs());
    ofRanks[Pstream::myProcNo()] = departures_;
    departures_.clear();

    Pstream::gatherList(ofRanks);
    Pstream::scatterList(ofRanks);

    DynamicList<departure> all;
    for (const List<departure>& ofRank : ofRanks)
    {
        all.append(ofRank);
    }

    std::sort
    (
        all.begin(),
        all.end(),
        [](const departure& a, const departure& b) { return a.id < b.id; }
    );

    return List<departure>(std::move(all));
}

// * * * * * * * * * * * * * * * * The motion  * * * * * * * * * * * * * * * //

void Foam::cghs::transport::reportConstrained
(
    const label n,
    const scalar furthest
) const
{
    const label nAll = returnReduce(n, sumOp<label>());
    const scalar most = returnReduce(furthest, maxOp<scalar>());

    if (nAll)
    {
        WarningInFunction
            << nAll << " parcels were out of the middle plane of the mesh, or"
            << " moved out of it: they are brought into it, by up to " << most
            << " diameters" << nl << endl;
    }
}


void Foam::cghs::transport::constrain(arena& parcels) const
{
    const vector free(freedom(mesh_));
    const vector across(vector::one - free);
    const bool flat = across != vector::zero;
    bool wedge = false;

    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        wedge = wedge || isA<wedgePolyPatch>(pp);
    }

    if (!flat && !returnReduce(wedge, orOp<bool>()))
    {
        return;
    }

    label nMoved = 0;
    scalar furthest = 0;

    for (label i = 0; i < parcels.size(); ++i)
    {
        sphere& s = parcels.spheres[i];
        const vector before(s.x);
        meshTools::constrainToMeshCentre(mesh_, s.x);

        const scalar moved = mag(s.x - before)/(2*s.r);
        bool out = moved > 1e-6;

        if (flat)
        {
            vector& v = parcels.motions[i].v;
            out = out || cmptMultiply(v, across) != vector::zero;
            v = cmptMultiply(v, free);

            if (parcels.spinning())
            {
                vector& w = parcels.spins[i];
                out = out || cmptMultiply(w, free) != vector::zero;
                w = cmptMultiply(w, across);
            }
        }
        nMoved += out;
        furthest = max(furthest, moved);
    }

    if (flat)
    {
        reportConstrained(nMoved, furthest);
    }
}


Foam::cghs::transport::report Foam::cghs::transport::survey
(
    const arena& parcels
) const
{
    scalar maxRateSqr = 0;

    for (label i = 0; i < parcels.size(); ++i)
    {
        maxRateSqr =
            max
            (
                maxRateSqr,
                magSqr(parcels.motions[i].v)/sqr(2*parcels.spheres[i].r)
            );
    }
    reduce(maxRateSqr, maxOp<scalar>());

    report r;
    r.diameterTime = 1/max(sqrt(maxRateSqr), VSMALL);
    return r;
}


Foam::cghs::transport::report Foam::cghs::transport::move
(
    arena& parcels,
    const scalar deltaT
)
{
    addProfiling(move, "cghs::move");

    const bool shifting = parcels.shifting() && parcels.shifts.size();
    scalar maxDistanceSqr = 0;
    scalar maxRateSqr = 0;
    bool crossed = false;
    DynamicList<labelPair> beyond;

    for (label i = 0; i < parcels.size(); ++i)
    {
        sphere& s = parcels.spheres[i];
        vector& v = parcels.motions[i].v;

        v = cmptMultiply(v, freedom_);

        vector path(deltaT*v);
        if (shifting)
        {
            path += parcels.shifts[i];
        }
        s.x += path;

        maxDistanceSqr = max(maxDistanceSqr, magSqr(path));
        maxRateSqr = max(maxRateSqr, magSqr(v)/sqr(2*s.r));

        const label facei = locator_.follow(s.x, parcels.cells[i]);

        if (facei != -1)
        {
            const label patchi = mesh_.boundaryMesh().whichPatch(facei);

            if
            (
                actions_[patchi] == action::rebound
             || actions_[patchi] == action::valve
             || actions_[patchi] == action::mirror
            )
            {
                turnBack(parcels, i, facei);
            }
            else
            {
                crossed = true;

                if (toOtherRank(facei))
                {
                    beyond.append(labelPair(i, facei));
                }
            }
        }
    }

    vector global(maxDistanceSqr, maxRateSqr, crossed);
    reduce(global, maxOp<vector>());

    report r;
    r.maxDistance = sqrt(global.x());
    r.diameterTime = 1/max(sqrt(global.y()), VSMALL);
    r.crossed = global.z() > 0;

    if (Pstream::parRun())
    {
        if (r.crossed)
        {
            findVisits(parcels, beyond);
        }
        else
        {
            parcels.visiting.clear();
        }
    }
    return r;
}

// * * * * * * * * * * * * * * * * * Public  * * * * * * * * * * * * * * * * //

Foam::cghs::transport::transport(const polyMesh& mesh, const dictionary& dict)
:
    mesh_(mesh),
    locator_(mesh),
    actions_(mesh.boundaryMesh().size(), action::none),
    freedom_
    (
        mesh.geometricD().x() > 0,
        mesh.geometricD().y() > 0,
        mesh.geometricD().z() > 0
    ),
    nEscaped_(0),
    massEscaped_(mesh.boundaryMesh().size(), Zero),
    nPenetrated_(0),
    keepsDepartures_(false),
    departures_()
{
    readActions(dict);

    // Made when it is first asked for, by all ranks together: later one of them
    // may ask alone
    mesh_.globalData();
}
