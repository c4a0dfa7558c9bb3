/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/outcome.h"

#include "base/alloc.h"
#include "base/statistics.h"

#include <gsl/gsl_math.h>
#include <stdlib.h>
#include <string.h>

/* --- one variant ---------------------------------------------------------- */

/* The standard error of a time, over it, that other programs on the machine
 * cause: two times are a tenth apart if they are by two of their difference. */
static const double scatter_of_time = 0.05 * M_SQRT1_2;

/* 1 for times of the summary, "seconds.dem", "effect_seconds.saffman". */
static int is_time(const struct measure *m)
{
    return strstr(m->name, "seconds.") != NULL;
}

/* The least that the repetitions of a variant with the k-th seed cost; nan if
 * none has ended. */
static double least_cost(const struct outcomes *o, int v, int k,
                         const struct measure *m)
{
    double least = NAN;

    for (int i = 0; i < o->n_runs; i++) {
        const struct run *const r = &o->run[i];
        if (r->variant != v || r->seed != k || r->code != 0) continue;
        struct curve c = measure_take(m, r->folder);
        if (c.n > 0) least = fmin(least, c.value[0]);
        curve_free(&c);
    }
    return least;
}

/* The mean over the seeds; *scatter is its standard error. */
static double outcome_cost_of(const struct outcomes *o, int v,
                              const struct measure *m, double *scatter)
{
    const int n = o->plan->seeds;
    double *const least = alloc_doubles(n);

    for (int k = 0; k < n; k++)
        least[k] = least_cost(o, v, k, m);
    const double mean = moments_mean(n, least);
    *scatter = fmax(curve_scatter(n, least),
                    is_time(m) ? scatter_of_time * mean : 0.0);
    free(least);
    return mean;
}

static struct curve mean_of_seeds(const struct outcomes *o, int v,
                                  const struct measure *m)
{
    struct curve *const of = alloc_zeroed((size_t)o->plan->seeds, sizeof *of);
    struct curve mean = {0};
    int n = 0;

    for (int i = 0; i < o->n_runs; i++) {
        const struct run *const r = &o->run[i];
        if (r->variant != v || r->time != 0) continue;
        of[n] = measure_take(m, r->folder);
        n += of[n].n > 0;
    }
    if (n > 0) mean = curve_mean(n, of);
    for (int i = 0; i < n; i++)
        curve_free(&of[i]);
    free(of);
    return mean;
}

static const struct measure processor = {
    .column = -1, .file = "summary.json", .name = PLAN_COST};

static void take_variant(struct outcomes *o, int v)
{
    const struct plan *const p = o->plan;
    struct outcome *const out = &o->variant[v];

    out->label = choices_label(&p->choices, v, -1);
    out->ended = 1;
    for (int i = 0; i < o->n_runs; i++)
        if (o->run[i].variant == v && o->run[i].code != 0) {
            out->ended = 0;
            if (out->broken == NULL) out->broken = &o->run[i];
        }
    out->seconds = outcome_cost_of(o, v, &processor, &out->scatter);
    out->cost = outcome_cost_of(o, v, &p->cost, &out->scatter);
    for (int m = 0; m < p->n_measures && out->ended; m++)
        out->of[m].found = mean_of_seeds(o, v, &p->measure[m]);
}

/* --- the truth ------------------------------------------------------------ */

/* The finest variant has the last entry of every choice. */
static int finest(const struct outcomes *o)
{
    return o->n - 1;
}

/* The last three entries of a line, from coarse to fine. */
struct last_three {
    const struct curve *c[3];
    double h[3], p; /* p: the order at which they approach each other */
};

static struct last_three last_of(const struct outcomes *o, int v, int m)
{
    const struct choice *const axis = &o->plan->choices.of[o->axis];
    struct last_three l;

    for (int k = 0; k < 3; k++) {
        const int entry = axis->n - 3 + k;
        l.c[k] = &o->variant[choices_with(&o->plan->choices, v, o->axis, entry)]
                      .of[m]
                      .found;
        l.h[k] = choices_size(axis, entry);
    }
    l.p = curve_richardson(l.h, curve_changes(l.c[0], l.c[1], l.c[2]));
    return l;
}

/* The truth at a point; *uncertainty is its standard error. */
static double truth_at(const struct outcomes *o, int v, int m, double x,
                       double *uncertainty)
{
    const struct truth *const t = &o->plan->truth[m];

    *uncertainty = 0.0;
    if (t->kind == TRUTH_NONE) return NAN;
    if (t->kind <= TRUTH_TABLE) return truth_value(t, x);
    if (t->kind == TRUTH_FINEST)
        return curve_at(&o->variant[finest(o)].of[m].found, x,
                        v == finest(o) ? NULL : uncertainty);
    const struct last_three l = last_of(o, v, m);
    const double more = 1.0 / (pow(l.h[1] / l.h[2], l.p) - 1.0);
    double of_fine, of_coarse;
    const double fine = curve_at(l.c[2], x, &of_fine);
    const double coarse = curve_at(l.c[1], x, &of_coarse);
    *uncertainty = hypot((1.0 + more) * of_fine, more * of_coarse);
    return fine + more * (fine - coarse); /* (25.2) */
}

/* 1 if the variant is what it would be compared with. */
static int is_reference(const struct outcomes *o, int v, int m)
{
    return o->plan->truth[m].kind == TRUTH_FINEST && v == finest(o);
}

/* A smaller standard error is that of rounding, of samples that are the same.
 */
static const double rounding = 1e-12;

/* Compares a variant with the truth where there is one. */
static void outcome_compare(const struct outcomes *o, int v, int m)
{
    struct finding *const f = &o->variant[v].of[m];
    double values = 0.0, own = 0.0; /* sums of squares, all points */
    double differences = 0.0, truths = 0.0, variances = 0.0; /* with a truth */
    int n = 0;

    f->truth = NAN;
    for (int i = 0; i < f->found.n; i++) {
        double uncertainty;
        const double q = f->found.value[i], e = f->found.error[i];
        const double q_0 = truth_at(o, v, m, f->found.x[i], &uncertainty);

        values += q * q;
        own += e * e;
        if (!isfinite(q_0)) continue;
        differences += (q - q_0) * (q - q_0);
        truths += q_0 * q_0;
        variances += e * e + uncertainty * uncertainty;
        f->truth = q_0;
        n++;
    }
    f->value = f->found.n == 1   ? f->found.value[0]
               : f->found.n == 0 ? NAN
                                 : sqrt(values / f->found.n);
    if (f->found.n > 1 && n > 0) f->truth = sqrt(truths / n);
    f->error = truths > 0.0 && !is_reference(o, v, m)
                   ? sqrt(differences / truths)
                   : NAN;
    f->uncertainty = sqrt(truths > 0.0 ? variances / truths : own / values);
    if (f->uncertainty < rounding) f->uncertainty = 0.0;
}

/* A variant that has found the same as the finest, to the last bit, is as good
 * as that, whatever the truth is. Then the finest is no judge of the others
 * alone: both have the error 0, without uncertainty, and differ in cost only.
 */
static void compare_finest(const struct outcomes *o, int m)
{
    struct finding *const f = &o->variant[finest(o)].of[m];

    for (int v = 0; v < finest(o); v++) {
        struct finding *const other = &o->variant[v].of[m];
        if (o->plan->truth[m].kind != TRUTH_FINEST) return;
        if (other->error == 0.0)
            other->uncertainty = f->error = f->uncertainty = 0.0;
    }
}

/* --- orders --------------------------------------------------------------- */

/* The order from the next coarser variant on its line; nan if one of their
 * errors, or their difference, may be chance. */
static double order_of(const struct outcomes *o, int v, int m)
{
    const struct choices *const c = &o->plan->choices;
    const int entry = o->axis >= 0 ? choices_entry(c, v, o->axis) : 0;

    if (entry == 0) return NAN;
    const struct finding *const fine = &o->variant[v].of[m];
    const struct finding *const coarse =
        &o->variant[choices_with(c, v, o->axis, entry - 1)].of[m];
    if (!outcome_is_resolved(fine) || !outcome_is_resolved(coarse) ||
        outcome_is_chance(fine, coarse))
        return NAN;
    return curve_order(choices_size(&c->of[o->axis], entry - 1), coarse->error,
                       choices_size(&c->of[o->axis], entry), fine->error);
}

struct outcomes outcomes_create(const struct plan *p, int n_runs,
                                const struct run *runs)
{
    struct outcomes o = {.plan = p, .n_runs = n_runs, .run = runs};

    o.n = choices_variants(&p->choices);
    o.variant = alloc_zeroed((size_t)o.n, sizeof *o.variant);
    o.axis = choices_axis(&p->choices);
    o.standing = runs_standing(p, n_runs, runs);
    for (int v = 0; v < o.n; v++)
        take_variant(&o, v);
    for (int m = 0; m < p->n_measures; m++) {
        for (int v = 0; v < o.n; v++)
            outcome_compare(&o, v, m);
        compare_finest(&o, m);
        for (int v = 0; v < o.n; v++)
            o.variant[v].of[m].order = order_of(&o, v, m);
    }
    return o;
}

void outcomes_free(struct outcomes *o)
{
    for (int v = 0; v < o->n; v++) {
        free(o->variant[v].label);
        for (int m = 0; m < PLAN_MEASURES; m++)
            curve_free(&o->variant[v].of[m].found);
    }
    free(o->variant);
    *o = (struct outcomes){0};
}

double outcomes_fitted_order(const struct outcomes *o, int v, int m)
{
    return o->plan->truth[m].kind == TRUTH_EXTRAPOLATED ? last_of(o, v, m).p
                                                        : NAN;
}

int outcome_is_resolved(const struct finding *f)
{
    return f->error > 2.0 * f->uncertainty;
}

int outcome_is_within(const struct finding *f, double limit)
{
    return f->error + 2.0 * f->uncertainty <= limit;
}

int outcome_is_chance(const struct finding *a, const struct finding *b)
{
    const double uncertainty = hypot(a->uncertainty, b->uncertainty);

    return uncertainty > 0.0 && fabs(a->error - b->error) <= 2.0 * uncertainty;
}

int outcome_costs_the_same(const struct outcome *a, const struct outcome *b)
{
    return fabs(a->cost - b->cost) <= 2.0 * hypot(a->scatter, b->scatter);
}
