/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "timeMeans.H"
#include "windowReport.H"
#include "SubList.H"
#include "Time.H"

Foam::cghs::timeMeans::timeMeans
(
    functionObjects::stateFunctionObject& owner,
    const objectRegistry& obr,
    const word& table
)
:
    writeFile(obr, owner.name(), table),
    owner_(owner),
    names_(),
    over_(),
    now_(),
    moments_()
{}


void Foam::cghs::timeMeans::start
(
    const wordList& names,
    const dictionary& dict,
    const char* entries,
    const labelList& over
)
{
    read(dict);

    if (names_.size())
    {
        // Asked for again during the run
        keep();
    }

    names_ = names;
    over_ = over.empty() ? labelList(names.size(), -1) : over;
    now_ = scalarField(names.size(), Zero);
    moments_ = List<blockMoments>(names.size(), blockMoments(2));

    resume(dict, entries);
}


Foam::scalar Foam::cghs::timeMeans::value(const label q) const
{
    const scalar under = over_[q] < 0 ? 1 : now_[over_[q]];

    return under != 0 ? now_[q]/under : 0;
}


void Foam::cghs::timeMeans::add(const scalar deltaT)
{
    scalarField sample(2);

    forAll(now_, q)
    {
        sample[0] = deltaT*(over_[q] < 0 ? 1 : now_[over_[q]]);
        sample[1] = deltaT*now_[q];
        moments_[q].add(sample);
    }
}

// * * * * * * * * * * * * * * * * The table * * * * * * * * * * * * * * * * //

Foam::scalar Foam::cghs::timeMeans::window() const
{
    // What a ratio is over is none
    const label q = over_.find(-1);

    return q < 0 ? 0 : moments_[q].nSamples()*moments_[q].mean(0);
}


void Foam::cghs::timeMeans::writeHeader(Ostream& os) const
{
    os  << "# time";
    for (const word& name : names_)
    {
        os  << ' ' << name;
        for
        (
            const char* column
          : {"Mean", "Error", "CorrelationTime", "WindowLongEnough"}
        )
        {
            os  << ' ' << name << column;
        }
    }
    os  << endl;
}


void Foam::cghs::timeMeans::writeRow(Ostream& os, const scalar time) const
{
    windowReport report(window());

    os  << time;
    forAll(now_, q)
    {
        const blockMoments::estimate mean
        (
            moments_[q].judge(moments_[q].ratio(1, 0))
        );
        report.see(names_[q] + "Mean", mean);

        os  << ' ' << value(q) << ' ' << mean.value << ' ' << mean.error
            << ' ' << report.correlationTime(mean)
            << ' ' << label(mean.longEnough);
    }
    os  << endl;

    report.write(owner_.name());
}


void Foam::cghs::timeMeans::write()
{
    if (writeToFile() && window() > 0)
    {
        if (!filePtr_.valid())
        {
            resetFile(fileName_);
            writeHeader(file());
            file().precision(writePrecision_);
        }
        writeRow(file(), owner_.time().value());
    }

    keep();
}

// * * * * * * * * * * * * * * * * Restarts  * * * * * * * * * * * * * * * * //

void Foam::cghs::timeMeans::keep() const
{
    owner_.setProperty("names", names_);
    owner_.setProperty("moments", state());
}


Foam::List<Foam::scalar> Foam::cghs::timeMeans::state() const
{
    return blockMoments::stateOf(moments_);
}


bool Foam::cghs::timeMeans::setState(const UList<scalar>& state)
{
    return blockMoments::setStateOf(moments_, state);
}


void Foam::cghs::timeMeans::resume(const dictionary& dict, const char* entries)
{
    wordList formerNames;
    if (!owner_.getProperty("names", formerNames))
    {
        return;
    }

    List<scalar> state;
    owner_.getProperty("moments", state);

    if (formerNames != names_ || !setState(state))
    {
        FatalIOErrorInFunction(dict)
            << entries << " ask for " << names_ << " but until time "
            << owner_.time().timeName() << " it was " << formerNames << nl
            << "Ask for the same, or rename the function object to start"
            << " anew" << nl
            << exit(FatalIOError);
    }
}
