/* SPDX-License-Identifier: GPL-3.0-or-later */
/* fluid_state.c -- what a checkpoint has of the fluid.  Chapter "Nothing is
 * lost".
 *
 * These are all fields of the last time levels; the matrices and the terms of a
 * step follow from them (systems.c lists all arrays). */
#include "fluid/fluid.h"

#include "fluid/face_jump.h"
#include "fluid/momentum_system.h"

static void cells_state(struct fluid *fl, struct state *s)
{
    const int n = fl->mesh->n_cells;

    state_reals(s, "u", "m/s", fl->u, n, 3);
    state_reals(s, "u_older", "m/s", fl->u_older, n, 3);
    state_reals(s, "p", "Pa", fl->p, n, 1);
    state_reals(s, "grad_p", "Pa/m", fl->grad_p, n, 3);
    state_reals(s, "eps", "-", fl->eps, n, 1);
    state_reals(s, "eps_n", "-", fl->eps_n, n, 1);
    state_reals(s, "eps_nm1", "-", fl->eps_nm1, n, 1);
    state_reals(s, "F", "N/m^3", fl->F, n, 3);
    state_reals(s, "K", "kg/(m^3 s)", fl->K, n, 1);
    state_reals(s, "eps_us", "m/s", fl->eps_us, n, 3);
    state_reals(s, "residual", "N", fl->momentum->residual, n, 3);
    state_reals(s, "smooth_force", "N/m^3", fl->jump->smooth_force, n, 3);
}

static void faces_state(struct fluid *fl, struct state *s)
{
    const int n = fl->mesh->n_faces;

    state_reals(s, "p_face", "Pa", fl->p_face, n, 1);
    state_reals(s, "phi", "m^3/s", fl->phi, n, 1);
    state_reals(s, "phi_older", "m^3/s", fl->phi_older, n, 1);
}

static void fluid_state_sums(struct fluid *fl, struct state *s)
{
    state_reals(s, "mean_gradient", "Pa/m", fl->mean_gradient, 3, 1);
    state_reals(s, "momentum_gained", "N s", fl->momentum_gained, 3, 1);
    state_reals(s, "relabelled", "N s", fl->relabelled, 3, 1);
    state_real(s, "replaced", "kg", &fl->replaced);
    state_reals(s, "replaced_momentum", "N s", fl->replaced_momentum, 3, 1);
}

void fluid_state(struct fluid *fl, struct state *s)
{
    state_begin(s, "fluid");
    state_real(s, "t", "s", &fl->t);
    state_real(s, "dt_older", "s", &fl->dt_older);
    cells_state(fl, s);
    faces_state(fl, s);
    fluid_state_sums(fl, s);
    state_end(s);
}
