/* SPDX-License-Identifier: GPL-3.0-or-later */
/* main_mpi.c -- the program on several ranks.  Chapter "Past one machine".
 *
 *     mpirun -n N build/winnow-mpi run CASE -o DIR
 *
 * The first rank has the command line of build/winnow; the others serve. */
#include <petscsys.h>

#include "base/interrupt.h"
#include "distributed/ranks/engine.h"

int winnow_main(int argc, char **argv); /* main.c */

int main(int argc, char **argv)
{
    int rank, code;

    interrupt_hold(); /* in the threads of MPI, too: the first rank looks */
    if (PetscInitializeNoArguments() != 0) return 4;
    PetscPopSignalHandler();
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank == 0) {
        code = winnow_main(argc, argv);
        engine_stop(code);
    } else {
        code = engine_serve(argc, argv);
    }
    PetscFinalize();
    return code;
}
