/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "timeMeans.H"
#include "Time.H"

Foam::cghs::timeMeans::timeMeans(const wordList& names)
:
    names_(names),
    now_(names.size(), Zero),
    moments_(1 + names.size())
{}


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

void Foam::cghs::timeMeans::writeHead(Ostream& os) const
{
    os  << "# time";
    for (const word& name : names_)
    {
        os  << ' ' << name << ' ' << name << "Mean " << name << "Error";
    }
    os  << endl;
}


void Foam::cghs::timeMeans::writeRow(Ostream& os, const scalar time) const
{
    os  << time;
    forAll(now_, q)
    {
        const blockMoments::estimate mean(moments_.ratio(1 + q, 0));
        os  << ' ' << now_[q] << ' ' << mean.value << ' ' << mean.error;
    }
    os  << endl;
}

// * * * * * * * * * * * * * * * * Restarts  * * * * * * * * * * * * * * * * //

void Foam::cghs::timeMeans::keep
(
    functionObjects::stateFunctionObject& object
) const
{
    object.setProperty("names", names_);
    object.setProperty("moments", moments_.state());
}


void Foam::cghs::timeMeans::resume
(
    functionObjects::stateFunctionObject& object,
    const dictionary& dict,
    const char* entries
)
{
    wordList formerNames;
    if (!object.getProperty("names", formerNames))
    {
        return;
    }

    List<scalar> state;
    object.getProperty("moments", state);

    if (formerNames != names_ || !moments_.setState(state))
    {
        FatalIOErrorInFunction(dict)
            << entries << " ask for " << names_ << " but until time "
            << object.time().timeName() << " it was " << formerNames << nl
            << "Ask for the same, or rename the function object to start"
            << " anew" << nl
            << exit(FatalIOError);
    }
}
