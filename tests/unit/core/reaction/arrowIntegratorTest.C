/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    Stiff reactions of a gas and of many bodies in it: against published and
    analytic solutions, balances, bounds, and the order of the bodies.

\*---------------------------------------------------------------------------*/

#include "arrowIntegrator.H"
#include "denseArrow.H"
#include "ODESolver.H"
#include "sampler.H"
#include "scalarField.H"
#include "claim.H"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace Foam
{
namespace cghs
{

namespace
{

//- Tolerances of a test: relative, and absolute
struct tolerances
{
    scalar relative;
    scalar absolute;

    scalar error(const scalar y, const scalar dy) const
    {
        return mag(dy)/(absolute + relative*mag(y));
    }
};


// No further below zero than rounding takes it
bool isThere(const scalar y)
{
    return y >= -1e-15;
}


//- One of each, row by row
scalarField unity(const label n)
{
    scalarField I(n*n, 0);
    for (label k = 0; k < n; ++k)
    {
        I[k*n + k] = 1;
    }
    return I;
}


const labelList none;


//- A -> B (0.04), 2 B -> B + C (3e7), B + C -> A + C (1e4), in the gas alone.
//  H. H. Robertson, in J. Walsh (ed.), Numerical Analysis (1966), p. 178
class robertson
:
    public arrowSystem
{
    const scalarField G_;
    const scalarField G0_;
    const scalarField views_;
    const tolerances tolerated_;

    const scalar* z_;


public:

    robertson(const tolerances& tolerated)
    :
        G0_
        (
            List<scalar>
            ({
                -1,  0,  1,
                 1, -1, -1,
                 0,  1,  0
            })
        ),
        views_(unity(3)),
        tolerated_(tolerated),
        z_(nullptr)
    {}

    virtual label nBodies() const { return 0; }
    virtual label nExtents() const { return 1; }
    virtual const UList<label>& active() const { return none; }
    virtual label nShared() const { return 3; }
    virtual label nViews() const { return 3; }
    virtual label nSeen() const { return 0; }
    virtual const UList<scalar>& views() { return views_; }
    virtual label nOwn() const { return 3; }

    // Without bodies there is nothing in it that is read
    virtual const UList<scalar>& gives() const { return G0_; }
    virtual const UList<scalar>& ownGives() const { return G0_; }

    virtual void share(const scalar* now) { z_ = now; }

    virtual void rates(const label, const scalar*, scalar*) {}

    virtual void derivatives
    (
        const label, const scalar*, scalar*, scalar*, scalar*
    )
    {}

    virtual void ownRates(scalar* f)
    {
        f[0] = 0.04*z_[0];
        f[1] = 3e7*sqr(z_[1]);
        f[2] = 1e4*z_[1]*z_[2];
    }

    virtual void ownDerivatives(scalar* f, scalar* fq)
    {
        ownRates(f);
        std::fill(fq, fq + 9, 0);
        fq[0] = 0.04;
        fq[4] = 6e7*z_[1];
        fq[7] = 1e4*z_[2];
        fq[8] = 1e4*z_[1];
    }

    virtual scalar error
    (
        const label, const scalar*, const scalar*
    ) const
    {
        return 0;
    }

    virtual scalar sharedError(const scalar* z, const scalar* dz) const
    {
        scalar worst = 0;
        for (label k = 0; k < 3; ++k)
        {
            worst = max(worst, tolerated_.error(z[k], dz[k]));
        }
        return worst;
    }

    virtual bool allows(const label, const scalar*) const { return true; }

    virtual bool allowsShared(const scalar* z) const
    {
        return isThere(z[0]) && isThere(z[1]) && isThere(z[2]);
    }
};


//- In each of many bodies A + B(gas) -> C + D(gas) with k a b, and C -> A with
//  r c. In the gas D -> B with q d
class manyBodies
:
    public arrowSystem
{
    const scalarField G_;
    const scalarField G0_;
    const labelList active_;
    const scalarField views_;
    const tolerances tolerated_;

    const scalar* z_;


public:

    scalarField k;
    scalarField r;
    scalarField a;
    scalarField c;
    scalar q;

    manyBodies(const label n, const tolerances& tolerated)
    :
        G_(List<scalar>({-1, 0, 1, 0})),
        G0_(List<scalar>({1, -1})),
        active_({0, 1}),
        views_(unity(2)),
        tolerated_(tolerated),
        z_(nullptr),
        k(n),
        r(n),
        a(n),
        c(n),
        q(0)
    {}

    virtual label nBodies() const { return k.size(); }
    virtual label nExtents() const { return 2; }
    virtual const UList<label>& active() const { return active_; }
    virtual label nShared() const { return 2; }
    virtual label nViews() const { return 2; }
    virtual label nSeen() const { return 1; }
    virtual const UList<scalar>& views() { return views_; }
    virtual label nOwn() const { return 1; }
    virtual const UList<scalar>& gives() const { return G_; }
    virtual const UList<scalar>& ownGives() const { return G0_; }

    scalar A(const label i, const scalar* x) const
    {
        return a[i] - x[0] + x[1];
    }

    scalar C(const label i, const scalar* x) const
    {
        return c[i] + x[0] - x[1];
    }

    virtual void share(const scalar* now) { z_ = now; }

    virtual void rates(const label i, const scalar* x, scalar* f)
    {
        f[0] = k[i]*A(i, x)*z_[0];
        f[1] = r[i]*C(i, x);
    }

    virtual void derivatives
    (
        const label i, const scalar* x, scalar* f, scalar* fx, scalar* fq
    )
    {
        rates(i, x, f);
        fx[0] = -k[i]*z_[0];
        fx[1] = k[i]*z_[0];
        fx[2] = r[i];
        fx[3] = -r[i];
        fq[0] = k[i]*A(i, x);
        fq[1] = 0;
    }

    virtual void ownRates(scalar* f)
    {
        f[0] = q*z_[1];
    }

    virtual void ownDerivatives(scalar* f, scalar* fq)
    {
        ownRates(f);
        fq[0] = 0;
        fq[1] = q;
    }

    virtual scalar error
    (
        const label i, const scalar* x, const scalar* dx
    ) const
    {
        const scalar dC = dx[0] - dx[1];

        return max
        (
            tolerated_.error(A(i, x), dC),
            tolerated_.error(C(i, x), dC)
        );
    }

    virtual scalar sharedError(const scalar* z, const scalar* dz) const
    {
        return max
        (
            tolerated_.error(z[0], dz[0]),
            tolerated_.error(z[1], dz[1])
        );
    }

    virtual bool allows(const label i, const scalar* x) const
    {
        return isThere(A(i, x)) && isThere(C(i, x));
    }

    virtual bool allowsShared(const scalar* z) const
    {
        return isThere(z[0]) && isThere(z[1]);
    }
};


//- In each of many bodies n processes M -> P_r, as fast as
//  k_r M exp(sum_j alpha_rj x_j) by some of their extents, and as fast as M by
//  the others. In the gas P_0 -> M with q P_0. What does not act may be told,
//  or be left to zeros
class deactivatingBodies
:
    public arrowSystem
{
    const label n_;
    const bool told_;
    const labelList acting_;
    const labelList active_;
    scalarField G_;
    scalarField G0_;

    //- M and P_0, or all
    scalarField views_;

    const tolerances tolerated_;

    const scalar* z_;


    //- alpha_rj of all bodies
    scalarField alpha_;


public:

    scalarField k;

    deactivatingBodies
    (
        const label nBodies,
        const label n,
        const labelList& acting,
        const scalar K,
        const bool told
    )
    :
        n_(n),
        told_(told),
        acting_(acting),
        active_(told ? acting : identity(n)),
        G_((n + 1)*n, 0),
        G0_(n + 1, 0),
        views_(unity(n + 1)),
        tolerated_({1e-4, 1e-8}),
        z_(nullptr),
        alpha_(n*n, 0),
        k(nBodies*n)
    {
        for (label r = 0; r < n; ++r)
        {
            G_[r] = -1;
            G_[(r + 1)*n + r] = 1;
        }
        G0_[0] = 1;
        G0_[1] = -1;

        sampler random(11);
        for (label r = 0; r < n; ++r)
        {
            for (const label j : acting)
            {
                alpha_[r*n + j] = random.between(-3, 0.5);
            }
        }
        for (scalar& one : k)
        {
            one = K*random.acrossDecades(0.1, 10);
        }
    }

    virtual label nBodies() const { return k.size()/n_; }
    virtual label nExtents() const { return n_; }
    virtual const UList<label>& active() const { return active_; }
    virtual label nShared() const { return n_ + 1; }
    virtual label nViews() const { return told_ ? 2 : n_ + 1; }
    virtual label nSeen() const { return told_ ? 1 : n_ + 1; }
    virtual label nOwn() const { return 1; }
    virtual const UList<scalar>& gives() const { return G_; }
    virtual const UList<scalar>& ownGives() const { return G0_; }
    virtual const UList<scalar>& views() { return views_; }
    virtual void share(const scalar* now) { z_ = now; }

    virtual void rates(const label i, const scalar* x, scalar* f)
    {
        for (label r = 0; r < n_; ++r)
        {
            scalar exponent = 0;
            for (const label j : acting_)
            {
                exponent += alpha_[r*n_ + j]*x[j];
            }
            f[r] = k[i*n_ + r]*z_[0]*std::exp(min(exponent, scalar(50)));
        }
    }

    virtual void derivatives
    (
        const label i, const scalar* x, scalar* f, scalar* fx, scalar* fq
    )
    {
        rates(i, x, f);
        std::fill_n(fq, n_*nSeen(), 0);
        for (label r = 0; r < n_; ++r)
        {
            for (const label j : active_)
            {
                *fx++ = f[r]*alpha_[r*n_ + j];
            }
            fq[r*nSeen()] = f[r]/z_[0];
        }
    }

    virtual void ownRates(scalar* f)
    {
        f[0] = 3*z_[1];
    }

    virtual void ownDerivatives(scalar* f, scalar* fq)
    {
        ownRates(f);
        std::fill_n(fq, nViews(), 0);
        fq[1] = 3;
    }

    virtual scalar error
    (
        const label, const scalar* x, const scalar* dx
    ) const
    {
        scalar worst = 0;
        for (label r = 0; r < n_; ++r)
        {
            worst = max(worst, tolerated_.error(x[r], dx[r]));
        }
        return worst;
    }

    virtual scalar sharedError(const scalar* z, const scalar* dz) const
    {
        return error(0, z, dz);
    }

    virtual bool allows(const label, const scalar*) const { return true; }

    virtual bool allowsShared(const scalar* z) const
    {
        return isThere(z[0]) && isThere(z[1]);
    }
};


const tolerances usual = {1e-4, 1e-8};


//- Bodies that take up much more than there is, at rates of about K over a
//  decade
manyBodies hungry(const label n, const scalar K)
{
    manyBodies system(n, usual);
    sampler random(3);
    forAll(system.k, i)
    {
        system.k[i] = K*random.acrossDecades(0.3, 3);
        system.a[i] = random.between(0.5, 1.5);
        system.c[i] = random.between(0, 0.5);
        system.r[i] = 0;
    }
    return system;
}


//- Visit(system, z, integrator) when a time of 1 has passed
template<class Visitor>
void forEachRate(const Visitor& visit)
{
    for (const scalar K : {1e-6, 1.0, 1e3, 1e6, 1e9, 1e12, 1e15})
    {
        for (const label n : {1, 10, 300})
        {
            manyBodies system(hungry(n, K));
            scalarField z(List<scalar>({0.3, 0.1}));
            auto integrator = arrowIntegrator::New(system.active().size());
            scalar h = 1;
            const bool ended = integrator->integrate(system, z, 1, h);
            visit(system, z, integrator(), ended);
        }
    }
}

}


TEST_CASE("Robertson's reactions", "[reaction]")
{
    // At 40 s, as published for this problem many times, e.g. with CVODE
    const scalar exact[] = {0.7158270688, 9.185534764e-6, 0.2841637457};

    claim close("arrowIntegrator.robertson", 1e-5);
    claim converges("arrowIntegrator.robertson.order", 0.3);
    claim closes("arrowIntegrator.robertson.closes", 1e-14);

    const scalarField relative(List<scalar>({1e-3, 1e-4, 1e-5}));
    scalarField error(relative.size(), 0);
    scalarField steps(relative.size(), 0);
    forAll(relative, i)
    {
        robertson system({relative[i], relative[i]*1e-6});
        scalarField z(List<scalar>({1, 0, 0}));
        auto integrator = arrowIntegrator::New(system.active().size());
        scalar h = 1e-4;
        REQUIRE(integrator->integrate(system, z, 40, h));

        forAll(z, k)
        {
            error[i] = max(error[i], mag(z[k]/exact[k] - 1));
        }
        closes.see(mag(sum(z) - 1));
        steps[i] = integrator->steps();
    }

    close.see(error.last());

    // Of the error over the number of steps
    converges.see
    (
        mag(std::log(error[0]/error[2])/std::log(steps[2]/steps[0]) - 3)/3
    );

    close.settle();
    converges.settle();
    closes.settle();
}


TEST_CASE("All rates end, close and stay above zero", "[reaction]")
{
    claim ends("arrowIntegrator.ends", 0);
    claim closes("arrowIntegrator.closes", 1e-14);
    claim positive("arrowIntegrator.positive", 1e-14);
    claim shares("arrowIntegrator.shares", 1e-4);

    forEachRate
    (
        [&]
        (
            const manyBodies& system,
            const scalarField& z,
            const arrowIntegrator& integrator,
            const bool ended
        )
        {
            ends.count(ended);

            scalar taken = 0;
            scalar least = 0;
            scalar greatest = 0;
            forAll(system.k, i)
            {
                const scalar* x = integrator.extents(i);
                taken += x[0];
                positive.see(max(-x[0], -system.A(i, x)));

                // d ln a = -k b dt: the same integral of b for all
                const scalar doses =
                    -std::log1p(-x[0]/system.a[i])/system.k[i];
                least = i == 0 ? doses : min(least, doses);
                greatest = max(greatest, doses);
            }
            closes.see(mag(z[0] + taken - 0.3));
            closes.see(mag(z[1] - taken - 0.1));
            positive.see(-z[0]);
            shares.see(greatest/least - 1);
        }
    );

    ends.settle();
    closes.settle();
    positive.settle();
    shares.settle();
}


TEST_CASE("Where forth and back are fast they end in balance", "[reaction]")
{
    claim balanced("arrowIntegrator.balanced", 1e-4);
    claim closes("arrowIntegrator.balanced.closes", 1e-14);

    for (const scalar K : {1e3, 1e6, 1e12})
    {
        manyBodies system(hungry(20, K));
        system.r = 0.1*K;
        scalarField z(List<scalar>({0.3, 1}));
        auto integrator = arrowIntegrator::New(system.active().size());
        scalar h = 1;

        // The gas gives back what it has got: A + B <-> C at last
        system.q = K;
        REQUIRE(integrator->integrate(system, z, 1, h));

        forAll(system.k, i)
        {
            const scalar* x = integrator->extents(i);
            const scalar forth = system.k[i]*system.A(i, x)*z[0];
            const scalar back = system.r[i]*system.C(i, x);
            balanced.see(mag(forth/back - 1));
        }

        // Of what goes either way, not of the difference
        scalar gross = 1;
        forAll(system.k, i)
        {
            const scalar* x = integrator->extents(i);
            gross = max(gross, x[0]);
        }
        closes.see
        (
            mag(z[0] + z[1] - 1.3)
           /max(gross, integrator->ownExtents(system)[0])
        );
    }

    balanced.settle();
    closes.settle();
}


TEST_CASE("The order of the bodies does not matter", "[reaction]")
{
    claim same("arrowIntegrator.order", 1e-12);

    for (const scalar K : {1.0, 1e6, 1e12})
    {
        manyBodies forth(hungry(300, K));
        manyBodies back(forth);
        std::reverse(back.k.begin(), back.k.end());
        std::reverse(back.a.begin(), back.a.end());
        std::reverse(back.c.begin(), back.c.end());

        auto forthBy = arrowIntegrator::New(2);
        auto backBy = arrowIntegrator::New(2);
        scalarField z(List<scalar>({0.3, 0}));
        scalarField zBack(z);
        scalar h = 1;
        REQUIRE(forthBy->integrate(forth, z, 1, h));
        h = 1;
        REQUIRE(backBy->integrate(back, zBack, 1, h));

        forAll(forth.k, i)
        {
            same.see
            (
                mag
                (
                    forthBy->extents(i)[0]
                  - backBy->extents(forth.k.size() - 1 - i)[0]
                )
            );
        }
    }

    same.settle();
}


TEST_CASE("Memory that is kept holds nothing of the cell before", "[reaction]")
{
    claim same("arrowIntegrator.memory", 0);

    auto kept = arrowIntegrator::New(2);
    for (const label n : {300, 1, 10, 0, 40})
    {
        manyBodies system(hungry(n, 1e6));
        auto fresh = arrowIntegrator::New(2);

        scalarField z(List<scalar>({0.3, 0}));
        scalarField zFresh(z);
        scalar h = 1;
        REQUIRE(kept->integrate(system, z, 1, h));
        h = 1;
        REQUIRE(fresh->integrate(system, zFresh, 1, h));
        same.see(mag(z[0] - zFresh[0]) + mag(z[1] - zFresh[1]));
    }

    same.settle();
}


TEST_CASE("What does not act need not be eliminated", "[reaction]")
{
    claim same("arrowIntegrator.inactive", 1e-12);
    claim ends("arrowIntegrator.inactive.ends", 0);

    const List<labelList> sets
    ({
        {}, {5}, {0}, {1, 4}, {2, 3, 6}, {0, 1, 2, 3}, {0, 2, 4, 5, 6}
    });
    for (const labelList& acting : sets)
    {
        for (const scalar K : {1e-3, 1.0, 1e3, 1e6})
        {
            deactivatingBodies told(20, 7, acting, K, true);
            deactivatingBodies all(20, 7, acting, K, false);
            auto by = arrowIntegrator::New(told.active().size());
            auto byAll = arrowIntegrator::New(all.active().size());

            scalarField z(8, 0);
            z[0] = 1;
            scalarField zAll(z);
            scalar h = 0.1;
            ends.count(by->integrate(told, z, 1, h));
            h = 0.1;
            ends.count(byAll->integrate(all, zAll, 1, h));

            same.see(max(mag(z - zAll)));
            for (label i = 0; i < told.nBodies(); ++i)
            {
                for (label r = 0; r < 7; ++r)
                {
                    same.see(mag(by->extents(i)[r] - byAll->extents(i)[r]));
                }
            }
        }
    }

    same.settle();
    ends.settle();
}


TEST_CASE("Stiff reactions by OpenFOAM's own solvers", "[reaction]")
{
    // Of a step. Errors of the steps add up: the whole may miss by three
    const tolerances asked = {1e-5, 1e-9};

    const auto check = [&]
    (
        claim& same,
        const char* solver,
        const label n,
        const scalar t
    )
    {
        // Each body a decade or two faster than the one before, to 1e12
        manyBodies system(n, asked);
        sampler random(7);
        forAll(system.k, i)
        {
            system.k[i] = std::pow(10, 12.0*i/(n - 1));
            system.r[i] = system.k[i]*random.between(0.1, 0.5);
            system.a[i] = random.between(0.5, 1.5);
            system.c[i] = random.between(0, 0.5);
        }
        system.q = 3;
        const scalarField start(List<scalar>({0.3, 0.1}));

        scalarField z(start);
        auto integrator = arrowIntegrator::New(system.active().size());
        scalar h = 1e-3*t;
        REQUIRE(integrator->integrate(system, z, t, h));

        const denseArrow dense(system, start);
        dictionary dict;
        dict.add("solver", word(solver));
        dict.add("absTol", 1e-9);
        dict.add("relTol", 1e-9);
        const autoPtr<ODESolver> other(ODESolver::New(dense, dict));
        scalarField y(dense.nEqns(), 0);
        scalar dt = 1e-13;
        other->solve(0, t, y, dt);

        const scalarField zOther(dense.shared(y));
        const scalarField dz(z - zOther);
        same.see(system.sharedError(z.cdata(), dz.cdata()));
        forAll(system.k, i)
        {
            const scalar* x = integrator->extents(i);
            const scalar dx[] = {x[0] - y[2*i], x[1] - y[2*i + 1]};
            same.see(system.error(i, x, dx));
        }
    };

    claim seulex("arrowIntegrator.seulex", 3);
    claim rodas("arrowIntegrator.rodas34", 3);
    for (const label n : {2, 7, 13})
    {
        for (const scalar t : {1e-11, 1e-6, 1e-2, 1.0})
        {
            check(seulex, "seulex", n, t);
            check(rodas, "rodas34", n, t);
        }
    }
    seulex.settle();
    rodas.settle();
}

} // End namespace cghs
} // End namespace Foam
