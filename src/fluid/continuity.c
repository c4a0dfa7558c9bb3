/* SPDX-License-Identifier: GPL-3.0-or-later */
/* continuity.c -- the two forms of the mass balance, and its residual. */
#include "fluid/systems.h"

#include <math.h>

#include "linear/faces.h"
#include "fluid/piso.h"

/* Sets the flux of solid volume through an inner face, by linear interpolation
 * [m^3/s]; p_face is work space until the pressure is known. */
FACE_KERNEL solid_flux(int f, int o, int n, const void *with)
{
    const struct fluid *const fl = with;
    const double *const S = mesh_S(fl->mesh, f), w = fl->mesh->w[f];
    const double *const a = &fl->eps_us[3 * o], *const b = &fl->eps_us[3 * n];

    fl->p_face[f] = (w * a[0] + (1.0 - w) * b[0]) * S[0] +
                    (w * a[1] + (1.0 - w) * b[1]) * S[1] +
                    (w * a[2] + (1.0 - w) * b[2]) * S[2];
}

/* dt times d eps/dt of cell c by the time scheme [-]. */
static double void_change(const struct fluid *fl, int c)
{
    const struct time_weights *const w = &fl->levels->weights;
    const double change = w->now * fl->eps[c] - w->old * fl->eps_n[c];

    return w->older == 0.0 ? change : change + w->older * fl->eps_nm1[c];
}

static void void_rate_rows(int first, int last, const struct fluid *fl)
{
    for (int c = first; c < last; c++)
        fl->pressure->source[c] =
            void_change(fl, c) * fl->mesh->V[c] / fl->options.dt;
}

static void mixture_rows(int first, int last, const struct fluid *fl,
                         const double *flux)
{
    double *const source = fl->pressure->source;

    for (int c = first; c < last; c++)
        source[c] = 0.0;
    face_loops_sum(first, last, fl->faces, face_loops_outflow, flux, source);
}

void continuity_source(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    double *const flux = fl->p_face;

    if (!fl->options.coupled) return;
    if (fl->options.continuity == CONTINUITY_VOID_RATE) { /* [XS11 2.3] */
        PARALLEL_RANGES(m->n_cells, 8, void_rate_rows, fl);
        return;
    }
    FOR_EACH_FACE(fl->faces, 8, solid_flux, fl); /* [XS11 2.7] */
    for (int f = m->n_internal; f < m->n_faces; f++)
        flux[f] = 0.0; /* particles do not cross the boundary */
    PARALLEL_RANGES(m->n_cells, 8, mixture_rows, fl, flux);
}

/* The largest values of a range of cells. */
struct largest {
    double defect, through, cfl; /* [m^3/s], [m^3/s], [-] */
};

/* The larger of a and b; a, if b is not a number. */
static double continuity_larger(double a, double b)
{
    return b > a ? b : a;
}

FACE_SUM_KERNEL half_size(int f, double out, const void *phi)
{
    (void)out;
    return 0.5 * fabs(((const double *)phi)[f]);
}

static void continuity_residual_rows(int first, int last,
                                     const struct fluid *fl,
                                     struct largest *partial)
{
    const struct mesh *const m = fl->mesh;
    const double *restrict V = m->V;
    const struct pressure_system *const pressure = fl->pressure;
    /* Work space that is not in use here. */
    double *restrict defect = pressure->per_flux;
    double *restrict through = pressure->resistance;
    const int range = parallel_ranges_of(m->n_cells, first);
    struct largest l = partial[range];

    for (int c = first; c < last; c++) {
        defect[c] = pressure_source(pressure, c);
        through[c] = 0.0;
    }
    face_loops_sum(first, last, fl->faces, face_loops_outflow, fl->phi, defect);
    face_loops_sum(first, last, fl->faces, half_size, fl->phi, through);
    for (int c = first; c < last; c++) {
        l.defect = continuity_larger(l.defect, fabs(defect[c]));
        l.through = continuity_larger(
            l.through, through[c] + 0.5 * fabs(pressure_source(pressure, c)));
        l.cfl = continuity_larger(l.cfl, through[c] * fl->options.dt /
                                             (fl->eps[c] * V[c]));
    }
    partial[range] = l;
}

double continuity_residual(struct fluid *fl)
{
    struct largest partial[PARALLEL_RANGES_COUNT] = {{0.0, 0.0, 0.0}},
                   all = {0.0, 0.0, 0.0};

    PARALLEL_BLOCKS(fl->mesh->n_cells, 8, continuity_residual_rows, fl,
                    partial);
    for (int s = 0; s < PARALLEL_RANGES_COUNT; s++) {
        all.defect = continuity_larger(all.defect, partial[s].defect);
        all.through = continuity_larger(all.through, partial[s].through);
        all.cfl = continuity_larger(all.cfl, partial[s].cfl);
    }
    fl->report.cfl = all.cfl; /* [LS 5.9, 5.10], summed over the directions */
    return all.through > 0.0 ? all.defect / all.through : 0.0;
}

const struct model fluid_continuity_mixture = {
    .name = "mixture",
    .what = "the volume fluxes of both phases have no divergence",
    .equations = "XS11 2.7",
    .function = "continuity_source",
    .value = CONTINUITY_MIXTURE,
};

const struct model fluid_continuity_void_rate = {
    .name = "void-rate",
    .what = "the fluid flows out of where the void shrinks",
    .equations = "XS11 2.3",
    .function = "continuity_source",
    .value = CONTINUITY_VOID_RATE,
};

const struct model *const fluid_continuity_forms[] = {
    &fluid_continuity_mixture, &fluid_continuity_void_rate, NULL};
