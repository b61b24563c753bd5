/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    What reactions of a cell's gas and its parcels cost: spent and regenerated
    cracking catalyst in a regenerator, and the same by OpenFOAM's seulex.

\*---------------------------------------------------------------------------*/

#include "reactingCell.H"
#include "Gunn.H"
#include "regeneratorScheme.H"
#include "denseArrow.H"
#include "drivingUnit.H"
#include "ODESolver.H"
#include "IStringStream.H"
#include "Random.H"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <vector>

using namespace Foam;
using namespace Foam::cghs;


const scalar deltaT = 1e-3;
const scalar p = 1.4e5;
const scalar pi = 3.14159265358979;

// Parcels of 48 mm
const scalar d = 60e-6;
const scalar W = 5.1e8;
const scalar density = 1500;
const scalar solidsFraction = 0.3;

const reactingCell::tolerances tolerated = {1e-3, 1e-8};


scalar cpuTime()
{
    timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return now.tv_sec + 1e-9*now.tv_nsec;
}


dictionary dictionaryOf(const char* text)
{
    IStringStream is(text);
    return dictionary(is);
}


// Mole fractions of O2 CO2 CO H2O N2
const scalarField flueGas(List<scalar>({0.06, 0.12, 0.01, 0.05, 0.76}));
const scalarField air(List<scalar>({0.21, 0, 0, 0, 0.79}));


//- A cell on its own, from step to step
class bedCell
{
    const reactionScheme& scheme_;

    scalarField gas_;
    scalar T_;

    std::vector<reactingCell::body> bodies_;
    std::vector<scalarField> amounts_;


public:

    reactingCell cell;

    //- The step to begin with
    scalar h;

    bedCell
    (
        const reactionScheme& scheme,
        const label n,
        const scalar conductance
    )
    :
        scheme_(scheme),
        gas_(),
        T_(905),
        cell(scheme, tolerated),
        h(1e-5)
    {
        Random random(n);
        const scalar V = n*W*pi/6*pow3(d)*(1/solidsFraction - 1);
        gas_ = flueGas*(p*V/(molarR*T_));

        for (label i = 0; i < n; ++i)
        {
            // A tenth of it has come in just now
            const bool spent = i % 10 == 0;
            const scalar m = W*density*pi/6*pow3(d);
            reactingCell::body b;
            b.W = W;
            b.d = d;
            b.T = spent ? 780 : 912 + 5*(random.sample01<scalar>() - 0.5);
            b.conductance = conductance;
            b.film = 1;
            bodies_.push_back(b);
            const scalar coke = spent ? 0.0095 : 0.0039;
            amounts_.push_back
            (
                scalarField
                (
                    List<scalar>({0.92*coke*m/0.012, 0.08*coke*m/0.001, m/0.06})
                )
            );
        }
    }

    //- A twentieth of the gas is replaced by air, colder by 20 K
    void ventilate()
    {
        const scalar share = 0.05;
        gas_ = (1 - share)*gas_ + share*sum(gas_)*air;
        T_ -= 20*share;
    }

    //- Have all in the cell
    void enter()
    {
        cell.start(gas_, T_, p);
        for (std::size_t i = 0; i < bodies_.size(); ++i)
        {
            cell.add(bodies_[i], amounts_[i]);
        }
    }

    void leave()
    {
        gas_ = SubList<scalar>(cell.fluidState(), gas_.size());
        T_ = cell.fluidTemperature();
        for (std::size_t i = 0; i < bodies_.size(); ++i)
        {
            amounts_[i] = cell.amounts(i);
            bodies_[i].T = cell.temperature(i);
        }
    }

    void step()
    {
        ventilate();
        enter();
        if (!cell.react(deltaT, h))
        {
            FatalErrorInFunction << "It does not end" << exit(FatalError);
        }
        leave();
    }
};


//- What seulex may miss in a step: of each extent of a body, and of the gas
scalarField absTol(const bedCell& bed, const label n, const label nExtents)
{
    scalarField tol;
    const reactingCell& cell = bed.cell;
    for (label i = 0; i < n; ++i)
    {
        const SubList<scalar> y(cell.amounts(i));
        const scalar all = tolerated.absolute*sum(y);
        const auto of = [&](const scalar amount)
        {
            return all + tolerated.relative*amount;
        };
        tol.append(of(y[0]));
        tol.append(of(y[0]));
        tol.append(of(y[1]));
        if (nExtents == 4)
        {
            // By a heat capacity of 1150 J/kg/K
            tol.append(0.06*y[2]*1150*tolerated.relative*cell.temperature(i));
        }
    }
    const scalarField& z = cell.fluidState();
    tol.append
    (
        tolerated.absolute*sum(SubList<scalar>(z, 5))
      + tolerated.relative*z[2]
    );
    return tol;
}


struct times
{
    scalar ours;
    scalar seulex;
    scalar steps;
    scalar difference;
};


times measure
(
    const reactionScheme& scheme,
    const label n,
    const scalar conductance
)
{
    bedCell bed(scheme, n, conductance);
    for (label i = 0; i < 20; ++i)
    {
        bed.step();
    }

    // On and on
    const label rounds = 30000/n;
    label steps = 0;
    const scalar begin = cpuTime();
    for (label i = 0; i < rounds; ++i)
    {
        bed.step();
        steps += bed.cell.steps() + bed.cell.refusals();
    }
    const scalar ours = (cpuTime() - begin)/rounds;

    // One step more by seulex, from the same start again and again
    bed.ventilate();
    bed.enter();
    const scalarField z(bed.cell.fluidState());
    const denseArrow dense(bed.cell, z);
    dictionary dict;
    dict.add("solver", "seulex");
    autoPtr<ODESolver> solver(ODESolver::New(dense, dict));
    solver->absTol() = absTol(bed, n, bed.cell.nExtents());
    solver->relTol() = 0;

    scalarField y(dense.nEqns(), 0);
    scalar dt = deltaT;
    solver->solve(0, deltaT, y, dt);

    const label repeats = max(label(3), label(2000/(n*n)));
    const scalar seulexBegin = cpuTime();
    for (label i = 0; i < repeats; ++i)
    {
        y = 0;
        dt = min(dt, deltaT);
        solver->solve(0, deltaT, y, dt);
    }
    const scalar seulex = (cpuTime() - seulexBegin)/repeats;

    // O2 that has gone, by either
    const scalar left = dense.shared(y)[0];
    bed.cell.react(deltaT, bed.h);
    const scalar difference =
        mag(bed.cell.fluidState()[0] - left)/mag(left - z[0]);

    return {ours, seulex, scalar(steps)/rounds, difference};
}


int main()
{
    // No word of which solver there is
    messageStream::level = 0;

    const reactionScheme scheme
    (
        dictionaryOf(regeneratorReactions),
        dictionaryOf(regeneratorGas),
        true
    );

    // Gunn's of all particles of a parcel, in gas of 912 K
    heatedFlow flow;
    flow.e = 1 - solidsFraction;
    flow.u = 0.3;
    flow.d = d;
    flow.rho = 0.53;
    flow.mu = 4e-5;
    flow.kappa = 0.062;
    flow.Cp = 1150;
    const scalar conductance = W*convectiveConductance(flow, Gunn().Nu(flow));

    printf("parcels   us a parcel-step   steps   over seulex   O2 apart\n");
    scalar us = 0;
    scalar ratio = 0;
    const label sizes[] = {3, 10, 30};
    for (const label n : sizes)
    {
        // The median of three
        times t[3];
        for (times& one : t)
        {
            one = measure(scheme, n, conductance);
        }
        std::sort
        (
            t, t + 3,
            [](const times& a, const times& b) { return a.ours < b.ours; }
        );
        const scalar each = 1e6*t[1].ours/n;
        const scalar over = t[1].ours/t[1].seulex;
        us += each/3;
        ratio += over/3;
        printf
        (
            "%7d   %16.2f   %5.2f   %11.4f   %8.1e\n",
            int(n), each, t[1].steps, over, t[1].difference
        );
    }
    printf("\nreactions.usPerParcelStep = %.3g\n", us);
    printf("reactions.ratioToSeulex = %.3g\n", ratio);
    return 0;
}
