/* bodies.h -- the particles as the contact loop wants them.  Chapter 2.
 *
 * Outside a run the particles are a structure of arrays (particles.h). Within
 * one they are two short rows each, 32 and 64 bytes: the difference of two
 * rows is all that a contact needs to know of its pair, in two operations,
 * whatever the sizes of the two.
 */
#ifndef BODIES_H
#define BODIES_H

#include "particles/particles.h"

/* The box they are in: six walls, or fewer where a direction is periodic. */
struct domain {
    double lo[3], hi[3]; /* [m] */
    int periodic[3];     /* [-] 1 where hi is lo again */
    double length[3];    /* [m] hi - lo if periodic, else 0 */
    double inverse[3];   /* [1/m] 1 / (hi - lo) if periodic, else 0 */
};

struct domain bodies_domain(const double lo[3], const double hi[3],
                            const int periodic[3]);

/* x in a periodic direction k, brought back between lo and hi; in others x. */
double bodies_inside(const struct domain *box, int k, double x);

struct bodies {
    int n;
    struct domain box;
    double (*place)[4];  /* [m] x, y, z, R */
    double (*motion)[8]; /* v [m/s], 1/R [1/m], R omega [m/s], 1/m [1/kg] */
    double (*push)[4];   /* [m/s^2] of the outside force; 0 */
    double (*mark)[3];   /* [m] x, y, z when the list was last made */
    /* Of particles that are held back (response.h); else NULL. */
    double (*response)[4];
    double *resisted;    /* [N s] the particles' own */
    double step;         /* [s] that the rows are for */
    const int *id;       /* [-] the particles' own */
    const int *material; /* [-] of each, in the particles' own array; NULL if
                            all are of material 0 */
    int n_materials;     /* [-] */
    int wall_material;   /* [-] of the box */
};

struct bodies *bodies_create(int capacity, const struct domain *box);
void bodies_free(struct bodies *b);

/* Rows for what holds the particles back, if anything does. */
void bodies_hold_back(struct bodies *b, const struct particles *ps);

/* Particles begin .. end - 1 from the arrays into the rows, and back. Back in
 * the arrays, they are inside of a periodic box. */
void bodies_fetch(struct bodies *b, const struct particles *ps, int begin,
                  int end);
void bodies_park(const struct bodies *b, struct particles *ps, int begin,
                 int end);

/* Velocity Verlet in one pass: v += kick F/m, then x += drift v. `load` holds
 * the contact force [N] and sum n x F_t (r/(R_i + R_j)) [N] of the particles
 * from begin on. The largest |v_x|, |v_y|, |v_z| raise what is in fastest. */
void bodies_advance(struct bodies *b, int begin, int end, double (*load)[8],
                    double kick, double drift, double fastest[4]);

/* What one finds by looking at the particles begin .. end - 1. */
struct bodies_survey {
    double moved2; /* [m^2] largest squared distance from the mark */
    int lost;      /* [-] particles outside of the box or not finite */
    int first;     /* [-] the first of them, or -1 */
    int through;   /* [-] the surface that it went through, or -1 */
};

struct bodies_survey bodies_look(const struct bodies *b, int begin, int end);

/* Marks where they are now. */
void bodies_mark(struct bodies *b, int begin, int end);

#endif
