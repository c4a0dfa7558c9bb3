/* SPDX-License-Identifier: GPL-3.0-or-later */
/* processes_none.c -- the program on one machine. build/winnow-mpi has an
 * engine of its own (distributed/ranks/engine.c), and the linker then passes
 * this file over. */
#include "coupling/processes.h"

#include <stddef.h>

const struct processes_engine *const processes_engine = NULL;
