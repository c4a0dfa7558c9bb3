/* rows.h -- the particles in the layout of the contact loop.
 * Chapter "Particles and contact".
 *
 * Outside a run the particles are a structure of arrays (particles.h). During a
 * run each particle has two short rows of 32 and 64 bytes: the difference of
 * two rows contains everything that a contact needs to know of its pair, in two
 * operations, for any two diameters.
 */
#ifndef DEM_FAST_ROWS_H
#define DEM_FAST_ROWS_H

#include <math.h>

#include "dem/box_domain.h"
#include "dem/contact.h"
#include "dem/particles.h"

struct row_place {
    double x[3], R; /* [m] */
};

struct row_motion {
    double v[3], per_R; /* [m/s], [1/m] */
    double s[3], per_m; /* [m/s] R omega; [1/kg] */
};

/* What the contacts do to one. */
struct row_load {
    double F[3], zero;        /* [N] */
    double turn[3], zero_too; /* [N] sum n x F_t (r/(R_i + R_j)) = -T/R */
};

static inline void row_load_add(struct row_load *to,
                                const struct row_load *from)
{
    for (int k = 0; k < 3; k++) {
        to->F[k] += from->F[k];
        to->turn[k] += from->turn[k];
    }
}

/* An implicit drag -k v and an added mass m_a (implicit_drag.h). */
struct row_drag {
    double rate;            /* [1/s] r = k / (m + m_a) */
    double gain, gain_half; /* [-] g(r dt), g(r dt/2) */
    double per_m;           /* [1/kg] 1/(m + m_a) */
};

/* A ball of a clump (clumps.h); and what the contacts of a clump need of it. */
struct row_ball {
    double arm[3]; /* [m] from the centre of the clump */
    int of;        /* [-] number of the clump; -1: a single sphere */
};

struct row_clump {
    double per_m, per_I[6]; /* [1/kg]; [1/(kg m^2)] in the box */
};

struct rows {
    int n;
    struct box_domain box;
    const struct contact_law *law;
    int sweep_options; /* [-] of the contact loop (sweep.h) */
    struct row_place *place;
    struct row_motion *motion;
    struct row_motion *before; /* `motion` before the last kick; NULL without a
                                   budget of energy */
    double (*acceleration)[3]; /* [m/s^2] of the external force */
    double (*listed)[3];       /* [m] where each was when the list was last
                                  made, or was to be a little later */
    struct row_place *chosen;  /* where it was when the contacts were chosen; R:
                                  its radius and its margin, how far it may
                                  move until they are chosen again */
    struct row_drag *drag;     /* NULL without an implicit drag */
    double *drag_impulse;      /* [N s] the particles' own */
    struct row_ball *ball;     /* NULL: there are no clumps */
    struct row_clump *clump;   /* of each clump */
    double *own_inverse_mass;  /* [1/kg] 1/m of those that move as prescribed,
                                  else 0; NULL if none ever does */
    double step;               /* [s] that the rows are for */
    const int *id;             /* [-] the particles' own */
    const int *material; /* [-] of each, in the particles' own array; NULL if
                            all are of material 0 */
    int n_materials;     /* [-] */
    int wall_material;   /* [-] of the box */
};

struct rows *rows_create(int capacity, const struct box_domain *box);

/* Allocates the rows of the implicit drag if the particles have one. */
void rows_add_implicit_drag(struct rows *b, const struct particles *ps);

/* Copies particles begin .. end - 1 from the arrays into the rows, and back;
 * the positions written back are inside a periodic box. */
void rows_load(struct rows *b, const struct particles *ps, int begin, int end);
void rows_store(const struct rows *b, struct particles *ps, int begin, int end);

/* Of one, what depends on its mass: with an implicit drag in steps of b->step.
 */
void rows_load_mass(struct rows *b, const struct particles *ps, int i);

/* Velocity Verlet in one pass: v += kick F/m, then x += drift v. `load` is that
 * of the particles from begin on. The largest |v_x|, |v_y|, |v_z| raise what is
 * in fastest. */
void rows_advance(struct rows *b, int begin, int end,
                  const struct row_load *load, double kick, double drift,
                  double fastest[4]);

/* The velocities that a kick of one step with this load of particle i would
 * give. */
struct row_motion rows_kicked(const struct rows *b, int i,
                              const struct row_load *load);

/* The result of a check of the particles begin .. end - 1. */
struct rows_survey {
    int lost;         /* [-] particles outside of the box or not finite */
    int first_lost;   /* [-] the first of them, or -1 */
    int lost_through; /* [-] the surface that it passed through, or -1 */
};

struct rows_survey rows_check_lost(const struct rows *b, int begin, int end);

/* Records where the particles will be after `ahead` [s] with their present
 * velocities, as the positions of the list. */
void rows_record_positions(struct rows *b, int begin, int end, double ahead);

/* What margins were given: the least [m]; 1 if there was too little room for
 * one. */
struct rows_margins {
    double least;
    int narrow;
};

/* Gives each particle the margin `least` + time |v| at its present place, or
 * what is left of `room` beyond its way from where it was listed [m]. */
struct rows_margins rows_set_margins(struct rows *b, int begin, int end,
                                     double least, double time, double room);

/* The least that is left of a margin, -1 if one is used up [m]. */
double rows_margin_left(const struct rows *b, int begin, int end);

/* Squared distance of two places, nearest image [m^2]; the gap of particles i
 * and j, and that of a place and a side of the box [m]. */
static inline double rows_distance2(const struct box_domain *box,
                                    const double p[3], const double q[3])
{
    double r2 = 0.0;

    for (int k = 0; k < 3; k++) {
        const double dx = box_domain_nearest(box, k, p[k] - q[k]);
        r2 += dx * dx;
    }
    return r2;
}

static inline double rows_pair_gap(const struct rows *b, int i, int j)
{
    const struct row_place *const p = &b->place[i], *const q = &b->place[j];
    return sqrt(rows_distance2(&b->box, p->x, q->x)) - p->R - q->R;
}

static inline double rows_wall_gap(const struct box_domain *box,
                                   const struct row_place *p, int wall)
{
    return box_domain_gap(box, wall, p->x) - p->R;
}

#endif
