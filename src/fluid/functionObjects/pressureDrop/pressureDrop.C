/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "pressureDrop.H"
#include "knownEntries.H"
#include "volFields.H"
#include "PstreamReduceOps.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(pressureDrop, 0);
    addToRunTimeSelectionTable(functionObject, pressureDrop, dictionary);
    describeFunction(pressureDrop, "between taps, with error bars");
}
}

// * * * * * * * * * * * * * * * Construction  * * * * * * * * * * * * * * * //

Foam::cghs::pressureDrop::pressureDrop
(
    const word& name,
    const Time& time,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, time, dict),
    taps_(),
    cells_(),
    means_(*this, mesh_, typeName)
{
    read(dict);
}


bool Foam::cghs::pressureDrop::read(const dictionary& dict)
{
    warnUnknownOfFunction(dict, wordList({"pairs"}));

    fvMeshFunctionObject::read(dict);

    const dictionary& pairs = dict.subDict("pairs");

    findPairs(pairs);
    means_.start(pairs.toc(), dict, "Entries of pairs");
    checkFormerTaps(pairs);

    return true;
}


void Foam::cghs::pressureDrop::findPairs(const dictionary& pairs)
{
    const wordList names(pairs.toc());

    taps_.resize(names.size());
    cells_.resize(names.size());

    forAll(names, i)
    {
        taps_[i] = pairs.get<Pair<point>>(names[i]);

        forAll(taps_[i], side)
        {
            cells_[i][side] = cellOf(names[i], taps_[i][side], pairs);
        }
    }
}


Foam::label Foam::cghs::pressureDrop::cellOf
(
    const word& pair,
    const point& tap,
    const dictionary& pairs
) const
{
    const label celli = mesh_.findCell(tap);
    const label nobody = Pstream::nProcs();
    const label owner =
        returnReduce
        (
            celli < 0 ? nobody : Pstream::myProcNo(),
            minOp<label>()
        );

    if (owner == nobody)
    {
        FatalIOErrorInFunction(pairs)
            << "Entry " << pair << ": the tap " << tap
            << " is outside the mesh" << nl
            << "Valid are points within " << mesh_.bounds() << nl
            << exit(FatalIOError);
    }

    return owner == Pstream::myProcNo() ? celli : -1;
}


void Foam::cghs::pressureDrop::checkFormerTaps(const dictionary& pairs) const
{
    List<Pair<point>> former(taps_);
    getProperty("taps", former);

    // They were written with the digits of the case
    const scalar rounding = 1e-5*mesh_.bounds().mag();

    forAll(taps_, i)
    {
        forAll(taps_[i], side)
        {
            if (mag(former[i][side] - taps_[i][side]) > rounding)
            {
                FatalIOErrorInFunction(pairs)
                    << "Entry " << means_.names()[i] << " is " << taps_[i]
                    << " but until time " << mesh_.time().timeName()
                    << " it was " << former[i] << nl
                    << "Leave it, or rename the function object to start anew"
                    << nl << exit(FatalIOError);
            }
        }
    }
}

// * * * * * * * * * * * * * * * * The drops * * * * * * * * * * * * * * * * //

Foam::scalar Foam::cghs::pressureDrop::pressure(const label celli) const
{
    if (celli < 0)
    {
        return 0;
    }

    const volScalarField& p = mesh_.lookupObject<volScalarField>("p");

    return
        p.dimensions() == dimPressure
      ? p[celli]
      : p[celli]*mesh_.lookupObject<volScalarField>("rho")[celli];
}


bool Foam::cghs::pressureDrop::execute()
{
    scalarField& drop = means_.now();

    forAll(drop, i)
    {
        drop[i] = pressure(cells_[i].first()) - pressure(cells_[i].second());
    }
    reduce(drop, sumOp<scalarField>());

    means_.add(mesh_.time().deltaTValue());

    return true;
}


bool Foam::cghs::pressureDrop::write()
{
    means_.write();
    setProperty("taps", taps_);

    return true;
}
