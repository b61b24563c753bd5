# shellcheck shell=bash
#------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Functions for the run scripts of the tests:
#
#         #!/bin/bash
#         . "$PROJECT_DIR/tests/lib/testing.sh"
#         runApplication blockMesh
#         runApplication cghsFoam
#         result restHeight "$(relativeError "$height" 0.0125)" 1e-3
#
#     Sourcing it makes the script stop at the first command that fails. Logs
#     are called log.<application> and lie in the current folder.
#------------------------------------------------------------------------------
set -euo pipefail


# result CASE ERROR TOLERANCE [SECONDS]
result()
{
    echo "RESULT $*"
}


# skip CASE REASON...
skip()
{
    echo "SKIP $*"
}


# The value of an expression, to 15 digits: calculate '2*sqrt(3)'
calculate()
{
    awk "BEGIN { printf \"%.15g\n\", $* }"
}


# |value - reference|; what is no number gives nan, which no tolerance passes
absoluteError()
{
    awk -v a="$1" -v b="$2" 'BEGIN {
        if (a + 0 != a || b + 0 != b) print "nan"
        else printf "%.6g\n", (a > b ? a - b : b - a)
    }'
}


# |value - reference|/|reference|
relativeError()
{
    awk -v a="$1" -v b="$2" 'BEGIN {
        if (a + 0 != a || b + 0 != b || b + 0 == 0) print "nan"
        else printf "%.6g\n", (a > b ? a - b : b - a)/(b < 0 ? -b : b)
    }'
}


# Run a command with its output in the file $1; on failure show the last of it.
# Not named 'run', which is what the scripts of the tests are called.
runLogged()
{
    local log="$1" status=0
    shift
    "$@" > "$log" 2>&1 < /dev/null || status=$?
    [ "$status" -ne 0 ] || return 0
    echo "$* ended with status $status, see $PWD/$log:"
    tail -n 12 "$log"
    return "$status"
}


# runApplication NAME [ARGUMENT...]
runApplication()
{
    runLogged "log.$1" "$@"
}


# runParallel RANKS NAME [ARGUMENT...]
runParallel()
{
    local ranks="$1"
    shift
    runLogged "log.$1" mpirun -np "$ranks" "$@" -parallel
}


# setEntry FILE ENTRY VALUE, e.g. setEntry system/controlDict endTime 0.5
setEntry()
{
    runLogged log.foamDictionary foamDictionary "$1" -entry "$2" -set "$3"
}


# The last number that follows the text $2 in the file $1
lastValue()
{
    grep -oE -- "$2[ =:]*[-+]?[0-9.]+([eE][-+]?[0-9]+)?" "$1" | tail -n 1 \
  | grep -oE '[-+]?[0-9.]+([eE][-+]?[0-9]+)?$'
}


# A copy of a tutorial that has not been run: copyTutorial NAME FOLDER
copyTutorial()
{
    cp -r "$PROJECT_DIR/tutorials/$1" "$2"
    "$2/Allclean"
}


# None of the files may be absent or empty: expectFiles CASE FOLDER NAME...
expectFiles()
{
    local case="$1" folder="$2" missing=0 name
    shift 2
    for name
    do
        [ -s "$folder/$name" ] && continue
        echo "$case: there is no $folder/$name"
        missing=$((missing + 1))
    done
    result "$case" "$missing" 0
}


# The case must be refused, with OpenFOAM's error and each of the texts in it:
# expectRefusal CASE 'text' ['text'...] -- COMMAND...
expectRefusal()
{
    local case="$1" texts=() missing=0 text
    shift
    while [ "$1" != -- ]
    do
        texts+=("$1")
        shift
    done
    shift

    local log="log.$case"
    if "$@" > "$log" 2>&1 < /dev/null
    then
        echo "$case: accepted, but should have been refused"
        missing=1
    fi
    for text in 'FOAM FATAL' "${texts[@]}"
    do
        grep -qF -- "$text" "$log" && continue
        echo "$case: the error does not say: $text"
        missing=$((missing + 1))
    done
    result "$case" "$missing" 0
}
