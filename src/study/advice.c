/* SPDX-License-Identifier: GPL-3.0-or-later */
/* advice.c -- what a study comes to, in words. */
#include "study/study_report.h"

#include "base/number.h"

#include <math.h>
#include <string.h>

static const double limits[] = {0.05, 0.01, 0.001};
enum { LIMITS = 3 };

/* The cheapest variant whose error is surely within the limit; -1 if none. */
static int cheapest_within(const struct outcomes *o, int m, double limit)
{
    int best = -1;

    for (int v = 0; v < o->n; v++) {
        const struct outcome *const out = &o->variant[v];
        if (!out->ended || !isfinite(out->cost)) continue;
        if (!outcome_is_within(&out->of[m], limit)) continue;
        if (best < 0 || out->cost < o->variant[best].cost) best = v;
    }
    return best;
}

/* The variant with the smallest error that costs no more than `most`; of those
 * that have it to three digits the cheapest. */
static int best_for(const struct outcomes *o, int m, double most)
{
    int best = -1;

    for (int v = 0; v < o->n; v++) {
        const struct outcome *const out = &o->variant[v];
        if (!out->ended || !(out->cost <= most)) continue;
        if (!isfinite(out->of[m].error)) continue;
        const struct outcome *const so_far = &o->variant[best < 0 ? v : best];
        if (best < 0 || out->of[m].error < 0.999 * so_far->of[m].error ||
            (out->of[m].error <= 1.001 * so_far->of[m].error &&
             out->cost < so_far->cost))
            best = v;
    }
    return best;
}

static const char *unit(const struct plan *p)
{
    return plan_cost_is_processor(p) ? " s" : "";
}

/* "0.42 s, error 0.8 %, fluid.step=1e-3". */
static void put_variant(const struct outcomes *o, int v, int m, FILE *out)
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
    if (f->doubt > 0.0)
        fprintf(out, " +- %s %%", number_rounded(100.0 * f->doubt, 2, text));
    fprintf(out, ": %s", o->variant[v].label);
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
            put_variant(o, v, m, out);
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
                 {1.0, "no more than that buys "},
                 {2.0, "twice of that buys "}};

    if (v < 0 || !isfinite(o->variant[v].cost)) return;
    fputs("- the case as it stands: ", out);
    put_variant(o, v, m, out);
    fputc('\n', out);
    if (!isfinite(o->variant[v].of[m].error)) return;
    for (int i = 0, told = v; i < 3; i++) {
        const int other = best_for(o, m, share[i].of * o->variant[v].cost);
        if (other < 0 || other == told || other == v) continue;
        told = other;
        fprintf(out, "- %s", share[i].words);
        put_variant(o, other, m, out);
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
        fprintf(out, "%s, against %s:\n", o->plan->measure[m].text,
                o->plan->truth[m].text);
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
