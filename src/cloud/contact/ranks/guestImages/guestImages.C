/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "guestImages.H"
#include "rankBoxes.H"
#include "periodicShifts.H"

void Foam::cghs::guestImages::add
(
    arena& parcels,
    const boundBox& box,
    const scalar reach
)
{
    images_.clear();

    if (periods_.empty() || box.empty())
    {
        first_ = parcels.spheres.size();
        return;
    }

    // A pair of own parcels would be met from both its sides: half of the
    // shifts will do. A borrowed guest is seen from this side only
    const List<vector> ownShifts(periodicShifts(periods_, true));
    const List<vector> guestShifts(periodicShifts(periods_, false));

    forAll(parcels.spheres, i)
    {
        const sphere& body = parcels.spheres[i];
        const boundBox near(widened(box, body.r + reach));

        for (const vector& s : i < parcels.size() ? ownShifts : guestShifts)
        {
            if (near.contains(body.x + s))
            {
                images_.append(image{i, s});
            }
        }
    }

    first_ = parcels.addGuests(images_.size());
    place(parcels);
}


void Foam::cghs::guestImages::place(arena& parcels) const
{
    forAll(images_, k)
    {
        const sphere& s = parcels.spheres[images_[k].body];

        parcels.spheres[first_ + k] = sphere(s.x + images_[k].shift, s.r);
    }
}
