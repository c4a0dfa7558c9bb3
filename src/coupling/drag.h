/* drag.h -- the steady force of the fluid on one particle.
 * Chapter "Drag".
 *
 * The documents write the force as (V_p beta / eps_s) (u_f - u_p), with beta a
 * correlation proportional to eps_s [XS11 2.9-2.11]. We work with
 *
 *   beta / eps_s = resistance(eps_f, rho_f, mu, d, u_r)      [kg/(m^3 s)],
 *
 * the force per volume of solid and per slip speed: it is finite for a lone
 * particle (eps_s = 0) and for a particle at rest in the fluid (u_r = 0).
 * u_r = |u_f - u_p| is the slip to the interstitial velocity.
 */
#ifndef COUPLING_DRAG_H
#define COUPLING_DRAG_H

#include "base/model.h"

/* The descriptor of a drag law. */

/* One correlation. resistance: eps_f [-], rho_f [kg/m^3], mu [Pa s], d [m],
 * u_r [m/s] -> beta / eps_s [kg/(m^3 s)]. */
struct drag_law {
    MODEL_MEMBERS;           /* base/model.h */
    double eps_min, eps_max; /* [-] fluid fractions of its data, */
    double Re_min, Re_max;   /* [-] and eps_f rho_f d u_r / mu; `winnow check`
                                warns outside of them */
    double (*resistance)(double eps_f, double rho_f, double mu, double d,
                         double u_r);
    /* In its place, of a law that is one: the factor F of drag_by_factor; alone
     * = 1: its eps_f is always 1. */
    double (*factor)(double eps_f, double Re);
    int alone;
    /* The same for n particles, to rounding; NULL: one by one. */
    void (*resistance_many)(int n, const double *eps_f, double rho_f, double mu,
                            const double *d, const double *u_r,
                            double *resistance);
    /* A law with keys of its own (base/model.h), one of the tables above, has
     * this function instead. Their numbers are those of the case; in the
     * descriptor, those with which the law is tested. */
    const struct key *own_keys;
    double own[MODEL_NUMBERS];
    double (*resistance_with)(const double *own, double eps_f, double rho_f,
                              double mu, double d, double u_r);
};

/* All laws, ended by NULL; drag_law_named: NULL if unknown. */
extern const struct drag_law drag_syamlal_obrien, drag_gidaspow,
    drag_schiller_naumann, drag_di_felice, drag_di_felice_printed,
    drag_beetstra, drag_huilin_gidaspow, drag_hill_koch_ladd, drag_tenneti,
    drag_rong, drag_cello, drag_dallavalle, drag_haider_levenspiel;
extern const struct drag_law *const drag_laws[];
const struct drag_law *drag_law_named(const char *name);

/* What the shape of a grain changes. With the diameter of Sauter, psi times
 * that of the sphere of its volume, Ergun's equation holds for a bed of grains
 * of any shape, but a lone grain has 1/psi^2 of the slow drag of that sphere,
 * which is too much. factor: the sphericity psi [-], Re with the diameter of
 * the volume
 * -> C_d Re / 24 [-] of a lone grain; NULL: none. */
struct drag_shape {
    MODEL_MEMBERS;
    double (*factor)(double psi, double Re);
};
extern const struct drag_shape *const drag_shapes[]; /* ended by NULL */

/* Drag of a lone grain over that of the sphere of its volume [-], where both
 * are of the same fit: those of the laws for shapes are none for spheres. */
double drag_shape_ratio(const struct drag_shape *shape, double psi, double Re);

/* How far a grain is alone [-]: 0 where Ergun's equation holds, up to eps_f =
 * 0.8, and 1 without neighbours; linear between, which is our choice. */
double drag_shape_lone(double eps_f);

/* beta [kg/(m^3 s)] of a mixture of one size [XS11 2.11, LS 5.27]. */
double drag_beta(const struct drag_law *law, double eps_s, double rho_f,
                 double mu, double d, double u_r);

/* B [kg/s]: the drag on a particle is eps_f B (u_f - u_p) [XS11 2.10]. */
double drag_coefficient(const struct drag_law *law, double eps_s, double rho_f,
                        double mu, double d, double u_r);

/* The time in which drag would stop a particle [s] [XS11 3.16, 3.17]. */
double drag_relaxation_time(const struct drag_law *law, double rho_s,
                            double eps_s, double rho_f, double mu, double d,
                            double u_r);

/* Re = rho_f d u_r / mu [-] [XS11 2.12]. */
double drag_reynolds(double rho_f, double mu, double d, double u_r);

/* Terminal velocity of a suspension over that of one sphere [-] [XS11 2.13,
 * 2.14], after Syamlal and O'Brien. */
double drag_terminal_ratio(double Re, double eps_f);

/* Drag coefficient of a sphere in a suspension [-] [LS 5.26], after Wen and
 * Yu; alpha is the fluid fraction. Above alpha Re = 1000 it is 0.44. */
double drag_wen_yu_cd(double alpha, double Re);

/* C_d Re / 24 of one sphere, the correction to Stokes' law [LS 5.13]. */
double drag_sphere(double Re);

/* Force on one sphere with drag coefficient C_D [N] [LS 5.2]. */
double drag_force(double rho_f, double C_D, double d, double u_r);

/* Relaxation time of one sphere after Stokes [s] [LS 5.12]. */
double drag_stokes_time(double rho_p, double d, double mu);

/* The same with the correction of Schiller and Naumann [s] [LS 5.13]. */
double drag_schiller_naumann_time(double rho_p, double d, double mu, double Re);

/* The slip at which the drag carries the weight less the buoyancy, where eps_s
 * is solid [m/s]. */
double drag_settling_slip(const struct drag_law *law, double rho_s,
                          double eps_s, double rho_f, double mu, double d,
                          double g);

/* Velocity after the time t of a particle at rest that a fluid of velocity u_f
 * takes along, du/dt = (u_f - u) / tau_p(|u_f - u|) with tau_p of
 * Syamlal-O'Brien at a constant solids fraction [m/s]; nan for t < 0.
 * [XS11 4.1] */
double drag_released(double rho_s, double eps_s, double rho_f, double mu,
                     double d, double u_f, double t);

/* A force on a sphere as a drag coefficient.
 *
 * EW18 measures a force by the superficial slip, eps times the interstitial
 * slip u_r [m/s]; F [N] is the whole force along it. */

/* C_d = 8 F / (pi rho_f d^2 eps^2 u_r^2) [-] [EW18 26]; it has the sign of F
 * and u_r. */
double coefficient_of_force(double F, double rho_f, double d, double eps,
                            double u_r);

/* Re_p = rho_f d eps |u_r| / mu [-] [EW18 27, A.1]. */
double coefficient_reynolds(double eps, double rho_f, double mu, double d,
                            double u_r);

/* Minimum fluidization. */

/* The superficial velocity u_mf [m/s] at which Ergun's pressure drop carries
 * the weight of a bed of the fluid fraction eps_mf less its buoyancy [EW18 22];
 * g [m/s^2]. 0 for a bed that is not heavier than the fluid. */
double fluidization_velocity(double eps_mf, double rho_f, double rho_s,
                             double mu, double d, double g);

/* --- factor --------------------------------------------------------------- */

/* Laws that are given as a factor to Stokes' law.
 *
 * Simulations that resolve the flow around the spheres report the drag on one
 * of them over Stokes' law at the superficial slip U = eps_f u_r,
 *
 *   F_d = 3 pi mu d U F(eps_f, Re),   Re = rho_f d U / mu.
 *
 * F_d is what law->resistance wants: without the force -V_p grad p of the mean
 * pressure gradient. In an even, steady bed the whole force is F_d / eps_f,
 * for the fluid's share eps_f of the gradient balances the drag. Some papers
 * give the whole force; their factor times eps_f is F. */

/* beta / eps_s [kg/(m^3 s)] of the factor F. From Re = 1e9 on, and without
 * viscosity, the drag coefficient is that of Re = 1e9. An averaged eps_f may be
 * above 1 by rounding or by an undershoot; F, with roots of 1 - eps_f, is then
 * that of eps_f = 1. */
static inline double drag_by_factor(double (*F)(double eps_f, double Re),
                                    double eps_f, double rho_f, double mu,
                                    double d, double u_r)
{
    const double fast = 1e9, Re = drag_reynolds(rho_f, mu, d, eps_f * u_r);
    const double eps = eps_f < 1.0 ? eps_f : 1.0;

    if (Re < fast) return 18.0 * mu / (d * d) * eps_f * F(eps, Re);
    return 18.0 * rho_f * eps_f * u_r / d * eps_f * F(eps, fast) / fast;
}

/* beta / eps_s [kg/(m^3 s)] by the law. */
static inline double drag_resistance(const struct drag_law *law, double eps_f,
                                     double rho_f, double mu, double d,
                                     double u_r)
{
    if (law->factor != NULL)
        return drag_by_factor(law->factor, law->alone ? 1.0 : eps_f, rho_f, mu,
                              d, u_r);
    return law->resistance != NULL
               ? law->resistance(eps_f, rho_f, mu, d, u_r)
               : law->resistance_with(law->own, eps_f, rho_f, mu, d, u_r);
}

/* Drag after Di Felice. */

/* The exponent chi [-] of the fluid fraction [EW18 A.3]. */
double drag_di_felice_exponent(double Re);

/* Drag [N] without the mean pressure gradient [EW18 A.2]: u_r [m/s] is the
 * interstitial slip, of which the superficial one, eps u_r, is squared. */
double drag_di_felice_force(double eps, double rho_f, double mu, double d,
                            double u_r);

/* Drag after Beetstra and others. */

/* The factor g [-] to Stokes' law [EW18 A.6]; Re with the superficial slip. */
double drag_beetstra_factor(double eps, double Re);

/* 3 pi mu d u_r g [N], u_r [m/s] interstitial [EW18 A.5]: the whole force,
 * with the part of the mean pressure gradient. */
double drag_beetstra_force(double eps, double rho_f, double mu, double d,
                           double u_r);

#endif
