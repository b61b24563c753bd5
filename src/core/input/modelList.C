/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "modelList.H"
#include "Ostream.H"

#include <algorithm>
#include <map>

namespace Foam
{
namespace cghs
{

//- By family and model. Made when the first line asks for it, whatever the
//  order in which libraries start
static std::map<std::string, std::map<std::string, std::string>>& lines()
{
    static std::map<std::string, std::map<std::string, std::string>> all;

    return all;
}


static void writeLine
(
    Ostream& os,
    const std::string& model,
    const std::size_t width,
    const std::string& line
)
{
    const std::size_t gap = width - model.size() + 2;

    os  << "    " << model.c_str() << std::string(gap, ' ').c_str()
        << line.c_str() << nl;
}

} // End namespace cghs
} // End namespace Foam


Foam::cghs::modelLine::modelLine
(
    const std::string& family,
    const std::string& model,
    const std::string& line
)
{
    lines()[family][model] = line;
}


void Foam::cghs::listModels(Ostream& os)
{
    for (const auto& family : lines())
    {
        std::size_t width = 0;
        for (const auto& model : family.second)
        {
            width = std::max(width, model.first.size());
        }

        const auto itself = family.second.find("");

        os  << nl << family.first.c_str();
        if (itself != family.second.end())
        {
            os  << ": " << itself->second.c_str();
        }
        os  << nl;

        for (const auto& model : family.second)
        {
            if (!model.first.empty())
            {
                writeLine(os, model.first, width, model.second);
            }
        }
    }
    os  << nl << "Each stands in its header in src/, with formula, units, source"
        << " and an example" << nl << endl;
}
