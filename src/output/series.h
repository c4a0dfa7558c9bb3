/* series.h -- the .pvd collection: which file shows which time.
 *
 * DIR/fluid.pvd lists fluid/fluid_000000.vtr, fluid/fluid_000001.vtr, ... each
 * with its time. The collection is rewritten for each added file, so that it
 * can be opened during the run and never lists a file that does not exist.
 */
#ifndef OUTPUT_SERIES_H
#define OUTPUT_SERIES_H

#include "base/state.h"
#include "output/folder.h"
#include "output/vtk.h"

struct series;

/* Makes the folder DIR/NAME for files ending in .SUFFIX; NULL after a message.
 * Nothing else is written before the first series_add. */
struct series *series_create(const char *dir, const char *name,
                             const char *suffix);
/* The same in the folder of a run, which lists its files and is borrowed. */
struct series *series_in(struct folder *f, const char *name,
                         const char *suffix);
void series_free(struct series *s);

/* The files so far (state.h); a collection that is loaded lists these. */
void series_state(struct series *s, struct state *state);

/* How many files it lists. */
int series_count(const struct series *s);

/* The path of the file to write next; valid until series_add. */
const char *series_next(struct series *s);

/* Adds that file, now written, with its time [s], which must be later than all
 * others. Non-zero after a message if the collection could not be written. */
int series_add(struct series *s, double time);

/* What writes the next file of a series of a folder, and its path, listed;
 * NULL after a message. */
struct vtk_file *series_writer(const struct series *s);
const char *series_begin(struct series *s);

/* Write and add a whole file, as vtk.h. */
int series_add_particles(struct series *s, int n, const double *const x[3],
                         double time, int n_arrays,
                         const struct vtk_array *arrays);
int series_add_polygons(struct series *s, const struct vtk_polygons *p,
                        double time, int n_arrays,
                        const struct vtk_array *arrays);

#endif
