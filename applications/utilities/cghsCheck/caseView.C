/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "caseView.H"
#include "meshFreedom.H"
#include "PstreamReduceOps.H"

bool Foam::cghs::caseView::adjusts() const
{
    return
        fluid.valid()
     && runTime.controlDict().getOrDefault<bool>("adjustTimeStep", false);
}


Foam::scalar Foam::cghs::caseView::longestFluidStep() const
{
    const dictionary& control = runTime.controlDict();

    return
        adjusts()
      ? control.getOrDefault<scalar>("maxDeltaT", GREAT)
      : control.get<scalar>("deltaT");
}


Foam::scalar Foam::cghs::caseView::largestCourant() const
{
    return runTime.controlDict().getOrDefault<scalar>("maxCo", 1);
}


Foam::scalar Foam::cghs::caseView::volume() const
{
    return gSum(mesh.cellVolumes());
}


Foam::scalar Foam::cghs::caseView::height() const
{
    // Where there is no gravity, along the longest side
    const vector span(mesh.bounds().span());

    return mag(g) > 0 ? mag(cmptMag(g) & span)/mag(g) : cmptMax(span);
}


Foam::scalar Foam::cghs::caseView::crossSection() const
{
    return volume()/height();
}


Foam::scalar Foam::cghs::caseView::thickness() const
{
    const vector free(freedom(mesh));

    for (direction d = 0; d < 3; ++d)
    {
        if (free[d] == 0)
        {
            return mesh.bounds().span()[d];
        }
    }
    return 0;
}


Foam::scalarField Foam::cghs::caseView::cellSizes() const
{
    const scalar thin = thickness();
    const scalarField& volumes = mesh.cellVolumes();

    return
        thin > 0
      ? scalarField(sqrt(volumes/thin))
      : scalarField(cbrt(volumes));
}


Foam::scalar Foam::cghs::caseView::largestSpeed() const
{
    scalar speed = 0;
    for (label i = 0; i < cloud.parcels().size(); ++i)
    {
        speed = max(speed, mag(cloud.parcels().motions[i].v));
    }
    return returnReduce(speed, maxOp<scalar>());
}


Foam::scalar Foam::cghs::caseView::solidsStep
(
    const scalar diameter,
    const scalar speed
) const
{
    const scalar most = solution().get<scalar>("maxDeltaT");

    return
        touching()
      ? min
        (
            most,
            solution().get<scalar>("maxDisplacement")
           *diameter/max(speed, VSMALL)
        )
      : most;
}


Foam::labelList Foam::cghs::caseView::exits() const
{
    const parcelBoundary& boundary = cloud.transportStage().boundary();
    DynamicList<label> patches;

    const label nPatches = mesh.boundaryMesh().nNonProcessor();

    for (label patchi = 0; patchi < nPatches; ++patchi)
    {
        if (boundary.escapes(patchi))
        {
            patches.append(patchi);
        }
    }
    return labelList(std::move(patches));
}


Foam::scalar Foam::cghs::caseView::rho() const
{
    return gSum(fluid->rho().primitiveField()*mesh.V().field())/volume();
}


Foam::scalar Foam::cghs::caseView::mu() const
{
    return gSum(fluid->mu().primitiveField()*mesh.V().field())/volume();
}
