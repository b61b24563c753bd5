/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "exchangeHistory.H"
#include "cghsCloud.H"
#include "exchange.H"
#include "knownEntries.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(exchangeHistory, 0);
    addToRunTimeSelectionTable(functionObject, exchangeHistory, dictionary);
    describeFunction(exchangeHistory, "the figures of an exchange over time");
}
}


Foam::cghs::exchangeHistory::exchangeHistory
(
    const word& name,
    const Time& time,
    const dictionary& dict
)
:
    cloudFunctionObject(name, time, dict),
    exchange_(nullptr),
    means_(*this, mesh_, typeName)
{
    read(dict);
}


const Foam::cghs::exchange& Foam::cghs::exchangeHistory::find
(
    const word& name,
    const dictionary& dict
) const
{
    DynamicList<word> valid;

    for (const exchange& e : theCloud().exchanges())
    {
        if (e.figures().size())
        {
            if (e.type() == name)
            {
                return e;
            }
            valid.append(e.type());
        }
    }

    FatalIOErrorInFunction(dict)
        << "Entry exchange: the cloud has no exchange " << name
        << " that reports figures" << nl
        << "Valid choices: " << valid << nl
        << "The exchanges of a cloud are listed in exchanges of subModels in"
        << " its properties" << nl
        << exit(FatalIOError);

    return theCloud().exchanges()[0];
}


bool Foam::cghs::exchangeHistory::read(const dictionary& dict)
{
    warnUnknownOfFunction(dict, wordList({"cloud", "exchange"}));

    cloudFunctionObject::read(dict);
    exchange_ = &find(dict.get<word>("exchange"), dict);

    const List<figure> figures(exchange_->figures());
    wordList names(figures.size());

    forAll(names, i)
    {
        names[i] = figures[i].name;
    }
    means_.start(names, dict, "Entry exchange");

    return true;
}


bool Foam::cghs::exchangeHistory::execute()
{
    const List<figure> figures(exchange_->figures());

    forAll(figures, i)
    {
        means_.now()[i] = figures[i].value;
    }
    means_.add(mesh_.time().deltaTValue());

    return true;
}


bool Foam::cghs::exchangeHistory::write()
{
    means_.write();

    return true;
}
