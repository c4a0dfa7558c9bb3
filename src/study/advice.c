/* SPDX-License-Identifier: GPL-3.0-or-later */
/* advice.c -- what a study comes to, in words. */
#include "study/study_report.h"

#include "base/alloc.h"
#include "base/number.h"
#include "base/text.h"

#include <math.h>
#include <stdlib.h>

static const double limits[] = {0.05, 0.01, 0.001};
enum { LIMITS = 3 };

/* --- which variant is advised --------------------------------------------- */

enum { COST = -1 };

/* Of those that are in, the variant with the least error of a measure, or with
 * the least COST; -1 if none is in. */
static int least(const struct outcomes *o, int m, const char *in)
{
    double smallest = INFINITY;
    int best = -1;

    for (int v = 0; v < o->n; v++) {
        const struct outcome *const out = &o->variant[v];
        const double value = m == COST ? out->cost : out->of[m].error;
        if (!in[v] || (best >= 0 && value >= smallest)) continue;
        smallest = value;
        best = v;
    }
    return best;
}

/* 1 if the errors of two variants cannot be told apart, or are the same to
 * three digits. */
static int is_as_good(const struct outcomes *o, int m, int v, int w)
{
    const struct finding *const a = &o->variant[v].of[m];
    const struct finding *const b = &o->variant[w].of[m];

    return outcome_is_chance(a, b) ||
           fabs(a->error - b->error) <= 1e-3 * fmax(a->error, b->error);
}

/* The cheapest of those that are in; of those that cost the same, as far as can
 * be told, the case as it stands or else the one with the least error. */
static int cheapest(const struct outcomes *o, int m, char *in)
{
    const int first = least(o, COST, in);

    for (int v = 0; v < o->n; v++)
        in[v] =
            in[v] && outcome_costs_the_same(&o->variant[v], &o->variant[first]);
    return o->standing >= 0 && in[o->standing] ? o->standing : least(o, m, in);
}

/* 1 if the others are compared with the case as it stands, and it costs no more
 * than a variant, as far as can be told. */
static int is_reference_as_cheap(const struct outcomes *o, int m, int v)
{
    if (o->standing < 0 || o->plan->truth[m].kind != TRUTH_FINEST) return 0;
    const struct outcome *const stands = &o->variant[o->standing];

    return !isfinite(stands->of[m].error) &&
           (stands->cost <= o->variant[v].cost ||
            outcome_costs_the_same(stands, &o->variant[v]));
}

/* The cheapest variant whose error is surely within the limit; -1 if none. */
static int cheapest_within(const struct outcomes *o, int m, double limit)
{
    char *const in = alloc_zeroed((size_t)o->n, 1);

    for (int v = 0; v < o->n; v++)
        in[v] = o->variant[v].ended && isfinite(o->variant[v].cost) &&
                outcome_is_within(&o->variant[v].of[m], limit);
    const int best = cheapest(o, m, in);
    free(in);
    return best >= 0 && is_reference_as_cheap(o, m, best) ? o->standing : best;
}

/* The variant with the least error that costs no more than a share of the cost
 * of another one, as far as can be told if the share is 1; of those that are as
 * good, the cheapest. -1 if there is none. */
static int best_for(const struct outcomes *o, int m, double share, int of)
{
    char *const in = alloc_zeroed((size_t)o->n, 1);
    const struct outcome *const that = &o->variant[of];

    for (int v = 0; v < o->n; v++) {
        const struct outcome *const out = &o->variant[v];
        in[v] = out->ended && isfinite(out->of[m].error) &&
                (out->cost <= share * that->cost ||
                 (share == 1.0 && outcome_costs_the_same(out, that)));
    }
    const int first = least(o, m, in);
    for (int v = 0; v < o->n; v++)
        in[v] = in[v] && is_as_good(o, m, v, first);
    const int best = cheapest(o, m, in);
    free(in);
    return best;
}

/* 1 if a variant costs less than another one, or has a smaller error, by what
 * can be told. */
static int is_better(const struct outcomes *o, int m, int v, int than)
{
    const struct outcome *const a = &o->variant[v];
    const struct outcome *const b = &o->variant[than];

    return (a->cost < b->cost && !outcome_costs_the_same(a, b)) ||
           (a->of[m].error < b->of[m].error && !is_as_good(o, m, v, than));
}

/* --- in words ------------------------------------------------------------- */

static const char *unit(const struct plan *p)
{
    return plan_cost_is_processor(p) ? " s" : "";
}

/* "0.42 s, error 0.8 %, fluid.step=1e-3". */
static void advice_put_variant(const struct outcomes *o, int v, int m,
                               FILE *out)
{
    const struct finding *const f = &o->variant[v].of[m];
    char text[NUMBER_LENGTH];

    fprintf(out, "%s%s, ", number_rounded(o->variant[v].cost, 3, text),
            unit(o->plan));
    if (!isfinite(f->error)) { /* the finest has no other to be compared with */
        fprintf(out, "which the others are compared with: %s",
                o->variant[v].label);
        return;
    }
    fprintf(out, "error %s %%", number_rounded(100.0 * f->error, 3, text));
    if (f->uncertainty > 0.0)
        fprintf(out, " +- %s %%",
                number_rounded(100.0 * f->uncertainty, 2, text));
    fputs(": ", out);
    text_put(out, o->variant[v].label, TEXT_PAGE);
}

/* Why there is no error of any variant; NULL if there is one. */
static const char *nothing_known(const struct outcomes *o, int m)
{
    const enum truth_kind kind = o->plan->truth[m].kind;
    int ended = 0, found = 0;

    for (int v = 0; v < o->n; v++) {
        const struct finding *const f = &o->variant[v].of[m];
        if (isfinite(f->error)) return NULL;
        ended += o->variant[v].ended;
        found += f->found.n > 0;
    }
    return ended == 0   ? "no variant has come to its end"
           : found == 0 ? "the runs have no such measure"
           : kind == TRUTH_FINEST && !o->variant[o->n - 1].ended
               ? "the finest has not come to its end"
           : kind == TRUTH_EXTRAPOLATED
               ? "nothing could be extrapolated"
               : "where it was measured the truth is unknown, or 0";
}

static void put_limits(const struct outcomes *o, int m, FILE *out)
{
    for (int i = 0; i < LIMITS; i++) {
        const int v = cheapest_within(o, m, limits[i]);

        fprintf(out, "- for %g %%: ", 100.0 * limits[i]);
        if (v >= 0)
            advice_put_variant(o, v, m, out);
        else
            fputs("none of these is surely within it", out);
        fputc('\n', out);
    }
}

/* What half, the same and twice the cost of the variant that the case itself is
 * buy. */
static void put_standing(const struct outcomes *o, int m, FILE *out)
{
    const int v = o->standing;
    static const struct {
        double of;
        const char *words;
    } share[] = {{0.5, "half of that buys "},
                 {1.0, "as much as that buys "},
                 {2.0, "twice of that buys "}};

    if (v < 0 || !isfinite(o->variant[v].cost)) return;
    fputs("- the case as it stands: ", out);
    advice_put_variant(o, v, m, out);
    fputc('\n', out);
    if (!isfinite(o->variant[v].of[m].error)) return;
    for (int i = 0, told = v; i < 3; i++) {
        const int other = best_for(o, m, share[i].of, v);
        if (other < 0 || other == told || !is_better(o, m, other, v)) continue;
        told = other;
        fprintf(out, "- %s", share[i].words);
        advice_put_variant(o, other, m, out);
        if (outcome_is_chance(&o->variant[v].of[m], &o->variant[other].of[m]))
            fputs(", no difference that can be told", out);
        fputc('\n', out);
    }
}

/* The last row of a run is that of its last step at which one was due. Without
 * an equation in time to compare with, the others need values of one time. */
static void put_times(const struct outcomes *o, int m, FILE *out)
{
    const struct measure *const of = &o->plan->measure[m];
    const enum truth_kind kind = o->plan->truth[m].kind;
    double first = INFINITY, last = -INFINITY;
    char from[NUMBER_LENGTH], to[NUMBER_LENGTH];

    if (of->how != MEASURE_LAST || isfinite(of->from)) return;
    if (kind != TRUTH_FINEST && kind != TRUTH_EXTRAPOLATED) return;
    for (int v = 0; v < o->n; v++) {
        const struct curve *const c = &o->variant[v].of[m].found;
        if (c->n == 0 || !isfinite(c->x[0])) continue;
        first = fmin(first, c->x[0]);
        last = fmax(last, c->x[0]);
    }
    if (!(last - first > 1e-6 * last)) return;
    fprintf(out,
            "- the last values are those of %s to %s s, and a part of the "
            "differences is that of the times: give %s@TIME, or an output.end "
            "and output.history that all steps divide\n",
            number_rounded(first, 4, from), number_rounded(last, 4, to),
            of->text);
}

void study_report_advice(const struct outcomes *o, FILE *out)
{
    for (int m = 0; m < o->plan->n_measures; m++) {
        if (o->plan->truth[m].kind == TRUTH_NONE) continue;
        text_put(out, o->plan->measure[m].text, TEXT_PAGE);
        fputs(", against ", out);
        text_put(out, o->plan->truth[m].text, TEXT_PAGE);
        fputs(":\n", out);
        put_times(o, m, out);
        const char *const why = nothing_known(o, m);
        if (why != NULL) {
            fprintf(out, "- no error is known: %s\n", why);
            continue;
        }
        put_limits(o, m, out);
        put_standing(o, m, out);
    }
}
