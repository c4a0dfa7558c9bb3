/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "distributed/ranks/solve.h"

#include <math.h>
#include <petscksp.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "fluid/face_jump.h"
#include "fluid/systems.h"
#include "fluid/piso.h"

_Static_assert(sizeof(PetscScalar) == sizeof(double),
               "PETSc of real numbers in double precision is needed: "
               "libpetsc-real-dev");

struct solve {
    struct shared_solution shared;
    const struct mesh *m;
    struct halo *h;
    const struct face_places *places;
    const unsigned char *own;
    int rows; /* [-] own cells */
    Mat A[2]; /* of momentum, of the pressure */
    KSP ksp[2];
    Vec b, x;
    double *entry, *diag; /* of the matrix: own rows; of all cells */
    double relabelled[3]; /* [N s] of all ranks */
};

/* The number of each cell's row, those of a rank one after the other. */
static PetscInt *row_numbers(const struct solve *s, MPI_Comm comm)
{
    const int n = s->m->n_cells;
    double *const number = alloc_doubles(n);
    PetscInt *const row = alloc_zeroed((size_t)n, sizeof *row);
    PetscInt end = s->rows;

    MPI_Scan(MPI_IN_PLACE, &end, 1, MPIU_INT, MPI_SUM, comm);
    PetscInt next = end - s->rows;
    for (int c = 0; c < n; c++)
        if (s->own[c]) number[c] = (double)next++;
    halo_refresh(s->h, 1, number);
    for (int c = 0; c < n; c++)
        row[c] = (PetscInt)number[c];
    free(number);
    return row;
}

/* The places of the entries of the own rows: the diagonal, and then face by
 * face; fill_entries takes the same order. */
static PetscInt list_entries(const struct solve *s, const PetscInt *row,
                             PetscInt *i, PetscInt *j)
{
    PetscInt n = 0;

    for (int c = 0; c < s->m->n_cells; c++)
        if (s->own[c]) i[n] = j[n] = row[c], n++;
    for (int f = 0; f < s->m->n_internal; f++) {
        const int o = s->m->owner[f], p = s->m->neighbour[f];
        if (s->own[o]) i[n] = row[o], j[n] = row[p], n++;
        if (s->own[p]) i[n] = row[p], j[n] = row[o], n++;
    }
    return n;
}

static void fill_entries(struct solve *s, const double *diag, int stride,
                         const double *upper, const double *lower, double sign)
{
    double *e = s->entry;

    for (int c = 0; c < s->m->n_cells; c++)
        if (s->own[c]) *e++ = diag[(long)stride * c];
    for (int f = 0; f < s->m->n_internal; f++) {
        if (s->own[s->m->owner[f]]) *e++ = sign * upper[f];
        if (s->own[s->m->neighbour[f]]) *e++ = sign * lower[f];
    }
}

static void create_matrix(struct solve *s, int which, PetscInt n, PetscInt *i,
                          PetscInt *j, MPI_Comm comm)
{
    PC pc;
    KSP *const ksp = &s->ksp[which];

    halo_must(MatCreate(comm, &s->A[which]));
    halo_must(MatSetSizes(s->A[which], s->rows, s->rows, PETSC_DETERMINE,
                          PETSC_DETERMINE));
    halo_must(MatSetType(s->A[which], MATAIJ));
    halo_must(MatSetPreallocationCOO(s->A[which], n, i, j));
    halo_must(KSPCreate(comm, ksp));
    halo_must(KSPSetOptionsPrefix(*ksp, which ? "p_" : "u_"));
    halo_must(KSPSetType(*ksp, which ? KSPCG : KSPBCGS));
    halo_must(KSPGetPC(*ksp, &pc));
    halo_must(PCSetType(pc, which ? PCGAMG : PCJACOBI));
    if (which == 0) halo_must(KSPSetPCSide(*ksp, PC_RIGHT));
    halo_must(KSPSetNormType(*ksp, KSP_NORM_UNPRECONDITIONED));
    halo_must(KSPSetInitialGuessNonzero(*ksp, PETSC_TRUE));
    halo_must(KSPSetFromOptions(*ksp));
    if (which == 1) halo_must(KSPConvergedDefaultSetUIRNorm(*ksp));
}

static void create_systems(struct solve *s, MPI_Comm comm)
{
    const size_t most = (size_t)s->m->n_cells + 2 * (size_t)s->m->n_internal;
    PetscInt *const row = row_numbers(s, comm);
    PetscInt *const i = alloc_zeroed(most, sizeof *i);
    PetscInt *const j = alloc_zeroed(most, sizeof *j);

    for (int which = 0; which < 2; which++) { /* which may sort the lists */
        const PetscInt n = list_entries(s, row, i, j);
        create_matrix(s, which, n, i, j, comm);
    }
    s->entry = owner_zeroed(s, most, sizeof *s->entry);
    s->diag = owner_doubles(s, s->m->n_cells);
    halo_must(MatCreateVecs(s->A[0], &s->x, &s->b));
    free(row);
    free(i);
    free(j);
}

/* Own cells of every stride-th number, to or from a vector. */
static void solve_put(const struct solve *s, Vec v, const double *from,
                      int stride)
{
    double *x;

    halo_must(VecGetArray(v, &x));
    for (int c = 0, o = 0; c < s->m->n_cells; c++)
        if (s->own[c]) x[o++] = from[(long)stride * c];
    halo_must(VecRestoreArray(v, &x));
}

/* The other way: from the vector to every stride-th number of own cells. */
static void solve_take(const struct solve *s, Vec v, double *to, int stride)
{
    const double *x;

    halo_must(VecGetArrayRead(v, &x));
    for (int c = 0, o = 0; c < s->m->n_cells; c++)
        if (s->own[c]) to[(long)stride * c] = x[o++];
    halo_must(VecRestoreArrayRead(v, &x));
}

/* What PETSc says of its last solve. */
static struct solve_report report_of(KSP ksp)
{
    PetscInt iterations;
    PetscReal residual;
    KSPConvergedReason why;

    halo_must(KSPGetIterationNumber(ksp, &iterations));
    halo_must(KSPGetResidualNorm(ksp, &residual));
    halo_must(KSPGetConvergedReason(ksp, &why));
    return (struct solve_report){
        .iterations = (int)iterations, .after = residual, .converged = why > 0};
}

static struct solve_report solve_one(struct solve *s, int which,
                                     const double *b, double *x, int stride)
{
    halo_must(MatSetValuesCOO(s->A[which], s->entry, INSERT_VALUES));
    solve_put(s, s->b, b, stride);
    solve_put(s, s->x, x, stride);
    halo_must(KSPSetOperators(s->ksp[which], s->A[which], s->A[which]));
    halo_must(KSPSolve(s->ksp[which], s->b, s->x));
    solve_take(s, s->x, x, stride);
    return report_of(s->ksp[which]);
}

/* The scale of the tolerance is that of all three components, as on one
 * machine. */
static double norm_of(const struct solve *s, const double *b3)
{
    double sum = 0.0;

    for (int c = 0; c < s->m->n_cells; c++)
        for (int k = 0; k < 3 && s->own[c]; k++)
            sum += b3[3 * c + k] * b3[3 * c + k];
    halo_sum(s->h, 1, &sum);
    return sqrt(sum);
}

static struct solve_report solve_momentum(void *parts, struct fluid *fl,
                                          double tolerance)
{
    struct solve *const s = parts;
    const struct momentum_system *const m = fl->momentum;
    struct solve_report worst = {-1, 0.0, 0.0, 1};

    halo_must(KSPSetTolerances(s->ksp[0], 0.0, tolerance * norm_of(s, m->H),
                               PETSC_DEFAULT, 200));
    for (int k = 0; k < 3; k++) {
        fill_entries(s, momentum_diagonal(m) + (m->diag3 != NULL ? k : 0),
                     m->matrix->diagonals, m->matrix->upper, m->matrix->lower,
                     1.0);
        const struct solve_report r = solve_one(s, 0, m->H + k, fl->u + k, 3);
        if (r.iterations > worst.iterations || !r.converged) worst = r;
    }
    halo_refresh(s->h, 3, fl->u);
    return worst;
}

/* The matrix of the pressure has the row sums of its diagonal beside the
 * conductances of the faces. */
static struct solve_report solve_pressure(void *parts, struct fluid *fl,
                                          double relative, double absolute)
{
    struct solve *const s = parts;
    const struct pressure_system *const p = fl->pressure;

    for (int c = 0; c < s->m->n_cells; c++)
        s->diag[c] = p->boundary_conductance[c];
    for (int f = 0; f < s->m->n_internal; f++) {
        s->diag[s->m->owner[f]] += p->conductance[f];
        s->diag[s->m->neighbour[f]] += p->conductance[f];
    }
    absolute = halo_largest(s->h, absolute);
    halo_must(
        KSPSetTolerances(s->ksp[1], relative, absolute, PETSC_DEFAULT, 500));
    fill_entries(s, s->diag, 1, p->conductance, p->conductance, -1.0);
    const struct solve_report r = solve_one(s, 1, p->divergence, fl->p, 1);
    halo_refresh(s->h, 1, fl->p);
    return r;
}

static void corrected(void *parts, struct fluid *fl)
{
    const struct solve *const s = parts;

    halo_refresh(s->h, 3, fl->u);
}

static double solve_residual(void *parts, const struct fluid *fl)
{
    const struct solve *const s = parts;
    const struct momentum_system *const m = fl->momentum;
    double worst = 0.0, largest = 0.0;

    fl->momentum->inertia = halo_largest(s->h, fl->momentum->inertia);
    for (int i = 0; i < 3 * s->m->n_cells; i++) {
        if (!s->own[i / 3]) continue;
        worst = fmax(worst, fabs(m->residual[i]));
        largest = fmax(largest, fabs(m->diag[i / 3] * fl->u[i]));
    }
    worst = halo_largest(s->h, worst);
    largest = halo_largest(s->h, largest);
    if (largest == 0.0) return 0.0;
    fl->momentum->inertia /= largest;
    return worst / largest;
}

void solve_refresh(struct solve *s, struct fluid *fl)
{
    memcpy(s->relabelled, fl->relabelled, sizeof s->relabelled);
    halo_refresh(s->h, 3, fl->u);
    halo_refresh(s->h, 1, fl->p);
    halo_refresh(s->h, 3, fl->grad_p);
    halo_refresh(s->h, 3, fl->momentum->residual);
    if (fl->jump->smooth_force != NULL)
        halo_refresh(s->h, 3, fl->jump->smooth_force);
    halo_refresh_faces(s->h, s->places, fl->phi);
    halo_refresh_faces(s->h, s->places, fl->p_face);
}

/* The reports of the own cells: what continuity_residual left in its work
 * space, and the momentum that averaging relabelled. */
static void solve_measure(struct solve *s, struct fluid *fl)
{
    const struct pressure_system *const p = fl->pressure;
    const double dt = fl->options.dt;
    double defect = 0.0, through = 0.0, cfl = 0.0, sum[3] = {0.0, 0.0, 0.0};

    for (int c = 0; c < s->m->n_cells; c++) {
        if (!s->own[c]) continue;
        const double flow = p->resistance[c];
        defect = fmax(defect, fabs(p->per_flux[c]));
        through = fmax(through, flow + 0.5 * fabs(pressure_source(p, c)));
        cfl = fmax(cfl, flow * dt / (fl->eps[c] * s->m->V[c]));
        for (int k = 0; k < 3; k++)
            sum[k] += fl->impulse_weight * fl->options.rho * dt *
                      fl->momentum->defect[c] * fl->u[3 * c + k];
    }
    defect = halo_largest(s->h, defect);
    through = halo_largest(s->h, through);
    halo_sum(s->h, 3, sum);
    fl->report.cfl = halo_largest(s->h, cfl);
    fl->report.mass_residual = through > 0.0 ? defect / through : 0.0;
    for (int k = 0; k < 3; k++)
        fl->relabelled[k] = s->relabelled[k] += sum[k];
}

static int finished(void *parts, struct fluid *fl, int failed)
{
    struct solve *const s = parts;

    solve_measure(s, fl);
    solve_refresh(s, fl);
    return halo_largest(s->h, failed) > 0.0;
}

static double solve_largest(void *parts, double x)
{
    const struct solve *const s = parts;

    return halo_largest(s->h, x);
}

struct solve *solve_create(const struct mesh *m, struct halo *h,
                           const struct face_places *places, MPI_Comm comm)
{
    struct solve *const s = owner_create(sizeof *s);

    s->m = m;
    s->h = h;
    s->places = places;
    s->own = halo_own(h);
    for (int c = 0; c < m->n_cells; c++)
        s->rows += s->own[c];
    create_systems(s, comm);
    s->shared = (struct shared_solution){.momentum = solve_momentum,
                                         .pressure = solve_pressure,
                                         .corrected = corrected,
                                         .residual = solve_residual,
                                         .finished = finished,
                                         .largest = solve_largest,
                                         .parts = s};
    return s;
}

void solve_free(struct solve *s)
{
    if (s == NULL) return;
    for (int i = 0; i < 2; i++) {
        halo_must(KSPDestroy(&s->ksp[i]));
        halo_must(MatDestroy(&s->A[i]));
    }
    halo_must(VecDestroy(&s->b));
    halo_must(VecDestroy(&s->x));
    owner_free(s);
}

const struct shared_solution *solve_shared(const struct solve *s)
{
    return &s->shared;
}
