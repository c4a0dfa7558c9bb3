/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coupling/drag.h"

#include "base/model.h"
#include "base/power.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>

double drag_reynolds(double rho_f, double mu, double d, double u_r)
{
    return rho_f * d * u_r / mu; /* [XS11 2.12] */
}

/* 1 where viscosity no longer matters: its contribution to the drag is less
 * than 1 / Re of the rest. Also where Re is not a number, 0 / 0 of a fluid
 * without viscosity that is at rest. */
static int is_inviscid(double Re)
{
    return !(Re < 1e9);
}

/* The exponents of [XS11 2.14]: A1 = eps_f^4.14, A2 is a multiple of the other
 * power. */
static const double power_A1 = 4.14;

static inline double power_A2(double eps_f)
{
    return eps_f <= 0.85 ? 1.28 : 2.65;
}

static inline double factor_A2(double eps_f)
{
    return eps_f <= 0.85 ? 0.8 : 1.0;
}

static inline double terminal_ratio(double Re, double A1, double A2)
{
    const double a = 0.06 * Re;
    const double V_r =
        0.5 *
        (A1 - a + sqrt(a * a + 2.0 * a * (2.0 * A2 - A1) + A1 * A1)); /* 2.13 */

    return is_inviscid(Re) ? A2 : V_r; /* its limit */
}

double drag_terminal_ratio(double Re, double eps_f)
{
    return terminal_ratio(Re, pow(eps_f, power_A1),
                          factor_A2(eps_f) * pow(eps_f, power_A2(eps_f)));
}

/* [XS11 2.11] with C_d u_r = (0.63 sqrt(u_r) + 4.8 sqrt(V_r u_r / Re))^2, where
 * u_r / Re = mu / (rho_f d) has no 0/0 in it. */
static inline double syamlal_obrien_of(double V_r, double eps_f, double rho_f,
                                       double mu, double d, double u_r)
{
    const double root = 0.63 * sqrt(u_r) + 4.8 * sqrt(V_r * mu / (rho_f * d));
    const double Cd_u = root * root;

    return 0.75 * Cd_u / (V_r * V_r) * rho_f / d * eps_f;
}

static double syamlal_obrien(double eps_f, double rho_f, double mu, double d,
                             double u_r)
{
    const double Re = drag_reynolds(rho_f, mu, d, u_r);

    return syamlal_obrien_of(drag_terminal_ratio(Re, eps_f), eps_f, rho_f, mu,
                             d, u_r);
}

/* Both powers of one logarithm, and all of it eight by eight. */
static void syamlal_obrien_many(int n, const double *eps_f, double rho_f,
                                double mu, const double *d, const double *u_r,
                                double *resistance)
{
#pragma omp simd
    for (int i = 0; i < n; i++) {
        const double Re = drag_reynolds(rho_f, mu, d[i], u_r[i]);
        const double eps = eps_f[i], log = power_log(eps);
        const double A2 = factor_A2(eps) * power_exp(power_A2(eps) * log);
        const double V_r = terminal_ratio(Re, power_exp(power_A1 * log), A2);

        resistance[i] = syamlal_obrien_of(V_r, eps, rho_f, mu, d[i], u_r[i]);
    }
}

const struct drag_law drag_syamlal_obrien = {
    .name = "syamlal-obrien",
    .what = "settling data of suspensions; the law of XS11 and SX15",
    .equations = "XS11 2.11-2.14",
    .function = "syamlal_obrien",
    .eps_min = 0.35,
    .eps_max = 1.0,
    .Re_max = 3e4,
    .resistance = syamlal_obrien,
    .resistance_many = syamlal_obrien_many,
};

/* C_d Re / 24, the correction to Stokes' law [LS 5.13, 5.26]. Schiller and
 * Naumann to Re = 1000, Newton's constant 0.44 beyond. */
double drag_sphere(double Re)
{
    return Re < 1000.0 ? 1.0 + 0.15 * pow(Re, 0.687) : 0.44 * Re / 24.0;
}

double drag_wen_yu_cd(double alpha, double Re)
{
    return 24.0 / (alpha * Re) * drag_sphere(alpha * Re); /* [LS 5.26] */
}

/* [LS 5.25-5.27] with beta as [XS11 2.9] means it, that is rho times what LS
 * prints. C_d u_r = 24 mu / (alpha rho d) times the correction. */
static double gidaspow(double eps_f, double rho_f, double mu, double d,
                       double u_r)
{
    const double Re = drag_reynolds(rho_f, mu, d, u_r);

    if (eps_f <= 0.8) /* Ergun */
        return 150.0 * (1.0 - eps_f) * mu / (eps_f * d * d) +
               1.75 * rho_f * u_r / d;
    const double Cd_u = is_inviscid(Re) ? 0.44 * u_r
                                        : 24.0 * mu / (eps_f * rho_f * d) *
                                              drag_sphere(eps_f * Re);
    return 0.75 * Cd_u * eps_f * rho_f / d * pow(eps_f, -2.65); /* Wen, Yu */
}

const struct drag_law drag_gidaspow = {
    .name = "gidaspow",
    .what = "Ergun's packed bed below eps_f = 0.8, Wen and Yu above",
    .equations = "LS 5.25-5.27",
    .function = "gidaspow",
    .eps_min = 0.35,
    .eps_max = 1.0,
    .Re_max = 2e3,
    .resistance = gidaspow,
};

/* One sphere alone [LS 5.2]: eps_f does not matter. 3 pi mu d phi over V. */
static double schiller_naumann(double eps_f, double rho_f, double mu, double d,
                               double u_r)
{
    const double Re = drag_reynolds(rho_f, mu, d, u_r);

    (void)eps_f;
    if (is_inviscid(Re)) return 0.75 * 0.44 * rho_f * u_r / d;
    return 18.0 * mu / (d * d) * drag_sphere(Re);
}

const struct drag_law drag_schiller_naumann = {
    .name = "schiller-naumann",
    .what = "one sphere in an unbounded stream, neighbours ignored",
    .equations = "LS 5.2, 5.13",
    .function = "schiller_naumann",
    .eps_min = 0.95,
    .eps_max = 1.0,
    .Re_max = 2e5,
    .resistance = schiller_naumann,
};

double drag_beta(const struct drag_law *law, double eps_s, double rho_f,
                 double mu, double d, double u_r)
{
    return eps_s * drag_resistance(law, 1.0 - eps_s, rho_f, mu, d, u_r);
}

double drag_coefficient(const struct drag_law *law, double eps_s, double rho_f,
                        double mu, double d, double u_r)
{
    const double V_p = M_PI / 6.0 * d * d * d, eps_f = 1.0 - eps_s;
    return V_p * drag_resistance(law, eps_f, rho_f, mu, d, u_r) / eps_f;
}

double drag_relaxation_time(const struct drag_law *law, double rho_s,
                            double eps_s, double rho_f, double mu, double d,
                            double u_r)
{
    return rho_s / drag_resistance(law, 1.0 - eps_s, rho_f, mu, d, u_r);
}

double drag_force(double rho_f, double C_D, double d, double u_r)
{
    return 0.5 * rho_f * M_PI / 4.0 * d * d * C_D * u_r * fabs(u_r);
}

double drag_stokes_time(double rho_p, double d, double mu)
{
    return rho_p * d * d / (18.0 * mu);
}

double drag_schiller_naumann_time(double rho_p, double d, double mu, double Re)
{
    return drag_stokes_time(rho_p, d, mu) / (1.0 + 0.15 * pow(Re, 0.687));
}

double drag_settling_slip(const struct drag_law *law, double rho_s,
                          double eps_s, double rho_f, double mu, double d,
                          double g)
{
    const double pull = fabs(rho_s - rho_f) * g; /* [N/m^3] */
    double low = 0.0, high = 1e3;

    for (int i = 0; i < 100; i++) {
        const double w = 0.5 * (low + high);
        if (w * drag_resistance(law, 1.0 - eps_s, rho_f, mu, d, w) <
            pull * (1.0 - eps_s))
            low = w;
        else
            high = w;
    }
    return low;
}

struct stream {
    const struct drag_law *law;
    double rho_s, eps_s, rho_f, mu, d, u_f;
};

/* [XS11 4.1] */
static int stream_acceleration(double t, const double u[], double dudt[],
                               void *of)
{
    const struct stream *const s = of;
    const double u_r = s->u_f - u[0];

    (void)t;
    dudt[0] = u_r / drag_relaxation_time(s->law, s->rho_s, s->eps_s, s->rho_f,
                                         s->mu, s->d, fabs(u_r));
    return isfinite(dudt[0]) ? GSL_SUCCESS : GSL_EBADFUNC;
}

/* Runge-Kutta of order 8, to 1e-11 of the velocity. */
double drag_released(double rho_s, double eps_s, double rho_f, double mu,
                     double d, double u_f, double t)
{
    struct stream s = {
        drag_law_named("syamlal-obrien"), rho_s, eps_s, rho_f, mu, d, u_f};
    gsl_odeiv2_system system = {stream_acceleration, NULL, 1, &s};
    double u[1] = {0.0}, now = 0.0;

    if (!(t >= 0.0)) return NAN;
    if (t == 0.0) return 0.0;
    gsl_odeiv2_driver *const driver = gsl_odeiv2_driver_alloc_y_new(
        &system, gsl_odeiv2_step_rk8pd, 1e-4 * t, 1e-11 * fabs(u_f), 0.0);
    const int status = gsl_odeiv2_driver_apply(driver, &now, t, u);
    gsl_odeiv2_driver_free(driver);
    return status == GSL_SUCCESS ? u[0] : NAN;
}

/* --- coefficient ---------------------------------------------------------- */

double coefficient_of_force(double F, double rho_f, double d, double eps,
                            double u_r)
{
    const double U = eps * u_r;

    return 8.0 * F / (M_PI * rho_f * d * d * U * fabs(U)); /* [EW18 26] */
}

double coefficient_reynolds(double eps, double rho_f, double mu, double d,
                            double u_r)
{
    return drag_reynolds(rho_f, mu, d, eps * fabs(u_r)); /* [EW18 27, A.1] */
}

/* --- fluidization --------------------------------------------------------- */

/* Minimum fluidization. [EW18 22] is
 *
 *   (1 - eps) (rho_s - rho_f) g = beta u_mf,
 *
 * printed with the densities the other way round and without saying of which
 * velocity beta is the coefficient. u_mf is superficial, so beta is Ergun's
 * pressure drop over it, beta = 150 (1 - eps)^2 mu / (eps^3 d^2) +
 * 1.75 (1 - eps) rho_f u_mf / (eps^3 d). */

/* With a = beta of slow flow and b u_mf the rest, the positive root of
 * b u^2 + a u = w, without the difference of two large numbers. */
double fluidization_velocity(double eps_mf, double rho_f, double rho_s,
                             double mu, double d, double g)
{
    const double s = 1.0 - eps_mf, e3 = eps_mf * eps_mf * eps_mf;
    const double a = 150.0 * s * s * mu / (e3 * d * d);
    const double b = 1.75 * s * rho_f / (e3 * d);
    const double w = s * (rho_s - rho_f) * g;

    return w > 0.0 ? 2.0 * w / (a + sqrt(a * a + 4.0 * b * w)) : 0.0;
}

/* --- all laws ------------------------------------------------------------- */

const struct drag_law *const drag_laws[] = {&drag_syamlal_obrien,
                                            &drag_gidaspow,
                                            &drag_schiller_naumann,
                                            &drag_di_felice,
                                            &drag_di_felice_printed,
                                            &drag_beetstra,
                                            &drag_huilin_gidaspow,
                                            &drag_hill_koch_ladd,
                                            &drag_tenneti,
                                            &drag_rong,
                                            &drag_cello,
                                            &drag_dallavalle,
                                            &drag_haider_levenspiel,
                                            NULL};

MODEL_NAMED(drag_law)
