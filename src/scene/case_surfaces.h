/* case_surfaces.h -- the walls of a case besides its box, and driven particles.
 */
#ifndef CASE_SURFACES_H
#define CASE_SURFACES_H

#include "base/key.h"
#include "particles/driven.h"
#include "particles/surface.h"
#include "scene/settings.h"

extern const struct key keys_surfaces[];

/* The surfaces of particles.surfaces, with their files read; *code is 0, or 2
 * after one message. Their names belong to the settings. */
struct surface *case_surfaces_create(const struct settings *s, int *n,
                                     int *code);
void case_surfaces_free(struct surface *list, int n);

/* Those of particles.driven, to be released with free(). */
struct driven *case_surfaces_driven(const struct settings *s, int *n);

/* For `check`: non-zero after a message if a file is no STL. */
struct wall_scales {
    int surfaces, triangles; /* [-] */
    double speed;            /* [m/s] highest of any point in the box */
};
int case_surfaces_measure(const struct settings *s, struct wall_scales *w);

/* For checks_whole: 0, or 2 after one message. */
int case_surfaces_check(const struct settings *s);

#endif
