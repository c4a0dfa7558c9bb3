/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 20-hard.c -- what each form of continuity does to the pressure where it is
 * hardest: the scenes of tests/hard_beds.h. One line a scene and form.
 *
 * swing: the largest change of the pressure in a cell from one step to the
 * next, and its root mean square over cells and steps, [Pa]. The first five
 * steps, in which the flow starts, do not count. mass: the largest defect of
 * continuity
 * [-]; exchange: what the particles were charged and the fluid did not pay [-].
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "coupling/coupling.h"
#include "hard_beds.h"

struct found {
    double swing, square, mass, exchange, speed;
    long n;
};

static void compare(const struct simulation *sim, double *past, int counts,
                    struct found *r)
{
    const int n = sim->mesh->n_cells;

    for (int c = 0; c < n && counts; c++) {
        const double change = sim->fluid->p[c] - past[c];
        r->swing = fmax(r->swing, fabs(change));
        r->square += change * change;
        r->n++;
    }
    memcpy(past, sim->fluid->p, (size_t)n * sizeof *past);
    r->mass = fmax(r->mass, sim->fluid->report.mass_residual);
    r->exchange = fmax(r->exchange, sim->coupling->report.exchange_residual);
    r->speed = fmax(r->speed, sim->dem_report.max_speed);
}

int main(void)
{
    if (freopen("/dev/null", "w", stderr) == NULL) return 4;
    printf("# scene, form, largest and rms swing [Pa], mass and exchange "
           "residual [-], fastest [m/s]\n");
    for (int i = 0; i < 2 * HARD_SCENES; i++) {
        const struct hard *const h = &hard_scenes[i / 2];
        const char *const form = i % 2 ? "mixture" : "void-rate";
        struct simulation *const sim = hard_build(h, form);
        if (sim == NULL || coupling_start(sim) != 0) return 3;
        double *const past = alloc_doubles(sim->mesh->n_cells);
        struct found r = {0};
        for (int k = 0; k < h->steps; k++) {
            if (coupling_step(sim) != 0) return 3;
            compare(sim, past, k >= 5, &r);
        }
        printf("%-33s %-9s %8.3g %8.3g %7.0e %7.0e %6.3f\n", h->name, form,
               r.swing, sqrt(r.square / (double)r.n), r.mass, r.exchange,
               r.speed);
        free(past);
        build_free(sim);
    }
    return 0;
}
