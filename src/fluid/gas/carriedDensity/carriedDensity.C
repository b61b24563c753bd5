/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "carriedDensity.H"

namespace Foam
{
namespace cghs
{

//- Nought where nothing flows. There the sign of the flux is chance, or none,
//  and the ranks on both sides of a face would have it otherwise
static tmp<surfaceScalarField> moves(const surfaceScalarField& flux)
{
    // Of the distance of both cells, in a step
    constexpr scalar still = 1e-6;

    const fvMesh& mesh = flux.mesh();

    return min
    (
        mag(flux)*mesh.time().deltaT()*mesh.deltaCoeffs()/mesh.magSf()/still,
        scalar(1)
    );
}


//- Set weights of owners between cells by a field of both sides, and by what
//  else there is of the face; linear where nothing flows
template<class Weight>
static void weigh
(
    surfaceScalarField& weights,
    const surfaceScalarField& others,
    const surfaceScalarField& flux,
    const volScalarField& field,
    const Weight& weight
)
{
    const fvMesh& mesh = field.mesh();
    const surfaceScalarField& linear = mesh.weights();
    const surfaceScalarField share(moves(flux));

    const auto between = [](scalar level, scalar share, scalar weight)
    {
        return level + share*(weight - level);
    };

    forAll(mesh.neighbour(), facei)
    {
        weights[facei] = between
        (
            linear[facei],
            share[facei],
            weight
            (
                linear[facei],
                others[facei],
                field[mesh.owner()[facei]],
                field[mesh.neighbour()[facei]]
            )
        );
    }

    for (const fvPatchScalarField& there : field.boundaryField())
    {
        if (there.coupled())
        {
            const label patchi = there.patch().index();
            scalarField& here = weights.boundaryFieldRef()[patchi];
            const scalarField& other = others.boundaryField()[patchi];
            const scalarField& level = linear.boundaryField()[patchi];
            const scalarField& part = share.boundaryField()[patchi];
            const scalarField owner(there.patchInternalField());
            const scalarField neighbour(there.patchNeighbourField());

            forAll(here, facei)
            {
                here[facei] = between
                (
                    level[facei],
                    part[facei],
                    weight
                    (
                        level[facei],
                        other[facei],
                        owner[facei],
                        neighbour[facei]
                    )
                );
            }
        }
    }
}

} // End namespace cghs
} // End namespace Foam


Foam::tmp<Foam::surfaceScalarField> Foam::cghs::donorWeights
(
    const volScalarField& rho,
    const surfaceScalarField& flux
)
{
    tmp<surfaceScalarField> tweights
    (
        new surfaceScalarField(rho.mesh().weights())
    );

    weigh
    (
        tweights.ref(),
        flux,
        flux,
        rho,
        [](const scalar w, const scalar phi, const scalar P, const scalar N)
        {
            constexpr scalar apart = 2;
            constexpr scalar alike = 1.2;

            const scalar ratio = max(P, N)/min(P, N);
            const scalar x =
                min(max((ratio - alike)/(apart - alike), scalar(0)), scalar(1));

            return w + sqr(x)*(3 - 2*x)*((phi > 0 ? 1 : 0) - w);
        }
    );

    return tweights;
}


Foam::tmp<Foam::surfaceScalarField> Foam::cghs::mixingWeights
(
    const volScalarField& rho,
    const surfaceScalarField& byMass,
    const surfaceScalarField& flux
)
{
    tmp<surfaceScalarField> tweights(new surfaceScalarField(byMass));

    weigh
    (
        tweights.ref(),
        byMass,
        flux,
        rho,
        [](const scalar, const scalar w, const scalar P, const scalar N)
        {
            return w*N/(w*N + (1 - w)*P);
        }
    );

    return tweights;
}
