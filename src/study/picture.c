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

/* cost, error [%], its lower and upper end (two standard errors). */
static void picture_put_point(const struct outcomes *o, int m, int v, FILE *out)
{
    const struct finding *const f = &o->variant[v].of[m];
    const double low = fmax(f->error - 2.0 * f->uncertainty, 1e-2 * f->error);

    fprintf(out, "%.8g %.8g %.8g %.8g\n", o->variant[v].cost, 100.0 * f->error,
            100.0 * low, 100.0 * (f->error + 2.0 * f->uncertainty));
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
    char *const label = words_variant(&o->plan->choices, first, o->axis);
    const double order = median_order(o, m, first);
    struct texts title = {0};

    texts_add(&title, "%s",
              label[0] != '\0' ? label : words_error(&o->plan->truth[m]));
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
    int labels;           /* [-] how many have been placed */
    double (*label)[2];   /* [px] their middles, */
    const char **text;    /* and the values of the axis that they are */
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

/* --- labels beside the points --------------------------------------------- */

/* [px] A panel's plot, a letter, a point, about: letters may be narrower. */
static const double plot_wide = 480.0, plot_high = 255.0;
static const double letter_wide = 7.6, letter_high = 15.0, point = 9.0;

/* The place of a point in a panel, from its lower left corner. */
static void place_of(const struct outcomes *o, const struct panel *p, int v,
                     double at[2])
{
    at[0] = plot_wide * log(o->variant[v].cost / p->x_low) /
            log(p->x_high / p->x_low);
    at[1] = plot_high * log(100.0 * o->variant[v].of[p->m].error / p->y_low) /
            log(p->y_high / p->y_low);
}

static int is_near(const double a[2], const double b[2], double x, double y)
{
    return fabs(a[0] - b[0]) < x && fabs(a[1] - b[1]) < y;
}

/* 1 if a text fits there beside all points and labels. */
static int is_free(const struct outcomes *o, const struct panel *p,
                   const double at[2], double wide)
{
    double other[2];

    if (at[0] < 0.5 * wide || at[1] < 0.5 * letter_high ||
        at[1] > plot_high - 0.5 * letter_high)
        return 0;
    for (int v = 0; v < o->n; v++) {
        if (!is_shown(o, p->m, v)) continue;
        place_of(o, p, v, other);
        if (is_near(at, other, 0.5 * (wide + point),
                    0.5 * (letter_high + point)))
            return 0;
    }
    for (int i = 0; i < p->labels; i++)
        if (is_near(at, p->label[i],
                    0.5 * (wide + letter_wide * (double)strlen(p->text[i])),
                    letter_high))
            return 0;
    return 1;
}

/* Finds a place for the label of a variant: above, below, or none. */
static void place_label(const struct outcomes *o, struct panel *p, int v)
{
    static const double way[][2] = {{1, 1},   {-1, -1},  {1, -1},  {-1, 1},
                                    {0, 1.4}, {0, -1.4}, {1.3, 0}, {-1.3, 0}};
    const struct choice *const axis = &o->plan->choices.of[o->axis];
    const char *const text =
        choices_value(&o->plan->choices, v, axis->key.text[0]);
    const double wide = letter_wide * (double)strlen(text);
    double at[2], to[2];

    place_of(o, p, v, at);
    for (int i = 0; i < 8; i++) {
        to[0] = at[0] + way[i][0] * 0.5 * (wide + point);
        to[1] = at[1] + way[i][1] * 0.5 * (letter_high + point);
        if (!is_free(o, p, to, wide)) continue;
        memcpy(p->label[p->labels], to, sizeof to);
        p->text[p->labels++] = text;
        return;
    }
}

/* The labels of a panel, a part of the data: their middles in the units of the
 * axes, and their texts; those of the first line where points are many. */
static void put_labels(const struct outcomes *o, struct panel *p, FILE *out)
{
    const int all = points(o, p->m, -1) <= 12;

    p->label = alloc_zeroed((size_t)o->n, sizeof *p->label);
    p->text = alloc_zeroed((size_t)o->n, sizeof *p->text);
    for (int v = 0; v < o->n && o->axis >= 0; v++)
        if (is_shown(o, p->m, v) &&
            (all || is_on(o, next_line(o, p->m, -1), v)))
            place_label(o, p, v);
    fputs("\n\n", out);
    for (int i = 0; i < p->labels; i++) {
        fprintf(
            out, "%.8g %.8g ",
            p->x_low * pow(p->x_high / p->x_low, p->label[i][0] / plot_wide),
            p->y_low * pow(p->y_high / p->y_low, p->label[i][1] / plot_high));
        text_put(out, p->text[i], TEXT_DATA);
        fputc('\n', out);
    }
    free(p->label);
    free(p->text);
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
        find_ranges(o, &panel[n]);
        put_labels(o, &panel[n], out);
        parts += panel[n++].labels > 0;
    }
    return n;
}

/* A line of the script: NAME = 'TEXT'. The text is freed. */
static void picture_put_words(const char *name, int i, char *text, FILE *out)
{
    fprintf(out, i > 0 ? "%s[%d] = " : "%s = ", name, i);
    text_put(out, text, TEXT_GNUPLOT);
    fputc('\n', out);
    free(text);
}

static void put_panel(const struct outcomes *o, int i, const struct panel *of,
                      FILE *out)
{
    const struct truth *const t = &o->plan->truth[of->m];

    fprintf(out,
            "front[%d] = %d; lines[%d] = %d; labels[%d] = %d\n"
            "x_low[%d] = %.4g; x_high[%d] = %.4g; y_low[%d] = %.4g; "
            "y_high[%d] = %.4g\n",
            i, of->front, i, of->lines, i, of->labels, i, of->x_low, i,
            of->x_high, i, of->y_low, i, of->y_high);
    fprintf(out, "errors[%d] = '%s %s '\n", i, words_error(t),
            t->kind == TRUTH_FINEST ? "from" : "against");
    picture_put_words("titles", i, words_measure(&o->plan->measure[of->m]),
                      out);
    picture_put_words("references", i, words_truth(o, of->m), out);
}

/* What differs from line to line, and along them; returns the longest title. */
static int put_meanings(const struct outcomes *o, int longest, FILE *out)
{
    const struct choices *const c = &o->plan->choices;
    int n = 0;

    fprintf(out, "array differ[%d]\ndiffer[1] = along = ''\n", c->n);
    for (int i = 0; i < c->n; i++) {
        char *const words = words_choice(&c->of[i]);
        const int before = i == o->axis ? 19 : 0; /* "beside the points: " */
        const int length = before + (int)strlen(words);

        if (c->of[i].n > 1 && length > longest) longest = length;
        if (c->of[i].n < 2)
            free(words);
        else if (i == o->axis)
            picture_put_words("along", 0, words, out);
        else
            picture_put_words("differ", ++n, words, out);
    }
    fprintf(out, "meanings = %d\n", n);
    return longest;
}

static void put_variables(const struct outcomes *o, int n,
                          const struct panel *panel, int longest, FILE *out)
{
    static const char *const arrays[] = {
        "front", "lines",  "labels", "x_low",  "x_high",
        "y_low", "y_high", "errors", "titles", "references"};
    const struct plan *const p = o->plan;
    int most = 0;

    fprintf(out, "panels = %d\n", n);
    for (int k = 0; k < 10; k++)
        fprintf(out, "array %s[%d]\n", arrays[k], n);
    for (int i = 0; i < n; i++) {
        put_panel(o, i + 1, &panel[i], out);
        if (panel[i].lines > most) most = panel[i].lines;
    }
    longest = put_meanings(o, longest, out);
    fprintf(out, "most = %d; longest = %d\n", most, longest);
    picture_put_words("title", 0, strdup(p->title), out);
    picture_put_words("cost", 0, words_cost(p), out);
}

/* Non-zero after a message; *panels is how many there are. */
static int write_script(const struct outcomes *o, int *panels)
{
    struct file *const f = report_file(o->plan, script);
    struct panel panel[PLAN_MEASURES];
    int longest = (int)strlen(o->plan->title);

    if (f == NULL) return 1;
    FILE *const out = file_stream(f);
    fputs("# cost, error [%], its ends at two standard errors; labels\n"
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
        if (gnuplot_draw(o->plan->dir, script, kinds[i][0], kinds[i][1]) != 0)
            fprintf(stderr, "winnow: no %s/%s\n", o->plan->dir, kinds[i][1]);
    }
    return 0;
}
