/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "diffusion.H"
#include "checkedEntry.H"
#include "knownEntries.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(diffusion, 0);
    addToRunTimeSelectionTable(mappingModel, diffusion, dictionary);
    describeModel
    (
        mappingModel,
        diffusion,
        "over some diameters, by diffusion: any parcels, any mesh"
    );

    //- More steps than this are not taken: they would cost more than the flow
    constexpr label maxSteps = 30;

    //- What the kernels spread as a Gaussian of width b would, b^2 over the
    //  square of the cell's side
    constexpr scalar kernelWidthSqr = 0.41;

    //- Least width in parcel diameters: there touching parcels, packed as
    //  densely as spheres can be, fill the cells in their middle
    constexpr scalar leastWidth = 0.48;
}
}


Foam::cghs::diffusion::diffusion
(
    const dictionary& dict,
    const fvMesh& mesh,
    const scalar parcelDiameter,
    const labelUList& plates
)
:
    mesh_(mesh),
    kernels_(parcelDiameter > 0 ? new cellKernels(mesh, plates) : nullptr),
    faces_(mesh, plates),
    nSteps_(0)
{
    const scalar width = scalarInRange(dict, "width", 0, GREAT);

    warnUnknownEntries(dict, wordList({"width"}));

    checkWidth(dict, width, parcelDiameter);
    setSteps(sqr(width*parcelDiameter)/4);
}


void Foam::cghs::diffusion::checkWidth
(
    const dictionary& dict,
    const scalar width,
    const scalar parcelDiameter
) const
{
    // The thickness of a two-dimensional mesh is no length of the flow
    if (mesh_.nGeometricD() < 3 || parcelDiameter <= 0)
    {
        return;
    }

    const scalar side = cbrt(gMin(mesh_.V().field()));
    const scalar needed =
        sqr(leastWidth) - kernelWidthSqr*sqr(side/parcelDiameter);

    if (sqr(width) < needed)
    {
        FatalIOErrorInFunction(dict)
            << "Entry width is " << width << " parcel diameters but must be"
            << " at least " << Foam::sqrt(needed) << nl
            << "The largest parcel is " << parcelDiameter << " m wide, the"
            << " smallest cell " << side << " m:" << nl
            << "a narrower kernel would leave less than no voidage in a packed"
            << " bed. Increase width, or take larger cells" << nl
            << exit(FatalIOError);
    }
}


void Foam::cghs::diffusion::setSteps(const scalar time)
{
    if (time <= 0)
    {
        return;
    }

    const scalar needed = time/faces_.limit();

    nSteps_ = min(label(min(needed, scalar(1e6))) + 1, maxSteps);

    if (nSteps_ == maxSteps)
    {
        WarningInFunction
            << "Spreading over a pseudo-time of " << time << " m^2 would need "
            << needed << " steps because of small cells; " << maxSteps
            << " are taken, and those cells spread less" << endl;
    }

    faces_.setStep(time/nSteps_);
}


void Foam::cghs::diffusion::spread(volScalarField& field) const
{
    for (label step = 0; step < nSteps_; ++step)
    {
        faces_.step(field);
    }
}


void Foam::cghs::diffusion::spread(volVectorField& field) const
{
    for (label step = 0; step < nSteps_; ++step)
    {
        faces_.step(field);
    }
}
