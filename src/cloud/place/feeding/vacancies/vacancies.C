/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "vacancies.H"
#include "periodicShifts.H"
#include "PstreamReduceOps.H"

Foam::cghs::vacancies::vacancies
(
    const arena& parcels,
    contactStage& contacts,
    const UList<vector>& periods
)
:
    parcels_(parcels),
    contacts_(contacts),
    shifts_(periodicShifts(periods, false))
{
    shifts_.append(vector(Zero));
}


Foam::DynamicList<Foam::cghs::sphere> Foam::cghs::vacancies::neighbours
(
    const boundBox& box
) const
{
    DynamicList<sphere> found;

    for (const vector& shift : shifts_)
    {
        for (label i = 0; i < parcels_.size(); ++i)
        {
            sphere s(parcels_.spheres[i]);
            s.x += shift;
            const vector reach(vector::uniform(s.r));

            if (box.overlaps(boundBox(s.x - reach, s.x + reach)))
            {
                found.append(s);
            }
        }
    }

    return found;
}


Foam::labelField Foam::cghs::vacancies::owners
(
    const UList<suggestion>& suggestions,
    const boundBox& box
)
{
    // The least that a rank says counts: -1 if it is taken there, the rank that
    // has the place, or nobody
    constexpr label taken = -1;
    constexpr label nobody = labelMax;

    const DynamicList<sphere> others(neighbours(box));
    labelField owner(suggestions.size(), nobody);

    forAll(suggestions, k)
    {
        const suggestion& it = suggestions[k];

        if (it.cell != -1)
        {
            owner[k] =
                contacts_.touchesWall(it.s) ? taken : Pstream::myProcNo();
        }

        for (label j = 0; owner[k] != taken && j < others.size(); ++j)
        {
            if
            (
                overlaps(it.s, others[j])
             && !contacts_.wallBetween(it.s.x, others[j].x)
            )
            {
                owner[k] = taken;
            }
        }
    }

    reduce(owner, minOp<labelField>());

    for (label& o : owner)
    {
        o = o == nobody ? -1 : o;
    }
    return owner;
}


bool Foam::cghs::vacancies::freeOfAccepted(const sphere& s)
{
    for (const vector& shift : shifts_)
    {
        for (const sphere& other : accepted_)
        {
            if
            (
                overlaps(sphere(s.x + shift, s.r), other)
             && !contacts_.wallBetween(s.x + shift, other.x)
            )
            {
                return false;
            }
        }
    }

    return true;
}
