/* SPDX-License-Identifier: GPL-3.0-or-later */
/* pressure.c -- the flux through a face, and the pressure that makes the
 * fluxes meet continuity.
 *
 * On its way from P to N the fluid meets the material of P for d_P and that of
 * N for d_N. With the same superficial flux in both, each side has a pressure
 * gradient of its own, drive - phi / (m |S|), and they add up to p_N - p_P:
 *
 *   phi = m_f (drive_f . S + c_f phi_old - (p_N - p_P) S.S / S.d)
 *   1 / m_f = (1 - w) / m_P + w / m_N,   drive_f, c_f averaged alike
 *
 * So drag, which jumps with eps, enters a face as the pressure gradient does,
 * and a packed column has its exact pressure drop. (Where eps jumps, a step of
 * p_N - p_P belongs to the fluid's inertia: jump.c.) The term with phi_old
 * keeps the storage of momentum at the face itself: in a steady flow it cancels
 * from both sides, and the solution does not know the time step.
 */
#include "fluid/piso.h"

#include <math.h>
#include <string.h>

static double dot3(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static int is_outlet(const struct fluid *fl, int patch)
{
    return fl->options.boundaries[patch].kind == BOUNDARY_OUTLET;
}

/* rho eps_start / (gamma dt eps_phi): storage per superficial flux. */
static double storage_per_flux(const struct fluid *fl, int c)
{
    return fl->piso->storage[c] /
           (piso_gamma(fl, c) * fl->mesh->V[c] * fl->eps_phi[c]);
}

/* The same for the flux before it, if the scheme looks there. */
static double older_per_flux(const struct fluid *fl, int c)
{
    return fl->piso->storage_older[c] /
           (piso_gamma(fl, c) * fl->mesh->V[c] * fl->eps_start[c]);
}

/* A scheme of two steps: the flux before the last, with its storage. */
static void add_older_fluxes(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const struct piso *const ps = fl->piso;

    for (int f = 0; f < m->n_internal; f++)
        fl->phi[f] += ps->m_face[f] * fl->phi_older[f] *
                      ((1.0 - m->w[f]) * older_per_flux(fl, m->owner[f]) +
                       m->w[f] * older_per_flux(fl, m->neighbour[f]));
    for (int i = 0; i < m->n_patches; i++) {
        const struct patch *const p = &m->patches[i];
        for (int f = p->first; f < p->first + p->n && is_outlet(fl, i); f++)
            fl->phi[f] += ps->m_face[f] * fl->phi_older[f] *
                          older_per_flux(fl, m->owner[f]);
    }
}

static void face_mobilities(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    struct piso *const ps = fl->piso;

    for (int c = 0; c < m->n_cells; c++)
        ps->mobility[c] =
            fl->eps[c] * piso_gamma(fl, c) * m->V[c] / ps->momentum->diag[c];
    for (int f = 0; f < m->n_internal; f++)
        ps->m_face[f] = 1.0 / ((1.0 - m->w[f]) / ps->mobility[m->owner[f]] +
                               m->w[f] / ps->mobility[m->neighbour[f]]);
    for (int i = 0; i < m->n_patches; i++) {
        const struct patch *const p = &m->patches[i];
        for (int f = p->first; f < p->first + p->n; f++)
            ps->m_face[f] = is_outlet(fl, i) ? ps->mobility[m->owner[f]] : 0.0;
    }
    for (int f = 0; f < m->n_faces; f++) {
        const double *const S = &m->S[3 * f];
        ps->conductance[f] = ps->m_face[f] * dot3(S, S) / dot3(S, &m->d[3 * f]);
    }
}

void pressure_assemble(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    struct piso *const ps = fl->piso;
    struct csr *const A = ps->pressure;

    face_mobilities(fl);
    for (int f = 0; f < m->n_internal; f++)
        A->a[A->upper[f]] = A->a[A->lower[f]] = -ps->conductance[f];
    for (int c = 0; c < m->n_cells; c++) {
        A->diag[c] = 0.0;
        for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++)
            A->diag[c] += ps->conductance[m->cell_face[a]];
    }
    if (ps->pinned >= 0) /* no outlet: one cell ties the level to zero */
        A->diag[ps->pinned] += A->diag[ps->pinned] + (m->n_cells == 1);
    multigrid_update(ps->mg, A);
}

/* phi without the pressure's part. Walls and inlets keep theirs. */
static void driven_fluxes(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    struct piso *const ps = fl->piso;

    for (int c = 0; c < m->n_cells; c++)
        for (int k = 0; k < 3; k++)
            ps->drive[3 * c + k] = (ps->H[3 * c + k] - ps->inertia[3 * c + k]) /
                                   (piso_gamma(fl, c) * m->V[c]);
    for (int f = 0; f < m->n_internal; f++) {
        const int o = m->owner[f], n = m->neighbour[f];
        const double *const S = &m->S[3 * f], w = m->w[f];
        const double drive = (1.0 - w) * dot3(&ps->drive[3 * o], S) +
                             w * dot3(&ps->drive[3 * n], S);
        const double storage =
            (1.0 - w) * storage_per_flux(fl, o) + w * storage_per_flux(fl, n);
        fl->phi[f] = ps->m_face[f] * (drive + storage * ps->phi_old[f]);
        if (fl->options.coupled)
            fl->phi[f] += ps->conductance[f] * jump_pressure(fl, f);
    }
    for (int i = 0; i < m->n_patches; i++) {
        const struct patch *const p = &m->patches[i];
        for (int f = p->first; f < p->first + p->n && is_outlet(fl, i); f++) {
            const int o = m->owner[f];
            fl->phi[f] =
                ps->m_face[f] * (dot3(&ps->drive[3 * o], &m->S[3 * f]) +
                                 storage_per_flux(fl, o) * ps->phi_old[f]);
        }
    }
}

/* Right side of the pressure equation; returns the 2-norm of the fluxes that
 * meet in the cells, the scale of its residual [m^3/s]. */
static double pressure_rhs(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    struct piso *const ps = fl->piso;
    double scale = 0.0;

    for (int c = 0; c < m->n_cells; c++) {
        double out = 0.0, through = fabs(ps->source[c]);
        for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
            const int f = m->cell_face[a];
            out += m->owner[f] == c ? fl->phi[f] : -fl->phi[f];
            through += 0.5 * (fabs(fl->phi[f]) + fabs(ps->phi_old[f]));
        }
        ps->divergence[c] = -out - ps->source[c];
        scale += through * through;
    }
    for (int i = 0; i < m->n_patches; i++) {
        const struct patch *const p = &m->patches[i];
        for (int f = p->first; f < p->first + p->n && is_outlet(fl, i); f++)
            ps->divergence[m->owner[f]] +=
                ps->conductance[f] * fl->options.boundaries[i].pressure;
    }
    return sqrt(scale);
}

static void add_pressure_fluxes(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const struct piso *const ps = fl->piso;

    for (int f = 0; f < m->n_internal; f++)
        fl->phi[f] -=
            ps->conductance[f] * (fl->p[m->neighbour[f]] - fl->p[m->owner[f]]);
    for (int i = 0; i < m->n_patches; i++) {
        const struct patch *const p = &m->patches[i];
        const double outside = fl->options.boundaries[i].pressure;
        for (int f = p->first; f < p->first + p->n && is_outlet(fl, i); f++)
            fl->phi[f] -= ps->conductance[f] * (outside - fl->p[m->owner[f]]);
    }
}

struct solve_report pressure_correct(struct fluid *fl)
{
    struct piso *const ps = fl->piso;

    driven_fluxes(fl);
    if (ps->storage_older != NULL) add_older_fluxes(fl);
    if (mean_gradient_exists(&fl->options)) mean_gradient_add(fl);
    const double scale = pressure_rhs(fl);
    const struct solve_report report =
        cg_solve(ps->pressure, ps->mg, ps->divergence, fl->p, 0.0,
                 fl->options.tolerance * scale, 500, ps->cg);
    add_pressure_fluxes(fl);
    return report;
}
