/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "page.H"
#include "messageStream.H"

namespace Foam
{
namespace cghs
{

//- As wide as the longest of most
constexpr std::size_t nameWidth = 38;
constexpr std::size_t cellWidth = 13;

static string padded(const string& text, const std::size_t width)
{
    return
        text.size() < width
      ? string(text + std::string(width - text.size(), ' '))
      : string(text + ' ');
}

} // End namespace cghs
} // End namespace Foam


void Foam::cghs::page::title(const string& text)
{
    Info<< nl << text.c_str() << nl
        << std::string(text.size(), '-').c_str() << endl;
}


void Foam::cghs::page::line(const string& what, const string& value)
{
    Info<< "    " << padded(what, nameWidth).c_str() << value.c_str() << endl;
}


void Foam::cghs::page::head(const UList<string>& columns)
{
    row("", columns);
}


void Foam::cghs::page::row(const string& name, const UList<string>& cells)
{
    Info<< "    " << padded(name, nameWidth/3).c_str();
    for (const string& cell : cells)
    {
        Info<< padded(cell, cellWidth).c_str();
    }
    Info<< endl;
}
