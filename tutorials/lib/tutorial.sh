# shellcheck shell=bash
#------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What the Allruns of the tutorials share, on top of tests/lib/testing.sh.
#     Each finds the project that it, or the copy of it, lies in, and goes on
#     from there:
#
#         set -euo pipefail
#         cd "$(dirname "${BASH_SOURCE[0]}")"
#
#         PROJECT_DIR="$PWD"
#         while [ -n "$PROJECT_DIR" ] && [ ! -e "$PROJECT_DIR/etc/openfoam" ]
#         do
#             PROJECT_DIR="${PROJECT_DIR%/*}"
#         done
#         . "$PROJECT_DIR/tutorials/lib/tutorial.sh" \
#          || { echo "Allrun: $PWD is not within a cghsFoam" >&2; exit 1; }
#
#         readOptions quick long hours= -- "$@"
#         runOptions() { ...; }       # prints the file system/runOptions
#         prepare() { ...; }          # mesh and parcels
#
#         buildProject
#         beginOrContinue
#         runToEnd
#         conclude "$PWD"
#
#     here            the tutorial's folder
#     choice          the last option of those without a value, or 'default'
#     option[NAME]    the value of an option that has one
#     ranks           the number of cores
#     reached         the time from which the run goes on [s]
#     deadline        when the shell's SECONDS are as many, a run is to pause:
#                     set by the option hours=
#     ran, paused     'yes' once a solver has run, has stopped at the deadline
#------------------------------------------------------------------------------
export PROJECT_DIR
here="$PWD"


# Whatever stage fails: say so at the end, where it is seen
trap '[ "$?" -eq 0 ] || echo "Allrun: FAILED" >&2' EXIT

fail()
{
    echo "Allrun: $*" >&2
    exit 1
}


#------------------------------------------------------------------------------
# What is asked for
#------------------------------------------------------------------------------

# shellcheck disable=SC2034 # read by the Allruns
choice=default
# shellcheck disable=SC2034
declare -A option=()
ranks=$(($(nproc) < 2 ? 1 : 2))
deadline=


# readOptions NAME... -- ARGUMENT...: those with a value are given as 'NAME='.
# -serial and -np N are known to all.
# shellcheck disable=SC2034
readOptions()
{
    local known=" " all=
    while [ "$1" != -- ]
    do
        known+="$1 "
        all+="-${1/=/ VALUE} "
        shift
    done
    shift

    while [ $# -gt 0 ]
    do
        case "$1" in
            -serial)
                ranks=1 ;;
            -np)
                shift
                ranks="${1:-}" ;;
            -?*)
                case "$known" in
                    *" ${1#-} "*)
                        choice="${1#-}" ;;
                    *" ${1#-}= "*)
                        [ $# -gt 1 ] || fail "option '$1' needs a value"
                        option[${1#-}]="$2"
                        shift ;;
                    *)
                        refuseOption "$1" "$all" ;;
                esac ;;
            *)
                refuseOption "$1" "$all" ;;
        esac
        shift
    done
    [[ "$ranks" =~ ^[1-9][0-9]?$ ]] \
 || fail "-np needs a number of cores, 1 to 99"
    [ -z "${option[hours]:-}" ] || setDeadline "${option[hours]}"
}


# That many hours from the start of the Allrun
setDeadline()
{
    [[ "$1" =~ ^[0-9]*\.?[0-9]+$ ]] \
 || fail "-hours needs a number of hours, such as 2.5"
    deadline="$(awk -v h="$1" 'BEGIN { printf "%d", 3600*h }')"
}


refuseOption()
{
    fail "unknown option '$1': choose among $2-serial -np N"
}


#------------------------------------------------------------------------------
# Stages
#------------------------------------------------------------------------------

buildProject()
{
    # shellcheck source=/dev/null
    . "$PROJECT_DIR/etc/openfoam" || exit 1
    "$PROJECT_DIR/Allwmake"
    # shellcheck source=/dev/null
    . "$PROJECT_DIR/tests/lib/testing.sh"
}


# A new folder with the files of the tutorial's case: freshCase FOLDER
freshCase()
{
    rm -rf "$1"
    mkdir "$1"
    cp -r "$here/0.orig" "$here/constant" "$here/system" "$1"
    rm -rf "$1/constant/polyMesh" "$1/system/runOptions"
}


# The last time that has been written, of the whole case or of its ranks
latestTime()
{
    local place=.
    [ ! -d processor0 ] || place=processor0
    find "$place" -mindepth 1 -maxdepth 1 -type d -printf '%f\n' \
  | { grep -E '^[0-9]+(\.[0-9]*)?(e-?[0-9]+)?$' || echo 0; } \
  | sort -g | tail -n 1
}


# Is $1 less than $2?
isLess()
{
    awk -v a="$1" -v b="$2" 'BEGIN { exit !(a < b - 1e-9) }'
}


# To the folder of a run of the tutorial itself, its own, with -quick a new one
quickOrHere()
{
    if [ "$choice" = quick ]
    then
        freshCase quick
        cd quick || exit
    elif ! isLess 0 "$(latestTime)"
    then
        ./Allclean
    fi
}


# Prepare the run in the current folder, unless it has begun. One that has goes
# on with as many ranks as it was begun with, whatever is asked for now.
beginOrContinue()
{
    reached="$(latestTime)"
    if isLess 0 "$reached"
    then
        ranks="$(find . -maxdepth 1 -name 'processor[0-9]*' | wc -l)"
        ranks=$((ranks > 0 ? ranks : 1))
        runOptions > system/runOptions
        echo "continuing from t = $reached s; to start anew: ./Allclean"
    else
        runOptions > system/runOptions
        prepare
    fi
}


# One line on how the solver gets on: renewed each second on a terminal, a new
# one every 10 s elsewhere
showProgress()
{
    local line
    line="$(tail -c 20000 log.cghsFoam | awk '
        /^Time = / { t = $3 } /^progress / { p = $0 }
        END { if (p != "") printf "t = %.3f s, %s", t, p }')"
    [ -n "$line" ] || return 0
    if [ -t 1 ]
    then
        printf '\r\033[K%s' "$line"
    elif [ $((SECONDS - shown)) -ge 10 ]
    then
        shown="$SECONDS"
        echo "$line"
    fi
}


solver=
ran=
# shellcheck disable=SC2034 # read by the Allruns
paused=
stopSolver()
{
    [ -z "$solver" ] || kill "$solver" 2> /dev/null || true
    echo
    fail "interrupted; Allrun with the same options continues"
}
trap stopSolver INT TERM


# Run the solver of the current folder in the background and say how it gets on.
# Past the deadline the file 'stop' asks it to end with the next time that it
# writes, which takes the function object 'abort' in the case.
runSolver()
{
    local command=(cghsFoam) status=0 shown="$SECONDS"
    [ "$ranks" -eq 1 ] || command=(mpirun -np "$ranks" cghsFoam -parallel)

    echo "${command[*]}: to t = $endTime s, details in log.cghsFoam"
    rm -f stop
    # shellcheck disable=SC2034
    ran=yes
    "${command[@]}" >> log.cghsFoam 2>&1 < /dev/null &
    solver=$!
    while kill -0 "$solver" 2> /dev/null
    do
        # Often, as the solver takes no heed of a file from before it began
        sleep 0.2
        showProgress
        [ -z "$deadline" ] || [ "$SECONDS" -lt "$deadline" ] || touch stop
    done
    wait "$solver" || status=$?
    solver=
    rm -f stop
    [ ! -t 1 ] || echo

    if [ "$status" -ne 0 ] || [ "$(tail -n 20 log.cghsFoam | grep -cx End)" = 0 ]
    then
        tail -n 20 log.cghsFoam >&2
        fail "cghsFoam ended with status $status, see $PWD/log.cghsFoam"
    fi
}


# From the time 'reached' to the end that the case names, or to the deadline;
# then put the ranks' parts together
runToEnd()
{
    local endTime
    endTime="$(foamDictionary system/controlDict -entry endTime -value)"
    if isLess "$reached" "$endTime"
    then
        runSolver
        # shellcheck disable=SC2034
        ! isLess "$(latestTime)" "$endTime" || paused=yes
    else
        echo "t = $endTime s has been reached before"
    fi

    if [ "$ranks" -gt 1 ]
    then
        echo "reconstructPar"
        runApplication reconstructPar -newTimes
    fi
}


# The page of results and the checks of the given cases, and where the page is:
# conclude FOLDER CASE...
conclude()
{
    local folder="$1"
    shift
    echo
    "$here/evaluate" "$@"
    echo
    "$here/validate" "$@"
    echo
    echo "results: $folder/results/results.md"
}


#------------------------------------------------------------------------------
# One bed by several methods: the files of the folder methods, each of which is
# run, as constant/method, in a folder of its name. In place of the stages above
# the Allrun has
#
#     readOptions quick methods= hours= -- "$@"
#     chooseMethods NAME...
#     runOptions() { ...; }       # knows the method's name as $method
#
#     buildProject
#     runMethods
#------------------------------------------------------------------------------

# Those that the option methods= names, else the given ones:
# chooseMethods NAME...
chooseMethods()
{
    local method
    read -ra methods <<< "${option[methods]:-$*}"
    for method in "${methods[@]}"
    do
        [ -e "methods/$method" ] || fail "there is no method '$method':" \
            "choose among $(cd methods && echo *)"
    done
}


# Mesh, parcels, ranks
prepare()
{
    cp -r 0.orig 0
    runApplication blockMesh
    runApplication fillParcels
    [ "$ranks" -eq 1 ] || runApplication decomposePar
}


# Is it time to pause? Whoever calls is to get on by one written time, at least
isLate()
{
    [ -n "$ran" ] && [ -n "$deadline" ] && [ "$SECONDS" -ge "$deadline" ]
}


# Call a function with one value after the other, each with as many ranks as are
# asked for, until it is time to pause: inTurn FUNCTION VALUE...
inTurn()
{
    local run="$1" cores="$ranks" value
    shift
    for value
    do
        if isLate
        then
            paused=yes
            continue
        fi
        ranks="$cores"
        "$run" "$value"
    done
}


sayIfPaused()
{
    [ -z "$paused" ] || echo "paused: Allrun with the same options continues"
}


# The run of the method, in the folder of its name
simulate()
{
    local from="$PWD" method="$1"
    if [ ! -e "$method/constant/method" ]
    then
        freshCase "$method"
        cp "$here/methods/$method" "$method/constant/method"
    fi
    cd "$method" || exit
    echo "$method:"
    beginOrContinue
    runToEnd
    cd "$from" || exit
}


# One after the other, then the page of results, with the choice quick in the
# folder of that name
runMethods()
{
    local folder="$here"
    if [ "$choice" = quick ]
    then
        folder="$here/quick"
        mkdir -p "$folder"
        cd "$folder" || exit
    fi

    inTurn simulate "${methods[@]}"

    conclude "$folder" "$folder"
    sayIfPaused
}
