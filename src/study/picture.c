/* SPDX-License-Identifier: GPL-3.0-or-later */
/* picture.c -- error against cost, drawn by gnuplot.
 *
 * A panel a measure, two of them one above the other, so that its letters can
 * be read at half the width of a page. A line goes along the axis; lines differ
 * by the shape of their points and by their dashes, so that no colour is needed
 * to tell them apart. The grey steps are the front: the least error that so
 * much buys.
 */
#include "study/outcome.h"

#include "base/alloc.h"
#include "base/file.h"
#include "base/number.h"
#include "output/pictures/gnuplot.h"

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

/* --- the data ------------------------------------------------------------- */

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

/* Blocks of data: $front, and one for each line by its first variant. */
static void picture_put_data(const struct outcomes *o, int m, FILE *out)
{
    fputs("# cost, error [%], its ends at two standard errors, axis\n"
          "$front << END\n",
          out);
    put_front(o, m, out);
    fputs("END\n", out);
    for (int l = next_line(o, m, -1); l < o->n; l = next_line(o, m, l)) {
        fprintf(out, "$line%d << END\n", l);
        for (int v = 0; v < o->n; v++)
            if (is_on(o, l, v) && is_shown(o, m, v))
                picture_put_point(o, m, v, out);
        fputs("END\n", out);
    }
}

/* --- the script ----------------------------------------------------------- */

static const char opening[] =
    "# gnuplot -c study.gp svg FILE    or png FILE, in this folder\n"
    "size_x = 130.0 + 8.0 * (longest > 56 ? longest : 56)\n"
    "size_y = 400.0 + 27.0 * (lines + 1)\n"
    "if (ARG1 eq 'png') {\n"
    "    set terminal pngcairo size 2*wide*size_x, 2*rows*size_y font "
    "'Sans,16' fontscale 2 linewidth 2 pointscale 2 background '#ffffff'\n"
    "} else {\n"
    "    set terminal svg size wide*size_x, rows*size_y dynamic font "
    "'sans,16' background '#ffffff'\n"
    "}\n"
    "set output ARG2\n"
    "set border 3 linecolor rgb '#555555'\n"
    "set tics nomirror font ',14' textcolor rgb '#333333'\n"
    "set grid linecolor rgb '#dddddd' linetype 1\n"
    "set key outside bottom left horizontal Left reverse spacing 1.2 "
    "samplen 4 font ',14' noenhanced\n"
    "set logscale xy\n"
    "set format '%g'\n"
    "set bars 0.6\n"
    "# Shape, dashes and shade differ from line to line.\n"
    "shades = '#0b3c5d #c2571a #3d7a3d #7a4a9a #222222 #b8860b #2a8a8a "
    "#a03060'\n"
    "dashes = '1 2 4 3 1 2 4 3'; shapes = '7 5 9 13 6 4 8 12'\n"
    "do for [i = 1:8] {\n"
    "    set linetype i linecolor rgb word(shades, i) "
    "dashtype int(word(dashes, i)) pointtype int(word(shapes, i)) "
    "linewidth (i > 4 ? 1.4 : 2)\n"
    "}\n"
    "set linetype cycle 8\n"
    "set pointsize 0.9\n";

static void put_labels(const struct plan *p, int m, FILE *out)
{
    const char *const measure = p->measure[m].text, *const truth =
                                                        p->truth[m].text;
    char text[4 * MEASURE_NAME];

    fputs("set xlabel ", out);
    text_put(out,
             plan_cost_is_processor(p) ? "processor time of a run [s]"
                                       : p->cost.text,
             TEXT_GNUPLOT);
    fputs(" noenhanced\nset ylabel 'error [%]'\nset title ", out);
    snprintf(text, sizeof text, "%s against %s", measure, truth);
    text_put(out, strlen(text) > 60 ? measure : text, TEXT_GNUPLOT);
    fputs(" font ',15' noenhanced offset 0,-0.5\n", out);
}

/* The range of an axis of logarithms and its marks: decades; 1, 2, 5 of each
 * where there are few of them; more where the range is narrow. */
static void put_range(const char *axis, double low, double high, FILE *out)
{
    static const char *const marks[] = {"1", "2", "5",   "1.2", "1.5",
                                        "3", "4", "2.5", "6",   "8"};
    const int first = number_clamped(floor(log10(low)), -300, 300);
    const int last = number_clamped(ceil(log10(high)), -300, 300);
    const int every = last - first > 8 ? 2 : 1;
    const int n = high < 6.0 * low ? 10 : last - first <= 3 ? 3 : 1;

    fprintf(out, "set %srange [%.4g:%.4g]\nset %stics (", axis, low, high,
            axis);
    for (int d = first; d <= last; d += every)
        for (int i = 0; i < n; i++)
            fprintf(out, "%s%se%d", d > first || i > 0 ? ", " : "", marks[i],
                    d);
    fputs(")\n", out);
}

static void put_ranges(const struct outcomes *o, int m, FILE *out)
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {0.0, 0.0};

    for (int v = 0; v < o->n; v++) {
        const struct finding *const f = &o->variant[v].of[m];
        if (!is_shown(o, m, v)) continue;
        low[0] = fmin(low[0], o->variant[v].cost);
        high[0] = fmax(high[0], o->variant[v].cost);
        low[1] = fmin(low[1], 100.0 * f->error);
        high[1] = fmax(high[1], 100.0 * (f->error + 2.0 * f->uncertainty));
    }
    put_range("x", low[0] / 1.3, 1.6 * high[0], out);
    put_range("y", low[1] / 2.0, 1.6 * high[1], out);
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

/* What a line is called. */
static void put_title(const struct outcomes *o, int m, int first, FILE *out)
{
    char *const label = choices_label(&o->plan->choices, first, o->axis);
    const double order = median_order(o, m, first);
    char title[4 * MEASURE_NAME], end[32] = "";

    if (isfinite(order)) snprintf(end, sizeof end, ", order %.2g", order);
    snprintf(title, sizeof title, "%.*s%s", (int)(sizeof title - sizeof end),
             label[0] != '\0' ? label : "error", end);
    text_put(out, title, TEXT_GNUPLOT);
    free(label);
}

/* One line of the plot command: its points, with error bars where there are
 * any. */
static void picture_put_line(const struct outcomes *o, int m, int first,
                             int number, FILE *out)
{
    const int alone = points(o, m, first) == 1;
    int has_bars = 0;

    for (int v = 0; v < o->n; v++)
        has_bars |= is_on(o, first, v) && o->variant[v].of[m].uncertainty > 0.0;
    fprintf(out, ", \\\n  $line%d using %s with %s linetype %d title ", first,
            has_bars ? "1:2:3:4" : "1:2",
            has_bars ? alone ? "yerrorbars" : "yerrorlines"
            : alone  ? "points"
                     : "linespoints",
            number);
    put_title(o, m, first, out);
    /* The values of the axis beside the points: once, where lines are many. */
    if (o->axis >= 0 && (number == 1 || points(o, m, -1) <= 12))
        fprintf(
            out,
            ", \\\n  '' using 1:2:5 with labels left offset "
            "0.8,0.6 font ',13' textcolor rgb '#444444' noenhanced notitle");
}

static void put_panel(const struct outcomes *o, int m, FILE *out)
{
    int number = 0;

    picture_put_data(o, m, out);
    put_labels(o->plan, m, out);
    put_ranges(o, m, out);
    fputs("plot $front using 1:2 with steps linecolor rgb '#cccccc' "
          "linewidth 6 dashtype 1 title 'least error for the cost'",
          out);
    for (int l = next_line(o, m, -1); l < o->n; l = next_line(o, m, l))
        picture_put_line(o, m, l, ++number, out);
    fputc('\n', out);
}

/* How many lines a panel has to hold at most, and the letters of the longest
 * label. */
static void count_contents(const struct outcomes *o, int *lines, int *longest)
{
    *lines = 0;
    *longest = (int)strlen(o->plan->title);
    for (int m = 0; m < o->plan->n_measures; m++) {
        int n = 0;
        for (int l = next_line(o, m, -1); l < o->n; l = next_line(o, m, l)) {
            char *const label = choices_label(&o->plan->choices, l, o->axis);
            const int length = (int)strlen(label) + (int)strlen(", order 0.12");
            if (length > *longest) *longest = length;
            if (++n > *lines) *lines = n;
            free(label);
        }
    }
}

static int write_script(const struct outcomes *o, int panels)
{
    struct file *const f = report_file(o->plan, script);
    const int wide = panels > 2 ? 2 : 1, rows = (panels + wide - 1) / wide;
    int lines, longest;

    if (f == NULL) return 1;
    count_contents(o, &lines, &longest);
    FILE *const out = file_stream(f);
    fprintf(out, "wide = %d; rows = %d; lines = %d; longest = %d\n%s", wide,
            rows, lines, longest, opening);
    fprintf(out, "set multiplot layout %d,%d title ", rows, wide);
    text_put(out, o->plan->title, TEXT_GNUPLOT);
    fputs(" noenhanced\n", out);
    for (int m = 0; m < o->plan->n_measures; m++)
        if (points(o, m, -1) > 0) put_panel(o, m, out);
    fputs("unset multiplot\n", out);
    return file_commit(f);
}

static int say_why_there_is_none(const struct outcomes *o)
{
    int same = 1;

    for (int m = 0; m < o->plan->n_measures; m++)
        for (int v = 0; v < o->n; v++)
            same &= o->variant[v].of[m].error == 0.0;
    fprintf(stderr, "winnow: study: no picture: %s\n",
            same ? "all variants agree to the last bit, so that nothing but "
                   "their cost is left to compare; it is in study.md"
                 : "no error above 0 is known");
    return 0;
}

int outcome_draw(const struct outcomes *o)
{
    static const char *const kinds[][2] = {{"svg", "study.svg"},
                                           {"png", "study.png"}};
    int panels = 0;

    for (int m = 0; m < o->plan->n_measures; m++)
        panels += points(o, m, -1) > 0;
    if (panels == 0) return say_why_there_is_none(o);
    if (write_script(o, panels) != 0) return 1;
    for (int i = 0; i < 2; i++) {
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
