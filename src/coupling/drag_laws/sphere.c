/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sphere.c -- laws of one sphere, alone or times a power of the fluid fraction,
 * and of a packed bed beside a suspension; and of one grain that is no sphere
 * (drag.h). */
#include "coupling/drag.h"

#include <gsl/gsl_math.h>
#include <math.h>

/* --- single sphere -------------------------------------------------------- */

/* One sphere in an unbounded stream, as schiller-naumann,
 * with other fits of its drag coefficient. The fluid fraction does not matter,
 * and the slip is the only one there is. */

/* C_d = (0.63 + 4.8 / sqrt(Re))^2 [DallaValle48], times Re / 24. */
static double dallavalle(double eps_f, double Re)
{
    const double root = 0.63 * sqrt(Re) + 4.8;

    (void)eps_f;
    return root * root / 24.0;
}

const struct drag_law drag_dallavalle = {
    .name = "dallavalle",
    .what = "one sphere, C_d = (0.63 + 4.8 / sqrt(Re))^2",
    .equations = "LS 5.2",
    .function = "dallavalle",
    .eps_min = 0.95,
    .eps_max = 1.0,
    .Re_max = 2e5,
    .factor = dallavalle,
    .alone = 1,
};

/* C_d = 24 / Re (1 + 0.1806 Re^0.6459) + 0.4251 / (1 + 6880.95 / Re), their fit
 * for spheres, 408 points with a mean error of 1.9 % in C_d [Haider89]. */
static double haider_levenspiel(double eps_f, double Re)
{
    (void)eps_f;
    return 1.0 + 0.1806 * pow(Re, 0.6459) +
           0.4251 * Re * Re / (24.0 * (Re + 6880.95));
}

const struct drag_law drag_haider_levenspiel = {
    .name = "haider-levenspiel",
    .what = "one sphere, fitted to 408 measurements",
    .equations = "LS 5.2",
    .function = "haider_levenspiel",
    .eps_min = 0.95,
    .eps_max = 1.0,
    .Re_max = 2.6e5,
    .factor = haider_levenspiel,
    .alone = 1,
};

/* Laws of one sphere, or of a packed bed, times a power of the
 * fluid fraction (drag.h). */

/* --- Di Felice ------------------------------------------------------------ */

/* The drag of one sphere at the superficial slip, times a power
 * of the fluid fraction that depends on Re,
 *
 *   F_d = (1/2) C_d rho_f (pi d^2 / 4) (eps_f u_r)^2 eps_f^-chi   [EW18 A.2]
 *
 * [DiFelice94]. This is the drag without the mean pressure gradient: in slow
 * flow a suspension then settles with eps_f^4.7 of the speed of one sphere,
 * and measured is 4.65.
 *
 * EW18 prints the square of the interstitial slip instead, and uses the result
 * as the whole force. The law "di-felice-printed" is that one; it is larger by
 * 1 / eps_f, and settles with the power 5.7. */

double drag_di_felice_exponent(double Re)
{
    const double a = 1.5 - log10(Re);

    return Re > 0.0 ? 3.7 - 0.65 * exp(-0.5 * a * a) : 3.7; /* [EW18 A.3] */
}

/* [EW18 A.2, A.4] over Stokes' law. */
static double di_felice_factor(double eps_f, double Re)
{
    return drag_sphere(Re) * pow(eps_f, -drag_di_felice_exponent(Re));
}

double drag_di_felice_force(double eps, double rho_f, double mu, double d,
                            double u_r)
{
    return M_PI / 6.0 * d * d * d *
           drag_resistance(&drag_di_felice, eps, rho_f, mu, d, u_r) * u_r;
}

const struct drag_law drag_di_felice = {
    .name = "di-felice",
    .what = "one sphere at the superficial slip, times a power of eps_f",
    .equations = "EW18 A.1-A.4",
    .function = "di_felice_factor",
    .eps_min = 0.4,
    .eps_max = 1.0,
    .Re_max = 1e4,
    .factor = di_felice_factor,
};

/* The whole force is (1/2) C_d rho_f (pi d^2 / 4) u_r^2 eps_f^-chi, so its
 * drag is eps_f times that: 1 / eps_f times Di Felice's. */
static double di_felice_printed_factor(double eps_f, double Re)
{
    return di_felice_factor(eps_f, Re) / eps_f;
}

const struct drag_law drag_di_felice_printed = {
    .name = "di-felice-printed",
    .what = "as EW18 prints Di Felice's law: 1 / eps_f times it",
    .equations = "EW18 A.1-A.4",
    .function = "di_felice_printed_factor",
    .eps_min = 0.4,
    .eps_max = 1.0,
    .Re_max = 1e4,
    .factor = di_felice_printed_factor,
};

/* --- Rong ----------------------------------------------------------------- */

/* Di Felice's form with an exponent that depends on the fluid
 * fraction too, fitted to lattice-Boltzmann simulations of packings [Rong13]:
 * the drag of one sphere at the superficial slip times eps_f^-chi. The drag
 * coefficient is DallaValle's. */

/* chi = 2.65 (eps_f + 1) - (5.3 - 3.5 eps_f) eps_f^2 exp(-(1.5 - log10 Re)^2 /
 * 2) [Rong13]. */
static double rong_exponent(double eps_f, double Re)
{
    const double a = 1.5 - log10(Re);
    const double bell = Re > 0.0 ? exp(-0.5 * a * a) : 0.0;

    return 2.65 * (eps_f + 1.0) - (5.3 - 3.5 * eps_f) * eps_f * eps_f * bell;
}

static double rong_factor(double eps_f, double Re)
{
    const double root = 0.63 * sqrt(Re) + 4.8; /* C_d Re = root^2 */

    return root * root / 24.0 * pow(eps_f, -rong_exponent(eps_f, Re));
}

const struct drag_law drag_rong = {
    .name = "rong",
    .what = "packings of spheres, from resolved flow; the form of Di Felice",
    .equations = "Rong13",
    .function = "rong_factor",
    .eps_min = 0.37,
    .eps_max = 1.0,
    .Re_max = 3e3,
    .factor = rong_factor,
};

/* --- Huilin and Gidaspow -------------------------------------------------- */

/* Ergun's packed bed and Wen and Yu's suspension, blended about eps_f = 0.8 by
 * an arcus tangens [Huilin03]: Gidaspow's law without its jump. */

/* beta_Ergun and beta_WenYu of [LS 5.27], over eps_s 18 mu eps_f / d^2. */
static double ergun_factor(double eps_f, double Re)
{
    return (150.0 * (1.0 - eps_f) + 1.75 * Re) / (18.0 * eps_f * eps_f);
}

static double wen_yu_factor(double eps_f, double Re)
{
    return drag_sphere(Re) * pow(eps_f, -3.65);
}

/* phi_gs = atan(150 x 1.75 (0.2 - eps_s)) / pi + 1/2, the weight of Wen and
 * Yu's law [Huilin03]. */
static double huilin_gidaspow_factor(double eps_f, double Re)
{
    const double phi = atan(262.5 * (eps_f - 0.8)) / M_PI + 0.5;

    return (1.0 - phi) * ergun_factor(eps_f, Re) +
           phi * wen_yu_factor(eps_f, Re);
}

const struct drag_law drag_huilin_gidaspow = {
    .name = "huilin-gidaspow",
    .what = "Gidaspow's law with its two branches blended",
    .equations = "LS 5.25-5.27",
    .function = "huilin_gidaspow_factor",
    .eps_min = 0.35,
    .eps_max = 1.0,
    .Re_max = 2e3,
    .factor = huilin_gidaspow_factor,
};

/* --- grains that are no spheres ------------------------------------------- */

/* C_d = 24 / Re (1 + A Re^B) + C / (1 + D / Re), their fit to 506 measurements
 * of spheres, isometric bodies and discs, times Re / 24 [Haider89]. In slow
 * flow it is Stokes' law for every shape. */
static double haider_levenspiel_shape(double psi, double Re)
{
    const double p2 = psi * psi, p3 = p2 * psi;
    const double A = exp(2.3288 - 6.4581 * psi + 2.4486 * p2);
    const double C = exp(4.905 - 13.8944 * psi + 18.4222 * p2 - 10.2599 * p3);
    const double D = exp(1.4681 + 12.2584 * psi - 20.7322 * p2 + 15.8855 * p3);

    return 1.0 + A * pow(Re, 0.0964 + 0.5565 * psi) +
           C * Re * Re / (24.0 * (Re + D));
}

/* Their C_d times Re / 24 [Hoelzer08]. The sphericities of the areas across and
 * along the flow are psi, which those of a convex body have in the mean over
 * all directions. */
static double hoelzer_sommerfeld_shape(double psi, double Re)
{
    const double slow = 24.0 / sqrt(psi), between = 3.0 / pow(psi, 0.75);
    const double fast = 0.42 * pow(10.0, 0.4 * pow(-log10(psi), 0.2)) / psi;

    return (slow + between * sqrt(Re) + fast * Re) / 24.0;
}

static const struct drag_shape drag_shape_sauter = {
    .name = "sauter",
    .what = "the drag law at six volumes over the surface, alone or in a bed",
    .equations = "",
    .function = "clumps_grain",
};

static const struct drag_shape drag_shape_haider_levenspiel = {
    .name = "haider-levenspiel",
    .what = "for a lone grain their C_d of its sphericity over that of a "
            "sphere; not for Re < 1",
    .equations = "Haider89",
    .function = "haider_levenspiel_shape",
    .factor = haider_levenspiel_shape,
};

static const struct drag_shape drag_shape_hoelzer_sommerfeld = {
    .name = "hoelzer-sommerfeld",
    .what = "for a lone grain their C_d of its sphericity over that of a "
            "sphere, in slow flow too",
    .equations = "Hoelzer08",
    .function = "hoelzer_sommerfeld_shape",
    .factor = hoelzer_sommerfeld_shape,
};

const struct drag_shape *const drag_shapes[] = {
    &drag_shape_sauter, &drag_shape_haider_levenspiel,
    &drag_shape_hoelzer_sommerfeld, NULL};

double drag_shape_ratio(const struct drag_shape *shape, double psi, double Re)
{
    const double most = fmin(Re, 1e9); /* without viscosity too */
    const double p = fmin(psi, 1.0);   /* a sphere's may be rounded */

    return shape->factor == NULL
               ? 1.0
               : shape->factor(p, most) / shape->factor(1.0, most);
}

double drag_shape_lone(double eps_f)
{
    return fmax(0.0, fmin(1.0, (eps_f - 0.8) / 0.2));
}
