# shellcheck shell=bash
#------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What the Allruns of the reactor in three dimensions share, on top of
#     tutorials/lib/tutorial.sh. Each has
#
#         readOptions quick factor= hours= -- "$@"
#         checkFactor DEFAULT
#         runOptions() { ...; }       # may use slowClock, clockOptions
#         folderOf() { ...; }         # prints the run's folder, '.' or a name
#
#         buildProject
#         shareCase
#         runReactor
#
#     factor          of the slow clock
#------------------------------------------------------------------------------
reactorCase="$PROJECT_DIR/tutorials/mto/common"
factor=1


checkFactor()
{
    factor="${option[factor]:-$1}"
    [[ "$factor" =~ ^[1-9][0-9]*$ ]] \
 || fail "-factor needs a whole number from 1"
}


# 8 h of the catalyst, in steps of half an hour, by a clock that is 'factor'
# times as fast as the flow, once that has had as long as such a step takes;
# with 1 the flow's first 360 s
slowClock()
{
    # shellcheck disable=SC2046 # three numbers
    clockOptions $(awk -v F="$factor" 'BEGIN {
        step = F > 1 ? 1800/F : 5
        printf("%.8g %.8g %.8g", step, F > 1 ? 17*step : 360, step) }')
}


# The slow clock and the means from a time on, to the end, and how often it is
# written: clockOptions FROM END INTERVAL. Ages of what leaves are those of the
# second half, up to what the clock shows at the end.
clockOptions()
{
    echo "slowFactor      $factor;"
    echo "slowFrom        $1;"
    echo "averageFrom     $1;"
    echo "endTime         $2;"
    echo "writeInterval   $3;"
    awk -v F="$factor" -v from="$1" -v end="$2" 'BEGIN {
        printf("agesFrom        %.8g;\n", 0.5*(from + end))
        printf("oldest          %.8g;\n", from + F*(end - from)) }'
    [ "$factor" -eq 1 ] || throughMouth
}


# What a slow clock feeds is more than the tube passes, 0.1 to 0.16 kg/s: the
# valve takes what is in the tube and, as the distance does not see the floor, a
# dome over it of 0.22 m and 40 mm as well, the nearest first
throughMouth()
{
    echo "valveReach      0.1;"
}


# Put the files that all cases of the reactor have beside those of the
# tutorial. What is there already stays, and is named where it differs.
shareCase()
{
    local name
    while read -r name
    do
        shareFile "$reactorCase/$name" "$name"
    done < <(cd "$reactorCase" && find 0.orig constant system -type f)
    shareFile "$PROJECT_DIR/tutorials/mto/0D/constant/reactions" \
        constant/reactions
}


# shareFile FILE NAME
shareFile()
{
    if [ ! -e "$here/$2" ]
    then
        mkdir -p "$(dirname "$here/$2")"
        cp "$1" "$here/$2"
    elif ! cmp -s "$1" "$here/$2"
    then
        echo "$2 differs from ${1#"$PROJECT_DIR"/} and is used as it is here;" \
            "to have that: rm $2"
    fi
}


# Has the run in the folder written a time?
hasBegun()
{
    [ -d "$1" ] && isLess 0 "$(cd "$1" && latestTime)"
}


# Has it begun, and not reached its end?
isPaused()
{
    hasBegun "$1" || return
    local endTime
    endTime="$(foamDictionary "$1/system/controlDict" -entry endTime -value)"
    isLess "$(cd "$1" && latestTime)" "$endTime"
}


# To the folder of the run, to go on or to begin. One that is quick begins anew,
# unless it was paused. Runs in other folders stay.
enterFolder()
{
    local folder="$1"
    if { [ "$choice" != quick ] && hasBegun "$folder"; } || isPaused "$folder"
    then
        cd "$folder" || exit
    elif [ "$folder" = . ]
    then
        "$reactorCase/clean" "$here" here
        shareCase
    else
        freshCase "$folder"
        cd "$folder" || exit
    fi
}


# Mesh, parcels, ranks
prepare()
{
    mkdir -p constant/triSurface
    "$here/vessel" constant/triSurface/reactor.stl
    runApplication surfaceFeatureExtract
    runApplication blockMesh
    runApplication snappyHexMesh -overwrite
    runApplication checkMesh
    grep -q '^Mesh OK' log.checkMesh || fail "see $PWD/log.checkMesh"
    rm -rf 0
    cp -r 0.orig 0
    runApplication fillParcels
    echo "mesh and parcels: $(lastValue log.checkMesh cells:) cells," \
        "$(grep -oE '[0-9]+ parcels' log.fillParcels | tail -n 1)"
    [ "$ranks" -eq 1 ] || runApplication decomposePar
}


runReactor()
{
    enterFolder "$(folderOf)"
    beginOrContinue
    runToEnd
    conclude "$PWD" "$PWD"
    sayIfPaused
}
