/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 30-weight.c -- who carries the bed of cases/fluidization-ramp.cfg?
 *
 *   30-weight SECONDS INLET [OVERRIDE...]
 *
 * The bed is blown through with INLET m/s. From its second half: the pressure
 * drop, the force of the fluid on the grains, that of the walls (what is left
 * of their change of momentum), all over the weight of the grains; and the part
 * of the time in which the walls push up with less than a hundredth of it.
 * Springs of 500 N/m instead of 5000.
 */
#include <stdio.h>
#include <stdlib.h>

#include "coupling/coupling.h"
#include "case/build.h"
#include "record/history.h"
#include "case/case_file.h"

enum { MOST = 12 };

struct sums {
    double drop, fluid, walls; /* [-] over the weight, and time */
    int light, n;              /* steps: walls carry nothing, all */
};

/* Upward momentum [N s] of the grains, and the outside forces [N] on them. */
static double momentum(const struct particles *ps, double *force)
{
    double sum = 0.0;

    *force = 0.0;
    for (int i = 0; i < ps->n; i++) {
        sum += ps->m[i] * ps->vy[i];
        *force += ps->ey[i];
    }
    return sum;
}

/* One step; drag is frozen, so that ey is what acted through all of it. */
static int measure(struct simulation *sim, struct sums *s, int counts)
{
    const double area = 0.040 * 0.0075; /* [m^2] */
    double force, weight = 0.0;
    const double before = momentum(sim->particles, &force);

    if (coupling_step(sim) != 0) return 1;
    const double after = momentum(sim->particles, &force);
    for (int i = 0; i < sim->particles->n; i++)
        weight -= sim->particles->m[i] * sim->gravity[1];
    const double walls = ((after - before) / sim->dt - force) / weight;
    s->n += counts;
    s->drop += counts * history_pressure_drop(sim) * area / weight;
    s->fluid += counts * (force + weight) / weight;
    s->walls += counts * walls;
    s->light += counts && walls < 0.01;
    return 0;
}

int main(int n, char **word)
{
    const char *list[MOST] = {"particles.grains.stiffness=500",
                              "particles.step=1.2e-5"};
    const int steps = (int)(1e3 * atof(word[1]) + 0.5);
    struct sums s = {0};
    char inlet[60];
    int count = 2, code;

    snprintf(inlet, sizeof inlet, "fluid.bottom.inlet=%s", word[2]);
    list[count++] = inlet;
    for (int i = 3; i < n && count < MOST; i++)
        list[count++] = word[i];
    struct settings *const set =
        case_file_read("cases/fluidization-ramp.cfg", count, list, &code);
    if (set == NULL) return code;
    struct simulation *const sim = build_simulation(set, &code);
    settings_free(set);
    if (sim == NULL || coupling_start(sim) != 0) return 3;
    for (int i = 0; i < steps; i++)
        if (measure(sim, &s, i >= steps / 2) != 0) return 3;
    printf("drop %.3f fluid %.3f walls %.3f alone %.2f\n", s.drop / s.n,
           s.fluid / s.n, s.walls / s.n, (double)s.light / s.n);
    build_free(sim);
    return 0;
}
