/* case_part.h -- a part of a case that a folder adds to the rooms' own.
 *
 * Its descriptor is named in the models.txt of the folder. Each function may be
 * NULL. Where a function returns a code, it is an exit code: 0, or another one
 * after a message.
 */
#ifndef CASE_CASE_PART_H
#define CASE_CASE_PART_H

#include "base/model.h"
#include "case/settings.h"
#include "coupling/simulation.h"
#include "dem/bed.h"

/* The smallest and the largest of some particles [m]; 0 if there are none. */
struct case_diameters {
    double min, max;
};

struct case_scales;

struct case_part {
    const struct key *keys; /* its table; NULL: it has none */
    int mesh_walls; /* [-] 1: it makes walls for particles of the boundary of
                       any mesh */

    /* Whether the particles that the case describes are possible. */
    int (*check)(const struct settings *s);
    /* The same for any case, with particles or without. */
    int (*check_any)(const struct settings *s);
    /* Changes the options of dem, before anything is created. */
    void (*dem_options)(const struct settings *s, struct dem_options *o);
    /* The sizes of the bed, where they are not all equal. */
    void (*bed_sizes)(const struct settings *s, struct bed_options *b);
    /* How many particles may be inserted after the start. */
    int (*count_later)(const struct settings *s);
    /* Their diameters, of one material or, if it is negative, of all. */
    struct case_diameters (*later_diameters)(const struct settings *s,
                                             int material);
    /* Prints its lines for `winnow check`. */
    void (*print)(const struct settings *s, const struct case_scales *k);
    /* Creates surfaces, attractions and sources before there are particles;
     * `free` releases them. */
    int (*complete)(const struct settings *s, struct simulation *sim,
                    struct dem_options *o);
    void (*free)(struct simulation *sim);
    /* The same, after the `complete` of all parts. */
    int (*complete_last)(const struct settings *s, struct simulation *sim,
                         struct dem_options *o);
    /* Whether particles can start where they were placed; may move them. */
    int (*place)(const struct settings *s, struct particles *ps,
                 const struct dem_options *o);
    /* The file that keeps a bed for which the case names none; 0: no file. */
    int (*bed_file)(const struct settings *s, char *path, size_t size);
    /* After the particles and their dem have been created. */
    int (*add)(const struct settings *s, struct simulation *sim);
    /* After all else has been created. */
    int (*add_last)(const struct settings *s, struct simulation *sim);
};

/* All of them, ended by NULL. */
extern const struct case_part *const case_parts[];

/* How many particles may be inserted after the start, by all parts. */
int case_part_count_later(const struct settings *s);

#endif
