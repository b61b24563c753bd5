/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "Igci.H"
#include "sphereDrag.H"
#include "checkedEntry.H"
#include "knownEntries.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(Igci, 0);
    addToRunTimeSelectionTable(dragModel, Igci, dictionary);
    describeModel
    (
        dragModel,
        Igci,
        "Igci et al. 2012: Wen and Yu, filtered over the size of cells"
    );
}
}

namespace Foam
{
namespace cghs
{

static scalar shareOfFilter(const dictionary& dict)
{
    const scalar F =
        positiveScalar(dict, "gravity")*positiveScalar(dict, "filterSize")
       /sqr(positiveScalar(dict, "terminalVelocity"));

    return 1/(1 + 0.4*pow(F, -1.6));
}


//- What the widest filter takes off in a dense suspension [-]
static scalar h(const scalar phi)
{
    if (phi < 0.0012)
    {
        return 2.7*pow(phi, 0.234);
    }
    else if (phi < 0.014)
    {
        return 0.963 - 0.019*pow(phi, -0.455);
    }
    else if (phi < 0.25)
    {
        return 0.868*exp(-0.38*phi) - 0.176*exp(-119.2*phi);
    }
    else if (phi < 0.455)
    {
        return 0.852*exp(-0.268*phi) - 4.59e-5*exp(19.75*phi);
    }
    else if (phi <= 0.59)
    {
        return (phi - 0.59)*(((-1501*phi + 2203)*phi - 1054)*phi + 162);
    }

    return 0;
}


//- What is left of it in three dimensions where it is dilute [-]
static scalar g(const scalar phi)
{
    return phi < 0.18 ? pow(phi, 0.24)*(1.48 + exp(-18*phi)) : 1;
}

} // End namespace cghs
} // End namespace Foam


Foam::cghs::Igci::Igci(const dictionary& dict)
:
    filterShare_(shareOfFilter(dict))
{
    warnUnknownEntries
    (
        dict,
        wordList({"gravity", "filterSize", "terminalVelocity"})
    );
}


Foam::scalar Foam::cghs::Igci::D(const slipFlow& f) const
{
    const scalar phi = solidsFraction(f.e);

    return wenYuD(f)*(1 - filterShare_*h(phi)*g(phi));
}
