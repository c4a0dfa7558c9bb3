/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A mesh from files, seen from above: the faces of its lid as closed lines, and
 * points at random with the cell that owns each. */
#include "mesh/poly/poly.h"

#include <stdint.h>
#include <stdio.h>

/* A number from 0 to 1 [Knuth's linear congruence]. */
static double chance(uint64_t *state)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (double)(*state >> 11) / 9007199254740992.0;
}

int main(void)
{
    struct mesh *const m = poly_read("cases/tapered-bed", NULL);
    if (m == NULL) return 1;
    const struct mesh_shape *const s = m->shape;
    const struct patch *const lid = mesh_patch(m, "lid");
    uint64_t state = 1;
    double area = 0.0;
    int asked = 0, inside = 0;

    printf("# faces of the lid: x z [mm]\n");
    for (int f = lid->first; f < lid->first + lid->n; f++) {
        const int p = s->boundary[f - m->n_internal];
        area += mesh_S(m, f)[1];
        const int n = s->start[p + 1] - s->start[p];
        for (int i = 0; i <= n; i++) {
            const double *const x =
                &s->point[3 * s->corner[s->start[p] + i % n]];
            printf("%.4f %.4f\n", 1e3 * x[0], 1e3 * x[2]);
        }
        printf("\n");
    }
    printf("\n# points: x z [mm] cell\n");
    for (; asked < 1500; asked++) {
        double x[3] = {0.0, 0.0899, 0.0}, offset[3];
        for (int k = 0; k < 3; k += 2)
            x[k] = m->lo[k] + chance(&state) * (m->hi[k] - m->lo[k]);
        const int c = mesh_cell_and_offset(m, x, offset);
        if (c < 0) continue;
        printf("%.4f %.4f %d\n", 1e3 * x[0], 1e3 * x[2], c);
        inside++;
    }
    const double room = (m->hi[0] - m->lo[0]) * (m->hi[2] - m->lo[2]);
    printf("\n\n# %d of %d points have a cell: %.3f; the lid has %.3f of the "
           "square\n",
           inside, asked, (double)inside / asked, area / room);
    mesh_free(m);
    return 0;
}
