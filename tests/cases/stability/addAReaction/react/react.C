/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    One mol of the first species at 500 K and 1 bar with a gram of catalyst:

        reactOnce REACTIONS THERMOPHYSICS SECONDS [LIBRARY]

    prints the moles of all species in the end.

\*---------------------------------------------------------------------------*/

#include "reactingCell.H"
#include "dlLibraryTable.H"
#include "IFstream.H"

using namespace Foam;
using namespace Foam::cghs;


static dictionary read(const char* name)
{
    IFstream is{fileName(name)};
    return dictionary(is);
}


int main(int argc, char* argv[])
{
    // As libs of a controlDict does
    dlLibraryTable libs;
    if (argc > 4)
    {
        libs.open(fileName(argv[4]));
    }

    const reactionScheme scheme(read(argv[1]), read(argv[2]), false);
    reactingCell cell(scheme, {1e-6, 1e-12});

    scalarField gas(scheme.fluid().size(), 0);
    gas[0] = 1;
    cell.start(gas, 500, 1e5);
    cell.add({1, 1e-3, 500, 0, 0, 0}, scalarField(1, 1e-3/0.06));

    scalar h = 1e-3;
    if (!cell.react(readScalar(argv[3]), h))
    {
        return 1;
    }
    for (const scalar n : cell.fluidState())
    {
        printf("%.15g\n", n);
    }
    return 0;
}
