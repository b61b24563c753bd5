/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "drivingUnit.H"
#include "string.H"

namespace Foam
{
namespace cghs
{

struct namedUnit
{
    const char* name;
    bool pressure;
    scalar size;
};

static const namedUnit units[] =
{
    {"Pa", true, 1},
    {"kPa", true, 1e3},
    {"bar", true, 1e5},
    {"atm", true, 101325},
    {"mol/m3", false, 1},
    {"kmol/m3", false, 1e3},
    {"mol/L", false, 1e3}
};

} // End namespace cghs
} // End namespace Foam


Foam::cghs::drivingUnit::drivingUnit(const dictionary& dict)
:
    pressure_(false),
    size_(0)
{
    if (!dict.found("driving"))
    {
        FatalIOErrorInFunction(dict)
            << "There is no entry driving: the unit in which the rate takes"
            << " pressures or concentrations of the fluid" << nl
            << "Valid choices: Pa kPa bar atm \"mol/m3\" \"kmol/m3\" \"mol/L\""
            << nl << exit(FatalIOError);
    }

    const token t(dict.lookup("driving"));
    const string name
    (
        t.isWord() ? string(t.wordToken())
      : t.isString() ? t.stringToken()
      : string()
    );
    for (const namedUnit& unit : units)
    {
        if (name == unit.name)
        {
            pressure_ = unit.pressure;
            size_ = unit.size;
        }
    }

    if (size_ == 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry driving is " << t << ", an unknown unit" << nl
            << "Valid choices: Pa kPa bar atm \"mol/m3\" \"kmol/m3\" \"mol/L\""
            << nl << exit(FatalIOError);
    }
}
