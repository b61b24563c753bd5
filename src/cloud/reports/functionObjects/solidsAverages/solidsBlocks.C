/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "solidsBlocks.H"
#include "blockErrors.H"
#include "SubList.H"

Foam::cghs::solidsBlocks::solidsBlocks
(
    const scalar length,
    const label nCells,
    const label nProperties
)
:
    N_(A + nProperties),
    length_(length),
    elapsed_(0),
    open_(nCells*N_, Zero),
    closed_(N_, nCells),
    last_(nCells, Zero),
    differences_(nCells, Zero)
{}


void Foam::cghs::solidsBlocks::add(const cellSums& now, const scalar deltaT)
{
    for (label celli = 0; celli < nCells(); ++celli)
    {
        scalar* sums = &open_[celli*N_];

        sums[PHI] += deltaT*now.fraction[celli];
        sums[M] += deltaT*now.density[celli];
        sums[Q] += deltaT*tr(now.stress[celli]);
        for (direction d = 0; d < 3; ++d)
        {
            sums[P + d] += deltaT*now.flux[celli][d];
        }
        forAll(now.content, k)
        {
            sums[A + k] += deltaT*now.content[k][celli];
        }
    }
    elapsed_ += deltaT;

    // Not for the round-off of steps that fit into a block
    if (elapsed_ > (1 - 1e-9)*length_)
    {
        open_ /= elapsed_;
        addDifferences();
        closed_.add(open_);
        open_ = Zero;
        elapsed_ = 0;
    }
}


void Foam::cghs::solidsBlocks::addDifferences()
{
    for (label celli = 0; celli < nCells(); ++celli)
    {
        const scalar phi = open_[celli*N_ + PHI];

        if (nBlocks() > 0)
        {
            differences_[celli] += sqr(phi - last_[celli]);
        }
        last_[celli] = phi;
    }
}

// * * * * * * * * * * * * * * * * The window  * * * * * * * * * * * * * * * //

Foam::scalar Foam::cghs::solidsBlocks::correlation(const label celli) const
{
    const scalar n = nBlocks();
    const scalar sum = n*(n - 1)*sqr(fractionError(celli));
    const scalar roundOff = n*sqr(1e-8*closed_.mean(PHI, celli));

    return sum > roundOff ? 1 - differences_[celli]/(2*sum) : 0;
}


Foam::scalar Foam::cghs::solidsBlocks::independent
(
    const label celli,
    const scalar variance
) const
{
    const scalar shared = blockErrors::stretch(correlation(celli));

    return variance/max(sqr(fractionError(celli))*shared, VSMALL);
}


bool Foam::cghs::solidsBlocks::longEnough
(
    const label celli,
    const scalar variance
) const
{
    return
        nBlocks() >= blockErrors::minBlocks
     && !blockErrors::alike(nBlocks(), correlation(celli))
     && independent(celli, variance) >= blockErrors::leastIndependent;
}

// * * * * * * * * * * * * * * * *  Errors * * * * * * * * * * * * * * * * * //

Foam::vector Foam::cghs::solidsBlocks::meanVelocity(const label celli) const
{
    const scalar mass = closed_.mean(M, celli);

    return
        vector
        (
            closed_.mean(P, celli),
            closed_.mean(P + 1, celli),
            closed_.mean(P + 2, celli)
        )/max(mass, VSMALL);
}


Foam::scalar Foam::cghs::solidsBlocks::error
(
    const scalarList& gradient,
    const label celli
) const
{
    return sqrt(closed_.squaredError(gradient, celli));
}


Foam::scalar Foam::cghs::solidsBlocks::fractionError(const label celli) const
{
    scalarList gradient(N_, Zero);
    gradient[PHI] = 1;

    return error(gradient, celli);
}


Foam::scalarField Foam::cghs::solidsBlocks::fractionError() const
{
    scalarField result(nCells());

    forAll(result, celli)
    {
        result[celli] = fractionError(celli);
    }
    return result;
}


Foam::vectorField Foam::cghs::solidsBlocks::fluxError() const
{
    vectorField result(nCells());

    for (direction d = 0; d < 3; ++d)
    {
        scalarList gradient(N_, Zero);
        gradient[P + d] = 1;

        forAll(result, celli)
        {
            result[celli][d] = error(gradient, celli);
        }
    }
    return result;
}


Foam::vectorField Foam::cghs::solidsBlocks::velocityError() const
{
    vectorField result(nCells(), Zero);

    forAll(result, celli)
    {
        const scalar mass = closed_.mean(M, celli);
        const vector U(meanVelocity(celli));

        for (direction d = 0; mass > 0 && d < 3; ++d)
        {
            scalarList gradient(N_, Zero);
            gradient[P + d] = 1/mass;
            gradient[M] = -U[d]/mass;

            result[celli][d] = error(gradient, celli);
        }
    }
    return result;
}


Foam::scalarField Foam::cghs::solidsBlocks::temperatureError() const
{
    scalarField result(nCells(), Zero);

    forAll(result, celli)
    {
        const scalar mass = closed_.mean(M, celli);

        if (mass > 0)
        {
            const vector U(meanVelocity(celli));

            scalarList gradient(N_, Zero);
            gradient[Q] = 1;
            gradient[M] = 2*magSqr(U) - closed_.mean(Q, celli)/mass;
            for (direction d = 0; d < 3; ++d)
            {
                gradient[P + d] = -2*U[d];
            }

            result[celli] = error(gradient, celli)/(3*mass);
        }
    }
    return result;
}

Foam::scalarField Foam::cghs::solidsBlocks::propertyError
(
    const label k
) const
{
    scalarField result(nCells(), Zero);

    forAll(result, celli)
    {
        const scalar mass = closed_.mean(M, celli);

        if (mass > 0)
        {
            scalarList gradient(N_, Zero);
            gradient[A + k] = 1/mass;
            gradient[M] = -closed_.mean(A + k, celli)/sqr(mass);

            result[celli] = error(gradient, celli);
        }
    }
    return result;
}

// * * * * * * * * * * * * * * * Across a restart  * * * * * * * * * * * * * //

Foam::label Foam::cghs::solidsBlocks::nStates() const
{
    constexpr label nEach = pTraits<tensor>::nComponents;

    return (closed_.stateSize() + N_ + 2 + nEach - 1)/nEach;
}


Foam::List<Foam::tensorField> Foam::cghs::solidsBlocks::state() const
{
    constexpr label nEach = pTraits<tensor>::nComponents;
    const label nClosed = closed_.stateSize();

    List<tensorField> fields(nStates(), tensorField(nCells(), Zero));
    scalarList numbers(nStates()*nEach, Zero);

    for (label celli = 0; celli < nCells(); ++celli)
    {
        closed_.getState(celli, numbers);
        SubList<scalar>(numbers, N_, nClosed) =
            SubList<scalar>(open_, N_, celli*N_);
        numbers[nClosed + N_] = last_[celli];
        numbers[nClosed + N_ + 1] = differences_[celli];

        forAll(numbers, k)
        {
            fields[k/nEach][celli][k % nEach] = numbers[k];
        }
    }
    return fields;
}


void Foam::cghs::solidsBlocks::setState
(
    const label nBlocks,
    const scalar elapsed,
    const UList<tensorField>& state
)
{
    constexpr label nEach = pTraits<tensor>::nComponents;
    const label nClosed = closed_.stateSize();

    scalarList numbers(nStates()*nEach);

    for (label celli = 0; celli < nCells(); ++celli)
    {
        forAll(numbers, k)
        {
            numbers[k] = state[k/nEach][celli][k % nEach];
        }

        closed_.setState(celli, numbers);
        SubList<scalar>(open_, N_, celli*N_) =
            SubList<scalar>(numbers, N_, nClosed);
        last_[celli] = numbers[nClosed + N_];
        differences_[celli] = numbers[nClosed + N_ + 1];
    }

    closed_.setSamples(nBlocks);
    elapsed_ = elapsed;
}
