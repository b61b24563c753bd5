/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "rankWire.H"
#include "UIPstream.H"
#include "UOPstream.H"

void Foam::cghs::rankWire::send(const label rank) const
{
    if (buffer_.size())
    {
        UOPstream::write
        (
            Pstream::commsTypes::scheduled,
            rank,
            reinterpret_cast<const char*>(buffer_.cdata()),
            buffer_.byteSize()
        );
    }
}


const Foam::scalar* Foam::cghs::rankWire::receive
(
    const label rank,
    const label n
)
{
    buffer_.resize(n);

    if (n)
    {
        UIPstream::read
        (
            Pstream::commsTypes::scheduled,
            rank,
            reinterpret_cast<char*>(buffer_.data()),
            buffer_.byteSize()
        );
    }

    return buffer_.cdata();
}
