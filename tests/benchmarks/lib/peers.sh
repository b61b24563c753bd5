# shellcheck shell=bash
#------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     OpenFOAM's own solvers of the Goldschmidt bed as benchmarks take them, on
#     top of benchmark.sh: 2 x 30 x 90 cells, and the same gas and drag for all.
#------------------------------------------------------------------------------
tutorials="$FOAM_TUTORIALS/lagrangian"


# MPPICFoam's tutorial has fewer cells
makeMesh()
{
    sed -i -e '/^ *hex.*(1 15 45)/s/(1 15 45)/(2 30 90)/' \
        "$1/system/blockMeshDict"
    runLogged "$1/log.blockMesh" blockMesh -case "$1"
}


# A tutorial of OpenFOAM: its own time step, our drag law and gas
makePeer()
{
    cp -r "$tutorials/$1/Goldschmidt" "$1"
    makeMesh "$1"
    setEntry "$1/constant/kinematicCloudProperties" subModels.particleForces \
        '{ ErgunWenYuDrag { alphac alpha.air; } gravity; }'
    setEntry "$1/constant/transportProperties" nu 1e-5
}


# Let it begin with parcels that are handed over to it, for so many steps:
# handSteps CASE STEPS
handSteps()
{
    setEntry "$1/constant/kinematicCloudProperties" \
        subModels.injectionModels '{}'
    setEntry "$1/system/controlDict" writeControl timeStep
    setEntry "$1/system/controlDict" writeInterval 1000000
    setEntry "$1/system/controlDict" endTime \
        "$(calculate "$2*$(entry "$1/system/controlDict" deltaT)")"
}
