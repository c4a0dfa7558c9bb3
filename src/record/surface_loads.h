/* surface_loads.h -- what the grains do to some surfaces, in output.forces.
 * Chapter "Averaged flow".
 *
 * Force and torque are means since the row before, the torque about the point
 * of the body: that about the centre of a surface's motion, and the arm from
 * the point to where that centre was in the middle of the time, times the
 * force.
 */
#ifndef RECORD_SURFACE_LOADS_H
#define RECORD_SURFACE_LOADS_H

#include "base/state.h"
#include "coupling/simulation.h"

enum { SURFACE_LOADS_EACH = 6 };
extern const char *const surface_loads_columns[SURFACE_LOADS_EACH];

/* Those whose names stand in `names`, with blanks between; NULL if that is.
 * `centre` [m] is borrowed. */
struct surface_loads *surface_loads_create(const struct simulation *sim,
                                           const char *names,
                                           const double centre[3]);
void surface_loads_free(struct surface_loads *l);

/* Fills SURFACE_LOADS_EACH numbers: force [N] and torque [N m]. */
void surface_loads_row(struct surface_loads *l, double *row);

/* As the part of that number (state.h). */
void surface_loads_state(struct surface_loads *l, int number, struct state *s);

/* 1 if the word is one of those of a text. */
int surface_loads_has_word(const char *text, const char *word);

#endif
