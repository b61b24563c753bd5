/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    The gas of a cell and its parcels: balance, bounds, limits, order of
    parcels and order of convergence.

\*---------------------------------------------------------------------------*/

#include "heatArrow.H"
#include "sampler.H"
#include "scalarField.H"
#include "claim.H"

#include <catch2/catch.hpp>

#include <cmath>

namespace Foam
{
namespace cghs
{

namespace
{

//- A cell with its gas and its parcels
struct cellHeat
{
    scalar Cg, Tg;
    scalarField C, k, T;

    //- Sum of C T [J], of parcels and gas
    scalar content() const
    {
        return sum(C*T) + Cg*Tg;
    }

    //- One step; the heats that the parcels took in
    scalarField step(const scalar dt, const scalar S = 0)
    {
        heatArrow sums(Tg);
        scalarField a(T.size()), Q(T.size());
        forAll(T, i)
        {
            a[i] = heatArrow::response(C[i], k[i], dt);
            sums.eliminate(T[i], a[i]);
        }
        Tg = sums.solve(Cg, Tg, S);
        forAll(T, i)
        {
            Q[i] = heatArrow::substitute(T[i], a[i], Tg);
            T[i] += Q[i]/C[i];
        }
        return Q;
    }
};


//- Capacities over six decades; time constants of the parcels over two, about
//  one second
cellHeat randomCell(sampler& random, const label n)
{
    cellHeat cell;
    cell.Cg = random.acrossDecades(1e-6, 1);
    cell.Tg = random.between(300, 1200);
    cell.C.setSize(n);
    cell.k.setSize(n);
    cell.T.setSize(n);
    for (label i = 0; i < n; ++i)
    {
        cell.C[i] = random.acrossDecades(1e-6, 1);
        cell.k[i] = cell.C[i]*random.acrossDecades(0.1, 10);
        cell.T[i] = random.between(300, 1200);
    }
    return cell;
}


//- Visit(cell, dt) for cells of 1 and 1000 parcels, dt over time constants of
//  about 1e-12 to 1e12
template<class Visitor>
void forEachStep(const Visitor& visit)
{
    sampler random(7);
    for (const label n : {1, 1000})
    {
        for (label decade = -12; decade <= 12; ++decade)
        {
            for (label repeat = 0; repeat < (n == 1 ? 100 : 5); ++repeat)
            {
                visit(randomCell(random, n), std::pow(10.0, decade));
            }
        }
    }
}

}


TEST_CASE("Heat between a gas and its parcels closes to round-off", "[heat]")
{
    claim closes("heatArrow.closes", 1e-14);
    claim taken("heatArrow.taken", 1e-14);
    sampler random(3);

    forEachStep([&](const cellHeat& before, const scalar dt)
    {
        for (const bool heated : {false, true})
        {
            cellHeat after(before);
            const scalar S =
                heated ? random.between(-1, 1)*before.content() : 0;
            const scalarField Q(after.step(dt, S));
            const scalar size = before.content() + mag(S);

            closes.see(mag(after.content() - before.content() - S)/size);
            taken.see
            (
                mag(before.Cg*(after.Tg - before.Tg) - S + sum(Q))/size
            );
        }
    });
    closes.settle();
    taken.settle();
}


TEST_CASE("No temperature shoots over, however long the step", "[heat]")
{
    // Beyond the bounds by rounding only
    claim bounded("heatArrow.bounded", 4e-16);
    claim still("heatArrow.still", 0);

    forEachStep([&](const cellHeat& before, const scalar dt)
    {
        const scalar low = min(min(before.T), before.Tg);
        const scalar high = max(max(before.T), before.Tg);

        cellHeat after(before);
        after.step(dt);
        bounded.see(max(max(after.T), after.Tg)/high - 1);
        bounded.see(1 - min(min(after.T), after.Tg)/low);

        // A parcel ends between where it was and where the gas ends
        forAll(after.T, i)
        {
            const scalar share =
                (after.T[i] - before.T[i])*sign(after.Tg - before.T[i]);
            bounded.see(-share/high);
            bounded.see((share - mag(after.Tg - before.T[i]))/high);
        }

        // Bodies of one temperature keep it
        cellHeat level(before);
        level.T = level.Tg;
        level.step(dt);
        still.see(mag(level.Tg - before.Tg));
        still.see(max(mag(level.T - before.Tg)));
    });
    bounded.settle();
    still.settle();
}


TEST_CASE("In a gas of huge capacity parcels follow the exponential", "[heat]")
{
    claim exact("heatArrow.hugeGas", 1e-13);
    sampler random(11);

    for (const scalar steps : {1e-12, 1e-3, 1e-2, 0.1, 1.0, 10.0, 1e3, 1e6})
    {
        cellHeat cell(randomCell(random, 100));
        cell.Cg = 1e30;
        const scalarField T0(cell.T);
        const scalarField Q(cell.step(steps));

        forAll(Q, i)
        {
            const scalar x = steps*cell.k[i]/cell.C[i];
            const scalar whole = cell.C[i]*(cell.Tg - T0[i]);
            const scalar left = std::exp(-x);
            const scalar start = x - x*x/2;

            exact.see(mag(Q[i]/whole - (x < 1e-6 ? start : 1 - left)));
            exact.see
            (
                x < 1e-6 ? mag(Q[i]/(whole*start) - 1) : scalar(0)
            );
        }
    }
    exact.settle();
}


TEST_CASE("Gas and parcels end at the mixed temperature", "[heat]")
{
    claim mixed("heatArrow.mixed", 1e-14);
    sampler random(13);

    for (const label n : {1, 10, 1000})
    {
        for (const scalar dt : {1e3, 1e6, 1e12})
        {
            const cellHeat before(randomCell(random, n));
            const scalar T = before.content()/(sum(before.C) + before.Cg);

            cellHeat after(before);
            after.step(dt);
            mixed.see(mag(after.Tg/T - 1));
            mixed.see(max(mag(after.T/T - 1)));
        }
    }
    mixed.settle();
}


TEST_CASE("The order of the parcels does not matter to the gas", "[heat]")
{
    claim same("heatArrow.order", 1e-14);
    sampler random(17);

    for (const scalar dt : {1e-3, 1.0, 1e3})
    {
        const cellHeat before(randomCell(random, 1000));
        const labelList order(random.shuffled(before.T.size()));

        cellHeat first(before), second(before);
        forAll(order, i)
        {
            second.C[i] = before.C[order[i]];
            second.k[i] = before.k[order[i]];
            second.T[i] = before.T[order[i]];
        }
        first.step(dt);
        second.step(dt);

        same.see(mag(first.Tg/second.Tg - 1));
        forAll(order, i)
        {
            same.see(mag(second.T[i]/first.T[order[i]] - 1));
        }
    }
    same.settle();
}


// T - T_g of two bodies falls as exp(-k (1/C + 1/C_g) t)
TEST_CASE("Two bodies converge to their exponential at first order", "[heat]")
{
    const scalar C = 2, Cg = 0.5, k = 0.8, T0 = 900, Tg0 = 300, end = 1;
    const scalar exact = (T0 - Tg0)*std::exp(-k*(1/C + 1/Cg)*end);

    const auto errorOf = [&](const label n)
    {
        cellHeat cell{Cg, Tg0, scalarField(1, C), scalarField(1, k), {}};
        cell.T = scalarField(1, T0);
        for (label i = 0; i < n; ++i)
        {
            cell.step(end/n);
        }
        return mag(cell.T[0] - cell.Tg - exact);
    };

    claim order("heatArrow.firstOrder", 0.02);
    claim converged("heatArrow.converged", 1e-3);
    for (const label n : {100, 200, 400, 800})
    {
        order.see(mag(std::log2(errorOf(n)/errorOf(2*n)) - 1));
    }
    converged.see(errorOf(4000)/exact);
    order.settle();
    converged.settle();
}


// With the reference 0 the sums are what a transport equation needs
TEST_CASE("The sums of the parcels serve another's equation", "[heat]")
{
    claim absolute("heatArrow.sums", 1e-14);
    sampler random(19);

    const scalar dt = 0.3, S = 40;
    const cellHeat cell(randomCell(random, 50));
    heatArrow plain, offset(cell.Tg);
    forAll(cell.T, i)
    {
        const scalar a = heatArrow::response(cell.C[i], cell.k[i], dt);
        plain.eliminate(cell.T[i], a);
        offset.eliminate(cell.T[i], a);
    }

    const scalar Tg =
        (cell.Cg*cell.Tg + S + plain.given())/(cell.Cg + plain.response());
    absolute.see(mag(offset.solve(cell.Cg, cell.Tg, S)/Tg - 1));
    absolute.see(mag(plain.solve(cell.Cg, cell.Tg, S)/Tg - 1));
    absolute.settle();
}

} // End namespace cghs
} // End namespace Foam
