/* case_clumps.h -- the clumps of a case (dem/clumps.h).
 * Chapter "Fewer or other particles".
 */
#ifndef CASE_PARTICLES_CASE_CLUMPS_H
#define CASE_PARTICLES_CASE_CLUMPS_H

#include "case/settings.h"
#include "dem/clumps.h"

/* Makes the shapes of all clumps, and gives their sizes to beds, sources and
 * places that name one. 0, or 2 after a message. */
int case_clumps_make(struct settings *s);
void case_clumps_release(struct settings *s);

/* The balls of a file, times a scale; NULL after a message of the file. */
struct body_ball *case_clumps_file(const struct settings *s, const char *file,
                                   double scale, int *n);

/* Whether clumps can be together with all else of the case. 0, or 2 after a
 * message. */
int case_clumps_check(const struct settings *s);

/* 1 if the case has clumps and the effect of that key is for spheres alone. */
int case_clumps_refuse(const struct settings *s, const char *key);

/* The shape of that name, which is there; NULL of NULL. */
const struct clump_shape *case_clumps_shape(const struct settings *s,
                                            const char *name);

/* How many particles stand for n grains of that name, of a mixture at most [-].
 */
double case_clumps_balls(const struct settings *s, const char *name, double n);

/* The entry of particles.place that particle i comes from. */
int case_clumps_origin(const struct settings *s, int i);

/* The least share of their own volume that balls of the case have a mass for
 * [-]. */
double case_clumps_filled(const struct settings *s);

/* Particles for so many balls, to which clumps can be added if the case has
 * some. */
struct particles *case_clumps_particles(const struct settings *s, double n);

/* Adds one that the case places, of the density [kg/m^3]; its first ball is
 * particle *at. 0, or 2 after a message if a ball is not in the box. */
struct place_setup;
struct dem_options;
int case_clumps_place(const struct settings *s, struct particles *ps,
                      const struct dem_options *o, const struct place_setup *p,
                      const double x[3], double density, int *at);

/* Its lines for `winnow check`. */
void case_clumps_print(const struct settings *s);

#endif
