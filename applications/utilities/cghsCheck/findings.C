/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "findings.H"
#include "messageStream.H"

const Foam::Enum<Foam::cghs::findings::kind>
Foam::cghs::findings::kindNames
({
    { kind::note, "Note" },
    { kind::warning, "Warning" },
    { kind::error, "Error" }
});


Foam::cghs::findings::findings()
:
    counts_(label(0))
{}


void Foam::cghs::findings::add
(
    const kind k,
    const place& where,
    const string& meaning,
    const string& remedy
)
{
    ++counts_[k];

    Info<< "  " << kindNames[k] << ": " << where.file.c_str() << ", "
        << where.entry.c_str() << ' ' << where.value.c_str() << nl
        << "    " << meaning.c_str() << nl
        << "    Remedy: " << remedy.c_str() << endl;
}
