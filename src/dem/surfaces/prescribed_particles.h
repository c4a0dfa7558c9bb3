/* prescribed_particles.h -- particles that move as prescribed.
 *
 * Chapter "Walls".
 *
 * During its prescribed motion a particle moves as a point of a rigid body,
 * alone or with all of a range of ids;
 * before and after it is free. In contacts it acts like a wall: its 1/m is 0.
 * Each step begins at the present position of the particle, so that the state
 * of a run consists of its particles and the time.
 */
#ifndef DEM_SURFACES_PRESCRIBED_PARTICLES_H
#define DEM_SURFACES_PRESCRIBED_PARTICLES_H

#include "dem/fast/rows.h"
#include "dem/surfaces/motion.h"

struct prescribed_particle {
    int id, last; /* [-] of the first, and of the last if it is larger */
    struct motion motion;
};

static inline int prescribed_last(const struct prescribed_particle *one)
{
    return one->last > one->id ? one->last : one->id;
}

/* As a case writes it. */
struct prescribed_setup {
    struct prescribed_particle of;
    int has_centre, has_last; /* [-] 1: of.motion.centre, of.last are given */
    struct motion_course course;
};

struct prescribed_particles {
    const struct prescribed_particle *list; /* borrowed */
    int n;                                  /* [-] particles of all ranges */
    int *range;                             /* [-] that of each of them */
    int *is_on; /* [-] 1: it is prescribed in this step */
    int n_ids;
    int *number; /* [-] of each id among them, or -1 */
    int n_found;
    struct prescribed_place {
        int index, number; /* [-] where it is now, rising, and which it is */
    } * found;
};

struct prescribed_particles *
prescribed_particles_create(const struct prescribed_particle *list, int n);

/* Finds the indices of these particles. */
void prescribed_particles_locate(struct prescribed_particles *d,
                                 const struct particles *ps);

/* Sets the velocities of those among begin ... end - 1 for a step from t to
 * t + dt [s]; dt = 0 gives those of the time t. Of those whose motion has ended
 * it clears the loads, from begin on, which would have acted in a kick [s];
 * NULL: there are none yet. Returns the energy that they gained by it [J]. */
double prescribed_particles_set_velocities(struct prescribed_particles *d,
                                           struct rows *b,
                                           const struct particles *ps,
                                           int begin, int end,
                                           struct row_load *load, double t,
                                           double dt, double kick);

/* After rows were loaded, fixed = 1: sets 1/m of the prescribed particles to 0;
 * fixed = 0: restores their own, for measurements. */
void prescribed_particles_set_mass(const struct prescribed_particles *d,
                                   struct rows *b, const struct particles *ps,
                                   int begin, int end, int fixed);

#endif
