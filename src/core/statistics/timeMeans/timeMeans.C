/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "timeMeans.H"
#include "windowReport.H"
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
    now_(),
    moments_(1)
{}


void Foam::cghs::timeMeans::start
(
    const wordList& names,
    const dictionary& dict,
    const char* entries
)
{
    read(dict);

    if (names_.size())
    {
        // Asked for again during the run
        keep();
    }

    names_ = names;
    now_ = scalarField(names.size(), Zero);
    moments_ = blockMoments(1 + names.size());

    resume(dict, entries);
}


void Foam::cghs::timeMeans::add(const scalar deltaT)
{
    scalarField sample(1 + now_.size(), deltaT);

    forAll(now_, q)
    {
        sample[1 + q] = deltaT*now_[q];
    }
    moments_.add(sample);
}

// * * * * * * * * * * * * * * * * The table * * * * * * * * * * * * * * * * //

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
    windowReport report(moments_.nSamples()*moments_.mean(0));

    os  << time;
    forAll(now_, q)
    {
        const blockMoments::estimate mean
        (
            moments_.judge(moments_.ratio(1 + q, 0))
        );
        report.see(names_[q] + "Mean", mean);

        os  << ' ' << now_[q] << ' ' << mean.value << ' ' << mean.error
            << ' ' << report.correlationTime(mean)
            << ' ' << label(mean.longEnough);
    }
    os  << endl;

    report.write(owner_.name());
}


void Foam::cghs::timeMeans::write()
{
    if (writeToFile() && moments_.nSamples() > 0)
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
    owner_.setProperty("moments", moments_.state());
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

    if (formerNames != names_ || !moments_.setState(state))
    {
        FatalIOErrorInFunction(dict)
            << entries << " ask for " << names_ << " but until time "
            << owner_.time().timeName() << " it was " << formerNames << nl
            << "Ask for the same, or rename the function object to start"
            << " anew" << nl
            << exit(FatalIOError);
    }
}
