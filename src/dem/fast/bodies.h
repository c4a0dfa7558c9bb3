/* bodies.h -- the particles in the layout of the contact loop.
 * Chapter "Particles and contact".
 *
 * Outside a run the particles are a structure of arrays (particles.h). During a
 * run each particle has two short rows of 32 and 64 bytes: the difference of
 * two rows contains everything that a contact needs to know of its pair, in two
 * operations, for any two diameters.
 */
#ifndef DEM_FAST_BODIES_H
#define DEM_FAST_BODIES_H

#include "dem/box_domain.h"
#include "dem/contact.h"
#include "dem/particles.h"

struct bodies {
    int n;
    struct box_domain box;
    const struct contact_law *law;
    double (*position_radius)[4]; /* [m] x, y, z, R */
    double (*velocity)[8]; /* v [m/s], 1/R [1/m], R omega [m/s], 1/m [1/kg] */
    double (*before)[8];   /* `velocity` before the last kick; NULL without a
                              budget of energy */
    double (*acceleration)[4]; /* [m/s^2] of the external force; 0 */
    double (
        *position_at_rebuild)[3]; /* [m] x, y, z when the list was last made */
    /* Of particles with an implicit drag (implicit_drag.h); else NULL. */
    double (*implicit_drag)[4];
    double *drag_impulse;     /* [N s] the particles' own */
    double *own_inverse_mass; /* [1/kg] 1/m of those that move as prescribed,
                                 else 0; NULL if none ever does */
    double step;              /* [s] that the rows are for */
    const int *id;            /* [-] the particles' own */
    const int *material; /* [-] of each, in the particles' own array; NULL if
                            all are of material 0 */
    int n_materials;     /* [-] */
    int wall_material;   /* [-] of the box */
};

struct bodies *bodies_create(int capacity, const struct box_domain *box);
void bodies_free(struct bodies *b);

/* Allocates the rows of the implicit drag if the particles have one. */
void bodies_add_implicit_drag(struct bodies *b, const struct particles *ps);

/* Copies particles begin .. end - 1 from the arrays into the rows, and back;
 * the positions written back are inside a periodic box. */
void bodies_load(struct bodies *b, const struct particles *ps, int begin,
                 int end);
void bodies_store(const struct bodies *b, struct particles *ps, int begin,
                  int end);

/* Velocity Verlet in one pass: v += kick F/m, then x += drift v. `load` holds
 * the contact force [N] and sum n x F_t (r/(R_i + R_j)) [N] of the particles
 * from begin on. The largest |v_x|, |v_y|, |v_z| raise what is in fastest. */
void bodies_advance(struct bodies *b, int begin, int end, double (*load)[8],
                    double kick, double drift, double fastest[4]);

/* The velocities that a kick of one step with this load of particle i would
 * give. */
void bodies_kicked(const struct bodies *b, int i, const double load[8],
                   double velocity[8]);

/* The result of a check of the particles begin .. end - 1. */
struct bodies_survey {
    double moved2;    /* [m^2] largest squared displacement since the
                         last rebuild */
    int lost;         /* [-] particles outside of the box or not finite */
    int first_lost;   /* [-] the first of them, or -1 */
    int lost_through; /* [-] the surface that it passed through, or -1 */
};

struct bodies_survey bodies_check_lost(const struct bodies *b, int begin,
                                       int end);

/* Records the present positions, as those of the last rebuild. */
void bodies_record_positions(struct bodies *b, int begin, int end);

#endif
