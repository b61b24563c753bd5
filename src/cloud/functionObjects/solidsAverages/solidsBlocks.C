/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "solidsBlocks.H"
#include "SubList.H"

Foam::cghs::solidsBlocks::solidsBlocks
(
    const scalar length,
    const label nCells
)
:
    length_(length),
    elapsed_(0),
    open_(nCells*N, Zero),
    closed_(N, nCells)
{}


void Foam::cghs::solidsBlocks::add(const cellSums& now, const scalar deltaT)
{
    for (label celli = 0; celli < nCells(); ++celli)
    {
        scalar* sums = &open_[celli*N];

        sums[PHI] += deltaT*now.fraction[celli];
        sums[M] += deltaT*now.density[celli];
        sums[Q] += deltaT*tr(now.stress[celli]);
        for (direction d = 0; d < 3; ++d)
        {
            sums[P + d] += deltaT*now.flux[celli][d];
        }
    }
    elapsed_ += deltaT;

    // Not for the round-off of steps that fit into a block
    if (elapsed_ > (1 - 1e-9)*length_)
    {
        open_ /= elapsed_;
        closed_.add(open_);
        open_ = Zero;
        elapsed_ = 0;
    }
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


Foam::scalarField Foam::cghs::solidsBlocks::fractionError() const
{
    scalarField result(nCells());
    scalarList gradient(N, Zero);
    gradient[PHI] = 1;

    forAll(result, celli)
    {
        result[celli] = error(gradient, celli);
    }
    return result;
}


Foam::vectorField Foam::cghs::solidsBlocks::fluxError() const
{
    vectorField result(nCells());

    for (direction d = 0; d < 3; ++d)
    {
        scalarList gradient(N, Zero);
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
            scalarList gradient(N, Zero);
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

            scalarList gradient(N, Zero);
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

// * * * * * * * * * * * * * * * Across a restart  * * * * * * * * * * * * * //

Foam::List<Foam::tensorField> Foam::cghs::solidsBlocks::state() const
{
    constexpr label nEach = pTraits<tensor>::nComponents;

    List<tensorField> fields(nStates, tensorField(nCells(), Zero));
    scalarList numbers(nStates*nEach, Zero);

    for (label celli = 0; celli < nCells(); ++celli)
    {
        closed_.getState(celli, numbers);
        SubList<scalar>(numbers, N, closed_.stateSize()) =
            SubList<scalar>(open_, N, celli*N);

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

    scalarList numbers(nStates*nEach);

    for (label celli = 0; celli < nCells(); ++celli)
    {
        forAll(numbers, k)
        {
            numbers[k] = state[k/nEach][celli][k % nEach];
        }

        closed_.setState(celli, numbers);
        SubList<scalar>(open_, N, celli*N) =
            SubList<scalar>(numbers, N, closed_.stateSize());
    }

    closed_.setSamples(nBlocks);
    elapsed_ = elapsed;
}
