/* SPDX-License-Identifier: GPL-3.0-or-later */
/* picture_flow.c -- the picture of a flow without particles: speed with
 * streamlines, and pressure, in a plane through the middle of the mesh. */
#include "output/flow/picture_flow.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/file.h"
#include "base/number.h"
#include "output/flow/slice.h"
#include "output/pictures/picture_script.h"

enum { POINTS = 120000, LINES = 26 };

/* clang-format off */
static const char *const script[] = {
PICTURE_SCRIPT_HEAD
"",
"# Sizes [pixels]. The panels are true to scale: side by side, or below each",
"# other where they are wide.",
"below_each_other = (x1 - x0) > 1.4 * (y1 - y0)",
"wide = below_each_other ? 900.0 : 420.0",
"tall = wide * (y1 - y0) / (x1 - x0)",
"if (tall > 640) { tall = 640.0; wide = tall * (x1 - x0) / (y1 - y0) }",
"if (tall < 40) { tall = 40.0 }",
"roomy = wide > 250 ? wide : 250.0",
"left = 90.0; gap = below_each_other ? 120.0 : 90.0; below = 120.0; above = 95.0",
"page_x = left + (below_each_other ? roomy : 2 * roomy + gap) + 40",
"page_y = below + (below_each_other ? 2 * tall + gap : tall) + above",
"if (page_x < 560) { page_x = 560.0 }",
"sx(pixels) = pixels / page_x",
"sy(pixels) = pixels / page_y",
"",
"ink = '#333333'",
PICTURE_SCRIPT_PAGE
"set label 2 sprintf('t = %.3f s', time) at screen sx(left), sy(page_y - 62) font 'Sans,12' textcolor rgb ink",
PICTURE_SCRIPT_AXES
"set ylabel right_up[2:2].' ['.mm.']' offset 0.8, 0 textcolor rgb ink",
"",
"# Speed, and streamlines over it.",
"base = below + (below_each_other ? tall + gap : 0)",
PICTURE_SCRIPT_SPEED
"set colorbox horizontal user origin sx(left), sy(base - 66) size sx(roomy), sy(10) bdefault",
"set cblabel 'speed [m/s]' offset 0, 0.9 textcolor rgb ink",
"set lmargin at screen sx(left); set rmargin at screen sx(left + wide)",
"set bmargin at screen sy(base); set tmargin at screen sy(base + tall)",
"plot dir.'/picture/flow.txt' using ($1 / unit):($2 / unit):3 with image, \\",
"     dir.'/picture/streamlines.txt' using ($1 / unit):($2 / unit) with lines linewidth 0.8 linecolor rgb '#90ffffff'",
"unset label",
"",
"# Pressure.",
"at = below_each_other ? left : left + roomy + gap",
"set palette defined (0 '#2166ac', 1 '#92c5de', 2 '#f7f7f7', 3 '#f4a582', 4 '#b2182b')",
"set cbrange [low : high]",
"set cbtics nice((high - low) / 5)",
"set colorbox horizontal user origin sx(at), sy(below - 66) size sx(roomy), sy(10) bdefault",
"set cblabel 'pressure [Pa]' offset 0, 0.9 textcolor rgb ink",
"set lmargin at screen sx(at); set rmargin at screen sx(at + wide)",
"set bmargin at screen sy(below); set tmargin at screen sy(below + tall)",
"plot dir.'/picture/flow.txt' using ($1 / unit):($2 / unit):4 with image",
"unset multiplot",
"unset output",
NULL};
/* clang-format on */

int picture_flow_fits(const struct picture *p)
{
    return p->u != NULL && p->x[0] == NULL;
}

static void put_numbers(FILE *out, int n, const double *x)
{
    char text[NUMBER_LENGTH];

    for (int i = 0; i < n; i++)
        fprintf(out, "%s%c", number_rounded(x[i], 6, text),
                i < n - 1 ? ' ' : '\n');
}

static int put_points(struct folder *folder, const struct slice *s)
{
    struct file *const f = picture_open(folder, "picture/flow.txt");

    if (f == NULL) return 1;
    fprintf(file_stream(f), "# place to the right, place up [m]  speed [m/s]  "
                            "pressure [Pa]\n");
    for (int i = 0; i < s->n[0] * s->n[1]; i++) {
        const double none = (double)NAN;
        put_numbers(file_stream(f), 4,
                    (double[4]){s->lo[0] + i % s->n[0] * s->step[0],
                                s->lo[1] + i / s->n[0] * s->step[1],
                                s->inside[i] ? s->speed[i] : none,
                                s->inside[i] ? s->p[i] : none});
    }
    return file_commit(f);
}

static void picture_flow_put_point(void *of, const double *x)
{
    if (x == NULL)
        fputc('\n', of);
    else
        put_numbers(of, 2, x);
}

static int picture_flow_put_lines(struct folder *folder, const struct slice *s)
{
    struct file *const f = picture_open(folder, "picture/streamlines.txt");
    const double size =
        sqrt(s->n[0] * s->step[0] * s->n[1] * s->step[1]); /* [m] */

    if (f == NULL) return 1;
    fprintf(file_stream(f), "# place to the right, place up [m]; a line ends "
                            "with an empty one\n");
    slice_streamlines(s, size / LINES, picture_flow_put_point, file_stream(f));
    /* gnuplot draws no file without a point */
    fprintf(file_stream(f), "nan nan\n");
    return file_commit(f);
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The range that all but one in a hundred points have: at a corner where a
 * moving wall ends the pressure has no bound. */
static void pressure_range(const struct slice *s, double *low, double *high)
{
    double *const p = alloc_doubles(s->n[0] * s->n[1]);
    int n = 0;

    for (int i = 0; i < s->n[0] * s->n[1]; i++)
        if (s->inside[i]) p[n++] = s->p[i];
    qsort(p, (size_t)n, sizeof *p, ascending);
    *low = n > 0 ? p[n / 200] : 0.0;
    *high = n > 0 ? p[n - 1 - n / 200] : 0.0;
    if (!(*high > *low)) *high = *low + 1.0;
    free(p);
}

static int picture_flow_put_script(struct folder *folder,
                                   const struct picture *p,
                                   const struct slice *s)
{
    struct file *const f = picture_open(folder, "picture/bed.gp");
    double fast = 0.0, low, high;

    if (f == NULL) return 1;
    for (int i = 0; i < s->n[0] * s->n[1]; i++)
        fast = fmax(fast, s->speed[i]);
    pressure_range(s, &low, &high);
    const int a = s->axis[0], b = s->axis[1];
    const double *const lo = p->mesh->lo, *const hi = p->mesh->hi;
    FILE *const out = file_stream(f);
    picture_put_box(out, p, fast > 0.0 ? fast : 1.0);
    picture_put_number(out, "x0", lo[a], "m");
    picture_put_number(out, "x1", hi[a], "m");
    picture_put_number(out, "y0", lo[b], "m");
    picture_put_number(out, "y1", hi[b], "m");
    picture_put_number(out, "low", low, "Pa");
    picture_put_number(out, "high", high, "Pa");
    fprintf(out, "right_up = '%c%c'\n\n", 'x' + a, 'x' + b);
    fprintf(out,
            "set xlabel '%c ['.((y1 - y0 < 1 && x1 - x0 < 1) ? 'mm' : "
            "'m').']' offset 0, 0.4\n",
            'x' + a);
    for (const char *const *line = script; *line; line++)
        fprintf(out, "%s\n", *line);
    return file_commit(f);
}

int picture_flow_write(struct folder *folder, const struct picture *p)
{
    struct slice s = slice_of(p->mesh, p->u, p->p, POINTS);
    const int failed = put_points(folder, &s) ||
                       picture_flow_put_lines(folder, &s) ||
                       picture_flow_put_script(folder, p, &s);

    slice_release(&s);
    return failed;
}
