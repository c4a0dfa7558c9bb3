/* clumps.h -- rigid bodies of balls as grains.
 * Chapter "Fewer or other particles".
 *
 * The balls of a clump are particles as all others: contacts, histories and
 * loads are those of spheres. Only their motion is another. A clump has one
 * mass M, one centre X and one angular momentum L, and the places and
 * velocities of its balls follow from these:
 *
 *   M dV/dt = sum F,   dL/dt = sum (r x F + T),   x = X + r,   v = V + w x r
 *
 * Balls overlap, so that M and the moments of inertia are those of their union.
 * For sums over particles each ball has a share of the mass and of the volume;
 * the shares are such that the balls have the clump's centre of mass too.
 */
#ifndef DEM_CLUMPS_H
#define DEM_CLUMPS_H

#include "base/rotation.h"
#include "dem/box_domain.h"
#include "dem/particles.h"

struct clump_ball {
    double at[3]; /* [m] from the centre of mass, along the principal axes */
    double R;     /* [m] */
    double share; /* [-] of the mass and the volume */
};

/* All clumps of a name, which may differ in size; or some, of a mixture. */
struct clump_shape {
    const char *name;               /* borrowed */
    double share;                   /* [-] of its name, of any sum */
    const struct clump_shape *next; /* of the same name; NULL: none */
    int n;                          /* [-] balls */
    struct clump_ball *ball;
    double volume;       /* [m^3] of the union */
    double sauter;       /* [m] six volumes over the surface */
    double gyration[3];  /* [m^2] principal moments of inertia over the mass */
    double principal[4]; /* [-] quaternion: from the principal axes to those
                           that its balls were given in */
    double reach;        /* [m] from the centre to the farthest point */
};

/* The shape of n balls, of which each has R and, from the centre of mass, `at`
 * in a frame of its own, in which the union has these moments over its mass
 * (xx, xy, xz, yy, yz, zz). The balls are kept. 0, or 1 if no positive shares
 * have the centre of mass. */
int clumps_shape_make(struct clump_shape *s, int n, struct clump_ball *ball,
                      double volume, const double gyration[6]);

/* [m] of the sphere of the same volume. */
double clumps_shape_diameter(const struct clump_shape *s);

/* The diameter of the sphere around it over that of the same volume [-]. */
static inline double clumps_shape_around(const struct clump_shape *s)
{
    return 2.0 * s->reach / clumps_shape_diameter(s);
}

/* The diameter [m] of the smallest ball of one in a sphere of the diameter d
 * [m]; d without a shape. */
double clumps_least_ball(const struct clump_shape *s, double d);

/* The volume that a ball's share of the mass would fill over its own [-], the
 * least of all balls of a mixture; 1 without a shape. No contact has a smaller
 * effective mass than the smallest ball with so much of its mass. */
double clumps_least_filled(const struct clump_shape *first);

/* The shape of grain number i of a mixture, by the seed; of one alone itself,
 * and NULL of NULL. Diameters of a mixture are those of its first shape, and
 * the others are larger or smaller as they were given. */
const struct clump_shape *clumps_drawn(const struct clump_shape *first,
                                       int seed, long i);

struct clump {
    int shape;          /* [-] its number */
    int first;          /* [-] id of its first ball; the others follow */
    double scale;       /* [-] its size over that of the shape */
    double m, per_I[3]; /* [kg], [1/(kg m^2)] about its principal axes */
    double x[3], v[3];  /* [m], [m/s] of the centre of mass */
    double q[4];        /* [-] quaternion: from the principal axes to the box */
    double L[3];        /* [kg m^2/s] angular momentum, in the box */
};

struct clumps {
    int n, capacity;
    int n_shapes;
    const struct clump_shape *shape; /* borrowed */
    struct clump *item;
    int *of;    /* [-] the clump of each id; -1: a single sphere */
    int *index; /* [-] place of each id, after clumps_locate */
};

/* Adds clumps to the particles, to which they belong; none yet. */
void clumps_add_to(struct particles *ps, int n_shapes,
                   const struct clump_shape *shape);

/* One more, at x with the velocity v, orientation q (from the frame that its
 * balls were given in) and spin w [rad/s]; its balls become particles, the
 * first at the returned index. */
int clumps_add(struct particles *ps, int shape, double scale, double density,
               const double x[3], const double v[3], const double q[4],
               const double w[3]);

/* Grain number i of a mixture, turned at random, or without one a sphere: in a
 * sphere of the diameter d [m] around x with the velocity v [m/s]. */
void clumps_add_drawn(struct particles *ps, const struct clump_shape *first,
                      int seed, long i, double d, double density,
                      const double x[3], const double v[3]);

/* q of a turn by |r| [rad] about r; and of one of all turns at random, numbers
 * (i, j) of the seed. */
void clumps_turn(const double r[3], double q[4]);
void clumps_turn_at_random(unsigned long seed, long i, double q[4]);

/* 1 for a ball of a clump; and for two balls of one. */
static inline int clumps_own(const struct particles *ps, int i)
{
    return ps->clumps != NULL && ps->clumps->of[ps->id[i]] >= 0;
}

static inline int clumps_are_one(const struct particles *ps, int i, int j)
{
    const int *const of = ps->clumps->of;
    return of[ps->id[i]] >= 0 && of[ps->id[i]] == of[ps->id[j]];
}

/* The volume of a ball over that of a whole sphere [-]. */
double clumps_filled(const struct particles *ps, int i);

/* The diameter that the drag on particle i has [m]: of a ball that of Sauter of
 * its clump, six volumes over the surface, with which Ergun's equation holds
 * for grains of any shape; else that of a grain. */
double clumps_grain(const struct particles *ps, int i);

/* The diameter of the sphere of the volume of the clump of ball i [m]. */
double clumps_sphere(const struct particles *ps, int i);

/* Finds the particles of all balls, after the order of these has changed. */
void clumps_locate(const struct particles *ps);

/* Before the particles i with removed[i] go: the clumps that these are of, with
 * all balls. */
void clumps_remove(struct particles *ps, const int *removed);

/* Where one ball of a clump is marked, all are. */
void clumps_mark(const struct particles *ps, int *marked);

/* All velocities times a factor; the balls follow. */
void clumps_slow_down(struct particles *ps, double factor);

/* Kinetic energies [J] of the centres and about them. */
void clumps_energy(const struct clumps *l, double *translation,
                   double *rotation);

/* Visits them (state.h), after the ids of the particles. */
void clumps_state(struct particles *ps, struct state *s);

/* --- motion --------------------------------------------------------------- */

/* What a force F [N] and a torque T [N m] about the centre change in dt [s];
 * and the free motion. */
static inline void clumps_kick(struct clump *c, const double F[3],
                               const double T[3], double dt)
{
    const double per_mass = dt / c->m;

    for (int k = 0; k < 3; k++) {
        c->v[k] += per_mass * F[k];
        c->L[k] += dt * T[k];
    }
}

static inline void clumps_move(struct clump *c, const struct box_domain *box,
                               double dt)
{
    for (int k = 0; k < 3; k++)
        c->x[k] = box_domain_inside(box, k, c->x[k] + dt * c->v[k]);
}

static inline void clumps_drift(struct clump *c, const struct box_domain *box,
                                double dt)
{
    clumps_move(c, box, dt);
    rotation_advance(c->q, c->L, c->per_I, dt);
}

/* Where the balls of a clump are. */
struct clump_pose {
    double Q[3][3];  /* [-] */
    double w[3];     /* [rad/s] */
    double per_I[6]; /* [1/(kg m^2)] xx, xy, xz, yy, yz, zz, in the box */
};

static inline void clumps_pose_of(const double q[4], const double L[3],
                                  const double own[3], struct clump_pose *at)
{
    static const int row[6] = {0, 0, 0, 1, 1, 2},
                     column[6] = {0, 1, 2, 1, 2, 2};
    double *const per_I = at->per_I;

    rotation_matrix(q, at->Q);
    for (int i = 0; i < 6; i++) { /* one loop, so that it is taken apart */
        const double *const a = at->Q[row[i]], *const b = at->Q[column[i]];
        per_I[i] =
            a[0] * own[0] * b[0] + a[1] * own[1] * b[1] + a[2] * own[2] * b[2];
    }
    at->w[0] = per_I[0] * L[0] + per_I[1] * L[1] + per_I[2] * L[2];
    at->w[1] = per_I[1] * L[0] + per_I[3] * L[1] + per_I[4] * L[2];
    at->w[2] = per_I[2] * L[0] + per_I[4] * L[1] + per_I[5] * L[2];
}

static inline struct clump_pose clumps_pose(const struct clump *c)
{
    struct clump_pose at;

    clumps_pose_of(c->q, c->L, c->per_I, &at);
    return at;
}

/* From the centre to ball k [m], and its velocity [m/s]. */
static inline void clumps_ball(const struct clumps *l, const struct clump *c,
                               const struct clump_pose *at, int k, double r[3],
                               double v[3])
{
    const double *const from = l->shape[c->shape].ball[k].at;
    double around[3];

    for (int e = 0; e < 3; e++)
        r[e] = c->scale * vector_dot(at->Q[e], from);
    vector_cross(at->w, r, around);
    vector_along(c->v, 1.0, around, v);
}

/* n . (1/m) n at r from the centre, less the part 1/M of the whole: of two
 * that touch the sum of these is 1/m_eff, and an impulse J along n changes the
 * velocity at r along n by J/m_eff. */
static inline double clumps_turning(const double per_I[6], const double r[3],
                                    const double n[3])
{
    double w[3];

    vector_cross(r, n, w);
    return w[0] *
               (per_I[0] * w[0] + 2.0 * (per_I[1] * w[1] + per_I[2] * w[2])) +
           w[1] * (per_I[3] * w[1] + 2.0 * per_I[4] * w[2]) +
           per_I[5] * w[2] * w[2];
}

#endif
