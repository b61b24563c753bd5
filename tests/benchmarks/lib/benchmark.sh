# shellcheck shell=bash
#------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What the benchmarks share, on top of tests/lib/testing.sh.
#------------------------------------------------------------------------------
. "$PROJECT_DIR/tests/lib/testing.sh"


# Progress, apart from the figures
say()
{
    echo "    ... $*" >&2
}


# The value of an entry: entry FILE NAME
entry()
{
    foamDictionary "$1" -entry "$2" -value
}


# runUntil CASE START END: let a case run from its time START to END [s], and
# write there alone
runUntil()
{
    setEntry "$1/system/controlDict" endTime "$3"
    setEntry "$1/system/controlDict" writeInterval "$(calculate "$3-$2")"
}
