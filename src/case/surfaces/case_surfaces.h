/* case_surfaces.h -- the walls of a case besides its box, and prescribed
 * particles.  Chapter "Walls".
 */
#ifndef CASE_SURFACES_CASE_SURFACES_H
#define CASE_SURFACES_CASE_SURFACES_H

#include "case/settings.h"
#include "dem/surfaces/prescribed_particles.h"
#include "dem/surfaces/surface.h"

/* How many there are, the walls of a mesh counted as one. */
int case_surfaces_count(const struct settings *s);

/* Reads the files of the surfaces, which the settings keep: 0, or 2 after one
 * message. */
int case_surfaces_read(struct settings *s);
void case_surfaces_release(struct settings *s);

/* The surfaces of particles.surfaces, and the walls of the mesh. Their names
 * and triangles belong to the settings. */
struct surface *case_surfaces_create(const struct settings *s);
void case_surfaces_free(struct surface *list, int n);

/* Those of particles.prescribed, to be released with free(). */
struct prescribed_particle *
case_surfaces_create_prescribed(const struct settings *s);

/* Completes them but for their files. 0, or 2 after a message about what the
 * case says of them. */
int case_surfaces_check(struct settings *s);

#endif
