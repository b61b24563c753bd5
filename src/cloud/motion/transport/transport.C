/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "transport.H"
#include "meshFreedom.H"
#include "cyclicPolyPatch.H"
#include "processorPolyPatch.H"
#include "processorCyclicPolyPatch.H"
#include "wedgePolyPatch.H"
#include "meshTools.H"
#include "PstreamBuffers.H"
#include "globalMeshData.H"
#include "SubField.H"
#include "PstreamReduceOps.H"
#include "profiling.H"

// * * * * * * * * * * * * * * * * The boundary  * * * * * * * * * * * * * * //

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


bool Foam::cghs::transport::holds(const label facei) const
{
    return
        facei != -1
     && boundary_.stops(mesh_.boundaryMesh().whichPatch(facei));
}


void Foam::cghs::transport::turnBack
(
    arena& parcels,
    const label i,
    const label facei,
    const bool mirrored
)
{
    const label patchi = mesh_.boundaryMesh().whichPatch(facei);
    // At a valve they wait to be let out
    const bool bounces =
        bouncing_ && mirrored && boundary_[patchi] != action::valve;

    const vector n(locator_.outwardNormal(facei));
    sphere& s = parcels.spheres[i];
    motion& m = parcels.motions[i];

    // To just inside the face, by the way it came in; or as far as it was out
    const scalar out = (s.x - mesh_.faceCentres()[facei]) & n;
    s.x -= (out + max(bounces ? out : scalar(0), 1e-3*s.r))*n;

    m.v -= (bounces ? 2 : 1)*max(m.v & n, scalar(0))*n;

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

        switch (boundary_[patchi])
        {
            case action::rebound:
            case action::valve:
            case action::mirror:
                turnBack(parcels, i, facei, step + corner_ < patience);
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
                departures_.note(parcels, i, patches.whichPatch(facei));
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

    for (label round = 0; anySent && round < visitors::ranksPassed; ++round)
    {
        first = settleFrom(parcels, first, entries, anySent);
    }
}


bool Foam::cghs::transport::enters(const vector& x, label& celli)
{
    const label facei = locator_.follow(x, celli);

    return
        facei == -1
     || boundary_[mesh_.boundaryMesh().whichPatch(facei)] == action::coupled;
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
                departures_.note(parcels, i, exits[i]);
            }
        }
    }

    parcels.thin(keep);
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
    const vector free(cghs::freedom(mesh_));
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


void Foam::cghs::transport::goneOutOfHand
(
    const arena& parcels,
    const label i
) const
{
    FatalErrorInFunction
        << "Parcel " << parcels.ids[i] << " at " << parcels.spheres[i].x
        << " moves at " << parcels.motions[i].v
        << " m/s, in a step further than " << ways_ << " times the mesh:"
        << " the run has gone out of hand" << nl
        << "It has a density of " << parcels.density(i) << " kg/m^3. One"
        << " that is lighter than its fluid wants forces (addedMass) in"
        << " subModels, one that burns up leastDensity in reactionsCoeffs" << nl
        << "This step is not written" << nl
        << exit(FatalError);
}


Foam::cghs::transport::report Foam::cghs::transport::move
(
    arena& parcels,
    const scalar deltaT
)
{
    addProfiling(move, "cghs::move");

    const bool shifting = parcels.shifting() && parcels.shifts.size();
    const scalar furthestSqr = sqr(ways_*mesh_.bounds().mag());
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

        const scalar distanceSqr = magSqr(path);
        maxDistanceSqr = max(maxDistanceSqr, distanceSqr);
        maxRateSqr = max(maxRateSqr, magSqr(v)/sqr(2*s.r));

        // Not 'distance > ...', which would let nan pass
        if (!(distanceSqr <= furthestSqr))
        {
            goneOutOfHand(parcels, i);
        }

        label facei = locator_.follow(s.x, parcels.cells[i]);

        // Back from walls. Beside one the cell may end, too
        const label nMirrors = bouncing_ ? mirrors_ : 0;
        for (label k = 0; k < nMirrors + corner_ && holds(facei); ++k)
        {
            turnBack(parcels, i, facei, k < nMirrors);
            facei = locator_.follow(s.x, parcels.cells[i]);
        }

        if (facei != -1 && !holds(facei))
        {
            crossed = true;

            if (visitors_.leadTo(facei))
            {
                beyond.append(labelPair(i, facei));
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
            visitors_.find(parcels, beyond);
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
    boundary_(mesh, dict),
    freedom_
    (
        mesh.geometricD().x() > 0,
        mesh.geometricD().y() > 0,
        mesh.geometricD().z() > 0
    ),
    departures_(mesh.boundaryMesh().size()),
    visitors_(mesh, locator_),
    nPenetrated_(0),
    bouncing_(false)
{
    // Made when it is first asked for, by all ranks together: later one of them
    // may ask alone
    mesh_.globalData();
}
