/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 16-sliding.c -- where sliding starts: ten spheres that hit a floor, after the
 * impact, of ours and of LIGGGHTS (the deck is figures/16/16-sliding.in); and the
 * same by the equations of one sphere in this file, with our rule and theirs.
 *
 *   sh figures/run.sh figures/16/16-sliding.c
 */
#include <stdio.h>
#include <stdlib.h>

#include "impacts.h"

enum { SPHERES = 10 };

static const double R = 5e-3, rho = 2500.0, E = 1e7, nu = 0.3, e = 0.8,
                    mu = 0.3, v_n = 2.0;

/* Where sliding starts: where spring and dashpot together are above Coulomb's
 * limit; or where the spring by itself is, and the dashpot acts where it is
 * not.
 */
enum rule { TOGETHER, SPRING_FIRST };

struct sphere_after {
    double v_x, v_y, spin;
};

/* The force along the floor, at a slip s; xi moves on by s dt. */
static double friction(enum rule rule, double k_t, double eta_t, double most,
                       double s, double dt, double *xi)
{
    *xi += s * dt;
    const double spring = -k_t * *xi, whole = spring - eta_t * s;

    if (rule == SPRING_FIRST) {
        if (fabs(spring) <= most) return whole;
        *xi *= most / fabs(spring);
        return copysign(most, spring);
    }
    if (fabs(whole) <= most) return whole;
    if (fabs(spring) > most) *xi = -copysign(most, whole) / k_t;
    return copysign(most, whole);
}

/* Velocity Verlet, as in dem.h, in the steps of the deck. */
static struct sphere_after impact(enum rule rule, double v_t)
{
    const double m = 4.0 / 3.0 * M_PI * R * R * R * rho, dt = 2e-7;
    const double zeta = contact_damping_ratio(e);
    const double E_star = contact_hertz_modulus(E, nu, E, nu);
    const double G_star = contact_hertz_shear(E, nu, E, nu);
    double y = R + 1e-5, v = -v_n, u = v_t, w = 0.0, xi = 0.0;
    double F_n = 0.0, F_t = 0.0, T = 0.0;

    for (int met = 0; y < R || !met;) {
        const double I = 0.4 * m * R * R;
        v += 0.5 * dt * F_n / m, u += 0.5 * dt * F_t / m, w += 0.5 * dt * T / I;
        y += v * dt;
        const double delta = R - y, arm = R - 0.5 * delta;
        F_n = F_t = T = 0.0;
        if (delta > 0.0) {
            const double S_n = contact_hertz_slope(E_star, R, delta);
            const double k_t = contact_hertz_tangential(G_star, R, delta);
            met = 1;
            F_n = contact_hertz_force(E_star, R, delta) -
                  contact_hertz_damping(zeta, S_n, m) * v;
            F_t = friction(rule, k_t, contact_hertz_damping(zeta, k_t, m),
                           mu * fabs(F_n), u + arm * w, dt, &xi);
            T = arm * F_t;
        }
        v += 0.5 * dt * F_n / m, u += 0.5 * dt * F_t / m, w += 0.5 * dt * T / I;
    }
    return (struct sphere_after){u, v, w};
}

static struct sphere_after winnow(double v_t)
{
    const struct impact c = {.R = R,
                             .density = rho,
                             .young = 0.5 * E, /* the floor yields as well */
                             .poisson = nu,
                             .e = e,
                             .mu = mu,
                             .v_n = v_n,
                             .v_t = v_t};
    const struct rebound b = impact_run(&c);

    return (struct sphere_after){b.v_t, b.v_n, b.spin};
}

static void read_theirs(struct sphere_after to[SPHERES])
{
    FILE *const f = fopen("figures/data/liggghts-sliding.txt", "r");
    int id;

    if (f == NULL || fscanf(f, "%*[^\n]") != 0) exit(1);
    for (int i = 0; i < SPHERES; i++)
        if (fscanf(f, "%d %lf %lf %lf", &id, &to[i].v_x, &to[i].v_y,
                   &to[i].spin) != 4)
            exit(1);
    fclose(f);
}

/* In per cent of the speed before. */
static double off(const struct sphere_after *a, const struct sphere_after *b,
                  double speed)
{
    return 100.0 *
           hypot(hypot(a->v_x - b->v_x, a->v_y - b->v_y),
                 0.4 * R * (a->spin - b->spin)) /
           speed;
}

int main(void)
{
    struct sphere_after theirs[SPHERES];
    double most[3] = {0.0};

    read_theirs(theirs);
    puts("# angle, v_x after [m/s] of ours and of LIGGGHTS; in % of the speed: "
         "they differ,\n# ours off our rule here, theirs off their rule here");
    for (int i = 0; i < SPHERES; i++) {
        const double angle = 6.0 * (i + 1) - 2.0;
        const double v_t = v_n * tan(angle * M_PI / 180.0);
        const double speed = hypot(v_n, v_t);
        const struct sphere_after w = winnow(v_t), o = impact(TOGETHER, v_t),
                                  r = impact(SPRING_FIRST, v_t);
        const double d[3] = {off(&w, &theirs[i], speed), off(&w, &o, speed),
                             off(&theirs[i], &r, speed)};
        printf("%2.0f %.5f %.5f  %.3f %.3f %.0e\n", angle, w.v_x, theirs[i].v_x,
               d[0], d[1], d[2]);
        for (int k = 0; k < 3; k++)
            most[k] = fmax(most[k], d[k]);
    }
    printf("differ = %.2f [%%]\nours = %.3f [%%]\ntheirs = %.0e [%%]\n",
           most[0], most[1], most[2]);
    return 0;
}
