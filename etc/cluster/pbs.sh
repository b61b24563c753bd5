#!/bin/bash
#------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Script
#     qsub pbs.sh
#
# Description
#     As slurm.sh, for PBS, which does not say when the time is nearly over:
#     'timeout' does, and must be less than the walltime by as long as a step and
#     a write take. Copy it into the case under this name, and change the lines
#     below. It has not been tried: the tests have no PBS.
#
# Environment
#     CGHS_DIR    the folder of cghsFoam, on a file system that all nodes see;
#                 default ~/cghsFoam
#------------------------------------------------------------------------------
#PBS -N cghsFoam
#PBS -l select=1:ncpus=2:mpiprocs=2
#PBS -l walltime=24:00:00
#PBS -r y
#PBS -j oe

cd "${PBS_O_WORKDIR:-.}" || exit 1

# shellcheck source=/dev/null
. "${CGHS_DIR:-$HOME/cghsFoam}/etc/openfoam" || exit 1

# Debian's mpirun does not know PBS, and takes ssh to other nodes
export FOAMRUN_LAUNCHER="mpirun --hostfile $PBS_NODEFILE"

# --foreground: the signal is for foamRun alone, the ranks would die of it
timeout --foreground --preserve-status -s USR1 23.9h \
    foamRun -np "$(wc -l < "$PBS_NODEFILE")" "$@"
status=$?

# 75: it was asked to stop, and can go on
[ "$status" -ne 75 ] || qsub pbs.sh
exit "$status"
