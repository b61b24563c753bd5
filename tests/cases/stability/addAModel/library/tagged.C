/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    A model of a test's own: parcels have a number, a vector and a label that tell
    which they are, and a twin of their radius that guests have, too.

\*---------------------------------------------------------------------------*/

#include "exchange.H"
#include "PstreamReduceOps.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{

//- The radius, which nobody has to be told
class twinOfRadius
:
    public propertyOf<scalar>
{
    const arena* parcels_ = nullptr;

public:

    twinOfRadius(): propertyOf<scalar>("twin") { lend(); }

    void of(const arena& parcels) { parcels_ = &parcels; }

    virtual void freshen(const label i, const dictionary&)
    {
        (*this)[i] = parcels_->spheres[i].r;
    }

    virtual void assume(const label i, const dictionary& dict)
    {
        freshen(i, dict);
    }
};


class tagged
:
    public exchange
{
    propertyOf<scalar> tag_;
    propertyOf<vector> spot_;
    propertyOf<label> mark_;
    twinOfRadius twin_;

    label nGuests_ = 0;
    label nWrong_ = 0;

    label nSteps_ = 0;

public:

    TypeName("tagged");

    tagged(const dictionary&, const fvMesh&)
    :
        tag_("tag"),
        spot_("spot"),
        mark_("mark")
    {
        tag_.allow(0, 1e6).readFrom("tag");
        spot_.freshAs(vector(1, 2, 3));
        mark_.freshAs(-5).forget();
    }

    virtual void addColumns(arena& parcels)
    {
        parcels.add(tag_);
        parcels.add(spot_);
        parcels.add(mark_);
        parcels.add(twin_);
        twin_.of(parcels);
    }

    virtual void evolve(arena& parcels, const scalar)
    {
        const label n = parcels.size();
        ++nSteps_;

        for (label i = 0; i < parcels.spheres.size(); ++i)
        {
            // Images and walls have none
            const bool has = i < n || twin_[i] != 0;

            nGuests_ += has && i >= n;
            nWrong_ += has && twin_[i] != parcels.spheres[i].r;
        }
    }

    virtual void report(const arena&, Ostream& os) const
    {
        os  << "guests seen: " << returnReduce(nGuests_, sumOp<label>())
            << ", wrong: " << returnReduce(nWrong_, sumOp<label>())
            << ", steps counted: " << nSteps_ << nl;
    }

    virtual void state(dictionary& state) const
    {
        state.add("steps", nSteps_);
    }

    virtual void setState(const dictionary& state)
    {
        state.readIfPresent("steps", nSteps_);
    }
};

defineTypeNameAndDebug(tagged, 0);
addToRunTimeSelectionTable(exchange, tagged, dictionary);

}
}
