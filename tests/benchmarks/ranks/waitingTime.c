/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    Preloaded into a parallel run, this measures the CPU time that a rank
    spends in MPI, most of it busy waiting, and writes at the end

        waitingTime.<rank>: CPU time in all [s], CPU time in MPI [s]

    It stands between the program and the MPI calls that OpenFOAM makes.

\*---------------------------------------------------------------------------*/

#include <mpi.h>
#include <stdio.h>
#include <time.h>

static double inMPI = 0;

static double cpuTime(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return t.tv_sec + 1e-9*t.tv_nsec;
}

#define TIMED(name, parameters, arguments)                                     \
    int MPI_##name parameters                                                  \
    {                                                                          \
        const double start = cpuTime();                                        \
        const int status = PMPI_##name arguments;                              \
        inMPI += cpuTime() - start;                                            \
        return status;                                                         \
    }

TIMED
(
    Send,
    (const void* b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c),
    (b, n, t, to, tag, c)
)
TIMED
(
    Bsend,
    (const void* b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c),
    (b, n, t, to, tag, c)
)
TIMED
(
    Isend,
    (
        const void* b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c,
        MPI_Request* r
    ),
    (b, n, t, to, tag, c, r)
)
TIMED
(
    Recv,
    (
        void* b, int n, MPI_Datatype t, int from, int tag, MPI_Comm c,
        MPI_Status* s
    ),
    (b, n, t, from, tag, c, s)
)
TIMED
(
    Irecv,
    (
        void* b, int n, MPI_Datatype t, int from, int tag, MPI_Comm c,
        MPI_Request* r
    ),
    (b, n, t, from, tag, c, r)
)
TIMED
(
    Probe,
    (int from, int tag, MPI_Comm c, MPI_Status* s),
    (from, tag, c, s)
)
TIMED(Wait, (MPI_Request* r, MPI_Status* s), (r, s))
TIMED
(
    Waitall,
    (int n, MPI_Request r[], MPI_Status s[]),
    (n, r, s)
)
TIMED
(
    Reduce,
    (
        const void* b, void* a, int n, MPI_Datatype t, MPI_Op o, int root,
        MPI_Comm c
    ),
    (b, a, n, t, o, root, c)
)
TIMED
(
    Allreduce,
    (const void* b, void* a, int n, MPI_Datatype t, MPI_Op o, MPI_Comm c),
    (b, a, n, t, o, c)
)
TIMED
(
    Bcast,
    (void* b, int n, MPI_Datatype t, int root, MPI_Comm c),
    (b, n, t, root, c)
)
TIMED
(
    Alltoall,
    (
        const void* b, int n, MPI_Datatype t, void* a, int m, MPI_Datatype u,
        MPI_Comm c
    ),
    (b, n, t, a, m, u, c)
)
TIMED(Barrier, (MPI_Comm c), (c))

int MPI_Finalize(void)
{
    int rank;
    char name[32];
    FILE* file;

    PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
    snprintf(name, sizeof name, "waitingTime.%d", rank);
    file = fopen(name, "w");

    if (file)
    {
        fprintf(file, "%.6f %.6f\n", cpuTime(), inMPI);
        fclose(file);
    }

    return PMPI_Finalize();
}
