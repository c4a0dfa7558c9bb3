/* piso.h -- what the files of the flow solver share: the geometry of faces, the
 * fluid's share of the pressure gradient, and the creation of the systems.
 * Chapter "Pressure".
 */
#ifndef FLUID_PISO_H
#define FLUID_PISO_H

#include "fluid/fluid.h"

struct face_geometry {
    double *SS, *Sd;          /* [m^2], [m^3] S.S and S.d of the faces */
    double *face_coefficient; /* [m] S.S / S.d: area over length of the link */
};

/* systems.c: creates and frees all arrays and systems of a fluid, for its mesh
 * and options. */
void systems_create(struct fluid *fl);
void systems_free(struct fluid *fl);

/* A loop over all boundary faces: b is the boundary condition of face f, which
 * is the j-th of its patch. */
#define FOR_EACH_BOUNDARY_FACE(fl, b, j, f)                                    \
    for (int i_ = 0; i_ < (fl)->mesh->n_patches; i_++)                         \
        for (const struct boundary *b = &(fl)->options.boundaries[i_];         \
             b == &(fl)->options.boundaries[i_]; b++)                          \
            for (int j = 0, f = (fl)->mesh->patches[i_].first;                 \
                 j < (fl)->mesh->patches[i_].n; j++, f++)

/* gamma: the fluid's share of the pressure gradient, eps in [XS11 2.8], 1 in
 * [XS11 2.4]. */
static inline double piso_gamma(const struct fluid *fl, int c)
{
    return fl->options.pressure_shared ? fl->eps[c] : 1.0;
}

/* 1: eps varies, and the convection scheme damps nothing. */
static inline int piso_nondissipative(const struct fluid *fl)
{
    return fl->options.coupled && !fl->options.convection->damps;
}

#endif
