/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "flowRange.H"
#include "messageStream.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"

bool Foam::cghs::askedFlows::warn
(
    const string& law,
    const char* quantity,
    const scalarMinMax& asked,
    const scalarMinMax& limits,
    bool& warned
)
{
    // A mean over cells may round to more than 1
    constexpr scalar roundOff = 1e-12;

    const bool below = asked.min() < limits.min();
    const bool above = asked.max() > (1 + roundOff)*limits.max();
    const bool tell = !warned && (below || above);

    if (tell)
    {
        WarningInFunction
            << law.c_str() << " was asked at " << quantity << ' '
            << (below ? asked.min() : asked.max()) << " but is made for "
            << limits.min() << " to " << limits.max() << '.' << nl
            << "    It is extrapolated; this is said once" << nl << endl;
    }
    warned = warned || tell;

    return tell;
}


bool Foam::cghs::askedFlows::warn
(
    const string& law,
    const flowRange& limits
)
{
    flowRange all(asked_);

    reduce(all.voidage, minMaxOp<scalar>());
    reduce(all.Re, minMaxOp<scalar>());

    if (!all.Re.valid())
    {
        return false;
    }

    const bool ofVoidage =
        warn(law, "voidage", all.voidage, limits.voidage, warnedOfVoidage_);

    return warn(law, "Re", all.Re, limits.Re, warnedOfRe_) || ofVoidage;
}
