/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 02-contact.c -- a sphere is thrown at a wall; what is the force, what comes
 * back?
 *
 * The grain of cases/rebound.cfg, with both laws. Hertz's modulus is chosen
 * such that at 1 m/s the elastic sphere goes as deep as the linear one.
 *
 *   02-contact loops     law, e, overlap [um], force of the wall [N]
 *   02-contact rebound   e that is asked for; what comes back, and what would
 *                        come back if the wall could not pull
 *   02-contact friction  slip before and after the impact [m/s]
 *   02-contact oblique   the impacts of Kharaz et al. (2001): angle [deg]
 *                        before and after, spin [rad/s]; linear, Hertz
 */
#include <gsl/gsl_math.h>
#include <stdio.h>
#include <string.h>

#include "dem/contact_hertz.h"
#include "dem/contact_linear.h"
#include "dem/dem.h"

static const double d = 1.5e-3, rho = 2000.0, k = 5000.0, nu = 0.3;
static const double mu = 0.15;

/* Along the wall and away from it [m/s]. */
struct impact {
    double v_t, v_n;
    double spin;    /* [m/s] R omega */
    double fastest; /* [m/s] away from the wall while in contact */
};

/* The modulus [Pa] at which half of m v^2 is 2/5 k_n delta^(5/2) at the delta
 * of the linear law. */
static double young(double m)
{
    const double delta = sqrt(m / k);
    const double k_n = 1.25 * m / pow(delta, 2.5);
    const double E_star = 0.75 * k_n / sqrt(0.5 * d);
    return 2.0 * E_star * (1.0 - nu * nu);
}

static struct material grain(double e, double friction)
{
    const struct material m = {.young = young(rho * M_PI / 6.0 * d * d * d),
                               .poisson = nu,
                               .stiffness = k,
                               .restitution = e,
                               .friction = friction};
    return m;
}

/* One that is thrown: at v_n at the wall and v_t along it. */
struct sphere {
    double d, rho;   /* [m], [kg/m^3] */
    double v_n, v_t; /* [m/s] */
};

/* From where it just does not touch. With `show`, prints what happens in the
 * contact. */
static struct impact collide(const struct contact_law *law,
                             const struct material *m, const struct sphere *s,
                             int show)
{
    struct particles *const ps = particles_create(1);
    struct impact after = {0.0, 0.0, 0.0, 0.0};
    struct dem_options o = {.law = law,
                            .material = *m,
                            .lo = {-1.0, 0.0, -1.0},
                            .hi = {1.0, 1.0, 1.0}};
    struct dem_report r;
    long step = 0;

    particles_add(ps, (double[3]){0.0, 0.5 * s->d + 1e-12, 0.0}, s->d, s->rho);
    ps->vx[0] = s->v_t;
    ps->vy[0] = -s->v_n;
    o.step = law->duration(m, 0.5 * s->d, ps->m[0], s->v_n) / 2000.0;
    struct dem *const dem = dem_create(ps, &o);
    do {
        dem_run(dem, 1, &r);
        if (show && step++ % 20 == 0)
            printf("%-6s %4.1f %8.3f %9.5f\n", law->name, m->restitution,
                   1e6 * (0.5 * s->d - ps->y[0]), ps->cfy[0]);
        after.fastest = fmax(after.fastest, ps->vy[0]);
    } while (r.contacts > 0);
    after.v_t = ps->vx[0];
    after.v_n = ps->vy[0];
    after.spin = 0.5 * s->d * ps->wz[0];
    dem_free(dem);
    particles_free(ps);
    return after;
}

/* The grain of the case at v_n and v_t. */
static struct impact rebounds(const struct contact_law *law, double e,
                              double friction, double v_n, double v_t)
{
    const struct material m = grain(e, friction);
    const struct sphere s = {d, rho, v_n, v_t};
    return collide(law, &m, &s, 0);
}

static void loops(void)
{
    const struct material material[2] = {grain(1.0, 0.0), grain(0.5, 0.0)};
    const struct sphere s = {d, rho, 1.0, 0.0};

    puts("# law, e, overlap [um], force [N]");
    for (int law = 0; law < 2; law++)
        for (int lossy = 0; lossy < 2; lossy++)
            collide(contact_laws[law], &material[lossy], &s, 1);
}

static void rebound(void)
{
    puts("# e asked for; linear, hertz at 1 m/s, hertz at 0.01 m/s; linear and "
         "hertz without pull");
    for (int tenth = 1; tenth <= 10; tenth++) {
        const double e = 0.1 * tenth;
        const struct impact a = rebounds(&contact_linear, e, 0.0, 1.0, 0.0);
        const struct impact b = rebounds(&contact_hertz, e, 0.0, 1.0, 0.0);
        const struct impact c = rebounds(&contact_hertz, e, 0.0, 0.01, 0.0);
        printf("%.1f  %.4f %.4f %.4f  %.4f %.4f\n", e, a.v_n, b.v_n,
               c.v_n / 0.01, a.fastest, b.fastest);
    }
}

/* The surface of the sphere slips at v_t + R omega_z along a wall below it. */
static void friction(void)
{
    puts("# slip before; after: linear, hertz, and if it slid throughout");
    for (int i = 1; i <= 40; i++) {
        const double v_n = 1.0, v_t = 0.05 * i, e = 0.7;
        const struct impact a = rebounds(&contact_linear, e, mu, v_n, v_t);
        const struct impact b = rebounds(&contact_hertz, e, mu, v_n, v_t);
        printf("%.2f  %7.4f %7.4f  %7.4f\n", v_t, a.v_t + a.spin,
               b.v_t + b.spin, v_t - 3.5 * mu * (1.0 + e) * v_n);
    }
}

/* Aluminium oxide on glass, as one material with the moduli of the pair: G* is
 * (1 - nu) of E* over 2 (2 - nu), which gives nu; the stiffnesses of the linear
 * law are those of MFiX. */
static void oblique(void)
{
    const double E = contact_hertz_modulus(380e9, 0.23, 70e9, 0.25);
    const double q = contact_hertz_shear(380e9, 0.23, 70e9, 0.25) / E;
    const double nu_pair = (1.0 - 4.0 * q) / (1.0 - 2.0 * q);
    const struct material pair = {.young = 2.0 * E * (1.0 - gsl_pow_2(nu_pair)),
                                  .poisson = nu_pair,
                                  .stiffness = 1.72e7,
                                  .tangential = 1.48 / 1.72,
                                  .restitution = 0.98,
                                  .friction = 0.092};

    puts("# before; after, linear and hertz [deg]; spin, linear and hertz");
    for (int degrees = 1; degrees <= 65; degrees += degrees < 20 ? 1 : 3) {
        const double a = degrees * M_PI / 180.0, v = 3.9;
        double angle[2], spin[2];
        for (int law = 0; law < 2; law++) {
            const struct contact_law *const l =
                law ? &contact_hertz : &contact_linear;
            const struct sphere s = {5e-3, 4000.0, v * cos(a), v * sin(a)};
            const struct impact after = collide(l, &pair, &s, 0);
            angle[law] = atan2(after.v_t, after.v_n) * 180.0 / M_PI;
            spin[law] = -after.spin / (0.5 * s.d);
        }
        printf("%2d  %7.3f %7.3f  %7.2f %7.2f\n", degrees, angle[0], angle[1],
               spin[0], spin[1]);
    }
}

int main(int argc, char **argv)
{
    if (argc == 2 && strcmp(argv[1], "loops") == 0) loops();
    if (argc == 2 && strcmp(argv[1], "rebound") == 0) rebound();
    if (argc == 2 && strcmp(argv[1], "friction") == 0) friction();
    if (argc == 2 && strcmp(argv[1], "oblique") == 0) oblique();
    return 0;
}
