/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/study_report.h"

#include "base/alloc.h"
#include "base/file.h"
#include "base/tables/input.h"
#include "base/number.h"
#include "base/text.h"
#include "case/resume/read_summary.h"

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

static void study_report_put_head(const struct plan *p, FILE *out)
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

struct file *study_report_file(const struct plan *p, const char *name)
{
    char *const path = file_join(p->words.dir, name);
    struct file *const f = file_create(path);

    free(path);
    return f;
}

int study_report_runs(const struct outcomes *o)
{
    struct file *const f = study_report_file(o->plan, "study.csv");

    if (f == NULL) return 1;
    study_report_put_head(o->plan, file_stream(f));
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

/* Why a run did not come to its end: its summary says so, or the first line of
 * what it said. To be freed. */
static char *study_report_reason_of(const struct run *r)
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

static void study_report_put_variant(const struct outcomes *o,
                                     const struct outcome *v, FILE *out)
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
        char *const reason = study_report_reason_of(v->broken);
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
    for (int m = 0; m < p->n_measures; m++)
        put_page(" | ", p->measure[m].text, " | error | order", out);
    fputs(" |\n| --- | ---:", out);
    for (int i = 0; i < 3 * p->n_measures + other; i++)
        fputs(" | ---:", out);
    fputs(" |\n", out);
    for (int v = 0; v < o->n; v++)
        study_report_put_variant(o, &o->variant[v], out);
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

/* Which costs the advice takes for the same. */
static const char same_costs[] =
    "Costs that two standard errors over the seeds explain count as the same, "
    "and so do times that differ by less than a tenth.";

int study_report_variants(const struct outcomes *o)
{
    const struct plan *const p = o->plan;
    struct file *const f = study_report_file(p, "study.md");

    if (f == NULL) return 1;
    FILE *const out = file_stream(f);
    put_page("# ", p->words.title, "\n\n", out);
    put_page("Case ", p->words.case_file, "; ", out);
    for (int m = 0; m < p->n_measures; m++) {
        put_page(m > 0 ? ", " : "", p->measure[m].text, " against ", out);
        put_page("", p->truth[m].text, "", out);
    }
    fprintf(out, ".\nSeeds: %d; repetitions: %d, the least counts. %s\n\n",
            p->words.seeds, p->words.times, same_costs);
    put_table(o, out);
    fputc('\n', out);
    put_fitted(o, out);
    fputc('\n', out);
    study_report_advice(o, out);
    return file_commit(f);
}
