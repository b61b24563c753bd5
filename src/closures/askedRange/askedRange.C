/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "askedRange.H"
#include "messageStream.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"

bool Foam::cghs::askedRange::warn
(
    const string& law,
    const string& quantity,
    const scalarMinMax& limits
)
{
    // A mean over cells may round to more than 1
    constexpr scalar roundOff = 1e-12;

    if (warned_)
    {
        return false;
    }

    const scalarMinMax all(returnReduce(asked_, minMaxOp<scalar>()));
    const bool below = all.valid() && all.min() < limits.min();
    const bool above = all.valid() && all.max() > (1 + roundOff)*limits.max();
    warned_ = below || above;

    if (warned_)
    {
        WarningInFunction
            << law.c_str() << " was asked at " << quantity.c_str() << ' '
            << (below ? all.min() : all.max()) << " but is made for "
            << limits.min() << " to " << limits.max() << '.' << nl
            << "    It is extrapolated; this is said once" << nl << endl;
    }

    return warned_;
}
