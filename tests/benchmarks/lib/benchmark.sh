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
