# shellcheck shell=bash
#------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Beds of any size in the same state, for the benchmarks of scaling: a box
#     of 10 000 parcels at a solids fraction of 0.5 is run until its parcels
#     have long forgotten how they were filled in, then set side by side.
#------------------------------------------------------------------------------
. "$PROJECT_DIR/tests/benchmarks/lib/benchmark.sh"

benchmarkLib="$PROJECT_DIR/tests/benchmarks/lib"


# makeBox CASE NX NY NZ: an empty box of so many tiles of 22 mm and 11 cells
makeBox()
{
    cp -r "$benchmarkLib/bed" "$1"
    cat > "$1/system/blockMeshDict" << EOF
FoamFile { version 2.0; format ascii; class dictionary; object blockMeshDict; }

scale 22e-3;

vertices
(
    (0 0 0) ($2 0 0) ($2 $3 0) (0 $3 0)
    (0 0 $4) ($2 0 $4) ($2 $3 $4) (0 $3 $4)
);

blocks
(
    hex (0 1 2 3 4 5 6 7) ($((11*$2)) $((11*$3)) $((11*$4)))
        simpleGrading (1 1 1)
);

boundary
(
    inlet { type patch; faces ((0 3 2 1)); }
    outlet { type patch; faces ((4 5 6 7)); }
    walls { type wall; faces ((0 1 5 4) (3 7 6 2) (0 4 7 3) (1 2 6 5)); }
);
EOF
    runLogged "$1/log.blockMesh" blockMesh -case "$1"
}


# One tile, run for 0.1 s, in the folder 'tile'
makeTile()
{
    say "one tile of 10 000 parcels, run for 0.1 s"
    makeBox tile 1 1 1
    runLogged log.fillParcels fillParcels -case tile
    runLogged log.tile cghsFoam -case tile
}


# makeBed CASE NX NY NZ STEPS [TILES]: a bed of all its tiles, or of the first
# TILES, that is to run for so many steps of 1e-4 s
makeBed()
{
    makeBox "$1" "$2" "$3" "$4"
    "$benchmarkLib/tile.py" tile "$1" "$2" "$3" "$4" "${6:-}"
    runUntil "$1" 0 "$(calculate "1e-4*$5")"
}
