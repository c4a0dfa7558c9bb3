/* SPDX-License-Identifier: GPL-3.0-or-later */
/* An even bed, a fine lattice of points, in the cone and tube of
 * cases/tapered-bed.cfg: the lowest and the highest of what is to be 1 in each
 * cell, and the root mean square of the error. The kernel is twice as wide,
 * which makes it about the same Gaussian (the chapter on averaging).
 *
 *     sh figures/run.sh figures/21/21-even.c
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "averaging/averaging.h"
#include "base/alloc.h"
#include "mesh/poly/poly.h"

static const double step = 0.8e-3; /* [m] of the lattice */
enum { ROOM = 400000 };

static struct particles *even_bed(const struct mesh *m)
{
    struct particles *const ps = particles_create(ROOM);
    double x[3];

    for (x[0] = m->lo[0] + 0.5 * step; x[0] < m->hi[0]; x[0] += step)
        for (x[1] = m->lo[1] + 0.5 * step; x[1] < m->hi[1]; x[1] += step)
            for (x[2] = m->lo[2] + 0.5 * step; x[2] < m->hi[2]; x[2] += step) {
                if (mesh_cell_at(m, x[0], x[1], x[2]) < 0) continue;
                ps->x[ps->n] = x[0];
                ps->y[ps->n] = x[1];
                ps->z[ps->n++] = x[2];
            }
    return ps;
}

static void show(const struct mesh *m, const struct particles *ps,
                 const char *method, double b)
{
    const struct averaging_options o = {.bandwidth = b};
    struct averaging *const a =
        averaging_create(averaging_method_named(method), m, ps, &o);
    double *const q = alloc_doubles(ps->n);
    double *const field = alloc_doubles(m->n_cells);
    double square = 0.0, V = 0.0;

    for (int i = 0; i < ps->n; i++)
        q[i] = step * step * step;
    if (averaging_bind(a) != 0) exit(1);
    averaging_spread(a, 1, q, field);
    for (int c = 0; c < m->n_cells; c++) {
        square += m->V[c] * (field[c] - 1.0) * (field[c] - 1.0);
        V += m->V[c];
    }
    printf("%-9s %4.1f  %.3f  %.3f  %.3f\n", method, 1e3 * b,
           averaging_report(a)->lowest, averaging_report(a)->highest,
           sqrt(square / V));
    averaging_free(a);
    free(q);
    free(field);
}

int main(void)
{
    static const double b[] = {3e-3, 6e-3};
    struct mesh *const m = poly_read("cases/tapered-bed", NULL);
    struct particles *const ps = even_bed(m);

    puts("# method, b [mm], lowest, highest, rms error");
    show(m, ps, "pcm", 0.0);
    for (int i = 0; i < 2; i++) {
        show(m, ps, "kernel", 2.0 * b[i]);
        show(m, ps, "gaussian", b[i]);
        show(m, ps, "diffusion", b[i]);
        show(m, ps, "images", b[i]);
    }
    particles_free(ps);
    mesh_free(m);
    return 0;
}
