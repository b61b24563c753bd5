/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "heatBalance.H"
#include "scalarField.H"
#include "PstreamReduceOps.H"

Foam::cghs::heatBalance::heatBalance()
:
    accounts_(),
    stored_(-1),
    storage_(0),
    defect_(0)
{}


Foam::label Foam::cghs::heatBalance::open(const word& name)
{
    accounts_.append(account{name, 0, 0, 0});

    return accounts_.size() - 1;
}


void Foam::cghs::heatBalance::close
(
    const scalar enthalpy,
    const scalar deltaT
)
{
    scalarField sums(accounts_.size() + 1);
    forAll(accounts_, i)
    {
        sums[i] = accounts_[i].now;
    }
    sums.last() = enthalpy;
    reduce(sums, sumOp<scalarField>());

    scalar received = 0;
    forAll(accounts_, i)
    {
        account& a = accounts_[i];

        a.now = 0;
        a.power = sums[i]/deltaT;
        a.total += sums[i];
        received += sums[i];
    }

    const scalar before = stored_ < 0 ? sums.last() - received : stored_;

    stored_ = sums.last();
    storage_ = (stored_ - before)/deltaT;
    defect_ = (stored_ - before - received)/deltaT;
}


Foam::scalar Foam::cghs::heatBalance::relativeDefect() const
{
    return mag(defect_)/max(stored_, VSMALL);
}


void Foam::cghs::heatBalance::report(Ostream& os) const
{
    os  << "        stored " << storage_ << " W";
    for (const account& a : accounts_)
    {
        os  << ", " << a.name << ' ' << a.power << " W";
    }
    os  << nl << "        since the beginning";
    for (const account& a : accounts_)
    {
        os  << (&a == &accounts_[0] ? " " : ", ") << a.name << ' ' << a.total
            << " J";
    }
    os  << "; enthalpy " << stored_ << " J, from nowhere " << defect_ << " W"
        << nl;
}


void Foam::cghs::heatBalance::state(dictionary& state) const
{
    for (const account& a : accounts_)
    {
        state.add(a.name, a.total);
    }
}


void Foam::cghs::heatBalance::setState(const dictionary& state)
{
    for (account& a : accounts_)
    {
        state.readIfPresent(a.name, a.total);
    }
}
