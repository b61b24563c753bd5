# shellcheck shell=bash
#------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What the Allruns of the leaching reactors share, on top of
#     tutorials/lib/tutorial.sh: cases are made of the folders common and
#     reactor, and of one of the methods, whose name leaching.py knows.
#------------------------------------------------------------------------------

# freshCase FOLDER
freshCase()
{
    rm -rf "$1"
    mkdir "$1"
    cp -r "$here/../common/." "$here/../reactor/." "$1"
}


# Mesh, parcels, ranks
prepare()
{
    "$here/../vessel" "${PWD##*/}" > system/blockMeshDict
    runApplication blockMesh
    runApplication checkMesh
    grep -q '^Mesh OK' log.checkMesh || fail "see $PWD/log.checkMesh"
    cp -r 0.orig 0
    runApplication fillParcels
    [ "$ranks" -eq 1 ] || runApplication decomposePar
}
