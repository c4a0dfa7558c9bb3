/* SPDX-License-Identifier: GPL-3.0-or-later */
/* picture_flow.c -- the picture of a flow without particles: speed with
 * streamlines, and pressure, in a plane through the middle of the mesh. */
#include "output/pictures/picture.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/file.h"
#include "output/pictures/slice.h"

enum { POINTS = 120000, LINES = 26 };

static int put_points(struct folder *folder, const struct slice *s)
{
    struct file *const f = picture_open(folder, "picture/flow.txt");

    if (f == NULL) return 1;
    fprintf(file_stream(f), "# place to the right, place up [m]  speed [m/s]  "
                            "pressure [Pa]\n");
    for (int i = 0; i < s->n[0] * s->n[1]; i++) {
        const double none = (double)NAN;
        picture_put_row(file_stream(f), 4,
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
        picture_put_row(of, 2, x);
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
    picture_put_program(out, picture_flow);
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
