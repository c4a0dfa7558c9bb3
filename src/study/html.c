/* SPDX-License-Identifier: GPL-3.0-or-later */
/* html.c -- study.html: what page_study.js makes a picture and tables of.
 *
 * All that comes from a case is text of hidden elements, escaped; the script
 * of the page puts it in as text.
 */
#include "study/outcome.h"

#include "base/file.h"
#include "base/number.h"
#include "report/page.h"

#include <math.h>
#include <stdlib.h>
#include <unistd.h>

/* ' data-NAME="TEXT"'. */
static void put_data(const char *name, const char *text, FILE *out)
{
    fprintf(out, " data-%s=\"", name);
    text_put(out, text, TEXT_XML);
    fputc('"', out);
}

/* A text that was made for it, and is freed. */
static void put_made(const char *name, char *text, FILE *out)
{
    put_data(name, text, out);
    free(text);
}

/* Left out if there is none. */
static void html_put_number(const char *name, double value, FILE *out)
{
    char text[NUMBER_LENGTH];

    if (isfinite(value)) put_data(name, number_text(value, text), out);
}

/* What a person types to make the run again. */
static char *command_of(const struct plan *p, const struct run *r)
{
    const char *const threads =
        choices_value(&p->choices, r->variant, PLAN_THREADS);
    char *text = NULL;
    size_t length;
    FILE *const out = open_memstream(&text, &length);

    fputs("winnow run ", out);
    text_put(out, p->case_file, TEXT_SHELL);
    fputs(" -j ", out);
    text_put(out, threads != NULL ? threads : "1", TEXT_SHELL);
    for (int i = 0; i < r->overrides.n; i++) {
        fputs(" -s ", out);
        text_put(out, r->overrides.text[i], TEXT_SHELL);
    }
    fclose(out);
    return text;
}

/* A run of a variant, with a link to its report if that is there. */
static void html_put_run(const struct run *r, FILE *out)
{
    char *const report = file_join(r->folder, "report.html");

    fputs("<u", out);
    put_data("run", r->name, out);
    put_data("folder", r->folder, out);
    fprintf(out, " data-code=\"%d\"", r->code);
    if (access(report, F_OK) == 0) fputs(" data-report=\"1\"", out);
    fputs("></u>", out);
    free(report);
}

/* One measure of a variant, or what it is compared with. */
static void html_put_finding(const struct finding *f, FILE *out)
{
    fputs("<b", out);
    html_put_number("value", f->value, out);
    html_put_number("truth", f->truth, out);
    html_put_number("error", f->error, out);
    html_put_number("uncertainty", f->uncertainty, out);
    html_put_number("order", f->order, out);
    fputs("></b>", out);
}

static void html_put_variant(const struct outcomes *o, int v, FILE *out)
{
    const struct choices *const c = &o->plan->choices;
    const struct outcome *const of = &o->variant[v];
    int first = 0;

    while (o->run[first].variant != v)
        first++;
    fputs("<i class=\"variant\" hidden", out);
    put_data("label", of->label, out);
    put_made("words", words_variant(c, v, -1), out);
    put_made("line", words_variant(c, v, o->axis), out);
    if (o->axis >= 0)
        put_data("along", choices_value(c, v, c->of[o->axis].key.text[0]), out);
    html_put_number("seconds", of->seconds, out);
    html_put_number("cost", of->cost, out);
    html_put_number("scatter", of->scatter, out);
    if (v == o->standing) fputs(" data-standing=\"1\"", out);
    if (of->broken != NULL && of->broken->code >= 0)
        put_made("reason", report_reason(of->broken), out);
    put_made("command", command_of(o->plan, &o->run[first]), out);
    fprintf(out, " data-ended=\"%d\">", of->ended);
    for (int m = 0; m < o->plan->n_measures; m++)
        html_put_finding(&of->of[m], out);
    for (int i = 0; i < o->n_runs; i++)
        if (o->run[i].variant == v) html_put_run(&o->run[i], out);
    fputs("</i>\n", out);
}

static void html_put_measure(const struct outcomes *o, int m, FILE *out)
{
    const struct truth *const t = &o->plan->truth[m];
    char unit[16] = "";

    for (int i = 0; i < o->n_runs && unit[0] == '\0'; i++)
        if (o->run[i].code == 0)
            measure_unit(&o->plan->measure[m], o->run[i].folder, unit);
    fputs("<i class=\"measure\" hidden", out);
    put_data("unit", unit, out);
    put_data("name", o->plan->measure[m].text, out);
    put_made("words", words_measure(&o->plan->measure[m]), out);
    put_data("truth", t->text, out);
    put_made("reference", words_truth(o, m), out);
    put_data("error", words_error(t), out);
    if (t->kind == TRUTH_FINEST) fputs(" data-finest=\"1\"", out);
    if (t->kind == TRUTH_NONE) fputs(" data-none=\"1\"", out);
    fputs("></i>\n", out);
}

/* What each choice means: its keys, and the words for them. */
static void put_choice(const struct choice *c, FILE *out)
{
    if (c->n < 2) return;
    fputs("<i class=\"choice\" hidden", out);
    put_made("words", words_choice(c), out);
    fputc('>', out);
    for (int k = 0; k < c->key.n; k++) {
        if (k > 0) fputs(", ", out);
        text_put(out, c->key.text[k], TEXT_XML);
    }
    fputs("</i>\n", out);
}

static void put_study(const struct outcomes *o, FILE *out)
{
    const struct plan *const p = o->plan;
    int ended = 0;

    for (int i = 0; i < o->n_runs; i++)
        ended += o->run[i].code >= 0;
    fputs("<i id=\"study\" hidden", out);
    put_data("title", p->title, out);
    put_data("case", p->case_file, out);
    fprintf(out, " data-runs=\"%d\" data-ended=\"%d\" data-seeds=\"%d\"",
            o->n_runs, ended, p->seeds);
    put_made("cost", words_cost(p), out);
    if (plan_cost_is_processor(p)) fputs(" data-processor=\"1\"", out);
    if (o->axis >= 0)
        put_made("along", words_choice(&p->choices.of[o->axis]), out);
    fputs("></i>\n", out);
    for (int i = 0; i < p->choices.n; i++)
        put_choice(&p->choices.of[i], out);
    for (int m = 0; m < p->n_measures; m++)
        html_put_measure(o, m, out);
    for (int v = 0; v < o->n; v++)
        html_put_variant(o, v, out);
}

int html_write(const struct outcomes *o)
{
    struct file *const f = report_file(o->plan, "study.html");

    if (f == NULL) return 1;
    FILE *const out = file_stream(f);
    fputs(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">"
        "\n<meta name=\"viewport\" content=\"width=device-width, "
        "initial-scale=1\">\n<meta http-equiv=\"Content-Security-Policy\" "
        "content=\"default-src 'none'; script-src 'unsafe-inline'; style-src "
        "'unsafe-inline'\">\n<title>Winnow: study</title>\n<style>\n",
        out);
    page_put_program(out, page_css);
    fputs("</style>\n</head>\n<body>\n<main></main>\n", out);
    put_study(o, out);
    fputs("<script>\n", out);
    page_put_program(out, page_add_js);
    page_put_program(out, page_study_js);
    fputs("</script>\n</body>\n</html>\n", out);
    return file_commit(f);
}
