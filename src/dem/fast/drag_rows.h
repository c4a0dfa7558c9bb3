/* drag_rows.h -- implicit drag and added mass in the layout of the contact
 * loop. Chapter "Which treatment is stable".
 *
 * A particle with an implicit drag (implicit_drag.h) has one more row, of r,
 * g(r dt), g(r dt/2) and 1/(m + m_a). Other cases have no such rows, and
 * bodies_advance does not read them.
 */
#ifndef DEM_FAST_DRAG_ROWS_H
#define DEM_FAST_DRAG_ROWS_H

#include "dem/fast/bodies.h"

/* The rows of the particles begin .. end - 1, for steps of b->step. */
void drag_rows_load(struct bodies *b, const struct particles *ps, int begin,
                    int end);

/* bodies_advance for particles with an implicit drag; the impulse of -k v is
 * added to b->drag_impulse. */
void drag_rows_advance(struct bodies *b, int begin, int end, double (*load)[8],
                       double kick, double drift, double fastest[4]);

#endif
