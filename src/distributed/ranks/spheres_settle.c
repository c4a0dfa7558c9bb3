/* SPDX-License-Identifier: GPL-3.0-or-later */
/* spheres_settle.c -- a bed comes to rest on all ranks.
 *
 * As in dem/bed_settling.h: first with a viscous drag, without which rolling
 * spheres would not stop, then without it, until the spheres have as little
 * energy as there. The material is the real one all the time, and meanwhile
 * LAMMPS moves the planes that cut the box, for there are no cells yet. */
#include "distributed/ranks/spheres_internal.h"

#include <math.h>

#define LAMMPS_LIB_MPI
#include <lammps/library.h>

#include "base/vector.h"

static const double settling_drag = 3.0; /* [-] relaxation over sqrt(d/g) */
enum { CHECK_EVERY = 50 };

static void spheres_settle_begin(struct spheres *q, const struct words *w,
                                 double step, const double g[3])
{
    const double size = vector_length(g);
    const int *const P = q->p->P;
    struct words own = *w;

    own.step = step;
    own.starts = 1;
    spheres_equip(q, &own);
    spheres_tell(q, "fix fall all gravity %.17g vector %.17g %.17g %.17g", size,
                 g[0] / size, g[1] / size, g[2] / size);
    if (q->p->size > 1)
        spheres_tell(q, "fix even all balance 1000 1.05 shift %s%s%s 10 1.02",
                     P[0] > 1 ? "x" : "", P[1] > 1 ? "y" : "",
                     P[2] > 1 ? "z" : "");
    spheres_tell(q, "run 0 post no");
}

static void spheres_settle_end(struct spheres *q)
{
    if (q->p->size > 1) spheres_tell(q, "unfix even");
    spheres_tell(q, "unfix fall");
    spheres_strip(q);
}

/* Multiplies all velocities; returns the kinetic energy before, over the energy
 * of falling by the height d [-]. */
static double spheres_settle_slow_down(struct spheres *q, double factor,
                                       double g, double d)
{
    const double *const R = lammps_extract_atom(q->lammps, "radius");
    const double *const m = lammps_extract_atom(q->lammps, "rmass");
    double **const v = spheres_rows(q, "v"),
                   **const w = spheres_rows(q, "omega");
    double sum[2] = {0.0, 0.0};

    for (int i = 0; i < spheres_count(q); i++) {
        sum[0] += m[i] * (0.5 * vector_dot(v[i], v[i]) +
                          0.2 * R[i] * R[i] * vector_dot(w[i], w[i]));
        sum[1] += m[i] * g * d;
        for (int k = 0; k < 3; k++) {
            v[i][k] *= factor;
            w[i][k] *= factor;
        }
    }
    MPI_Allreduce(MPI_IN_PLACE, sum, 2, MPI_DOUBLE, MPI_SUM, q->comm);
    return sum[0] / sum[1];
}

void spheres_settle(struct spheres *q, const struct words *w, double step,
                    const struct bed_options *bed, struct bed_report *r)
{
    const double g = vector_length(bed->gravity);
    const double fall = sqrt(bed->diameter / g), interval = CHECK_EVERY * step;

    *r = (struct bed_report){.settled = 0};
    spheres_settle_begin(q, w, step, bed->gravity);
    for (int part = 0; part < 2; part++) {
        const double kept = part ? 1.0 : exp(-interval / settling_drag / fall);
        const double least = part ? 0.0 : 1.5 * fall;
        do {
            spheres_tell(q, "run %d pre no post no", CHECK_EVERY);
            r->time += interval;
            r->steps += CHECK_EVERY;
            r->kinetic = spheres_settle_slow_down(q, kept, g, bed->diameter);
            r->settled = r->kinetic < BED_SETTLED_ENERGY && r->time >= least;
        } while (!r->settled && r->time < bed->settle);
        if (!r->settled) break;
    }
    spheres_settle_end(q);
}
