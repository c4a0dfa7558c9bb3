/* solve.h -- the two linear systems of a fluid step, solved by all ranks.
 * Chapter "Past one machine".
 *
 * Each rank hands in the rows of its own cells. PETSc solves the momentum
 * equation by BiCGStab with the diagonal as preconditioner, and the pressure by
 * conjugate gradients with its algebraic multigrid; PETSC_OPTIONS can choose
 * others, by the prefixes -u_ and -p_.
 */
#ifndef DISTRIBUTED_RANKS_SOLVE_H
#define DISTRIBUTED_RANKS_SOLVE_H

#include "distributed/ranks/partition.h"
#include "fluid/fluid.h"

struct solve;

struct solve *solve_create(const struct mesh *m, struct halo *h,
                           const struct face_places *places, MPI_Comm comm);
void solve_free(struct solve *s);

/* The hooks of the fluid; solve_shared is borrowed from the solve. */
const struct shared_solution *solve_shared(const struct solve *s);

/* All fields of the fluid that the next step begins with, to all copies. */
void solve_refresh(struct solve *s, struct fluid *fl);

#endif
