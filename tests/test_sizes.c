/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Distributions of diameters: the drawn diameters have the reported moments,
 * and these are exact. */
#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_randist.h>
#include <string.h>

#include "base/alloc.h"
#include "dem/population/sizes.h"
#include "facts.h"

static const double sieves[][2] = {
    {1e-4, 0.0}, {2e-4, 0.1}, {5e-4, 0.1}, {8e-4, 0.7}, {2e-3, 1.0}};
static const double two[][2] = {{1e-3, 3.0}, {2e-3, 1.0}};

/* XS11 section 4.4, and one of each other kind; by number, then by mass. */
static const struct {
    const char *law;
    struct sizes_options o;
} kinds[] = {
    {"normal",
     {.mean = 1.25e-3, .deviation = 0.5e-3, .min = 8.3e-5, .max = 2.5e-3}},
    {"uniform", {.min = 1e-3, .max = 3e-3}},
    {"lognormal", {.median = 1e-3, .ratio = 1.5}},
    {"lognormal", {.median = 1e-3, .ratio = 1.5, .min = 5e-4, .max = 1.8e-3}},
    {"discrete", {.n = 2, .point = two}},
    {"table", {.n = 5, .point = sieves}},
    {"uniform", {.min = 1e-3, .max = 3e-3, .by_mass = 1}},
    {"lognormal", {.median = 1e-3, .ratio = 1.5, .by_mass = 1}},
    {"discrete", {.n = 2, .point = two, .by_mass = 1}},
    {"table", {.n = 5, .point = sieves, .by_mass = 1}}};
enum { KINDS = sizeof kinds / sizeof *kinds };

static struct sizes *kind(int i)
{
    struct sizes_options o = kinds[i].o;

    o.law = sizes_law_named(kinds[i].law);
    ck_assert_ptr_nonnull(o.law);
    ck_assert_ptr_null(sizes_wrong(&o));
    return sizes_create(&o);
}

/* The middle of every 1/N of the particles: the error of this rule is of
 * order 1/N^2, and 1/N where the quantile jumps or has a tail without end. */
FACT_FOR_EACH(drawn_diameters_have_the_given_moments, KINDS)
{
    enum { N = 100000 };
    struct sizes *const s = kind(_i);

    for (int k = 0; k <= 3; k++) {
        double sum = 0.0;
        for (int i = 0; i < N; i++)
            sum += gsl_pow_int(sizes_quantile(s, (i + 0.5) / N), k) / N;
        ck_assert_double_eq_tol(sum / sizes_moment(s, k), 1.0, 3e-4);
    }
    owner_free(s);
}

/* M_0 of the quantile of p is p, but for a jump of "discrete", where it is at
 * least p; and no quantile is outside of the cut-offs. */
FACT_FOR_EACH(the_quantile_is_the_inverse_of_the_cumulative_distribution, KINDS)
{
    struct sizes *const s = kind(_i);
    const int jumps = strcmp(kinds[_i].law, "discrete") == 0;
    double last = 0.0;

    for (int i = 0; i < 1000; i++) {
        const double p = i / 1000.0, d = sizes_quantile(s, p);
        const double below = sizes_moment_below(s, 0, d);
        if (jumps)
            ck_assert_double_ge(below, p);
        else
            ck_assert_double_eq_tol(below, p, 1e-9);
        ck_assert_double_ge(d, sizes_min(s));
        ck_assert_double_le(d, sizes_max(s));
        ck_assert_double_ge(d, last);
        last = d;
    }
    ck_assert_double_eq_tol(sizes_moment(s, 0), 1.0, 1e-14);
    ck_assert_double_eq(sizes_moment_below(s, 0, 0.5 * sizes_min(s)), 0.0);
    owner_free(s);
}

struct bell {
    int k;
};

static double bell_of_case_4(double d, void *p)
{
    return gsl_pow_int(d, ((const struct bell *)p)->k) *
           gsl_ran_gaussian_pdf(d - 1.25e-3, 0.5e-3);
}

static double integral(int k, double a, double b)
{
    struct bell bell = {k};
    gsl_function f = {bell_of_case_4, &bell};
    gsl_integration_workspace *const w = gsl_integration_workspace_alloc(100);
    double sum, error;

    gsl_integration_qag(&f, a, b, 0.0, 1e-12, 100, GSL_INTEG_GAUSS61, w, &sum,
                        &error);
    gsl_integration_workspace_free(w);
    return sum;
}

/* The bell of Case 4, integrated by brute force up to the borders of the three
 * groups that the paper colours. Without the cut at 0.083 mm 0.6 % would be
 * smaller, and some negative. */
FACT(xs11_case_4_has_the_moments_of_a_bell_with_cut_offs)
{
    static const double border[3] = {0.83e-3, 1.67e-3, 2.5e-3};
    struct sizes *const s = kind(0);

    for (int k = 0; k <= 3; k++)
        for (int g = 0; g < 3; g++) {
            const double exact =
                integral(k, 8.3e-5, border[g]) / integral(0, 8.3e-5, 2.5e-3);
            const double ours = sizes_moment_below(s, k, border[g]);
            ck_assert_double_eq_tol(ours / exact, 1.0, 1e-11);
        }
    owner_free(s);
}

/* With cut-offs eight deviations away: mu, mu^2 + s^2, mu^3 + 3 mu s^2. */
FACT(a_bell_far_from_its_cut_offs_has_the_moments_of_gauss)
{
    const struct sizes_options o = {.law = sizes_law_named("normal"),
                                    .mean = 1.0,
                                    .deviation = 0.1,
                                    .min = 0.2,
                                    .max = 1.8};
    struct sizes *const s = sizes_create(&o);

    ck_assert_double_eq_tol(sizes_moment(s, 1), 1.0, 1e-13);
    ck_assert_double_eq_tol(sizes_moment(s, 2), 1.01, 1e-13);
    ck_assert_double_eq_tol(sizes_moment(s, 3), 1.03, 1e-13);
    ck_assert_double_eq_tol(sizes_quantile(s, 0.841344746), 1.1, 1e-9);
    owner_free(s);
}

FACT(a_uniform_distribution_has_its_textbook_moments)
{
    struct sizes *const s = kind(1);

    ck_assert_double_eq_tol(sizes_moment(s, 1), 2e-3, 1e-16);
    ck_assert_double_eq_tol(sizes_moment(s, 2), 13.0 / 3.0 * 1e-6, 1e-19);
    ck_assert_double_eq_tol(sizes_moment(s, 3), 10e-9, 1e-21);
    ck_assert_double_eq_tol(sizes_quantile(s, 0.25), 1.5e-3, 1e-16);
    owner_free(s);
}

/* Moments exp(k mu + k^2 s^2 / 2); the 84 % quantile is the ratio; and half of
 * the mass lies below exp(3 s^2) times the median (Hatch and Choate). */
FACT(a_lognormal_distribution_has_its_textbook_moments)
{
    struct sizes *const s = kind(2);
    const double v = gsl_pow_2(log(1.5));

    for (int k = 1; k <= 3; k++)
        ck_assert_double_eq_tol(sizes_moment(s, k) / gsl_pow_int(1e-3, k) /
                                    exp(0.5 * k * k * v),
                                1.0, 1e-13);
    ck_assert_double_eq_tol(sizes_quantile(s, 0.8413447460685429), 1.5e-3,
                            1e-14);
    ck_assert_double_eq_tol(sizes_moment_below(s, 3, 1e-3 * exp(3.0 * v)),
                            0.5 * sizes_moment(s, 3), 1e-21);
    owner_free(s);
}

/* Given by mass, half of the mass lies below the median. */
FACT(a_lognormal_mass_has_its_median_by_mass)
{
    struct sizes *const s = kind(7);

    ck_assert_double_eq_tol(sizes_moment_below(s, 3, 1e-3) / sizes_moment(s, 3),
                            0.5, 1e-13);
    ck_assert_double_lt(sizes_quantile(s, 0.5), 0.7e-3);
    owner_free(s);
}

/* Of equal masses of two sizes, one twice as large, 8 of 9 particles are
 * small; of 3 to 1 by mass, 24 of 25. */
FACT(fractions_by_mass_are_fractions_by_number_times_d_cubed)
{
    struct sizes *const number = kind(4), *const mass = kind(8);

    ck_assert_double_eq_tol(sizes_moment_below(number, 0, 1e-3), 0.75, 1e-15);
    ck_assert_double_eq_tol(sizes_moment_below(mass, 0, 1e-3), 24.0 / 25.0,
                            1e-15);
    ck_assert_double_eq(sizes_quantile(mass, 0.9599), 1e-3);
    ck_assert_double_eq(sizes_quantile(mass, 0.9601), 2e-3);
    owner_free(number);
    owner_free(mass);
}

/* A sieve analysis by mass comes back as the mass of what is drawn; between
 * two sieves in proportion, and an empty class has no particles. */
FACT(a_sieve_analysis_by_mass_is_met_by_the_mass)
{
    struct sizes *const s = kind(9);
    const double all = sizes_moment(s, 3);

    for (int i = 0; i < 5; i++)
        ck_assert_double_eq_tol(sizes_moment_below(s, 3, sieves[i][0]) / all,
                                sieves[i][1], 1e-14);
    ck_assert_double_eq_tol(sizes_moment_below(s, 3, 6.5e-4) / all, 0.4, 1e-14);
    ck_assert_double_eq(sizes_moment_below(s, 0, 2e-4),
                        sizes_moment_below(s, 0, 5e-4));
    owner_free(s);
}

static void refused(const char *law, struct sizes_options o, const char *why)
{
    o.law = sizes_law_named(law);
    const char *const wrong = sizes_wrong(&o);
    ck_assert_ptr_nonnull(wrong);
    ck_assert_msg(strstr(wrong, why) != NULL, "no \"%s\" in %s", why, wrong);
}

FACT(a_distribution_that_cannot_be_is_refused)
{
    static const double down[][2] = {{2.0, 0.0}, {1.0, 1.0}};
    static const double none[][2] = {{1.0, 0.0}, {2.0, 0.0}};
    static const double fall[][2] = {{1.0, 0.0}, {2.0, 0.6}, {3.0, 0.4}};
    static const double less[][2] = {{1.0, 0.0}, {2.0, -0.1}};
    typedef struct sizes_options o;

    ck_assert_ptr_null(sizes_law_named("gauss"));
    refused("uniform", (o){.min = 2.0, .max = 1.0}, "min must be below");
    refused("uniform", (o){.min = 2.0}, "needs min and max");
    refused("normal", (o){.min = 1.0, .max = 2.0}, "mean > 0");
    refused("normal", (o){.mean = 1.0, .deviation = 1.0}, "negative");
    refused("normal",
            (o){.mean = 1, .deviation = 1, .min = 1, .max = 2, .by_mass = 1},
            "by number only");
    refused("normal", (o){.mean = 1, .deviation = 0.1, .min = 2, .max = 3},
            "less than 1e-6");
    refused("lognormal", (o){.median = 1.0, .ratio = 1.0}, "ratio > 1");
    refused("discrete", (o){.n = 0}, "too few");
    refused("discrete", (o){.n = 2, .point = down}, "must rise");
    refused("discrete", (o){.n = 2, .point = none}, "not all be 0");
    refused("discrete", (o){.n = 2, .point = less}, ">= 0");
    refused("table", (o){.n = 1, .point = down}, "too few");
    refused("table", (o){.n = 3, .point = fall}, "must not fall");
    refused("table", (o){.n = 2, .point = none}, "below the last 1");
}
