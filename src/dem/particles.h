/* particles.h -- spheres, as a structure of arrays.
 * Chapter "Particles and contact".
 *
 * One array a quantity, one entry a particle. The order of the particles
 * changes when they are sorted in space: a particle is identified by its id,
 * not by its index. An array with one row a particle can be attached, and is
 * then sorted with them.
 */
#ifndef DEM_PARTICLES_H
#define DEM_PARTICLES_H

#include <stddef.h>

#include "base/state.h"

struct particles {
    int n, capacity;
    int next_id;             /* [-] of the next one: an id is used once */
    double *x, *y, *z;       /* [m] centre */
    double *vx, *vy, *vz;    /* [m/s] velocity */
    double *wx, *wy, *wz;    /* [rad/s] angular velocity */
    double *d;               /* [m] diameter */
    double *m;               /* [kg] mass */
    double *ex, *ey, *ez;    /* [N] external force, constant during dem_run */
    double *cfx, *cfy, *cfz; /* [N] of contacts and attractions, at the end of
                                dem_run */
    int *id;                 /* [-] 0, 1, ... in the order of creation */
    int *material;           /* [-] number of it; NULL: all are of material 0 */
    /* Implicit drag and added mass (implicit_drag.h): NULL unless
     * particles_add_implicit_drag was called. */
    double *drag_coefficient; /* [kg/s] k of a drag -k v besides the external
                                 force */
    double *added_mass;       /* [kg] of fluid that accelerates with it */
    double *drag_impulse;     /* [N s] impulse of -k v, summed; 3 a particle */
    double *across; /* [-] diameter of a parcel over that of its grains, by
                       material; NULL: each particle is one grain */
    struct clumps
        *clumps; /* rigid bodies of some of them (clumps.h); or NULL */
    struct attachments *attached;
};

struct particles *particles_create(int capacity);
void particles_free(struct particles *ps);

/* One more sphere of the given diameter [m] and density [kg/m^3], at rest at x
 * [m]. Returns its index. */
int particles_add(struct particles *ps, const double x[3], double d,
                  double density);

/* Allocates drag_coefficient, added_mass and drag_impulse, all 0. A second call
 * has no effect. */
void particles_add_implicit_drag(struct particles *ps);

/* Adds a material number to each particle, initially 0. */
void particles_add_material(struct particles *ps);

/* `array`, with `width` numbers a particle, follows the particles from now on,
 * and is a part of their state, by its name and unit. All are borrowed: they
 * must stay as long as the particles do, or until the array is detached. */
void particles_attach(struct particles *ps, const char *name, const char *unit,
                      double *array, int width);
void particles_detach(struct particles *ps, const double *array);

/* A new array that is attached, all 0; it belongs to the particles. */
double *particles_new_array(struct particles *ps, const char *name,
                            const char *unit, int width);

/* Removes the particles i with removed[i]; the others keep their order. */
void particles_remove(struct particles *ps, const int *removed);

/* Puts the particle that was at order[i] to place i, for all arrays. */
void particles_permute(struct particles *ps, const int *order);

/* The same for share number 0 ... of - 1 of the arrays, by one thread each; of
 * is at most PARTICLES_SHARES, and all have so many doubles a particle to work
 * in. */
enum { PARTICLES_SHARES = 8 };
void particles_permute_share(struct particles *ps, const int *order, int share,
                             int of, double *work);

/* Visits all arrays, those that are attached too (state.h). */
void particles_state(struct particles *ps, struct state *s);

/* The largest diameter [m]; 0 without particles. */
double particles_widest(const struct particles *ps);

/* Volume of particle i [m^3]. */
double particles_volume(const struct particles *ps, int i);

/* A particle may be a parcel, which stands for several equal grains: their
 * number [-], which need not be whole, and their diameter [m]. What the fluid
 * does is done to grains; a contact, an average and a sum of volumes know the
 * parcel alone. */
static inline double particles_across(const struct particles *ps, int i)
{
    return ps->across == NULL
               ? 1.0
               : ps->across[ps->material != NULL ? ps->material[i] : 0];
}

static inline double particles_grains(const struct particles *ps, int i)
{
    const double l = particles_across(ps, i);
    return l * l * l;
}

static inline double particles_grain(const struct particles *ps, int i)
{
    return ps->d[i] / particles_across(ps, i);
}

#endif
