/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "slowClock.H"
#include "checkedEntry.H"
#include "cloudProperties.H"
#include "knownEntries.H"

Foam::cghs::slowClock::slowClock(const dictionary& cloudProperties)
:
    dict_
    (
        cloudProperties.subOrEmptyDict("solution").subOrEmptyDict("slowClock")
    ),
    factor_(runs() ? scalarInRange(dict_, "factor", 1, 1e6) : 1),
    from_(dict_.getOrDefault<scalar>("from", 0))
{
    checkRange(dict_, "from", from_, scalar(0), GREAT);
    warnUnknownEntries
    (
        dict_,
        wordList({"factor", "from", "reactions", "exposure"})
    );

    if (runs() && transportedQuantitiesOf(cloudProperties).found("energy"))
    {
        FatalIOErrorInFunction(dict_)
            << "There is a slowClock with factor " << factor_
            << ", but the fluid transports energy: solids that are fed so many"
            << " times as fast would heat or cool it as many times as much"
            << nl
            << "Take energy out of transported, or take out slowClock" << nl
            << exit(FatalIOError);
    }
}


Foam::wordList Foam::cghs::slowClock::reactions() const
{
    return dict_.getOrDefault("reactions", wordList());
}


void Foam::cghs::slowClock::report(const scalar time, Ostream& os) const
{
    if (runs())
    {
        os  << "slowClock: " << at(time) << " s, " << factor_
            << " times as fast as the flow from " << from_ << " s on" << nl;
    }
}
