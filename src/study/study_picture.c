/* SPDX-License-Identifier: GPL-3.0-or-later */
/* study_picture.c -- error against cost, drawn by gnuplot.
 *
 * A panel a measure. A line goes along the axis; lines differ by the shape of
 * their points and by their dashes, so that no colour is needed to tell them
 * apart. The grey steps are the front: the least error that so much buys.
 */
#include "study/study_report.h"

#include "base/alloc.h"
#include "base/file.h"
#include "base/number.h"
#include "output/gnuplot.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char data[] = "study-lines.txt", script[] = "study.gp";

/* 1 if the variant can be drawn: an error above 0 and a cost. */
static int is_shown(const struct outcome *v, int m)
{
    return v->ended && v->of[m].error > 0.0 && v->cost > 0.0;
}

/* The first variant of the line that v lies on. */
static int line_of(const struct outcomes *o, int v)
{
    return o->axis < 0 ? v : choices_with(&o->plan->choices, v, o->axis, 0);
}

static int shown_in_line(const struct outcomes *o, int first, int m)
{
    int n = 0;

    for (int v = 0; v < o->n; v++)
        n += line_of(o, v) == first && is_shown(&o->variant[v], m);
    return n;
}

static int shown_in_panel(const struct outcomes *o, int m)
{
    int n = 0;

    for (int v = 0; v < o->n; v++)
        n += is_shown(&o->variant[v], m);
    return n;
}

/* --- the data --------------------------------------------------------------
 */

static const char *axis_value(const struct outcomes *o, int v)
{
    if (o->axis < 0) return "";
    const struct choice *const c = &o->plan->choices.of[o->axis];
    return c->value[choices_entry(&o->plan->choices, v, o->axis) * c->n_keys];
}

/* cost, error [%], its lower and upper end (two standard errors), value of the
 * axis. */
static void put_point(const struct outcomes *o, int v, int m, FILE *out)
{
    const struct finding *const f = &o->variant[v].of[m];
    const double low = fmax(f->error - 2.0 * f->doubt, 1e-2 * f->error);

    fprintf(out, "%.8g %.8g %.8g %.8g \"%s\"\n", o->variant[v].cost,
            100.0 * f->error, 100.0 * low, 100.0 * (f->error + 2.0 * f->doubt),
            axis_value(o, v));
}

/* The front: for each variant that no cheaper one beats, in order of cost. */
static void put_front(const struct outcomes *o, int m, FILE *out)
{
    double cost = 0.0, error = INFINITY;

    for (;;) {
        int next = -1;
        for (int v = 0; v < o->n; v++) {
            const struct outcome *const out_v = &o->variant[v];
            if (!is_shown(out_v, m) || out_v->cost < cost ||
                out_v->of[m].error >= error)
                continue;
            if (next < 0 || out_v->cost < o->variant[next].cost) next = v;
        }
        if (next < 0) return;
        cost = o->variant[next].cost;
        error = o->variant[next].of[m].error;
        put_point(o, next, m, out);
    }
}

static int write_data(const struct outcomes *o)
{
    char *const path = file_join(o->plan->dir, data);
    struct file *const f = file_create(path);

    free(path);
    if (f == NULL) return 1;
    FILE *const out = file_stream(f);
    fputs("# cost, error [%], its ends at two standard errors, axis\n", out);
    for (int m = 0; m < o->plan->n_measures; m++) {
        fprintf(out, "# the front, %s\n", o->plan->measure[m].text);
        put_front(o, m, out);
        fputs("\n\n", out);
        for (int first = 0; first < o->n; first++) {
            if (line_of(o, first) != first || shown_in_line(o, first, m) == 0)
                continue;
            char *const label =
                choices_label(&o->plan->choices, first, o->axis);
            fprintf(out, "# %s\n", label);
            free(label);
            for (int v = 0; v < o->n; v++)
                if (line_of(o, v) == first && is_shown(&o->variant[v], m))
                    put_point(o, v, m, out);
            fputs("\n\n", out);
        }
    }
    return file_commit(f);
}

/* --- the script ------------------------------------------------------------
 */

static const char opening[] =
    "# gnuplot -c study.gp svg FILE    or png FILE, in this folder\n"
    "size_x = width > 1 ? 560.0 : 720.0; size_y = 360.0 + 26.0 * (lines + 1)\n"
    "if (ARG1 eq 'png') {\n"
    "    set terminal pngcairo size 2*width*size_x, 2*rows*size_y font "
    "'Sans,13' fontscale 2 linewidth 2 pointscale 2 background '#ffffff'\n"
    "} else {\n"
    "    set terminal svg size width*size_x, rows*size_y dynamic font "
    "'sans,13' background '#ffffff'\n"
    "}\n"
    "set output ARG2\n"
    "set border 3 linecolor rgb '#555555'\n"
    "set tics nomirror textcolor rgb '#333333'\n"
    "set grid linecolor rgb '#dddddd' linetype 1\n"
    "set key outside bottom left horizontal Left reverse spacing 1.3 "
    "samplen 4 noenhanced\n"
    "set logscale xy\n"
    "set format '%g'\n"
    "set bars 0.6\n"
    "# Shape, dashes and shade differ from line to line.\n"
    "set linetype 1 linecolor rgb '#0b3c5d' dashtype 1 pointtype 7 "
    "linewidth 2\n"
    "set linetype 2 linecolor rgb '#c2571a' dashtype 2 pointtype 5 "
    "linewidth 2\n"
    "set linetype 3 linecolor rgb '#3d7a3d' dashtype 4 pointtype 9 "
    "linewidth 2\n"
    "set linetype 4 linecolor rgb '#7a4a9a' dashtype 3 pointtype 13 "
    "linewidth 2\n"
    "set linetype 5 linecolor rgb '#222222' dashtype 1 pointtype 6 "
    "linewidth 1.4\n"
    "set linetype 6 linecolor rgb '#b8860b' dashtype 2 pointtype 4 "
    "linewidth 1.4\n"
    "set linetype 7 linecolor rgb '#2a8a8a' dashtype 4 pointtype 8 "
    "linewidth 1.4\n"
    "set linetype 8 linecolor rgb '#a03060' dashtype 3 pointtype 12 "
    "linewidth 1.4\n"
    "set linetype cycle 8\n"
    "set pointsize 0.9\n";

/* A text in single quotes, as gnuplot has them: a quote within is doubled. */
static void put_quoted(FILE *out, const char *text)
{
    fputc('\'', out);
    for (; *text != '\0'; text++) {
        if (*text == '\'') fputc('\'', out);
        fputc(*text == '\n' ? ' ' : *text, out);
    }
    fputc('\'', out);
}

static void put_labels(const struct plan *p, int m, FILE *out)
{
    char text[4 * MEASURE_NAME];

    if (strcmp(p->cost.name, PLAN_COST) == 0)
        fputs("set xlabel 'processor time of a run [s]'\n", out);
    else {
        fputs("set xlabel ", out);
        put_quoted(out, p->cost.text);
        fputs(" noenhanced\n", out);
    }
    fputs("set ylabel 'error [%]'\nset title ", out);
    snprintf(text, sizeof text, "%s against %s", p->measure[m].text,
             p->truth[m].text);
    if (strlen(text) > 60)
        snprintf(text, sizeof text, "%s", p->measure[m].text);
    put_quoted(out, text);
    fputs(" font ',12' noenhanced offset 0,-0.5\n", out);
}

/* The range of an axis and its marks: decades; 1, 2, 5 of each where there are
 * few of them; more where the range is narrow. */
static void put_range(const char *axis, double low, double high, FILE *out)
{
    static const char *const marks[] = {"1", "2", "5",   "1.2", "1.5",
                                        "3", "4", "2.5", "6",   "8"};
    const int first = number_clamped(floor(log10(low)), -300, 300);
    const int last = number_clamped(ceil(log10(high)), -300, 300);
    const int every = last - first > 8 ? 2 : 1;
    const int n = high < 6.0 * low ? 10 : last - first <= 3 ? 3 : 1;
    const char *between = "";

    fprintf(out, "set %srange [%.4g:%.4g]\nset %stics (", axis, low, high,
            axis);
    for (int d = first; d <= last; d += every)
        for (int i = 0; i < n; i++) {
            fprintf(out, "%s%se%d", between, marks[i], d);
            between = ", ";
        }
    fputs(")\n", out);
}

static void put_ranges(const struct outcomes *o, int m, FILE *out)
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {0.0, 0.0};

    for (int v = 0; v < o->n; v++) {
        const struct outcome *const of = &o->variant[v];
        if (!is_shown(of, m)) continue;
        const struct finding *const f = &of->of[m];
        low[0] = fmin(low[0], of->cost);
        high[0] = fmax(high[0], of->cost);
        low[1] = fmin(low[1], 100.0 * f->error);
        high[1] = fmax(high[1], 100.0 * (f->error + 2.0 * f->doubt));
    }
    put_range("x", low[0] / 1.3, 1.6 * high[0], out);
    put_range("y", low[1] / 2.0, 1.6 * high[1], out);
}

/* One line of the plot command: its points, with error bars where there are
 * any. */
static void put_line(const struct outcomes *o, int first, int m, int index,
                     int number, FILE *out)
{
    char *const label = choices_label(&o->plan->choices, first, o->axis);
    const int alone = shown_in_line(o, first, m) == 1;
    int doubtful = 0;

    for (int v = 0; v < o->n; v++)
        doubtful |= line_of(o, v) == first && o->variant[v].of[m].doubt > 0.0;
    fprintf(out, ", \\\n  '%s' index %d using %s with %s linetype %d title ",
            data, index, doubtful ? "1:2:3:4" : "1:2",
            doubtful ? alone ? "yerrorbars" : "yerrorlines"
            : alone  ? "points"
                     : "linespoints",
            number);
    put_quoted(out, label[0] != '\0' ? label : "error");
    /* The values of the axis beside the points: once, where lines are many. */
    if (o->axis >= 0 && (number == 1 || shown_in_panel(o, m) <= 12))
        fprintf(out,
                ", \\\n  '' index %d using 1:2:5 with labels left offset "
                "0.8,0.6 font ',10' textcolor rgb '#444444' noenhanced notitle",
                index);
    free(label);
}

static void put_panel(const struct outcomes *o, int m, int *index, FILE *out)
{
    int number = 0;

    put_labels(o->plan, m, out);
    put_ranges(o, m, out);
    fprintf(out,
            "plot '%s' index %d using 1:2 with steps linecolor rgb '#cccccc' "
            "linewidth 6 dashtype 1 title 'least error for the cost'",
            data, (*index)++);
    for (int first = 0; first < o->n; first++)
        if (line_of(o, first) == first && shown_in_line(o, first, m) > 0)
            put_line(o, first, m, (*index)++, ++number, out);
    fputc('\n', out);
}

static int most_lines(const struct outcomes *o)
{
    int most = 0;

    for (int m = 0; m < o->plan->n_measures; m++) {
        int n = 0;
        for (int v = 0; v < o->n; v++)
            n += line_of(o, v) == v && shown_in_line(o, v, m) > 0;
        if (n > most) most = n;
    }
    return most;
}

static int write_script(const struct outcomes *o, int panels)
{
    char *const path = file_join(o->plan->dir, script);
    struct file *const f = file_create(path);
    int index = 0;

    free(path);
    if (f == NULL) return 1;
    FILE *const out = file_stream(f);
    fprintf(out, "width = %d; rows = %d; lines = %d\n%s", panels > 1 ? 2 : 1,
            (panels + 1) / 2, most_lines(o), opening);
    fprintf(out, "set multiplot layout %d,%d title ", (panels + 1) / 2,
            panels > 1 ? 2 : 1);
    put_quoted(out, o->plan->title);
    fputs(" noenhanced\n", out);
    for (int m = 0; m < o->plan->n_measures; m++) {
        if (shown_in_panel(o, m) > 0)
            put_panel(o, m, &index, out);
        else
            index++; /* its front is empty */
    }
    fputs("unset multiplot\n", out);
    return file_commit(f);
}

static void draw(const struct plan *p, const char *kind, const char *file)
{
    const struct gnuplot g = {.folder = p->dir,
                              .script = script,
                              .above = kind,
                              .png = file,
                              .log = "gnuplot.log"};

    if (gnuplot_draw(&g) == 0) return;
    fprintf(stderr, "winnow: no %s/%s\n", p->dir, file);
}

int study_report_picture(const struct outcomes *o)
{
    int panels = 0;

    for (int m = 0; m < o->plan->n_measures; m++)
        panels += shown_in_panel(o, m) > 0;
    if (panels == 0) {
        fputs("winnow: study: no picture, for no error is known\n", stderr);
        return 0;
    }
    if (write_data(o) != 0 || write_script(o, panels) != 0) return 1;
    draw(o->plan, "svg", "study.svg");
    draw(o->plan, "png", "study.png");
    return 0;
}
