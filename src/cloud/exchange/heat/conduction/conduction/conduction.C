/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "conduction.H"
#include "facesOfRanks.H"
#include "patchParts.H"
#include "wallHeat.H"
#include "volFields.H"
#include "profiling.H"
#include "PstreamReduceOps.H"

#include <cmath>

// * * * * * * * * * * * * * * * Construction  * * * * * * * * * * * * * * * //

Foam::cghs::conduction::conduction
(
    const dictionary& dict,
    parcelCapacity& Cp,
    propertyOf<scalar>& T
)
:
    models_(conductionModel::New(dict)),
    Cp_(Cp),
    T_(T),
    partners_("conductionPartners"),
    received_("conductionReceived"),
    next_(0),
    now_(models_.size()),
    last_(models_.size()),
    inAll_(models_.size(), Zero),
    deltaT_(1)
{
    partners_.lend().hide();
    received_.lend().hide();

    forAll(models_, m)
    {
        (models_[m].layered() ? layered_ : touching_).append(m);
    }

    if (any())
    {
        T_.lend();
    }
}


Foam::cghs::contactNeeds Foam::cghs::conduction::needs() const
{
    contactNeeds needs;
    needs.wallFaces = any();

    for (const conductionModel& model : models_)
    {
        needs.add(model.needs());
    }
    return needs;
}


void Foam::cghs::conduction::addColumns(arena& parcels)
{
    if (any())
    {
        parcels.add(partners_);
        parcels.add(received_);
    }

    for (conductionModel& model : models_)
    {
        model.addColumns(parcels);
    }
}

// * * * * * * * * * * * * * * * * The step  * * * * * * * * * * * * * * * * //

void Foam::cghs::conduction::meet
(
    const arena& parcels,
    const carrierFluid& fluid
)
{
    if (!any())
    {
        return;
    }

    const volScalarField& T = fluid.field("T");
    List<scalarField> byPatch(wallPatches_.size());

    forAll(wallPatches_, k)
    {
        const fvPatchScalarField& at = T.boundaryField()[wallPatches_[k]];

        byPatch[k] =
            wallHeat::givenTemperatures
            (
                at,
                nFacesOf(T.mesh(), wallPatches_[k])
            );
    }
    wallT_ = facesOfRanks(byPatch);

    if (patchOfFace_.size() != wallT_.size())
    {
        List<Field<label>> patches(wallPatches_.size());
        forAll(patches, k)
        {
            patches[k] = Field<label>(byPatch[k].size(), k);
        }
        patchOfFace_ = facesOfRanks(patches);
    }

    for (conductionModel& model : models_)
    {
        model.meet(parcels, fluid);
    }
}


void Foam::cghs::conduction::prepare(const arena& parcels)
{
    for (conductionModel& model : models_)
    {
        model.prepare(parcels);
    }
}


Foam::scalar Foam::cghs::conduction::wallTOf
(
    const contactList& list,
    const label k
) const
{
    const contact& c = list.contacts[k];

    return
        !c.atWall() || wallT_.empty()
     || c.surface % contact::nSurfaces == contact::parcelMirror
      ? 0
      : wallT_[list.wallFaces[k]];
}


void Foam::cghs::conduction::survey
(
    const labelUList& models,
    const contactList& list,
    const arena& parcels,
    const scalar deltaT
)
{
    addProfiling(conduction, "cghs::conduction");

    forAll(list.contacts, k)
    {
        const contact& c = list.contacts[k];
        const bool conducting = conducts(c, wallTOf(list, k));
        scalar all = 0;

        const conductingPair pair
        {
            c,
            k < list.memories.size() ? list.memories[k].load : -1,
            k < list.approaches.size() ? list.approaches[k] : 0,
            deltaT
        };

        for (const label m : models)
        {
            passing_.append
            (
                conducting ? models_[m].passes(pair, parcels) : 0
            );
            all += passing_.last();
        }

        if (all > 0)
        {
            ++partners_[c.a];
            if (!c.atWall())
            {
                ++partners_[c.b];
            }
        }
    }
}


void Foam::cghs::conduction::pass
(
    const labelUList& models,
    const contactList& list,
    const arena& parcels
)
{
    addProfiling(conduction, "cghs::conduction");

    forAll(list.contacts, k)
    {
        const SubList<scalar> passing(passing_, models.size(), next_);
        next_ += models.size();
        const scalar all = sum(passing);

        if (all <= 0)
        {
            continue;
        }

        const contact& c = list.contacts[k];
        const bool wall = c.atWall();

        const scalar invC =
            share(parcels, c.a) + (wall ? 0 : share(parcels, c.b));
        const scalar Tb = wall ? wallTOf(list, k) : T_[c.b];
        const scalar Q = -std::expm1(-all*invC)/invC*(Tb - T_[c.a]);

        received_[c.a] += Q;
        if (!wall)
        {
            received_[c.b] -= Q;
        }

        if (wall)
        {
            fromPatches_[patchOfFace_[list.wallFaces[k]]] += Q;
        }

        forAll(models, m)
        {
            heatPassed& passed = now_[models[m]];
            const scalar part = Q*passing[m]/all;

            (wall ? passed.walls : passed.between) += wall ? part : mag(part);
        }
    }
}


void Foam::cghs::conduction::finish(const arena& parcels)
{
    for (label i = 0; i < parcels.size(); ++i)
    {
        T_[i] += received_[i]*parcels.motions[i].invMass/Cp_(i);
        received_[i] = 0;
        partners_[i] = 0;
    }

    passing_.clear();
    next_ = 0;
}


void Foam::cghs::conduction::moveTo(wallHeat& walls)
{
    forAll(wallPatches_, k)
    {
        walls.add(wallPatches_[k], fromPatches_[k]);
        fromPatches_[k] = 0;
    }
}


void Foam::cghs::conduction::evolve(const scalar deltaT)
{
    deltaT_ = deltaT;

    forAll(models_, m)
    {
        last_[m] = now_[m];
        now_[m] = heatPassed();

        inAll_[m] += returnReduce(last_[m].between, sumOp<scalar>());
    }
}

// * * * * * * * * * * * * * * * * Reports * * * * * * * * * * * * * * * * * //

void Foam::cghs::conduction::report(Ostream& os) const
{
    forAll(models_, m)
    {
        const scalar between =
            returnReduce(last_[m].between, sumOp<scalar>());

        os  << "        " << models_[m].type() << " passes "
            << between/deltaT_ << " W between parcels, " << inAll_[m]
            << " J so far" << nl;
    }
}


void Foam::cghs::conduction::state(dictionary& state) const
{
    forAll(models_, m)
    {
        state.add(word(models_[m].type() + "Between"), inAll_[m]);
    }
}


void Foam::cghs::conduction::setState(const dictionary& state)
{
    forAll(models_, m)
    {
        state.readIfPresent(models_[m].type() + "Between", inAll_[m]);
    }
}
