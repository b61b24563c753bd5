/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "momentum.H"
#include "fvcGrad.H"
#include "profiling.H"
#include "PstreamReduceOps.H"
#include "zeroGradientFvPatchFields.H"
#include "Time.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(momentum, 0);
}
}


Foam::cghs::momentum::momentum
(
    const dictionary& subModels,
    const fvMesh& mesh,
    const word& cloudName,
    const vector& g,
    const scalar parcelDiameter,
    const labelUList& plates,
    const scalar minVoidage
)
:
    mesh_(mesh),
    cloudName_(cloudName),
    mapping_(mappingModel::New(subModels, mesh, parcelDiameter, plates)),
    suspension_(subModels, g, mesh.nCells(), mapping_->kernels()),
    nCrowdedCells_(0),
    gained_(Zero),
    exchanged_(0)
{
    if (minVoidage > 0)
    {
        limit_.reset(new solidsLimit(mesh, 1 - minVoidage, plates));

        if (mapping_->kernels())
        {
            cellDrag_.reset(new cellDrag(mesh, mapping_(), plates));
        }
    }
}


void Foam::cghs::momentum::addColumns(arena& parcels)
{
    suspension_.addColumns(parcels);
}

// * * * * * * * * * * * * * * * * The step  * * * * * * * * * * * * * * * * //

void Foam::cghs::momentum::meet(const arena& parcels, carrierFluid& fluid)
{
    addProfiling(mapping, "cghs::mapping");

    tmp<volVectorField> tu(smooth(fluid.U()));
    const tmp<volVectorField> tgrad(smooth(fluid.gradP()));
    const scalarField& alpha = fluid.alpha();
    const scalarField& rho = fluid.rho();
    const scalarField& mu = fluid.mu();
    List<carrier> byCell(mesh_.nCells());

    forAll(byCell, celli)
    {
        byCell[celli] = carrier
        (
            tu()[celli],
            tgrad()[celli],
            alpha[celli],
            rho[celli],
            mu[celli]
        );
    }

    suspension_.startFluidStep();
    suspension_.meet
    (
        parcels,
        std::move(byCell),
        suspension_.feelsTurning() ? turnings(fluid.U()) : List<turning>()
    );

    if (cellDrag_.valid())
    {
        metU_ = tu;
    }
}


Foam::List<Foam::cghs::turning> Foam::cghs::momentum::turnings
(
    const volVectorField& U
) const
{
    const tmp<volVectorField> field(smooth(U & fvc::grad(U)));
    List<turning> byCell(mesh_.nCells());

    forAll(byCell, celli)
    {
        byCell[celli] = turning(field()[celli]);
    }

    return byCell;
}


Foam::tmp<Foam::volVectorField> Foam::cghs::momentum::smooth
(
    const volVectorField& field
) const
{
    // Coupled patches carry on; elsewhere nothing is passed anyway
    auto result = volVectorField::New
    (
        "smooth(" + field.name() + ')',
        mesh_,
        dimensionedVector(field.dimensions(), Zero)
    );

    result.ref().primitiveFieldRef() = field.primitiveField();
    result.ref().correctBoundaryConditions();
    mapping_->spread(result.ref());

    return result;
}


template<class Type>
Foam::tmp<Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh>>
Foam::cghs::momentum::density
(
    const word& name,
    const Field<Type>& sums,
    const dimensionSet& dimensions
) const
{
    auto result = GeometricField<Type, fvPatchField, volMesh>::New
    (
        cloudName_ + ':' + name,
        mesh_,
        dimensioned<Type>(dimensions, Zero),
        zeroGradientFvPatchField<Type>::typeName
    );

    result.ref().primitiveFieldRef() = sums/mesh_.V();
    result.ref().correctBoundaryConditions();

    return result;
}


template<class Type>
Foam::tmp<Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh>>
Foam::cghs::momentum::spreadDensity
(
    const word& name,
    const Field<Type>& sums,
    const dimensionSet& dimensions
) const
{
    auto result = density(name, sums, dimensions);
    mapping_->spread(result.ref());

    return result;
}


void Foam::cghs::momentum::leave(const arena& parcels, const scalar deltaT)
{
    addProfiling(mapping, "cghs::mapping");

    suspension_.leave(parcels, deltaT);

    theta_ = spreadDensity("theta", suspension_.volume(), dimless);
    nCrowdedCells_ = limit_->bound(theta_.ref());
}


void Foam::cghs::momentum::complete
(
    arena& parcels,
    const carrierFluid& fluid,
    const scalar deltaT
)
{
    addProfiling(complete, "cghs::complete");

    const tmp<volVectorField> dU(fluid.dU());
    const tmp<volVectorField> tdU(smooth(dU()));
    const tmp<volVectorField> tdGradP(smooth(fluid.dGradP()()));
    List<change> changes(mesh_.nCells());

    forAll(changes, celli)
    {
        changes[celli] = change(tdU()[celli], tdGradP()[celli]);
    }

    suspension_.complete(parcels, std::move(changes), deltaT);

    if (cellDrag_.valid())
    {
        cellDrag_->finish(dU());
    }
}

// * * * * * * * * * * * * * * What the fluid receives * * * * * * * * * * * //

Foam::tmp<Foam::volScalarField> Foam::cghs::momentum::noSolids() const
{
    return spreadDensity
    (
        "theta",
        scalarField(mesh_.nCells(), Zero),
        dimless
    );
}


Foam::tmp<Foam::volVectorField> Foam::cghs::momentum::drag
(
    const scalar deltaT,
    const volVectorField& U,
    const volScalarField& rho,
    const volScalarField& response
)
{
    addProfiling(mapping, "cghs::mapping");

    tmp<volVectorField> F
    (
        density
        (
            "drag",
            vectorField(suspension_.impulse()/deltaT),
            dimForce/dimVolume
        )
    );

    if (!cellDrag_.valid())
    {
        mapping_->spread(F.ref());
        return F;
    }

    cellDrag_->spread
    (
        F.ref(),
        U,
        metU_(),
        density("cellDrag", suspension_.drag(), dimDensity/dimTime)(),
        response
      + rho*(1 - theta_())/dimensionedScalar("dt", dimTime, deltaT)
    );

    return F;
}


Foam::tmp<Foam::volScalarField> Foam::cghs::momentum::dragResponse() const
{
    addProfiling(mapping, "cghs::mapping");

    return spreadDensity
    (
        "dragResponse",
        suspension_.response(),
        dimDensity/dimTime
    );
}


Foam::tmp<Foam::volScalarField>
Foam::cghs::momentum::dissipation(const arena& parcels) const
{
    return spreadDensity
    (
        "dragDissipation",
        suspension_.dissipation(parcels),
        dimPower/dimVolume
    );
}


Foam::tmp<Foam::volScalarField>
Foam::cghs::momentum::yieldToVelocity() const
{
    addProfiling(mapping, "cghs::mapping");

    return spreadDensity
    (
        "yieldToVelocity",
        suspension_.yieldToVelocity(),
        dimless
    );
}


Foam::tmp<Foam::volScalarField>
Foam::cghs::momentum::yieldToGradient() const
{
    addProfiling(mapping, "cghs::mapping");

    return spreadDensity
    (
        "yieldToGradient",
        suspension_.yieldToGradient(),
        dimTime/dimDensity
    );
}

// * * * * * * * * * * * * * * * * Reports * * * * * * * * * * * * * * * * * //

Foam::List<Foam::cghs::figure> Foam::cghs::momentum::errors() const
{
    if (!limit_.valid())
    {
        return List<figure>();
    }

    // Less than that of the parcels' momentum drowns in its rounding
    constexpr scalar least = 1e-6;

    const vector defect(suspension_.received() + gained_);
    scalarField sums
    ({
        defect.x(), defect.y(), defect.z(), exchanged_, suspension_.carried()
    });
    reduce(sums, sumOp<scalarField>());

    const scalar scale = max(sums[3], least*sums[4]);

    return List<figure>
    ({
        {
            "momentumDefect",
            mag(vector(sums[0], sums[1], sums[2]))/max(scale, VSMALL)
        }
    });
}
