/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "solidsPassage.H"
#include "parcelNumber.H"
#include "PstreamReduceOps.H"

Foam::cghs::solidsPassage::solidsPassage(const wordList& fractions)
:
    fractions_(fractions),
    in_(fractions.size(), Zero),
    out_(fractions.size(), Zero)
{}


void Foam::cghs::solidsPassage::add
(
    scalarField& sums,
    const arena& parcels,
    const label i
) const
{
    forAll(fractions_, s)
    {
        const parcelNumber Y(fractions_[s], parcels);

        sums[s] += parcels.motions[i].mass()*Y(i);
    }
}


Foam::scalarField Foam::cghs::solidsPassage::content
(
    const arena& parcels
) const
{
    scalarField sums(fractions_.size(), Zero);

    forAll(fractions_, s)
    {
        const parcelNumber Y(fractions_[s], parcels);

        for (label i = 0; i < parcels.size(); ++i)
        {
            sums[s] += parcels.motions[i].mass()*Y(i);
        }
    }

    return sums;
}


//- The sums of all ranks, which begin anew
static Foam::scalarField take(Foam::scalarField& sums)
{
    Foam::scalarField all(sums);
    Foam::reduce(all, Foam::sumOp<Foam::scalarField>());
    sums = Foam::Zero;

    return all;
}


Foam::scalarField Foam::cghs::solidsPassage::takeIn()
{
    return take(in_);
}


Foam::scalarField Foam::cghs::solidsPassage::takeOut()
{
    return take(out_);
}
