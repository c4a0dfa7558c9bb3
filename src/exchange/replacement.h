/* replacement.h -- particles that come or go in a coupled run.  Chapter 10.
 *
 * A particle that is inserted takes the place of as much fluid, and fluid takes
 * the place of a particle that is removed, at once and on the spot: nothing
 * flows because of it, and the pressure does not notice. (Were the fluid pushed
 * aside in one step instead, a grain would make a jet, and in a closed box
 * there would be no solution.) What the fluid still owes for a removed particle
 * is paid in the next step, in the cells where the particle was. So
 *
 *   momentum of fluid and particles - owed - (what came - what went)
 *
 * is kept as in a run in which no particle comes or goes.
 */
#ifndef EXCHANGE_REPLACEMENT_H
#define EXCHANGE_REPLACEMENT_H

#include "exchange/simulation.h"

struct replacement {
    double *eps_before; /* [-] fluid fraction before particles came or went */
    double *unpaid;     /* [N s/m^3] that the fluid owes for particles that were
                           removed, 3 a cell */
    double unpaid_sum[3]; /* [N s] its integral; 0 from the payment on */
};

struct replacement *replacement_create(int n_cells);
void replacement_free(struct replacement *r);

/* Before the particles marked in sim->life->gone are removed: keeps what the
 * fluid owes for them. */
void replacement_collect(struct simulation *sim);

/* After particles were removed, or inserted from index `first` on: averages
 * anew, replaces the fluid, and makes the drag terms of the next step. Non-zero
 * if a cell holds more solids than it has room for. */
int replacement_apply(struct simulation *sim, int first);

/* Takes what is unpaid [N s] out of the force F of the fluid's next step, given
 * as rows of 4 a cell (K, F) [N/m^3]. */
void replacement_charge(const struct replacement *r, int n_cells, double dt,
                        double *field);

/* The fluid has paid. */
void replacement_settle(struct replacement *r, int n_cells);

/* What came less what went since the run began: particles, and the fluid that
 * they replaced [N s]. */
void replacement_momentum(const struct simulation *sim, double brought[3]);

#endif
