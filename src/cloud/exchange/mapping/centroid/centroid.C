/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "centroid.H"
#include "fvMesh.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(centroid, 0);
    addToRunTimeSelectionTable(mappingModel, centroid, dictionary);
    describeModel
    (
        mappingModel,
        centroid,
        "to the cell of the centre: parcels much smaller than cells"
    );
}
}


Foam::cghs::centroid::centroid
(
    const dictionary& dict,
    const fvMesh& mesh,
    const scalar parcelDiameter,
    const labelUList&
)
{
    const scalar cell = cbrt(gAverage(mesh.V().field()));

    // Of one cell alone, and where parcels are in one plane, width says little
    const bool many = returnReduce(mesh.nCells(), sumOp<label>()) > 1;
    if (many && mesh.nGeometricD() == 3 && parcelDiameter > 0.5*cell)
    {
        IOWarningInFunction(dict)
            << "Parcels of " << parcelDiameter << " m, in cells that are "
            << cell << " m wide in the mean: centroid leaves all of a parcel in"
            << " the cell of its centre, so each that changes cells is a blow"
            << " to the fluid"
            << nl << "    Take mappingModel diffusion, larger cells, or smaller"
            << " parcels" << nl << endl;
    }
}
