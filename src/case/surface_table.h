/* surface_table.h -- forces and torques on the surfaces: DIR/surfaces.csv.
 *
 * A row with each row of history.csv: of each surface the force and the torque,
 * as means since the row before, and the work that it has done so far.
 */
#ifndef CASE_SURFACE_TABLE_H
#define CASE_SURFACE_TABLE_H

#include "coupling/simulation.h"
#include "output/folder.h"

struct surface_table;

/* NULL after a message if it cannot be written. The simulation is borrowed and
 * has surfaces. */
struct surface_table *surface_table_create(const struct simulation *sim,
                                           struct folder *folder);
void surface_table_free(struct surface_table *t);

/* The rows so far, and what the next one needs (state.h). */
void surface_table_state(struct surface_table *t, struct state *s);

/* A row for the present time; non-zero after a message. No table, no row. */
int surface_table_add(struct surface_table *t);

#endif
