/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sizes.c -- the distributions of diameters: bells, and those made of intervals
 * and of single diameters. */
#include "dem/population/sizes.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_randist.h>
#include <string.h>

#include "base/alloc.h"

/* Diameters from a to b, spread with a density that goes as d^-falling; all of
 * one size where a is b. */
struct piece {
    double a, b;  /* [m] */
    double below; /* [-] share of the particles in the pieces before it */
    double share; /* [-] of the particles, in this one */
};

struct sizes {
    const struct sizes_law *law;
    double min, max;           /* [m] */
    double own[MODEL_NUMBERS]; /* of the keys that the law alone reads */
    /* normal, of d [m]; lognormal, of ln(d / 1 m) [-] */
    double mu, sigma;
    double low, high; /* [-] shares of the whole bell below the cut-offs */
    /* uniform, discrete, table */
    int n, falling;
    struct piece *piece;
};

const char *sizes_wrong(const struct sizes_options *o)
{
    if (o->max > 0.0 && o->min >= o->max) return "min must be below max";
    return o->law->wrong(o);
}

struct sizes *sizes_create(const struct sizes_options *o)
{
    struct sizes *const s = owner_create(sizeof *s);

    s->law = o->law;
    memcpy(s->own, o->own, sizeof s->own);
    o->law->shape(s, o);
    return s;
}

/* Rounding must not lead out of the cut-offs. */
double sizes_quantile(const struct sizes *s, double p)
{
    const double d = s->law->quantile(s, p);
    return d < s->min ? s->min : d > s->max ? s->max : d;
}

double sizes_moment_below(const struct sizes *s, int k, double x)
{
    return s->law->moment(s, k, x);
}

double sizes_moment(const struct sizes *s, int k)
{
    return s->law->moment(s, k, HUGE_VAL);
}

double sizes_min(const struct sizes *s)
{
    return s->min;
}

double sizes_max(const struct sizes *s)
{
    return s->max;
}

/* Keys that several distributions read. */
static const struct key sizes_range_keys[] = {
    {"particles.sizes.min", KEY_REAL, "m", "> 0", KEY_OPTIONAL,
     "smallest diameter; needed by uniform and normal", "XS11 section 4.4", "",
     KEY_AT(sizes_setup, of.min)},
    {"particles.sizes.max", KEY_REAL, "m", "> 0", KEY_OPTIONAL,
     "largest diameter; needed by uniform and normal", "XS11 section 4.4", "",
     KEY_AT(sizes_setup, of.max)},
    KEY_END};

static const struct key sizes_by_keys[] = {
    {"particles.sizes.by", KEY_NAME, "", "number | mass", "number",
     "whether shares are of the number or of the mass of the particles", "", "",
     KEY_AT(sizes_setup, by)},
    KEY_END};

/* --- Gauss's bell, of the diameter or of its logarithm -------------------- */

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
     KEY_AT(sizes_setup, of.mean)},
    {"particles.sizes.deviation", KEY_REAL, "m", "> 0", KEY_OPTIONAL,
     "standard deviation of normal, before the cut-offs", "XS11 section 4.4",
     "", KEY_AT(sizes_setup, of.deviation)},
    KEY_END};

static const struct key lognormal_keys[] = {
    {"particles.sizes.median", KEY_REAL, "m", "> 0", KEY_OPTIONAL,
     "median of lognormal, before the cut-offs", "", "",
     KEY_AT(sizes_setup, of.median)},
    {"particles.sizes.ratio", KEY_REAL, "-", "> 1", KEY_OPTIONAL,
     "of the 84 % quantile of lognormal to its median", "", "",
     KEY_AT(sizes_setup, of.ratio)},
    KEY_END};

static const struct sizes_law sizes_normal = {
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

static const struct sizes_law sizes_lognormal = {
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

/* --- intervals and single diameters: uniform, discrete, table ------------- */

/* int_a^b d^n dd. */
static double power_integral(int n, double a, double b)
{
    return n == -1 ? log(b / a)
                   : (gsl_pow_int(b, n + 1) - gsl_pow_int(a, n + 1)) / (n + 1);
}

static double pieces_moment(const struct sizes *s, int k, double x)
{
    const int q = s->falling;
    double sum = 0.0;

    for (int i = 0; i < s->n; i++) {
        const struct piece *const p = &s->piece[i];
        const double end = GSL_MIN_DBL(x, p->b);
        if (x < p->a) continue;
        sum += p->share * (p->b > p->a ? power_integral(k - q, p->a, end) /
                                             power_integral(-q, p->a, p->b)
                                       : gsl_pow_int(p->a, k));
    }
    return sum;
}

/* Within a piece the share f lies below a + f (b - a), or, with a density that
 * falls as d^-3, below the d of 1/d^2 = 1/a^2 - f (1/a^2 - 1/b^2). */
static double pieces_quantile(const struct sizes *s, double p)
{
    int i = 0;

    while (i + 1 < s->n && p >= s->piece[i + 1].below)
        i++;
    const struct piece *const in = &s->piece[i];
    const double a = in->a, b = in->b;
    const double f = in->share > 0.0 ? (p - in->below) / in->share : 0.0;
    if (s->falling == 0) return a + GSL_MIN_DBL(f, 1.0) * (b - a);
    const double w = 1.0 - GSL_MIN_DBL(f, 1.0) * (1.0 - gsl_pow_2(a / b));
    return a / sqrt(w);
}

/* Adds the piece a ... b with the share that the case gives it. Of that share
 * of the mass, the particles are the more, the smaller they are. */
static void sizes_pieces_add_piece(struct sizes *s, double a, double b,
                                   double share, int by_mass)
{
    double weight = 1.0;

    if (by_mass)
        weight = b > a ? power_integral(-3, a, b) / (b - a) : 1.0 / (a * a * a);
    s->piece[s->n++] = (struct piece){a, b, 0.0, share * weight};
}

static void close_pieces(struct sizes *s)
{
    double sum = 0.0, below = 0.0;

    for (int i = 0; i < s->n; i++)
        sum += s->piece[i].share;
    for (int i = 0; i < s->n; i++) {
        s->piece[i].share /= sum;
        s->piece[i].below = below;
        below += s->piece[i].share;
    }
    s->min = s->piece[0].a;
    s->max = s->piece[s->n - 1].b;
}

static void begin_pieces(struct sizes *s, const struct sizes_options *o, int n)
{
    s->falling = o->by_mass ? 3 : 0;
    s->piece = owner_zeroed(s, (size_t)n, sizeof *s->piece);
}

static void shape_uniform(struct sizes *s, const struct sizes_options *o)
{
    begin_pieces(s, o, 1);
    sizes_pieces_add_piece(s, o->min, o->max, 1.0, o->by_mass);
    close_pieces(s);
}

/* Pieces from point to point of a table, or of points alone. */
static void shape_points(struct sizes *s, const struct sizes_options *o)
{
    const int table = o->law == &sizes_table;

    begin_pieces(s, o, o->n);
    for (int i = 0; i + table < o->n; i++) {
        const double *const from = o->point[i], *const to = o->point[i + table];
        sizes_pieces_add_piece(s, from[0], to[0],
                               to[1] - (table ? from[1] : 0.0), o->by_mass);
    }
    close_pieces(s);
}

static const char *uniform_wrong(const struct sizes_options *o)
{
    return o->min > 0.0 && o->max > 0.0 ? NULL : "it needs min and max";
}

static const char *points_wrong(const struct sizes_options *o)
{
    const int table = o->law == &sizes_table;
    double sum = 0.0;

    if (o->n < (table ? 2 : 1)) return "it has too few points";
    for (int i = 0; i < o->n; i++) {
        const double share = o->point[i][1];
        if (!(o->point[i][0] > 0.0)) return "a diameter must be > 0";
        if (i > 0 && o->point[i][0] <= o->point[i - 1][0])
            return "the diameters must rise";
        if (!(share >= 0.0)) return "a share must be >= 0";
        if (table && i > 0 && share < o->point[i - 1][1])
            return "the share below a diameter must not fall";
        sum += share;
    }
    if (table && (o->point[0][1] != 0.0 || o->point[o->n - 1][1] != 1.0))
        return "the share below the first diameter must be 0, below the last 1";
    return sum > 0.0 ? NULL : "the shares must not all be 0";
}

static const struct key points_keys[] = {
    {"particles.sizes.points", KEY_CURVE, "m, -", ">= 0", KEY_OPTIONAL,
     "((diameter, share), ...); of table the share below the diameter", "", "",
     KEY_AT(sizes_setup, points)},
    KEY_END};

static const struct sizes_law sizes_uniform = {
    .name = "uniform",
    .what = "all diameters between two ends, equally often",
    .equations = "",
    .function = "pieces_quantile",
    .keys = {sizes_range_keys, sizes_by_keys},
    .wrong = uniform_wrong,
    .shape = shape_uniform,
    .quantile = pieces_quantile,
    .moment = pieces_moment,
};

const struct sizes_law sizes_discrete = {
    .name = "discrete",
    .what = "single diameters, each with its share",
    .equations = "",
    .function = "pieces_quantile",
    .keys = {points_keys, sizes_by_keys},
    .wrong = points_wrong,
    .shape = shape_points,
    .quantile = pieces_quantile,
    .moment = pieces_moment,
};

const struct sizes_law sizes_table = {
    .name = "table",
    .what = "the share below a diameter, linear between points",
    .equations = "",
    .function = "pieces_quantile",
    .keys = {points_keys, sizes_by_keys},
    .wrong = points_wrong,
    .shape = shape_points,
    .quantile = pieces_quantile,
    .moment = pieces_moment,
};

const struct sizes_law *const sizes_laws[] = {&sizes_uniform,   &sizes_normal,
                                              &sizes_lognormal, &sizes_discrete,
                                              &sizes_table,     NULL};

MODEL_NAMED(sizes_law)
