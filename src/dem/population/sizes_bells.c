/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sizes_bells.c -- Gauss's bell, of the diameter or of its logarithm. */
#include "dem/population/sizes_internal.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_randist.h>

static double normal_quantile(const struct sizes *s, double p)
{
    return s->mu +
           s->sigma * gsl_cdf_ugaussian_Pinv(s->low + p * (s->high - s->low));
}

/* By parts: M_k = mu M_(k-1) + (k - 1) sigma^2 M_(k-2) - sigma [d^(k-1) phi],
 * over the share of the bell that the cut-offs leave. */
static double normal_moment(const struct sizes *s, int k, double x)
{
    const double a = s->min, b = GSL_MIN_DBL(x, s->max);
    const double t_a = (a - s->mu) / s->sigma, t_b = (b - s->mu) / s->sigma;
    const double left = s->high - s->low;
    double before = 0.0, m = (gsl_cdf_ugaussian_P(t_b) - s->low) / left;

    if (x <= a) return 0.0;
    for (int j = 1; j <= k; j++) {
        const double ends = gsl_pow_int(b, j - 1) * gsl_ran_ugaussian_pdf(t_b) -
                            gsl_pow_int(a, j - 1) * gsl_ran_ugaussian_pdf(t_a);
        const double next = s->mu * m + (j - 1) * s->sigma * s->sigma * before -
                            s->sigma * ends / left;
        before = m;
        m = next;
    }
    return m;
}

static double lognormal_quantile(const struct sizes *s, double p)
{
    return exp(normal_quantile(s, p));
}

/* d^k times a bell in ln d is a bell again, k sigma^2 higher up. */
static double lognormal_moment(const struct sizes *s, int k, double x)
{
    const double up = k * s->sigma, end = GSL_MIN_DBL(x, s->max);
    const double t_a = (log(s->min) - s->mu) / s->sigma - up;
    const double t_b = (log(end) - s->mu) / s->sigma - up;

    if (x <= s->min) return 0.0;
    return exp(k * s->mu + 0.5 * up * up) *
           (gsl_cdf_ugaussian_P(t_b) - gsl_cdf_ugaussian_P(t_a)) /
           (s->high - s->low);
}

/* Between the cut-offs a and b, in the variable of the bell. */
static void cut_bell(struct sizes *s, double a, double b)
{
    s->low = gsl_cdf_ugaussian_P((a - s->mu) / s->sigma);
    s->high = gsl_cdf_ugaussian_P((b - s->mu) / s->sigma);
}

static void shape_normal(struct sizes *s, const struct sizes_options *o)
{
    s->min = o->min;
    s->max = o->max > 0.0 ? o->max : HUGE_VAL;
    s->mu = o->mean;
    s->sigma = o->deviation;
    cut_bell(s, s->min, s->max);
}

/* A lognormal mass is a lognormal number, 3 sigma^2 lower down. */
static void shape_lognormal(struct sizes *s, const struct sizes_options *o)
{
    s->min = o->min;
    s->max = o->max > 0.0 ? o->max : HUGE_VAL;
    s->mu = log(o->median);
    s->sigma = log(o->ratio);
    if (o->by_mass) s->mu -= 3.0 * s->sigma * s->sigma;
    cut_bell(s, log(s->min), log(s->max));
}

/* Cut-offs that leave less than this fraction of a bell are refused, because
 * the formulas then lose their digits. */
static const double least_left = 1e-6;

static const char *bell_wrong(const struct sizes_options *o)
{
    struct sizes s = {.n = 0};

    o->law->shape(&s, o);
    if (s.high - s.low < least_left)
        return "min and max leave less than 1e-6 of it";
    return NULL;
}

static const char *normal_wrong(const struct sizes_options *o)
{
    if (!(o->mean > 0.0 && o->deviation > 0.0))
        return "it needs mean > 0 and deviation > 0";
    if (!(o->min > 0.0 && o->max > 0.0))
        return "it needs min and max: a normal distribution has no ends, and "
               "its diameters would even be negative";
    if (o->by_mass)
        return "its shares are by number only; for shares by mass give a table";
    return bell_wrong(o);
}

static const char *lognormal_wrong(const struct sizes_options *o)
{
    return o->median > 0.0 && o->ratio > 1.0
               ? bell_wrong(o)
               : "it needs median > 0 and ratio > 1";
}

static const struct key normal_keys[] = {
    {"particles.sizes.mean", KEY_REAL, "m", "> 0", KEY_OPTIONAL,
     "mean of normal, before the cut-offs", "XS11 section 4.4", "",
     .at = KEY_AT(sizes_setup, of.mean)},
    {"particles.sizes.deviation", KEY_REAL, "m", "> 0", KEY_OPTIONAL,
     "standard deviation of normal, before the cut-offs", "XS11 section 4.4",
     "", .at = KEY_AT(sizes_setup, of.deviation)},
    KEY_END};

static const struct key lognormal_keys[] = {
    {"particles.sizes.median", KEY_REAL, "m", "> 0", KEY_OPTIONAL,
     "median of lognormal, before the cut-offs", "", "",
     .at = KEY_AT(sizes_setup, of.median)},
    {"particles.sizes.ratio", KEY_REAL, "-", "> 1", KEY_OPTIONAL,
     "of the 84 % quantile of lognormal to its median", "", "",
     .at = KEY_AT(sizes_setup, of.ratio)},
    KEY_END};

const struct sizes_law sizes_normal = {
    .name = "normal",
    .what = "a normal distribution between two cut-offs",
    .equations = "XS11 section 4.4",
    .function = "normal_quantile",
    .keys = {normal_keys, sizes_range_keys},
    .wrong = normal_wrong,
    .shape = shape_normal,
    .quantile = normal_quantile,
    .moment = normal_moment,
};

const struct sizes_law sizes_lognormal = {
    .name = "lognormal",
    .what = "a normal distribution of the logarithm of the diameter",
    .equations = "",
    .function = "lognormal_quantile",
    .keys = {lognormal_keys, sizes_range_keys, sizes_by_keys},
    .wrong = lognormal_wrong,
    .shape = shape_lognormal,
    .quantile = lognormal_quantile,
    .moment = lognormal_moment,
};
