#!/bin/bash
#------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Script
#     sbatch slurm.sh [OPTION OF foamRun...]
#
# Description
#     A job of Slurm that runs the case in the folder where sbatch is called, and
#     goes on with it until its end. Copy it into the case, and change the lines
#     below. Some minutes before the time limit the solver writes and stops, and
#     the job puts itself into the queue again; likewise when a node has failed.
#     doc/clusters.md says more.
#
# Environment
#     CGHS_DIR    the folder of cghsFoam, on a file system that all nodes see;
#                 default ~/cghsFoam
#------------------------------------------------------------------------------
#SBATCH --job-name=cghsFoam
#SBATCH --ntasks=2
#SBATCH --time=24:00:00
#SBATCH --signal=B:USR1@300
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output=log.slurm

cd "${SLURM_SUBMIT_DIR:-.}" || exit 1

# shellcheck source=/dev/null
. "${CGHS_DIR:-$HOME/cghsFoam}/etc/openfoam" || exit 1

foamRun "$@" &
run=$!

# Slurm tells this shell alone that the time is nearly over
told=
trap 'told=yes; kill -USR1 "$run"' USR1

# A signal ends 'wait', but not the run
while :
do
    told=
    wait "$run"
    status=$?
    [ -n "$told" ] || break
done

# 75: it was asked to stop, and can go on
[ "$status" -ne 75 ] || scontrol requeue "$SLURM_JOB_ID"
exit "$status"
