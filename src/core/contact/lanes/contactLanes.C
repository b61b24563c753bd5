/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "contactLanes.H"

bool Foam::cghs::contactLanes::abreast
(
    const contactBlock& block,
    const bool (&wall)[laneCount]
)
{
    // Walls do not move: any number of contacts may have them in common
    label body[2*laneCount];

    for (label l = 0; l < laneCount; ++l)
    {
        body[l] = block.a[l];
        body[laneCount + l] = wall[l] ? -1 - l : block.b[l];
    }

    // Mostly the strands are far apart
    bool rising = true;

    for (label l = 1; l < laneCount; ++l)
    {
        rising =
            rising
         && max(body[l - 1], body[laneCount + l - 1]) < body[l]
         && (wall[l] || body[l] < body[laneCount + l]);
    }

    if (rising)
    {
        return true;
    }

    for (label i = 1; i < 2*laneCount; ++i)
    {
        for (label j = 0; j < i; ++j)
        {
            if (body[i] == body[j])
            {
                return false;
            }
        }
    }

    return true;
}


void Foam::cghs::contactLanes::resize(const label nContacts)
{
    length_ = nContacts/laneCount;
    blocks_.resize((nContacts + laneCount - 1)/laneCount);

    forAll(blocks_, k)
    {
        blocks_[k].size = laneCount;
    }

    const label rest = nContacts - laneCount*length_;

    if (rest)
    {
        blocks_.last().size = rest;
    }
}


void Foam::cghs::contactLanes::arrange
(
    const label blocki,
    const UList<contact>& contacts
)
{
    contactBlock& block = blocks_[blocki];
    bool wall[laneCount];

    for (label l = 0; l < block.size; ++l)
    {
        const contact& c = contacts[contactOf(blocki, l)];

        block.a[l] = c.a;
        block.b[l] = c.b;
        block.n[0][l] = c.n.x();
        block.n[1][l] = c.n.y();
        block.n[2][l] = c.n.z();
        block.overlap[l] = c.overlap;
        wall[l] = c.atWall();
    }

    block.abreast = block.size == laneCount && abreast(block, wall);
}


void Foam::cghs::contactLanes::arrange(const UList<contact>& contacts)
{
    resize(contacts.size());

    forAll(blocks_, k)
    {
        arrange(k, contacts);
    }
}
