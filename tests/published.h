/* published.h -- what others have published of the drag on spheres, alone, in
 * a packed bed and in a suspension that settles, and what a drag law says of
 * the same. For tests/test_drag_published.c and figures/09/09-published.c.
 */
#ifndef PUBLISHED_H
#define PUBLISHED_H

#include <gsl/gsl_math.h>
#include <math.h>

#include "coupling/drag.h"

/* Drag over Stokes' law at the superficial slip; Re is of that slip. In units
 * of d, rho_f and mu u_r is Re over eps_f. */
static inline double published_factor(const struct drag_law *law, double eps_f,
                                      double Re)
{
    return drag_resistance(law, eps_f, 1.0, 1.0, 1.0, Re / eps_f) /
           (18.0 * eps_f);
}

/* C_d of one sphere. Clift78: the standard curve of Clift, Grace and Weber, by
 * the values of its formulas in another program (CalebBell/fluids, tests).
 * Johnson99: flow computed by Johnson and Patel, read from their figure 5, the
 * last one printed in their text. */
struct published_sphere {
    const char *source;
    double Re, C_d; /* [-] */
};
static const struct published_sphere published_spheres[] = {
    {"Clift78", 0.002, 12000.1875},
    {"Clift78", 0.5, 51.538273834491875},
    {"Johnson99", 25.0, 2.366},
    {"Clift78", 50.0, 1.5742657203722197},
    {"Johnson99", 100.0, 1.102},
    {"Johnson99", 200.0, 0.790},
    {"Johnson99", 300.0, 0.656},
    {"Clift78", 500.0, 0.5549240285782678},
    {"Clift78", 2500.0, 0.40817983162668914},
};
enum {
    PUBLISHED_SPHERES = sizeof published_spheres / sizeof published_spheres[0]
};

static inline double published_sphere_cd(const struct drag_law *law, double Re)
{
    return 24.0 / Re * published_factor(law, 1.0, Re);
}

/* A packed bed, eps_f = 0.4, of spheres of 0.8 mm in water that passes with
 * 1 mm/s: the pressure drop over a metre [Pa] by the correlations of five
 * groups that measured it, by another program (CalebBell/fluids, tests). */
static const struct {
    const char *source;
    double drop; /* [Pa/m] */
} published_beds[] = {{"Ergun52", 1338.8671874999995},
                      {"Erdim15", 1438.2826958844414},
                      {"KTA81", 1440.409277034248},
                      {"Brauer71", 1441.5479196020563},
                      {"Carman37", 1614.721678121775}};
enum { PUBLISHED_BEDS = sizeof published_beds / sizeof published_beds[0] };

/* The drop [Pa/m] there at the superficial velocity U: the drag on all spheres
 * of a volume is the fluid's share eps_f of it (9.15). */
static inline double published_bed_drop(const struct drag_law *law, double U)
{
    const double eps = 0.4, d = 8e-4, rho = 1000.0, mu = 1e-3;

    return (1.0 - eps) / gsl_pow_2(eps) * U *
           drag_resistance(law, eps, rho, mu, d, U / eps);
}

/* The safety rule KTA 3102.3 (Re/(1 - eps_f) of 1 to 1e5), where Ergun's is
 * known to be too large. */
static inline double published_bed_kta(double U)
{
    const double eps = 0.4, d = 8e-4, rho = 1000.0, mu = 1e-3;
    const double Re = rho * U * d / mu / (1.0 - eps);

    return (320.0 / Re + 6.0 * pow(Re, -0.1)) * (1.0 - eps) / gsl_pow_3(eps) *
           rho * U * U / (2.0 * d);
}

/* The exponent n of u = u_t eps_f^n as measured: Richardson and Zaki's, and
 * Garside and Al-Dibouni's, (5.1 - n)/(n - 2.7) = 0.1 Re_t^0.9. */
static inline double published_zaki(double Re_t)
{
    if (Re_t < 0.2) return 4.65;
    if (Re_t < 1.0) return 4.35 * pow(Re_t, -0.03);
    return Re_t < 500.0 ? 4.45 * pow(Re_t, -0.1) : 2.39;
}

static inline double published_garside(double Re_t)
{
    const double q = 0.1 * pow(Re_t, 0.9);
    return (5.1 + 2.7 * q) / (1.0 + q);
}

/* The same of a law, from the velocity at eps: there the drag carries eps of
 * the weight, which is the drag on one sphere at Re_t. */
static inline double published_exponent(const struct drag_law *law, double eps,
                                        double Re_t)
{
    const double weight = eps * published_factor(law, 1.0, Re_t) * Re_t;
    double low = 0.0, high = Re_t;

    for (int i = 0; i < 60; i++) { /* the drag grows with Re */
        const double Re = 0.5 * (low + high);
        if (published_factor(law, eps, Re) * Re < weight)
            low = Re;
        else
            high = Re;
    }
    return log(low / Re_t) / log(eps);
}

#endif
