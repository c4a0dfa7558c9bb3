/* SPDX-License-Identifier: GPL-3.0-or-later */
/* non_orthogonal.c -- the part of the pressure gradient that the difference of
 * the pressures of two cells does not give, because their link is not normal to
 * the face.
 */
#include "fluid/deferred.h"

#include <math.h>

#include "base/vector.h"
#include "linear/faces.h"
#include "fluid/systems.h"
#include "fluid/piso.h"

/* The pressure gradient that balances the momentum equation of a cell [Pa/m]
 * with the present velocities of its neighbours. */
static void balancing_gradient(const struct fluid *fl, int c, double slope[3])
{
    const struct momentum_system *const momentum = fl->momentum;

    for (int k = 0; k < 3; k++) {
        const int i = 3 * c + k;
        slope[k] = (momentum->H[i] + fl->levels->old_time_source[i] -
                    momentum->diag[c] * fl->u[i]) *
                       fl->pressure->per_force[c] -
                   fl->mean_gradient[k];
    }
}

/* S - d S.S / S.d, but not longer than two areas, as it is on links at 63
 * degrees to the normal: beyond, it would amplify itself from corrector to
 * corrector in flat tetrahedra. What is left out of the flux is of the order of
 * the square of the mesh width. */
static void oblique_part(const struct fluid *fl, int f, double oblique[3])
{
    const double max = 2.0; /* [-] */

    mesh_oblique_part(fl->mesh, f, oblique);
    const double square =
        vector_dot(oblique, oblique) / (max * max * piso_square(fl, f));
    for (int k = 0; k < 3 && square > 1.0; k++)
        oblique[k] /= sqrt(square);
}

/* The non-orthogonal part of grad p . S, linear between the cells. With the
 * gradient of the last correction, and cells strongly coupled by viscosity, the
 * correctors would diverge for a shear above 1/sqrt(8): their factor solves x^2
 * + 2 r x - r = 0, with r the fraction of the non-orthogonal part. With the
 * gradient that balances the momentum equation the factor is -r. */
FACE_KERNEL non_orthogonal_flux(int f, int o, int n, const void *with)
{
    const struct fluid *const fl = with;
    const double w = fl->mesh->w[f];
    double oblique[3], a[3], b[3];

    oblique_part(fl, f, oblique);
    balancing_gradient(fl, o, a);
    balancing_gradient(fl, n, b);
    fl->phi[f] -=
        fl->pressure->m_face[f] *
        (w * vector_dot(a, oblique) + (1.0 - w) * vector_dot(b, oblique));
}

void deferred_add_oblique_fluxes(struct fluid *fl)
{
    FOR_EACH_FACE(fl->faces, 16, non_orthogonal_flux, fl);
}
