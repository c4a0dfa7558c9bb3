/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The places of all spheres of a case at a time, in thousandths of a diameter.
 *
 *     sh figures/run.sh figures/26/26-bed.c -- cases/mueller-bed.cfg 0.3
 * >figures/data/26-bed.txt
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "coupling/coupling.h"
#include "case/build.h"
#include "case/case_file.h"

int main(int argc, char **argv)
{
    int code = 2;
    if (argc != 3) return code;
    struct settings *const s = case_file_read(argv[1], 0, NULL, &code);
    if (s == NULL) return code;
    struct simulation *const sim = build_simulation(s, &code);
    if (sim == NULL) return code;
    const struct particles *const ps = sim->particles;

    if (coupling_start(sim) != 0) return 3;
    while (sim->t < atof(argv[2]) - 0.5 * sim->dt)
        if (coupling_step(sim) != 0) return 3;
    printf("# %s at %g s: x y z in thousandths of a diameter\n", argv[1],
           sim->t);
    for (int i = 0; i < ps->n; i++)
        printf("%.0f %.0f %.0f\n", rint(1e3 * ps->x[i] / ps->d[i]),
               rint(1e3 * ps->y[i] / ps->d[i]),
               rint(1e3 * ps->z[i] / ps->d[i]));
    build_free(sim);
    settings_free(s);
    return 0;
}
