/* case_surfaces.h -- the walls of a case besides its box, and prescribed
 * particles.
 */
#ifndef CASE_CASE_SURFACES_H
#define CASE_CASE_SURFACES_H

#include "base/key.h"
#include "dem/surfaces/prescribed_particles.h"
#include "dem/surfaces/surface.h"
#include "case/settings.h"

extern const struct key keys_surfaces[];

/* The surfaces of particles.surfaces, with their files read; *code is 0, or 2
 * after one message. Their names belong to the settings. */
struct surface *case_surfaces_create(const struct settings *s, int *n,
                                     int *code);
void case_surfaces_free(struct surface *list, int n);

/* Those of particles.prescribed, to be released with free(). */
struct prescribed_particle *case_surfaces_driven(const struct settings *s,
                                                 int *n);

/* For `check`: non-zero after a message if a file is no STL. */
struct wall_scales {
    int surfaces, triangles; /* [-] */
    double speed;            /* [m/s] highest of any point in the box */
};
int case_surfaces_measure(const struct settings *s, struct wall_scales *w);

/* For validate_case: 0, or 2 after one message. */
int case_surfaces_check(const struct settings *s);

#endif
