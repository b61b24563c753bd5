/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    A model of a test's own, to which contacts are lent: parcels that touch pass
    on a share of the difference of what they hold, and count what they touch.

\*---------------------------------------------------------------------------*/

#include "exchange.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{

class conducting
:
    public exchange
{
    //- Share of the difference that goes over in a second [1/s]
    const scalar rate_;

    propertyOf<scalar> held_;
    propertyOf<scalar> gained_;
    propertyOf<label> touched_;

public:

    TypeName("conducting");

    conducting(const dictionary& dict, const fvMesh&)
    :
        rate_(dict.get<scalar>("rate")),
        held_("held"),
        gained_("gained"),
        touched_("touched")
    {
        held_.lend();
        gained_.lend().hide();
        touched_.lend();

        lookAtContacts
        (
            List<property*>({&held_}),
            List<property*>({&gained_, &touched_})
        );
    }

    virtual void addColumns(arena& parcels)
    {
        parcels.add(held_);
        parcels.add(gained_);
        parcels.add(touched_);
    }

    virtual void touch(const contactList& list, arena&, const scalar deltaT)
    {
        for (const contact& c : list.contacts)
        {
            if (!c.atWall())
            {
                const scalar q = rate_*deltaT*(held_[c.b] - held_[c.a]);

                gained_[c.a] += q;
                gained_[c.b] -= q;
                ++touched_[c.a];
                ++touched_[c.b];
            }
        }
    }

    virtual void evolve(arena& parcels, const scalar)
    {
        for (label i = 0; i < parcels.size(); ++i)
        {
            held_[i] += gained_[i];
            gained_[i] = 0;
        }
    }
};

defineTypeNameAndDebug(conducting, 0);
addToRunTimeSelectionTable(exchange, conducting, dictionary);

}
}
