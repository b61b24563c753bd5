/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "EMMS.H"
#include "sphereDrag.H"
#include "checkedEntry.H"
#include "knownEntries.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(EMMS, 0);
    addToRunTimeSelectionTable(dragModel, EMMS, dictionary);
    addToRunTimeSelectionTable(dragModel, EMMS, published);
    describeModel
    (
        dragModel,
        EMMS,
        "Wen and Yu, less what clusters take off: coarse cells"
    );
}
}


void Foam::cghs::EMMS::checkBase
(
    const dictionary& dict,
    const word& branch,
    const FixedList<scalar, 3>& coeffs,
    const scalar low,
    const scalar high
)
{
    const scalar atLow = coeffs[0] + coeffs[1]*low;
    const scalar atHigh = coeffs[0] + coeffs[1]*high;

    if (!(min(atLow, atHigh) > 0))
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << branch << " is " << coeffs << nl
            << "Its first number plus voidage times its second is " << atLow
            << " at voidage " << low << " and " << atHigh << " at " << high
            << nl << "Both must be greater than zero, as a power is taken" << nl
            << exit(FatalIOError);
    }
}


Foam::cghs::EMMS::EMMS()
:
    dense_({0.1443, 1.6864, 0.4064, 20.4805}),
    denseEnd_(0.4924),
    middle_({-0.0999, 0.9586, 1.8008}),
    middleEnd_(0.9505),
    dilute_({1649.4591, -1648.5453, -0.08597})
{}


Foam::cghs::EMMS::EMMS(const dictionary& dict)
:
    dense_(dict.get<FixedList<scalar, 4>>("dense")),
    denseEnd_(scalarInRange(dict, "denseEnd", 0, 1)),
    middle_(dict.get<FixedList<scalar, 3>>("middle")),
    middleEnd_(scalarInRange(dict, "middleEnd", denseEnd_, 1)),
    dilute_(dict.get<FixedList<scalar, 3>>("dilute"))
{
    warnUnknownEntries
    (
        dict,
        wordList({"dense", "denseEnd", "middle", "middleEnd", "dilute"})
    );

    if (!(dense_[2] > 0))
    {
        FatalIOErrorInFunction(dict)
            << "Entry dense is " << dense_ << nl
            << "Its third number divides the voidage and must be greater than"
            << " zero" << nl
            << exit(FatalIOError);
    }

    checkBase(dict, "middle", middle_, denseEnd_, middleEnd_);
    checkBase(dict, "dilute", dilute_, middleEnd_, 1);
}


Foam::scalar Foam::cghs::EMMS::H(const scalar e) const
{
    if (e <= denseEnd_)
    {
        const scalar bend = pow(e/dense_[2], dense_[3]);

        return min(dense_[0] + dense_[1]/(1 + bend), scalar(1));
    }

    // Rounding may bring a voidage above 1
    const FixedList<scalar, 3>& c = e <= middleEnd_ ? middle_ : dilute_;

    return min(pow(c[0] + c[1]*min(e, scalar(1)), c[2]), scalar(1));
}


Foam::scalar Foam::cghs::EMMS::D(const slipFlow& f) const
{
    return wenYuD(f)*H(f.e);
}
