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

/* rho eps_start / (gamma dt eps_phi): storage per superficial flux; and the
 * mobility of the cells. */
static void cell_mobilities(int first, int last, const struct fluid *fl)
{
    const struct piso *const ps = fl->piso;
    const double *restrict V = fl->mesh->V, *restrict eps = fl->eps;
    const double *restrict diag = ps->momentum->diag;
    const double *restrict storage = ps->storage, *restrict eps_phi =
                                                      fl->eps_phi;
    double *restrict per_flux = ps->per_flux, *restrict mobility = ps->mobility;

    for (int c = first; c < last; c++) {
        const double gamma = piso_gamma(fl, c);
        per_flux[c] = storage[c] / (gamma * V[c] * eps_phi[c]);
        mobility[c] = eps[c] * gamma * V[c] / diag[c];
    }
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

static void inner_mobilities(int first, int last, const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const double *restrict mobility = fl->piso->mobility, *restrict w = m->w;
    const int *restrict owner = m->owner, *restrict neighbour = m->neighbour;
    double *restrict m_face = fl->piso->m_face;

    for (int f = first; f < last; f++)
        m_face[f] = 1.0 / ((1.0 - w[f]) / mobility[owner[f]] +
                           w[f] / mobility[neighbour[f]]);
}

static void conductances(int first, int last, const struct piso *ps)
{
    const double *restrict m_face = ps->m_face;
    const double *restrict SS = ps->SS, *restrict Sd = ps->Sd;
    double *restrict conductance = ps->conductance;

    for (int f = first; f < last; f++)
        conductance[f] = m_face[f] * SS[f] / Sd[f];
}

static void face_mobilities(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    struct piso *const ps = fl->piso;

    STRIPS_RUN(m->n_cells, 4, cell_mobilities, fl);
    STRIPS_RUN(m->n_internal, 4, inner_mobilities, fl);
    for (int i = 0; i < m->n_patches; i++) {
        const struct patch *const p = &m->patches[i];
        for (int f = p->first; f < p->first + p->n; f++)
            ps->m_face[f] = is_outlet(fl, i) ? ps->mobility[m->owner[f]] : 0.0;
    }
    STRIPS_RUN(m->n_faces, 4, conductances, ps);
}

static void fill_links(int first, int last, struct piso *ps)
{
    const double *restrict conductance = ps->conductance;
    const struct csr *const A = ps->pressure;
    double *restrict entry = A->a;

    for (int f = first; f < last; f++)
        entry[A->upper[f]] = entry[A->lower[f]] = -conductance[f];
}

static void fill_diagonal(int first, int last, const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const double *restrict conductance = fl->piso->conductance;

    for (int c = first; c < last; c++) {
        double sum = 0.0;
        for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++)
            sum += conductance[m->cell_face[a]];
        fl->piso->pressure->diag[c] = sum;
    }
}

void pressure_assemble(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    struct piso *const ps = fl->piso;
    struct csr *const A = ps->pressure;

    face_mobilities(fl);
    STRIPS_RUN(m->n_internal, 4, fill_links, ps);
    STRIPS_RUN(m->n_cells, 8, fill_diagonal, fl);
    if (ps->pinned >= 0) /* no outlet: one cell ties the level to zero */
        A->diag[ps->pinned] += A->diag[ps->pinned] + (m->n_cells == 1);
    multigrid_update(ps->mg, A);
}

static void drives(int first, int last, const struct fluid *fl)
{
    const double *restrict H = fl->piso->H, *restrict V = fl->mesh->V;
    const double *restrict inertia = fl->piso->inertia;
    double *restrict drive = fl->piso->drive;

    for (int c = first; c < last; c++) {
        const double share = piso_gamma(fl, c) * V[c];
        for (int k = 0; k < 3; k++)
            drive[3 * c + k] = (H[3 * c + k] - inertia[3 * c + k]) / share;
    }
}

static void inner_fluxes(int first, int last, struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const struct piso *const ps = fl->piso;
    const double *restrict per_flux = ps->per_flux, *restrict cells = ps->drive;
    const double *restrict m_face = ps->m_face, *restrict phi_old = ps->phi_old;
    double *restrict phi = fl->phi;

    for (int f = first; f < last; f++) {
        const int o = m->owner[f], n = m->neighbour[f];
        const double *const S = &m->S[3 * f], w = m->w[f];
        const double drive =
            (1.0 - w) * dot3(&cells[3 * o], S) + w * dot3(&cells[3 * n], S);
        const double storage = (1.0 - w) * per_flux[o] + w * per_flux[n];
        phi[f] = m_face[f] * (drive + storage * phi_old[f]);
    }
}

static void add_jumps(int first, int last, struct fluid *fl)
{
    for (int f = first; f < last; f++)
        fl->phi[f] += fl->piso->conductance[f] * jump_pressure(fl, f);
    for (int f = first; f < last && fl->piso->rest; f++)
        fl->phi[f] += fl->piso->conductance[f] * jump_of_rest(fl, f);
}

/* The part of grad p . S that an oblique link does not see, from the last
 * gradient, linear between the cells. */
static void add_oblique(int first, int last, struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const double *const G = fl->mean_gradient;

    for (int f = first; f < last; f++) {
        const double *const a = &fl->grad_p[3 * m->owner[f]];
        const double *const b = &fl->grad_p[3 * m->neighbour[f]];
        const double w = m->w[f];
        double rest[3], slope[3];
        mesh_oblique_part(m, f, rest);
        for (int k = 0; k < 3; k++)
            slope[k] = w * a[k] + (1.0 - w) * b[k] - G[k];
        fl->phi[f] -= fl->piso->m_face[f] * dot3(slope, rest);
    }
}

/* phi without the pressure's part. Walls and inlets keep theirs. */
static void driven_fluxes(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    struct piso *const ps = fl->piso;

    STRIPS_RUN(m->n_cells, 12, drives, fl);
    STRIPS_RUN(m->n_internal, 8, inner_fluxes, fl);
    if (ps->rest != NULL) jump_rest(fl);
    if (fl->options.coupled) STRIPS_RUN(m->n_internal, 8, add_jumps, fl);
    if (m->oblique) STRIPS_RUN(m->n_internal, 16, add_oblique, fl);
    for (int i = 0; i < m->n_patches; i++) {
        const struct patch *const p = &m->patches[i];
        for (int f = p->first; f < p->first + p->n && is_outlet(fl, i); f++) {
            const int o = m->owner[f];
            fl->phi[f] =
                ps->m_face[f] * (dot3(&ps->drive[3 * o], &m->S[3 * f]) +
                                 ps->per_flux[o] * ps->phi_old[f]);
        }
    }
}

/* Returns the sum of squares of what meets in the cells [(m^3/s)^2]. */
static double rhs_rows(int first, int last, const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const struct piso *const ps = fl->piso;
    const double *restrict phi = fl->phi, *restrict phi_old = ps->phi_old;
    double scale = 0.0;

    for (int c = first; c < last; c++) {
        double out = 0.0, through = fabs(ps->source[c]);
        for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
            const int f = m->cell_face[a];
            out += m->out[a] * phi[f];
            through += 0.5 * (fabs(phi[f]) + fabs(phi_old[f]));
        }
        ps->divergence[c] = -out - ps->source[c];
        scale += through * through;
    }
    return scale;
}

/* Right side of the pressure equation; returns the 2-norm of the fluxes that
 * meet in the cells, the scale of its residual [m^3/s]. */
static double pressure_rhs(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    struct piso *const ps = fl->piso;
    double scale;

    STRIPS_SUM(scale, m->n_cells, 8, rhs_rows, fl);
    for (int i = 0; i < m->n_patches; i++) {
        const struct patch *const p = &m->patches[i];
        for (int f = p->first; f < p->first + p->n && is_outlet(fl, i); f++)
            ps->divergence[m->owner[f]] +=
                ps->conductance[f] * fl->options.boundaries[i].pressure;
    }
    return sqrt(scale);
}

static void subtract_pressure(int first, int last, struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const double *restrict conductance = fl->piso->conductance;
    const double *restrict p = fl->p;
    double *restrict phi = fl->phi;

    for (int f = first; f < last; f++)
        phi[f] -= conductance[f] * (p[m->neighbour[f]] - p[m->owner[f]]);
}

static void add_pressure_fluxes(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const struct piso *const ps = fl->piso;

    STRIPS_RUN(m->n_internal, 4, subtract_pressure, fl);
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
    const int last = fl->report.correctors >= fl->options.correctors - 1;
    const struct solve_report report =
        cg_reduce(ps->pressure, ps->mg, ps->divergence, fl->p,
                  last ? 0.0 : fl->options.enough,
                  fl->options.tolerance * scale, 500, ps->cg);
    add_pressure_fluxes(fl);
    return report;
}
