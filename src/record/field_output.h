/* field_output.h -- the files that ParaView shows, written from a snapshot. */
#ifndef RECORD_FIELD_OUTPUT_H
#define RECORD_FIELD_OUTPUT_H

#include "coupling/simulation.h"
#include "output/folder.h"
#include "output/vtk_file.h"
#include "record/snapshot.h"

struct field_output;

/* The collections of the phases of the simulation, of unstructured grids alone
 * if `grids` is not 0; NULL after a message. */
struct field_output *field_output_create(const struct simulation *sim,
                                         struct folder *folder, int grids);
void field_output_free(struct field_output *p);

/* The arrays of the files besides cells and centres. Both return their number.
 */
enum { FIELD_OUTPUT_ARRAYS = 16 };
int field_output_of_fluid(const struct simulation *sim,
                          const struct snapshot *s,
                          struct vtk_array arrays[FIELD_OUTPUT_ARRAYS]);
int field_output_of_particles(const struct snapshot *s,
                              struct vtk_array arrays[FIELD_OUTPUT_ARRAYS]);

/* Non-zero after a message. */
int field_output_add(struct field_output *p, const struct snapshot *s);

/* The files so far (state.h). */
void field_output_state(struct field_output *p, struct state *s);

/* The time of the last one [s]; -1 before the first. */
double field_output_last(const struct field_output *p);

#endif
