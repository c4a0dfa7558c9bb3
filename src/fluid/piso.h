/* piso.h -- what the files of the flow solver share: the geometry of faces, the
 * fluid's share of the pressure gradient, and the creation of the systems.
 * Chapter "Pressure".
 */
#ifndef FLUID_PISO_H
#define FLUID_PISO_H

#include "base/vector.h"
#include "fluid/fluid.h"
#include "linear/faces.h"

struct face_geometry {
    double *face_coefficient; /* [m] S.S / S.d: area over length of the link */
};

/* systems.c: creates all arrays and systems of a fluid, for its mesh and
 * options. */
void systems_create(struct fluid *fl);

/* A loop over all boundary faces that do something: b is the boundary condition
 * of face f, which is the j-th of its patch. */
#define FOR_EACH_BOUNDARY_FACE(fl, b, j, f)                                    \
    for (int i_ = 0; i_ < (fl)->mesh->n_patches &&                             \
                     (fl)->mesh->patches[i_].first < (fl)->faces->n;           \
         i_++)                                                                 \
        for (const struct boundary *b = &(fl)->options.boundaries[i_];         \
             b == &(fl)->options.boundaries[i_]; b++)                          \
            for (int j = 0, f = (fl)->mesh->patches[i_].first;                 \
                 j < (fl)->mesh->patches[i_].n; j++, f++)

/* S.S of a face [m^4]. */
static inline double piso_square(const struct fluid *fl, int f)
{
    return vector_dot(mesh_S(fl->mesh, f), mesh_S(fl->mesh, f));
}

/* gamma: the fluid's share of the pressure gradient, eps in [XS11 2.8], 1 in
 * [XS11 2.4, SX15 2b]. */
static inline double piso_gamma(const struct fluid *fl, int c)
{
    return fl->options.pressure_shared ? fl->eps[c] : 1.0;
}

/* 1: eps varies, and the convection scheme damps nothing. */
static inline int piso_nondissipative(const struct fluid *fl)
{
    return fl->options.coupled && !fl->options.convection->damps;
}

/* 1 if nothing but the equations of a step reads the fluxes and pressures of
 * the inner faces between its corrections. */
static inline int piso_alone(const struct fluid *fl)
{
    return !fl->options.coupled && fl->deferred == NULL &&
           fl->immersed == NULL && fl->options.shared == NULL;
}

/* What the time derivative takes from the previous steps.
 *
 *   (now eps_new u - old eps_old u_n + older eps_older u_nm1) rho V / dt
 *
 * The fluid fractions are those of the mass that has the velocity u: eps,
 * eps_n, eps_nm1 of struct fluid, or each one step earlier (ddt.c). */

struct time_levels {
    struct time_weights weights; /* [-] now, old, older of this step */
    /* The fluid fraction of the mass with the velocity u at the end of the step
     * and at its beginning, and one step earlier in a two-step scheme [-]. */
    const double *eps_new, *eps_old, *eps_older;
    double *ddt;             /* [kg/s] old rho eps_old V / dt */
    double *ddt_older;       /* [kg/s] -older rho eps_older V / dt, or NULL */
    double *old_time_source; /* [N] ddt u_n + ddt_older u_nm1 */
    double *phi_old;         /* [m^3/s] the flux before the step */
    /* The flux that convects momentum is phi_old or, if the scheme needs one of
     * its own, convecting_flux_own [m^3/s]. */
    const double *convecting_flux;
    double *convecting_flux_own;
    double *u_known;      /* [m/s] u extrapolated to the new time; NULL: u */
    double reweighted[3]; /* [N s] change of what is pending of the last gain,
                             because the step has changed */
};

/* ddt.c: sets the terms of the previous steps; sets the convecting flux of
 * an outer iteration; stores the terms for the next step. */
void ddt_begin(struct fluid *fl);
void ddt_renew_flux(struct fluid *fl);
void ddt_end(struct fluid *fl);

/* What follows of a gain of momentum, of 1 [-]: see schemes.h. */
double ddt_pending(const struct fluid *fl);

/* 1 if the step has outer iterations or a two-step scheme: convected mass and
 * flux are then those of the new time, not of the previous step. */
int ddt_uses_new_time(const struct fluid_options *o);

#endif
