/* surface_table.h -- what the surfaces feel: DIR/surfaces.csv.
 *
 * A row with each row of history.csv: of each surface the force and the torque,
 * as means since the row before, and the work that it has done so far.
 */
#ifndef SURFACE_TABLE_H
#define SURFACE_TABLE_H

#include "exchange/simulation.h"
#include "output/folder.h"

struct surface_table;

/* NULL after a message if it cannot be written. The simulation is borrowed and
 * has surfaces. */
struct surface_table *surface_table_create(const struct simulation *sim,
                                           struct folder *folder);
void surface_table_free(struct surface_table *t);

/* A row for the present time; non-zero after a message. No table, no row. */
int surface_table_add(struct surface_table *t);

#endif
