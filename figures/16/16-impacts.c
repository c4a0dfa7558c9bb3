/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 16-impacts.c -- single impacts, as in tests/test_impacts.c, for the figures.
 *
 *   hertz    force in time, tests 1 (glass) and 2 (aluminium) of [Chung11]
 *   oblique  rebound against the angle of the impact [Kharaz01]
 *   slip     tests 5 and 6 of [Chung11]
 *   restitution   test 3
 */
#include <stdio.h>
#include <string.h>

#include "impacts.h"

static const double degree = M_PI / 180.0;

static void print_force(void *to, double time, double overlap, double force)
{
    int *const count = to;

    if ((*count)++ % 20 == 0)
        printf("%8.3f %8.3f %8.4f\n", 1e6 * time, 1e6 * overlap, 1e-3 * force);
}

static void hertz(void)
{
    const struct impact glass = {.partner = EQUAL_SPHERE,
                                 .R = 0.01,
                                 .density = 2800,
                                 .young = 48e9,
                                 .poisson = 0.2,
                                 .e = 1.0,
                                 .v_n = 10.0};
    const struct impact metal = {.partner = RIGID_PLANE,
                                 .R = 0.1,
                                 .density = 2699,
                                 .young = 70e9,
                                 .poisson = 0.3,
                                 .e = 1.0,
                                 .v_n = 0.2};
    struct rebound b;
    int count = 0;

    printf("# t [us], overlap [um], force [kN]\n");
    b = impact_watch(&glass, print_force, &count);
    printf("\n\n# glass: %.3f kN, %.2f um, %.2f us\n", 1e-3 * b.force,
           1e6 * b.overlap, 1e6 * b.time);
    count = 0;
    b = impact_watch(&metal, print_force, &count);
    printf("\n\n# aluminium: %.3f kN, %.2f um, %.2f us\n", 1e-3 * b.force,
           1e6 * b.overlap, 1e6 * b.time);
}

/* Aluminium oxide on glass: a rigid plane and a sphere of the same E*, G*. */
static struct impact on_glass(double angle)
{
    const double E = contact_hertz_modulus(380e9, 0.23, 70e9, 0.25);
    const double q = contact_hertz_shear(380e9, 0.23, 70e9, 0.25) / E;
    const double nu = (1.0 - 4.0 * q) / (1.0 - 2.0 * q);

    return (struct impact){.partner = RIGID_PLANE,
                           .R = 2.5e-3,
                           .density = 4000,
                           .young = E * (1.0 - nu * nu),
                           .poisson = nu,
                           .e = 0.98,
                           .mu = 0.092,
                           .v_n = 3.9 * cos(angle * degree),
                           .v_t = 3.9 * sin(angle * degree)};
}

static void oblique(void)
{
    for (int linear = 0; linear < 2; linear++) {
        printf("%s# %s: angle [deg], of the rebound [deg], e_t [-], spin "
               "[rad/s]\n",
               linear ? "\n\n" : "", linear ? "linear" : "hertz");
        for (int k = 1; k <= 85; k += k < 10 ? 1 : 3) {
            struct impact c = on_glass(k);
            c.k = linear ? 1.72e7 : 0.0;
            c.k_t = 1.48e7;
            const struct rebound b = impact_run(&c);
            printf("%2d %8.3f %7.4f %8.2f\n", k, atan2(b.v_t, b.v_n) / degree,
                   b.v_t / c.v_t, -b.spin);
        }
    }
}

static void slip(void)
{
    printf("# v_t/(mu v_n), R omega/(mu v_n)\n");
    for (double x = 0.1; x < 20.0; x *= 1.2) {
        const struct impact c = {.partner = RIGID_PLANE,
                                 .R = 1e-5,
                                 .density = 7850,
                                 .young = 208e9,
                                 .poisson = 0.3,
                                 .e = 1.0,
                                 .mu = 0.3,
                                 .v_n = 5.0,
                                 .v_t = 1.5 * x};
        printf("%7.3f %8.4f\n", x, c.R * impact_run(&c).spin / 1.5);
    }
    printf("\n\n# theta, beta\n");
    for (double theta = 0.15; theta < 25.0; theta *= 1.15) {
        const struct impact c = {.partner = RIGID_PLANE,
                                 .R = 0.1,
                                 .density = 2700,
                                 .young = 70e9,
                                 .poisson = 0.33,
                                 .e = 0.5,
                                 .mu = 0.4,
                                 .v_n = 0.2,
                                 .spin = 4.2 / theta};
        const struct rebound b = impact_run(&c);
        printf("%7.3f %8.4f\n", theta,
               -(b.v_t + c.R * b.spin) / (c.R * c.spin));
    }
}

static void restitution(void)
{
    printf("# e: in, out (aluminium oxide)\n");
    for (int k = 1; k <= 5; k++) {
        const struct impact c = {.partner = RIGID_PLANE,
                                 .R = 2.5e-3,
                                 .density = 4000,
                                 .young = 380e9,
                                 .poisson = 0.23,
                                 .e = 0.2 * k,
                                 .v_n = 3.9};
        printf("%.1f %.5f\n", c.e, impact_run(&c).v_n / c.v_n);
    }
}

int main(int argc, char **argv)
{
    const char *const what = argc > 1 ? argv[1] : "";

    if (strcmp(what, "hertz") == 0)
        hertz();
    else if (strcmp(what, "oblique") == 0)
        oblique();
    else if (strcmp(what, "slip") == 0)
        slip();
    else
        restitution();
    return 0;
}
