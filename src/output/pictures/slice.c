/* SPDX-License-Identifier: GPL-3.0-or-later */
/* slice.c -- a plane through a flow, its streamlines, and the picture of a flow
 * without particles: speed with streamlines, and pressure. */
#include "output/pictures/picture.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/file.h"
#include "base/number.h"
#include "base/vector.h"
#include "output/means/means.h"

/* The direction with one cell, else the shortest; z before the others. */
static int least_to_see(const struct mesh *m)
{
    static const int order[3] = {2, 1, 0};
    int best = 2;

    for (int i = 0; i < 3 && m->face_centre == NULL; i++)
        if (m->box.n[order[i]] == 1) return order[i];
    for (int i = 0; i < 3; i++) {
        const int k = order[i];
        if (m->hi[k] - m->lo[k] < 0.999 * (m->hi[best] - m->lo[best])) best = k;
    }
    return best;
}

static void slice_sample(struct slice *s, const struct mesh *m, int i,
                         const double x[3], const double *u, const double *p)
{
    double offset[3];

    if (mesh_cell_and_offset(m, x, offset) < 0) return;
    const struct probe at = probe_at(m, x);
    double w[3];
    for (int k = 0; k < 3; k++)
        w[k] = probe_value(&at, u, 3, k, NULL);
    s->inside[i] = 1;
    s->u[i] = w[s->axis[0]];
    s->v[i] = w[s->axis[1]];
    s->speed[i] = sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
    s->p[i] = probe_value(&at, p, 1, 0, NULL);
}

struct slice slice_of(const struct mesh *m, const double *u, const double *p,
                      const double up[3], int points)
{
    const int k = least_to_see(m), high = vector_axis(up);
    struct slice s = {.axis = {k == 0 ? 2 : 0, k == 1 ? 2 : 1}};
    if (high != k) s.axis[0] = 3 - k - (s.axis[1] = high);
    double x[3], area = 1.0;

    for (int a = 0; a < 2; a++)
        area *= m->hi[s.axis[a]] - m->lo[s.axis[a]];
    for (int a = 0; a < 2; a++) {
        const double length = m->hi[s.axis[a]] - m->lo[s.axis[a]];
        s.n[a] = number_clamped(ceil(sqrt(points / area) * length), 2, 2000);
        s.step[a] = length / s.n[a];
        s.lo[a] = m->lo[s.axis[a]] + 0.5 * s.step[a];
    }
    const int n = s.n[0] * s.n[1];
    s.u = alloc_doubles(n);
    s.v = alloc_doubles(n);
    s.speed = alloc_doubles(n);
    s.p = alloc_doubles(n);
    s.inside = alloc_zeroed((size_t)n, 1);
    x[k] = 0.5 * (m->lo[k] + m->hi[k]);
    for (int i = 0; i < n; i++) {
        x[s.axis[0]] = s.lo[0] + i % s.n[0] * s.step[0];
        x[s.axis[1]] = s.lo[1] + i / s.n[0] * s.step[1];
        slice_sample(&s, m, i, x, u, p);
    }
    return s;
}

void slice_release(struct slice *s)
{
    free(s->u);
    free(s->v);
    free(s->speed);
    free(s->p);
    free(s->inside);
}

int slice_velocity(const struct slice *s, const double x[2], double w[2])
{
    int at[2];
    double t[2];

    w[0] = w[1] = 0.0;
    for (int a = 0; a < 2; a++) {
        const double steps = (x[a] - s->lo[a]) / s->step[a];
        at[a] = number_clamped(floor(steps), 0, s->n[a] - 2);
        t[a] = fmin(fmax(steps - at[a], 0.0), 1.0);
        if (steps < -0.5 || steps > s->n[a] - 0.5) return 0;
    }
    for (int corner = 0; corner < 4; corner++) {
        const int i = at[0] + (corner & 1) + s->n[0] * (at[1] + (corner >> 1));
        const double share =
            (corner & 1 ? t[0] : 1.0 - t[0]) * (corner & 2 ? t[1] : 1.0 - t[1]);
        if (!s->inside[i]) return 0;
        w[0] += share * s->u[i];
        w[1] += share * s->v[i];
    }
    return 1;
}

/* --- streamlines ---------------------------------------------------------- */

/* Squares as wide as lines are apart, with the number of the line that has come
 * through each; 0: none. */
struct squares {
    int n[2];
    double width;
    int *line;
};

static int square_of(const struct squares *q, const struct slice *s,
                     const double x[2])
{
    int at[2];

    for (int a = 0; a < 2; a++)
        at[a] =
            number_clamped((x[a] - s->lo[a]) / q->width + 0.5, 0, q->n[a] - 1);
    return at[0] + q->n[0] * at[1];
}

/* A step of one point's width along the velocity, by the midpoint; 0 where it
 * ends. */
static int step_along(const struct slice *s, double sign, double still,
                      double x[2])
{
    const double h = 0.7 * fmin(s->step[0], s->step[1]);
    double w[2], middle[2];

    if (!slice_velocity(s, x, w)) return 0;
    double size = hypot(w[0], w[1]);
    if (size <= still) return 0;
    for (int a = 0; a < 2; a++)
        middle[a] = x[a] + 0.5 * sign * h * w[a] / size;
    if (!slice_velocity(s, middle, w)) return 0;
    size = hypot(w[0], w[1]);
    if (size <= still) return 0;
    for (int a = 0; a < 2; a++)
        x[a] += sign * h * w[a] / size;
    return 1;
}

enum { MOST_STEPS = 4000 };

/* 1 if the last of n points is near the first, after some way. */
static int is_closed(const struct slice *s, int n, double (*x)[2])
{
    return n > 12 && hypot(x[n - 1][0] - x[0][0], x[n - 1][1] - x[0][1]) <
                         0.7 * fmin(s->step[0], s->step[1]);
}

/* Goes from x in one direction until the line leaves the plane, closes, or
 * enters a square that another line has; returns how many points it has. */
static int trace(const struct slice *s, struct squares *q, int line,
                 double sign, double still, const double from[2],
                 double (*x)[2])
{
    int n = 0;

    memcpy(x[n++], from, sizeof x[0]);
    while (n < MOST_STEPS) {
        memcpy(x[n], x[n - 1], sizeof x[0]);
        if (!step_along(s, sign, still, x[n])) break;
        int *const owner = &q->line[square_of(q, s, x[n])];
        if (*owner != 0 && *owner != line) break;
        *owner = line;
        if (is_closed(s, ++n, x)) break;
    }
    return n;
}

void slice_streamlines(const struct slice *s, double apart,
                       void (*put)(void *of, const double *x), void *of)
{
    struct squares q = {.width = apart};
    double fastest = 0.0;
    double(*const x)[2] = alloc_zeroed(2 * (MOST_STEPS + 1), sizeof *x);

    for (int a = 0; a < 2; a++)
        q.n[a] = number_clamped(ceil(s->n[a] * s->step[a] / apart), 1, 1000);
    q.line = alloc_ints(q.n[0] * q.n[1]);
    for (int i = 0; i < s->n[0] * s->n[1]; i++)
        fastest = fmax(fastest, s->speed[i]);
    for (int i = 0, line = 1; i < q.n[0] * q.n[1]; i++, line++) {
        const double from[2] = {s->lo[0] + (i % q.n[0] + 0.5) * apart,
                                s->lo[1] + (i / q.n[0] + 0.5) * apart};
        double w[2];
        if (q.line[i] != 0 || !slice_velocity(s, from, w)) continue;
        const double still = 1e-3 * fastest;
        const int back = trace(s, &q, line, -1.0, still, from, x);
        const int on = trace(s, &q, line, 1.0, still, from, x + MOST_STEPS + 1);
        if (back + on < 12) continue;
        for (int k = back - 1; k > 0; k--)
            put(of, x[k]);
        for (int k = 0; k < on; k++)
            put(of, x[MOST_STEPS + 1 + k]);
        put(of, NULL);
    }
    free(q.line);
    free(x);
}

/* --- the picture ---------------------------------------------------------- */

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
    FILE *const out = file_stream(f);
    picture_put_box(out, p, s->axis, fast > 0.0 ? fast : 1.0);
    picture_put_number(out, "low", low, "Pa");
    picture_put_number(out, "high", high, "Pa");
    fputc('\n', out);
    picture_put_program(out, picture_flow);
    return file_commit(f);
}

int picture_flow_write(struct folder *folder, const struct picture *p)
{
    struct slice s = slice_of(p->mesh, p->u, p->p, p->up, POINTS);
    const int failed = put_points(folder, &s) ||
                       picture_flow_put_lines(folder, &s) ||
                       picture_flow_put_script(folder, p, &s);

    slice_release(&s);
    return failed;
}
