/* SPDX-License-Identifier: GPL-3.0-or-later */
/* equations_drag.c -- every drag law by its name, for `winnow eval`. */
#include "case/report/equations.h"

#include <math.h>
#include <stddef.h>

#include "coupling/drag.h"

/* The drag over Stokes' law at the superficial slip eps_f u_r, x = eps_f and
 * the Reynolds number of that slip: beta/eps_s of (9.7) over 18 mu eps_f/d^2.
 * In units of d, rho_f and mu. */
static double factor(const char *law, const double *x)
{
    if (x[0] > 1.0 || x[1] < 0.0) return NAN;
    return drag_law_named(law)->resistance(x[0], 1.0, 1.0, 1.0, x[1] / x[0]) /
           (18.0 * x[0]);
}

static double syamlal_obrien(const double *x)
{
    return factor("syamlal-obrien", x);
}

static double gidaspow(const double *x)
{
    return factor("gidaspow", x);
}

static double schiller_naumann(const double *x)
{
    return factor("schiller-naumann", x);
}

static double di_felice(const double *x)
{
    return factor("di-felice", x);
}

static double di_felice_printed(const double *x)
{
    return factor("di-felice-printed", x);
}

static double beetstra(const double *x)
{
    return factor("beetstra", x);
}

static double huilin_gidaspow(const double *x)
{
    return factor("huilin-gidaspow", x);
}

static double hill_koch_ladd(const double *x)
{
    return factor("hill-koch-ladd", x);
}

static double tenneti(const double *x)
{
    return factor("tenneti", x);
}

static double rong(const double *x)
{
    return factor("rong", x);
}

static double cello(const double *x)
{
    return factor("cello", x);
}

static double dallavalle(const double *x)
{
    return factor("dallavalle", x);
}

static double haider_levenspiel(const double *x)
{
    return factor("haider-levenspiel", x);
}

#define LAW(name, what, function)                                              \
    {                                                                          \
        "drag:" name, what,                                                    \
            "F = F_d / (3 pi mu d eps_f u_r), Re = eps_f "                     \
            "rho_f d u_r / mu",                                                \
            "eps_f [-], Re [-]", "F", "-", #function, function                 \
    }

const struct equation equations_drag[] = {
    LAW("syamlal-obrien", "drag over Stokes' law after Syamlal and O'Brien",
        syamlal_obrien),
    LAW("gidaspow", "drag over Stokes' law after Ergun, Wen and Yu", gidaspow),
    LAW("schiller-naumann", "drag over Stokes' law of one sphere",
        schiller_naumann),
    LAW("di-felice", "drag over Stokes' law after Di Felice", di_felice),
    LAW("di-felice-printed", "the same as EW18 prints it", di_felice_printed),
    LAW("beetstra", "drag over Stokes' law after Beetstra", beetstra),
    LAW("huilin-gidaspow", "drag over Stokes' law after Huilin and Gidaspow",
        huilin_gidaspow),
    LAW("hill-koch-ladd", "drag over Stokes' law after Hill, Koch and Ladd",
        hill_koch_ladd),
    LAW("tenneti", "drag over Stokes' law after Tenneti", tenneti),
    LAW("rong", "drag over Stokes' law after Rong", rong),
    LAW("cello", "drag over Stokes' law after Cello", cello),
    LAW("dallavalle", "drag over Stokes' law of one sphere, DallaValle",
        dallavalle),
    LAW("haider-levenspiel",
        "drag over Stokes' law of one sphere, Haider and Levenspiel",
        haider_levenspiel),
    {NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL}};
