/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sizes_pieces.c -- distributions that are made of intervals and of single
 * diameters: uniform, discrete, table. */
#include "dem/population/sizes_internal.h"

#include <gsl/gsl_math.h>

#include "base/alloc.h"

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
    s->piece = alloc_zeroed((size_t)n, sizeof *s->piece);
}

static void shape_uniform(struct sizes *s, const struct sizes_options *o)
{
    begin_pieces(s, o, 1);
    sizes_pieces_add_piece(s, o->min, o->max, 1.0, o->by_mass);
    close_pieces(s);
}

static void shape_discrete(struct sizes *s, const struct sizes_options *o)
{
    begin_pieces(s, o, o->n);
    for (int i = 0; i < o->n; i++)
        sizes_pieces_add_piece(s, o->point[i][0], o->point[i][0],
                               o->point[i][1], o->by_mass);
    close_pieces(s);
}

static void shape_table(struct sizes *s, const struct sizes_options *o)
{
    begin_pieces(s, o, o->n);
    for (int i = 0; i + 1 < o->n; i++)
        sizes_pieces_add_piece(s, o->point[i][0], o->point[i + 1][0],
                               o->point[i + 1][1] - o->point[i][1], o->by_mass);
    close_pieces(s);
}

static const char *uniform_wrong(const struct sizes_options *o)
{
    return o->min > 0.0 && o->max > 0.0 ? NULL : "it needs min and max";
}

static const char *points_wrong(const struct sizes_options *o, int table)
{
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

static const char *discrete_wrong(const struct sizes_options *o)
{
    return points_wrong(o, 0);
}

static const char *table_wrong(const struct sizes_options *o)
{
    return points_wrong(o, 1);
}

static const struct key points_keys[] = {
    {"particles.sizes.points", KEY_CURVE, "m, -", ">= 0", KEY_OPTIONAL,
     "((diameter, share), ...); of table the share below the diameter", "", "",
     .at = KEY_AT(sizes_setup, points)},
    KEY_END};

const struct sizes_law sizes_uniform = {
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
    .wrong = discrete_wrong,
    .shape = shape_discrete,
    .quantile = pieces_quantile,
    .moment = pieces_moment,
};

const struct sizes_law sizes_table = {
    .name = "table",
    .what = "the share below a diameter, linear between points",
    .equations = "",
    .function = "pieces_quantile",
    .keys = {points_keys, sizes_by_keys},
    .wrong = table_wrong,
    .shape = shape_table,
    .quantile = pieces_quantile,
    .moment = pieces_moment,
};
