/* SPDX-License-Identifier: GPL-3.0-or-later */
/* report.c -- study.csv, study.md, and what a study comes to, in words. */
#include "study/outcome.h"

#include "base/alloc.h"
#include "base/file.h"
#include "base/number.h"
#include "output/summary.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Numbers of each run's summary that study.csv repeats: path and head. */
static const struct {
    const char *path, *head;
} from_summary[] = {
    {"seconds.processor", "processor [s]"},
    {"seconds.cfd", "cfd [s]"},
    {"seconds.dem", "dem [s]"},
    {"seconds.averaging", "averaging [s]"},
    {"seconds.exchange", "exchange [s]"},
    {"seconds.output", "output [s]"},
    {"seconds.total", "total [s]"},
    {"steps", "steps [-]"},
    {"particle_steps_in_a_step", "particle_steps_in_a_step [-]"},
    {"cells", "cells [-]"},
    {"particles", "particles [-]"},
    {"peak_memory", "peak_memory [byte]"}};
enum { FROM_SUMMARY = sizeof from_summary / sizeof from_summary[0] };

/* --- study.csv ------------------------------------------------------------ */

/* An empty field for what is not there. */
static void put_number(FILE *out, double value)
{
    char text[NUMBER_LENGTH];

    fprintf(out, ",%s", isfinite(value) ? number_text(value, text) : "");
}

static void put_head(const struct plan *p, FILE *out)
{
    fputs("run", out);
    for (int i = 0; i < p->choices.n; i++)
        for (int k = 0; k < p->choices.of[i].key.n; k++)
            fprintf(out, ",%s", p->choices.of[i].key.text[k]);
    fputs(",seed,repetition,exit_code", out);
    for (int i = 0; i < FROM_SUMMARY; i++)
        fprintf(out, ",%s", from_summary[i].head);
    for (int m = 0; m < p->n_measures; m++) {
        const char *const name = p->measure[m].text;
        fprintf(out, ",%s,standard error of %s,truth of %s,error of %s [-]",
                name, name, name, name);
    }
    fputc('\n', out);
}

static void put_choices(const struct plan *p, const struct run *r, FILE *out)
{
    for (int i = 0; i < p->choices.n; i++) {
        const struct choice *const c = &p->choices.of[i];
        const int entry = choices_entry(&p->choices, r->variant, i);

        for (int k = 0; k < c->key.n; k++) {
            fputc(',', out);
            text_put(out, choices_in_entry(c, entry, k), TEXT_CSV);
        }
    }
}

/* The run by itself; the error is that of its variant where it is one number,
 * for the truth is the variant's. */
static void put_measure(const struct outcomes *o, const struct run *r, int m,
                        FILE *out)
{
    const struct finding *const f = &o->variant[r->variant].of[m];
    struct curve c = {0};

    if (r->code == 0) c = measure_take(&o->plan->measure[m], r->folder);
    const int single = c.n == 1;
    put_number(out, single ? c.value[0] : c.n > 0 ? f->value : NAN);
    put_number(out, single ? c.error[0] : NAN);
    put_number(out, c.n > 0 ? f->truth : NAN);
    put_number(out, single && isfinite(f->error)
                        ? fabs(c.value[0] / f->truth - 1.0)
                    : c.n > 0 ? f->error
                              : NAN);
    curve_free(&c);
}

static void put_run(const struct outcomes *o, const struct run *r, FILE *out)
{
    text_put(out, r->name, TEXT_CSV);
    put_choices(o->plan, r, out);
    fprintf(out, ",%d,%d,%d", r->seed, r->time, r->code);
    for (int i = 0; i < FROM_SUMMARY; i++)
        put_number(out, read_summary_number(r->folder, from_summary[i].path));
    for (int m = 0; m < o->plan->n_measures; m++)
        put_measure(o, r, m, out);
    fputc('\n', out);
}

struct file *report_file(const struct plan *p, const char *name)
{
    char *const path = file_join(p->dir, name);
    struct file *const f = file_create(path);

    free(path);
    return f;
}

static int write_runs(const struct outcomes *o)
{
    struct file *const f = report_file(o->plan, "study.csv");

    if (f == NULL) return 1;
    put_head(o->plan, file_stream(f));
    for (int i = 0; i < o->n_runs; i++)
        put_run(o, &o->run[i], file_stream(f));
    return file_commit(f);
}

/* --- study.md ------------------------------------------------------------- */

static void put_page(const char *before, const char *text, const char *behind,
                     FILE *out)
{
    fputs(before, out);
    text_put(out, text, TEXT_PAGE);
    fputs(behind, out);
}

/* Nothing for what is not there. */
static void put_rounded(FILE *out, double value, int digits, const char *unit)
{
    char text[NUMBER_LENGTH];

    if (isfinite(value))
        fprintf(out, "%s%s", number_rounded(value, digits, text), unit);
}

static void put_finding(const struct finding *f, FILE *out)
{
    fputs(" | ", out);
    put_rounded(out, f->value, 4, "");
    fputs(" | ", out);
    put_rounded(out, 100.0 * f->error, 3, " %");
    if (f->uncertainty > 0.0) {
        fputs(" +- ", out);
        put_rounded(out, 100.0 * f->uncertainty, 3, " %");
        if (!outcome_is_resolved(f) && isfinite(f->error))
            fputs(" (no difference)", out);
    }
    fputs(" | ", out);
    if (isfinite(f->order)) fprintf(out, "%.2f", f->order);
}

char *report_reason(const struct run *r)
{
    char *const log = file_join(r->folder, "log.txt");
    char *reason = read_summary_text(r->folder, "exit_reason");
    const char *why;
    size_t length;
    char *const text = input_text(log, &length, &why);

    if (r->code != 3 && text != NULL) {
        free(reason);
        reason = strndup(text, strcspn(text, "\n"));
    }
    free(text);
    free(log);
    if (reason == NULL || reason[0] == '\0') {
        free(reason);
        return strdup(r->code > 128 ? "ended by a signal"
                                    : "its log.txt says nothing");
    }
    reason[strcspn(reason, "\n")] = '\0'; /* then follows what to try */
    return reason;
}

static void put_outcome(const struct outcomes *o, const struct outcome *v,
                        FILE *out)
{
    fputs("| ", out);
    text_put(out, v->label, TEXT_PAGE);
    fputs(" | ", out);
    put_rounded(out, v->seconds, 4, "");
    if (!plan_cost_is_processor(o->plan)) {
        fputs(" | ", out);
        put_rounded(out, v->cost, 4, "");
    }
    if (v->broken != NULL) {
        char *const reason = report_reason(v->broken);
        fprintf(out, " | exit code %d: ", v->broken->code);
        text_put(out, reason, TEXT_PAGE);
        free(reason);
    } else
        for (int m = 0; m < o->plan->n_measures; m++)
            put_finding(&v->of[m], out);
    fputs(" |\n", out);
}

static void put_table(const struct outcomes *o, FILE *out)
{
    const struct plan *const p = o->plan;
    const int other = !plan_cost_is_processor(p);

    fputs("| variant | processor [s]", out);
    if (other) put_page(" | ", p->cost.text, "", out);
    for (int m = 0; m < p->n_measures; m++) {
        put_page(" | ", p->measure[m].text, " | ", out);
        fprintf(out, "%s | order", words_error(&p->truth[m]));
    }
    fputs(" |\n| --- | ---:", out);
    for (int i = 0; i < 3 * p->n_measures + other; i++)
        fputs(" | ---:", out);
    fputs(" |\n", out);
    for (int v = 0; v < o->n; v++)
        put_outcome(o, &o->variant[v], out);
}

/* The order of each line that was extrapolated. */
static void put_fitted(const struct outcomes *o, FILE *out)
{
    for (int m = 0; m < o->plan->n_measures; m++) {
        if (o->plan->truth[m].kind != TRUTH_EXTRAPOLATED) continue;
        for (int v = 0; v < o->n; v++) {
            if (choices_entry(&o->plan->choices, v, o->axis) > 0) continue;
            const double p = outcomes_fitted_order(o, v, m);
            char *const line = choices_label(&o->plan->choices, v, o->axis);
            put_page("- ", o->plan->measure[m].text,
                     line[0] != '\0' ? ", " : "", out);
            put_page("", line, ": ", out);
            if (isfinite(p))
                fprintf(out, "extrapolated with the order %.2f\n", p);
            else
                fputs("not extrapolated, the last three do not approach each "
                      "other as a power of the size, or by no more than "
                      "chance explains\n",
                      out);
            free(line);
        }
    }
}

static const double limits[] = {0.05, 0.01, 0.001};
enum { LIMITS = 3 };

/* --- the advice: which variant -------------------------------------------- */

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

/* The cheapest variant whose error is certainly within the limit; -1 if none.
 */
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

/* --- in words ------------------------------------------------------------- */

/* "error 0.8 % +- 0.1 %". */
static void put_error(const struct outcomes *o, int v, int m, FILE *out)
{
    const struct finding *const f = &o->variant[v].of[m];
    char text[NUMBER_LENGTH];

    fprintf(out, "%s %s %%", words_error(&o->plan->truth[m]),
            number_rounded(100.0 * f->error, 3, text));
    if (f->uncertainty > 0.0)
        fprintf(out, " +- %s %%",
                number_rounded(100.0 * f->uncertainty, 2, text));
}

/* "0.42 s, error 0.8 %: fluid.step=1e-3". */
static void put_advised(const struct outcomes *o, int v, int m, FILE *out)
{
    const struct finding *const f = &o->variant[v].of[m];
    char text[NUMBER_LENGTH];

    fprintf(out, "%s%s, ", number_rounded(o->variant[v].cost, 3, text),
            plan_cost_is_processor(o->plan) ? " s" : "");
    if (isfinite(f->error))
        put_error(o, v, m, out);
    else /* the finest has no other to be compared with */
        fputs("the reference", out);
    put_page(": ", o->variant[v].label, "", out);
}

/* Why none is certainly within the limit, which holds for smaller ones too. */
static void put_beyond(const struct outcomes *o, int m, double limit, FILE *out)
{
    const struct finding *const reference = &o->variant[o->n - 1].of[m];
    const double own =
        o->plan->truth[m].kind == TRUTH_FINEST ? reference->uncertainty : 0.0;
    double least = INFINITY;
    int nearest = 0;
    char text[NUMBER_LENGTH];

    for (int v = 0; v < o->n; v++) {
        const struct finding *const f = &o->variant[v].of[m];
        if (!(f->error + 2.0 * f->uncertainty < least)) continue;
        least = f->error + 2.0 * f->uncertainty;
        nearest = v;
    }
    fprintf(out, "- no variant is certainly within %g %%: ", 100.0 * limit);
    if (2.0 * own > limit)
        fprintf(out, "the reference's own standard error is %s %%\n",
                number_rounded(100.0 * own, 3, text));
    else {
        fputs("the nearest has the ", out);
        put_error(o, nearest, m, out);
        fputc('\n', out);
    }
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
               : "where it was measured the reference is unknown, or 0";
}

/* A line for each limit that a variant is within, one for the first that none
 * is, and one for the variant that the case itself is. */
static void put_lines(const struct outcomes *o, int m, FILE *out)
{
    const int standing = o->standing;

    for (int i = 0; i < LIMITS; i++) {
        const int v = cheapest_within(o, m, limits[i]);

        if (v < 0) {
            put_beyond(o, m, limits[i], out);
            break;
        }
        fprintf(out, "- for %g %%: ", 100.0 * limits[i]);
        put_advised(o, v, m, out);
        fputc('\n', out);
    }
    if (standing < 0 || !isfinite(o->variant[standing].cost)) return;
    fputs("- the case as it stands: ", out);
    put_advised(o, standing, m, out);
    fputc('\n', out);
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

/* "mean_height, against method=diffusion, the finest". */
static void put_compared(const struct outcomes *o, int m, FILE *out)
{
    const int finest = o->plan->truth[m].kind == TRUTH_FINEST;

    put_page("", o->plan->measure[m].text, ", against ", out);
    put_page("", finest ? o->variant[o->n - 1].label : o->plan->truth[m].text,
             finest ? ", the finest" : "", out);
}

void report_advice(const struct outcomes *o, FILE *out)
{
    for (int m = 0; m < o->plan->n_measures; m++) {
        if (o->plan->truth[m].kind == TRUTH_NONE) continue;
        put_compared(o, m, out);
        fputs(":\n", out);
        put_times(o, m, out);
        const char *const why = nothing_known(o, m);
        if (why != NULL) {
            fprintf(out, "- no error is known: %s\n", why);
            continue;
        }
        put_lines(o, m, out);
    }
}

/* --- the page ------------------------------------------------------------- */

static int write_page(const struct outcomes *o)
{
    const struct plan *const p = o->plan;
    struct file *const f = report_file(p, "study.md");

    if (f == NULL) return 1;
    FILE *const out = file_stream(f);
    put_page("# ", p->title, "\n\n", out);
    put_page("Case ", p->case_file, "; ", out);
    for (int m = 0; m < p->n_measures; m++) {
        fputs(m > 0 ? "; " : "", out);
        put_compared(o, m, out);
    }
    fprintf(out,
            ".\nSeeds: %d; repetitions: %d, the least counts. Costs that two "
            "standard errors over the seeds explain count as the same, and so "
            "do times that differ by less than a tenth.\n\n",
            p->seeds, p->times);
    put_table(o, out);
    fputc('\n', out);
    put_fitted(o, out);
    fputc('\n', out);
    report_advice(o, out);
    return file_commit(f);
}

int report_write(const struct outcomes *o)
{
    return write_runs(o) != 0 || write_page(o) != 0 || html_write(o) != 0;
}
