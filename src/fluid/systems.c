/* SPDX-License-Identifier: GPL-3.0-or-later */
/* systems.c -- creates and frees what a fluid computes with. */
#include "fluid/piso.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "linear/faces.h"
#include "fluid/deferred.h"
#include "fluid/face_jump.h"
#include "fluid/systems.h"

static int systems_has(const struct fluid *fl, enum boundary_kind kind)
{
    FOR_EACH_BOUNDARY_FACE (fl, b, j, f)
        if (b->kind == kind) return 1;
    return 0;
}

/* 1 if a slip wall is not normal to an axis. */
static int has_inclined_slip(const struct fluid *fl)
{
    FOR_EACH_BOUNDARY_FACE (fl, b, j, f) {
        const double *const S = mesh_S(fl->mesh, f);
        const double x = fabs(S[0]), y = fabs(S[1]), z = fabs(S[2]);
        const double smallest = fmin(fmin(x + y, y + z), z + x);
        if (b->kind == BOUNDARY_SLIP && smallest > 1e-12 * (x + y + z))
            return 1;
    }
    return 0;
}

/* 1 if the time scheme uses two old levels. */
static int two_steps(const struct fluid_options *o)
{
    return o->time != NULL && o->time->time_levels > 1;
}

/* All arrays, with their numbers and whether the flow needs them. `room` has
 * three a cell or one a face, whichever is more; `work` too, and one a boundary
 * face beyond. An own flux is needed where the last step's does not convect
 * momentum. */
static void allocate_arrays(struct fluid *fl)
{
    const struct fluid_options *const o = &fl->options;
    const int cells = fl->mesh->n_cells, faces = fl->mesh->n_faces;
    const int inner = fl->mesh->n_internal, acting = fl->faces->n;
    const int room = 3 * cells > acting ? 3 * cells : acting;
    const int work = (3 * cells > inner ? 3 * cells : inner) + faces - inner;
    const int coupled = o->coupled, biased = piso_nondissipative(fl);
    const int slip = systems_has(fl, BOUNDARY_SLIP), two = two_steps(o);
    const struct {
        double **at;
        int n, needed;
    } rows[] = {
        {&fl->u, 3 * cells, 1},
        {&fl->grad_p, 3 * cells, 1},
        {&fl->p, cells, 1},
        {&fl->eps, cells, 1},
        {&fl->eps_n, cells, coupled},
        {&fl->eps_nm1, cells, coupled},
        {&fl->phi, faces, 1},
        {&fl->F, 3 * cells, coupled},
        {&fl->eps_us, 3 * cells, coupled},
        {&fl->K, cells, coupled},
        {&fl->u_older, 3 * cells, two},
        {&fl->phi_older, faces, two},
        {&fl->momentum->diag, cells, 1},
        {&fl->momentum->defect, cells, 1},
        {&fl->momentum->diag3, 3 * cells, slip},
        {&fl->momentum->b, 3 * cells, 1},
        {&fl->momentum->H, 3 * cells, 1},
        {&fl->pressure->source, cells, coupled},
        {&fl->pressure->per_force, room, 1},
        {&fl->pressure->m_face, room, 1},
        {&fl->pressure->conductance, room, 1},
        {&fl->pressure->explicit_flux, room, 1},
        {&fl->pressure->work, work, 1},
        {&fl->jump->pressure_jump, inner, coupled},
        {&fl->jump->pressure_offset, inner, coupled},
        {&fl->jump->pressure_per_flux, inner, coupled},
        {&fl->jump->inertia, 3 * cells, coupled},
        {&fl->jump->smooth_force, 3 * cells, biased && o->pressure_shared},
        {&fl->levels->ddt, cells, 1},
        {&fl->levels->old_time_source, 3 * cells, 1},
        {&fl->levels->phi_old, faces, 1},
        {&fl->levels->convecting_flux_own, faces, ddt_uses_new_time(o)},
        {&fl->levels->ddt_older, cells, two},
        {&fl->levels->u_known, 3 * cells, two}};

    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        if (rows[i].needed) *rows[i].at = owner_doubles(fl, rows[i].n);
    if (!coupled) fl->eps_n = fl->eps_nm1 = fl->eps;
    fl->p_face = fl->pressure->work + (work - faces);
}

/* Geometric coefficients of each face, computed once. */
static void create_geometry(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;

    fl->geometry = owner_zeroed(fl, 1, sizeof *fl->geometry);
    fl->geometry->face_coefficient = owner_doubles(fl, m->n_faces);
    for (int f = 0; f < m->n_faces; f++) {
        const double *const S = mesh_S(m, f);
        fl->geometry->face_coefficient[f] =
            vector_dot(S, S) / vector_dot(S, mesh_d(m, f));
    }
}

/* --- a plane
 *
 * Where a mesh is one layer of cells between two slip walls, nothing flows
 * across the layer: the component of the velocity across it stays zero, and
 * those walls have no flux and no stress. Their faces do nothing then, and if
 * they are the last of the mesh, the loops over faces end before them. */

/* The part of the area vector of face f along axis k, and across it [m^2]. */
static double area_along(const struct mesh *m, int f, int k)
{
    return fabs(mesh_S(m, f)[k]);
}

static double area_across(const struct mesh *m, int f, int k)
{
    const double *const S = mesh_S(m, f);

    return fabs(S[(k + 1) % 3]) + fabs(S[(k + 2) % 3]);
}

static const double rounding = 1e-12; /* [-] of an area vector */

/* 1 if patch i is a slip wall normal to axis k. */
static int ends_layer(const struct fluid *fl, int i, int k)
{
    const struct mesh *const m = fl->mesh;
    const struct patch *const p = &m->patches[i];

    for (int f = p->first; f < p->first + p->n; f++)
        if (area_across(m, f, k) > rounding * area_along(m, f, k)) return 0;
    return fl->options.boundaries[i].kind == BOUNDARY_SLIP;
}

/* 1 if nothing but the faces from n on could move the fluid along axis k. */
static int lies_across(const struct fluid *fl, int n, int k)
{
    const struct mesh *const m = fl->mesh;
    const struct fluid_options *const o = &fl->options;
    int moves = o->mean_gradient[k] != 0.0 || o->keeps_flow[k];

    for (int f = 0; f < n && !moves; f++)
        moves = area_along(m, f, k) > rounding * area_across(m, f, k);
    for (int i = 0; i < m->n_patches; i++)
        for (int j = 0; j < m->patches[i].n && !moves; j++)
            moves = boundary_wall_velocity(&o->boundaries[i], j)[k] != 0.0;
    return !moves;
}

/* How many faces do something. */
static int faces_that_act(const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const int undisturbed = fl->options.undisturbed &&
                            fl->options.shared == NULL && fl->deferred == NULL;

    for (int k = 0; k < 3 && undisturbed; k++) {
        int i = m->n_patches;
        while (i > 0 && ends_layer(fl, i - 1, k))
            i--;
        if (i < m->n_patches && lies_across(fl, m->patches[i].first, k))
            return m->patches[i].first;
    }
    return m->n_faces;
}

static struct faces *systems_faces_of(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    struct faces *const f = owner_zeroed(fl, 1, sizeof *f);

    *f = (struct faces){.n_inner = m->n_internal,
                        .n = faces_that_act(fl),
                        .n_cells = m->n_cells,
                        .owner = m->owner,
                        .neighbour = m->neighbour,
                        .cell_start = m->cell_start,
                        .cell_face = m->cell_face,
                        .out = m->out,
                        .S = m->S,
                        .S_at = m->S_at};
    faces_divide(f);
    owner_join(fl, f->pieces);
    return f;
}

static struct preconditioned pressure_matrix(const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    double *const link = mesh_links(m);
    const struct preconditioned A =
        preconditioned_create(m->n_cells, m->n_internal, m->owner, m->neighbour,
                              fl->geometry->face_coefficient, link, m->V);

    free(link);
    return A;
}

void systems_own_residual(struct fluid *fl)
{
    struct momentum_system *const m = fl->momentum;
    const int n = 3 * fl->mesh->n_cells;

    if (m == NULL || m->own_residual != NULL)
        return; /* no arrays: an outline */
    m->own_residual = owner_doubles(fl, n);
    memcpy(m->own_residual, m->residual, (size_t)n * sizeof *m->residual);
    m->residual = m->own_residual;
}

/* Between two predictions of the velocity the pressure has its numbers of cells
 * and faces in the vectors of BiCGStab. In the fourth, `work`, are by turns the
 * residual, from the last solution of a step until the next step has begun; the
 * vectors of conjugate gradients, of which the third begins as the right-hand
 * side; and the pressures of the inner faces, until they have become a
 * gradient. Those of the boundary faces lie behind, and stay. While the
 * momentum equation is made, the others have the weights of its faces, where a
 * force at a face follows the convecting velocity, and the parts of its jump.
 */
static void create_solvers(struct fluid *fl)
{
    struct pressure_system *const p = fl->pressure;
    double *const work = p->work;
    const int n = fl->mesh->n_cells;

    p->resistance = p->boundary_conductance = p->per_force + n;
    p->per_flux = p->per_force + 2L * n;
    p->divergence = work + 2L * n;
    p->cg = owner_join(
        fl, cg_work_lent(n, (double *const[]){work, work + n, p->divergence}));
    fl->momentum->residual = work;
    double *const space[] = {p->per_force, p->m_face, p->conductance, work,
                             p->explicit_flux};
    fl->momentum->bicgstab = owner_join(fl, bicgstab_work_lent(n, space));
    if (fl->options.coupled || fl->deferred != NULL)
        fl->momentum->owner_weight = p->m_face;
    fl->jump->owner_part = p->conductance;
    fl->jump->neighbour_part = p->explicit_flux;
    fl->jump->upwind_bias = p->per_force;
    if (fl->options.outer_correctors > 0 || fl->options.shared != NULL)
        systems_own_residual(fl);
}

void systems_create(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const int n = m->n_cells;

    fl->momentum = owner_zeroed(fl, 1, sizeof *fl->momentum);
    fl->pressure = owner_zeroed(fl, 1, sizeof *fl->pressure);
    fl->jump = owner_zeroed(fl, 1, sizeof *fl->jump);
    fl->levels = owner_zeroed(fl, 1, sizeof *fl->levels);
    create_geometry(fl);
    /* Before the arrays, because it takes more memory while it is made. */
    if (fl->options.shared == NULL) fl->pressure->matrix = pressure_matrix(fl);
    owner_join(fl, fl->pressure->matrix.matrix);
    fl->deferred = owner_join(fl, deferred_create(fl));
    fl->faces = systems_faces_of(fl);
    allocate_arrays(fl);
    fl->momentum->matrix =
        owner_join(fl, ldu_create(n, m->n_internal, m->owner, m->neighbour,
                                  fl->faces->pieces));
    fl->momentum->matrix->diagonals = fl->momentum->diag3 != NULL ? 3 : 1;
    fl->momentum->oblique_slip = has_inclined_slip(fl);
    fl->pressure->pinned_cell = systems_has(fl, BOUNDARY_OUTLET) ? -1 : 0;
    create_solvers(fl);
}
