/* SPDX-License-Identifier: GPL-3.0-or-later */
/* picture.c -- error against cost: data for output/pictures/study.gp.
 *
 * All panels have one block of data, a part after the other: the front, then
 * each line below its title. Their numbers stand in arrays.
 */
#include "study/outcome.h"

#include "base/alloc.h"
#include "base/file.h"
#include "output/pictures/picture.h"

#include <gsl/gsl_sort.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char script[] = "study.gp";

/* 1 if the variant can be drawn: an error above 0 and a cost. */
static int is_shown(const struct outcomes *o, int m, int v)
{
    const struct outcome *const of = &o->variant[v];

    return of->ended && of->of[m].error > 0.0 && of->cost > 0.0;
}

/* 1 if the variant lies on the line that begins with `first`; -1: on any. */
static int is_on(const struct outcomes *o, int first, int v)
{
    return first < 0 || first == (o->axis < 0 ? v
                                              : choices_with(&o->plan->choices,
                                                             v, o->axis, 0));
}

static int points(const struct outcomes *o, int m, int first)
{
    int n = 0;

    for (int v = 0; v < o->n; v++)
        n += is_on(o, first, v) && is_shown(o, m, v);
    return n;
}

/* The first variant of the next line that has points, or o->n; first = -1
 * before the first line. */
static int next_line(const struct outcomes *o, int m, int first)
{
    while (++first < o->n)
        if (is_on(o, first, first) && points(o, m, first) > 0) break;
    return first;
}

/* cost, error [%], its lower and upper end (two standard errors), value of the
 * axis. */
static void picture_put_point(const struct outcomes *o, int m, int v, FILE *out)
{
    const struct finding *const f = &o->variant[v].of[m];
    const double low = fmax(f->error - 2.0 * f->uncertainty, 1e-2 * f->error);
    const struct choices *const c = &o->plan->choices;

    fprintf(out, "%.8g %.8g %.8g %.8g ", o->variant[v].cost, 100.0 * f->error,
            100.0 * low, 100.0 * (f->error + 2.0 * f->uncertainty));
    text_put(out,
             o->axis < 0 ? "" : choices_value(c, v, c->of[o->axis].key.text[0]),
             TEXT_DATA);
    fputc('\n', out);
}

/* 1 if the variant costs more than the last of the front, and is better by more
 * than chance. */
static int picture_goes_on(const struct outcomes *o, int m, int last, int v)
{
    const struct outcome *const of = &o->variant[v];

    if (!is_shown(o, m, v) || last < 0) return is_shown(o, m, v);
    const struct outcome *const before = &o->variant[last];
    return of->cost >= before->cost && of->of[m].error < before->of[m].error &&
           !outcome_is_chance(&of->of[m], &before->of[m]);
}

/* The front: the variants that no cheaper one equals, in order of cost. */
static void put_front(const struct outcomes *o, int m, FILE *out)
{
    for (int last = -1, next; last < o->n; last = next) {
        next = o->n;
        for (int v = 0; v < o->n; v++)
            if (picture_goes_on(o, m, last, v) &&
                (next == o->n || o->variant[v].cost < o->variant[next].cost))
                next = v;
        if (next < o->n) picture_put_point(o, m, next, out);
    }
}

/* The orders of a line: their median, the higher of two; nan if there are
 * none. */
static double median_order(const struct outcomes *o, int m, int first)
{
    double *const orders = alloc_doubles(o->n);
    int n = 0;

    for (int v = 0; v < o->n; v++)
        if (is_on(o, first, v) && isfinite(o->variant[v].of[m].order))
            orders[n++] = o->variant[v].of[m].order;
    gsl_sort(orders, 1, (size_t)n);
    const double median = n > 0 ? orders[n / 2] : NAN;
    free(orders);
    return median;
}

/* A line below its title; returns how long that is. */
static int picture_put_line(const struct outcomes *o, int m, int first,
                            FILE *out)
{
    char *const label = choices_label(&o->plan->choices, first, o->axis);
    const double order = median_order(o, m, first);
    struct texts title = {0};

    texts_add(&title, "%s", label[0] != '\0' ? label : "error");
    if (isfinite(order))
        texts_add(&title, "%s, order %.2g", title.text[0], order);
    const char *const last = title.text[title.n - 1];
    const int length = (int)strlen(last);
    fputs("\n\n", out);
    text_put(out, last, TEXT_DATA);
    fputc('\n', out);
    for (int v = 0; v < o->n; v++)
        if (is_on(o, first, v) && is_shown(o, m, v))
            picture_put_point(o, m, v, out);
    texts_free(&title);
    free(label);
    return length;
}

/* What a panel has to hold. */
struct panel {
    int m, front, lines;  /* [-] measure; part of the data; lines */
    double x_low, x_high; /* ends of its axes: cost */
    double y_low, y_high; /* [%] and error */
};

static void find_ranges(const struct outcomes *o, struct panel *p)
{
    p->x_low = p->y_low = INFINITY;
    for (int v = 0; v < o->n; v++) {
        const struct finding *const f = &o->variant[v].of[p->m];
        const double cost = o->variant[v].cost, error = 100.0 * f->error;
        if (!is_shown(o, p->m, v)) continue;
        p->x_low = fmin(p->x_low, cost / 1.3);
        p->x_high = fmax(p->x_high, 1.6 * cost);
        p->y_low = fmin(p->y_low, error / 2.0);
        p->y_high = fmax(p->y_high, 1.6 * (error + 200.0 * f->uncertainty));
    }
}

/* The data of all panels; *longest is the length of the longest title. Returns
 * how many panels have points. */
static int picture_put_data(const struct outcomes *o, struct panel *panel,
                            int *longest, FILE *out)
{
    int n = 0, parts = 0;

    for (int m = 0; m < o->plan->n_measures; m++) {
        if (points(o, m, -1) == 0) continue;
        panel[n] = (struct panel){.m = m, .front = parts++};
        if (n > 0) fputs("\n\n", out);
        put_front(o, m, out);
        for (int l = next_line(o, m, -1); l < o->n; l = next_line(o, m, l)) {
            const int length = picture_put_line(o, m, l, out);
            if (length > *longest) *longest = length;
            panel[n].lines++;
            parts++;
        }
        find_ranges(o, &panel[n++]);
    }
    return n;
}

static void put_title(const struct plan *p, int m, FILE *out)
{
    struct texts title = {0};
    const char *const text = texts_add(&title, "%s against %s",
                                       p->measure[m].text, p->truth[m].text);

    text_put(out, strlen(text) > 60 ? p->measure[m].text : text, TEXT_GNUPLOT);
    texts_free(&title);
}

static void put_variables(const struct outcomes *o, int n,
                          const struct panel *panel, int longest, FILE *out)
{
    const struct plan *const p = o->plan;
    int most = 0;

    fprintf(out,
            "panels = %d\narray front[%d]; array lines[%d]; array points[%d]\n"
            "array x_low[%d]; array x_high[%d]; array y_low[%d]\n"
            "array y_high[%d]; array titles[%d]\n",
            n, n, n, n, n, n, n, n, n);
    for (int i = 0; i < n; i++) {
        const struct panel *const of = &panel[i];
        fprintf(out, "front[%d] = %d; lines[%d] = %d; points[%d] = %d\n", i + 1,
                of->front, i + 1, of->lines, i + 1,
                o->axis >= 0 ? points(o, of->m, -1) : 0);
        fprintf(out,
                "x_low[%d] = %.4g; x_high[%d] = %.4g; y_low[%d] = %.4g; "
                "y_high[%d] = %.4g\ntitles[%d] = ",
                i + 1, of->x_low, i + 1, of->x_high, i + 1, of->y_low, i + 1,
                of->y_high, i + 1);
        put_title(p, of->m, out);
        fputc('\n', out);
        if (of->lines > most) most = of->lines;
    }
    fprintf(out, "most = %d; longest = %d\ntitle = ", most, longest);
    text_put(out, p->title, TEXT_GNUPLOT);
    fputs("\ncost = ", out);
    text_put(out,
             plan_cost_is_processor(p) ? "processor time of a run [s]"
                                       : p->cost.text,
             TEXT_GNUPLOT);
    fputc('\n', out);
}

/* Non-zero after a message; *panels is how many there are. */
static int write_script(const struct outcomes *o, int *panels)
{
    struct file *const f = report_file(o->plan, script);
    struct panel panel[PLAN_MEASURES];
    int longest = (int)strlen(o->plan->title);

    if (f == NULL) return 1;
    FILE *const out = file_stream(f);
    fputs("# cost, error [%], its ends at two standard errors, axis\n"
          "$data << END\n",
          out);
    *panels = picture_put_data(o, panel, &longest, out);
    fputs("END\n", out);
    put_variables(o, *panels, panel, longest, out);
    picture_put_program(out, picture_study);
    if (*panels > 0) return file_commit(f);
    file_discard(f);
    return 0;
}

static void say_why_there_is_none(const struct outcomes *o)
{
    int same = 1;

    for (int m = 0; m < o->plan->n_measures; m++)
        for (int v = 0; v < o->n; v++)
            same &= o->variant[v].of[m].error == 0.0;
    fprintf(stderr, "winnow: study: no picture: %s\n",
            same ? "all variants agree to the last bit, so that nothing but "
                   "their cost is left to compare; it is in study.md"
                 : "no error above 0 is known");
}

int outcome_draw(const struct outcomes *o)
{
    static const char *const kinds[][2] = {{"svg", "study.svg"},
                                           {"png", "study.png"}};
    int panels;

    if (write_script(o, &panels) != 0) return 1;
    if (panels == 0) say_why_there_is_none(o);
    for (int i = 0; i < 2 && panels > 0; i++) {
        const struct gnuplot g = {.folder = o->plan->dir,
                                  .script = script,
                                  .above = kinds[i][0],
                                  .png = kinds[i][1],
                                  .log = "gnuplot.log"};
        if (gnuplot_draw(&g) != 0)
            fprintf(stderr, "winnow: no %s/%s\n", g.folder, g.png);
    }
    return 0;
}
