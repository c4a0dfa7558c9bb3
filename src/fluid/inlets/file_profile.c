/* SPDX-License-Identifier: GPL-3.0-or-later */
/* file_profile.c -- the profile of an inlet by a file of points.
 *
 * Rows of u at points that are told by one, two or three of x, y, z, and
 * perhaps at times t. Along one coordinate u is linear between the rows; in two
 * or three it is the mean of the four nearest points, weighted by the inverse
 * square of their distance [Shepard68]. In time it is linear between the
 * levels. Before and after, and beyond the rows, it is constant.
 */
#include "fluid/inlet_profile.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/csv.h"

/* A row with two or three places. */
struct point {
    double key; /* [m] its place along the axis on which the rows are sorted */
    double x[3], u;
    int row; /* [-] of the file */
};

/* The rows of one level of a file. */
struct rows {
    const struct csv *file;
    int first, n;
    int u, place[3], places[3], n_places; /* [-] columns, and their axes */
    int axis;             /* [-] of `places`, along which they are sorted */
    struct point *sorted; /* unless they are on a line */
};

static double number_at(const struct rows *r, int row, int column)
{
    return r->file->value[(long)(r->first + row) * r->file->n_columns + column];
}

static double on_line(const struct rows *r, double s)
{
    const int x = r->place[0];
    int i = 0, end = r->n - 1;

    if (s <= number_at(r, 0, x)) return number_at(r, 0, r->u);
    if (s > number_at(r, end, x)) return number_at(r, end, r->u);
    while (end - i > 1) {
        const int middle = i + (end - i) / 2;
        *(s > number_at(r, middle, x) ? &i : &end) = middle;
    }
    const double below = number_at(r, i, x), above = number_at(r, end, x);
    return number_at(r, i, r->u) +
           (number_at(r, end, r->u) - number_at(r, i, r->u)) * (s - below) /
               (above - below);
}

static int by_key(const void *a, const void *b)
{
    const struct point *const p = a, *const q = b;

    if (p->key != q->key) return p->key < q->key ? -1 : 1;
    return p->row - q->row;
}

/* Sorts the points of a level along the axis on which they are widest. */
static void file_profile_sort(struct rows *r)
{
    double most = -1.0;

    for (int k = 0; k < r->n_places; k++) {
        double lo = HUGE_VAL, hi = -HUGE_VAL;
        for (int i = 0; i < r->n; i++) {
            lo = fmin(lo, number_at(r, i, r->place[k]));
            hi = fmax(hi, number_at(r, i, r->place[k]));
        }
        if (hi - lo > most) r->axis = k;
        most = fmax(most, hi - lo);
    }
    for (int i = 0; i < r->n; i++) {
        struct point *const p = &r->sorted[i];
        *p = (struct point){.u = number_at(r, i, r->u), .row = i};
        for (int k = 0; k < r->n_places; k++)
            p->x[k] = number_at(r, i, r->place[k]);
        p->key = p->x[r->axis];
    }
    qsort(r->sorted, (size_t)r->n, sizeof *r->sorted, by_key);
}

/* The four points that are nearest to a place, the nearest first; of two that
 * are equally far the one that comes first in the file. */
struct nearest_points {
    const struct point *point[4];
    double square[4]; /* [m^2] */
};

static void file_profile_offer(struct nearest_points *near,
                               const struct rows *r, const struct point *p,
                               const double x[3])
{
    double square = 0.0;
    int at = 4;

    for (int k = 0; k < r->n_places; k++) {
        const double d = p->x[k] - x[r->places[k]];
        square += d * d;
    }
    while (at > 0 && (square < near->square[at - 1] ||
                      (square == near->square[at - 1] &&
                       p->row < near->point[at - 1]->row)))
        at--;
    for (int i = 3; i > at; i--) {
        near->point[i] = near->point[i - 1];
        near->square[i] = near->square[i - 1];
    }
    if (at == 4) return;
    near->point[at] = p;
    near->square[at] = square;
}

/* From the place on to both sides, until all further points are farther along
 * the axis alone than the four. */
static double among_points(const struct rows *r, const double x[3])
{
    struct nearest_points near = {
        .square = {HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL}};
    const double key = x[r->places[r->axis]];
    double sum = 0.0, weights = 0.0;
    int right = 0, end = r->n;

    while (right < end) {
        const int middle = right + (end - right) / 2;
        if (r->sorted[middle].key < key)
            right = middle + 1;
        else
            end = middle;
    }
    for (int left = right - 1; left >= 0 || right < r->n;) {
        const double before = left < 0 ? HUGE_VAL : key - r->sorted[left].key;
        const double behind =
            right == r->n ? HUGE_VAL : r->sorted[right].key - key;
        const double least = fmin(before, behind);
        if (least * least > near.square[3]) break;
        file_profile_offer(&near, r,
                           &r->sorted[before < behind ? left-- : right++], x);
    }
    if (near.square[0] == 0.0) return near.point[0]->u;
    for (int i = 0; i < 4 && near.square[i] < HUGE_VAL; i++) {
        sum += near.point[i]->u / near.square[i];
        weights += 1.0 / near.square[i];
    }
    return sum / weights;
}

static double file_profile_value_at(const void *of, const double x[3])
{
    const struct rows *const r = of;
    return r->n_places == 1 ? on_line(r, x[r->places[0]]) : among_points(r, x);
}

/* The levels of a file: times, and the means over the faces at each. */
struct levels {
    int n, n_faces;
    double *value; /* [-] n_faces of each level */
    double time[]; /* [s] */
};

static double file_profile_varying(const struct boundary *b, int j, double t)
{
    const struct levels *const l = b->memory;
    int i = 0;

    if (t <= l->time[0]) return l->value[j];
    while (i < l->n - 1 && t > l->time[i + 1])
        i++;
    const double *const u = &l->value[(long)i * l->n_faces + j];
    if (i == l->n - 1) return u[0];
    return u[0] + (u[l->n_faces] - u[0]) * (t - l->time[i]) /
                      (l->time[i + 1] - l->time[i]);
}

/* Finds the columns of a file; non-zero after a message if one is missing. */
static int file_profile_find_columns(struct rows *r, int t,
                                     char wrong[BOUNDARY_TEXT])
{
    static const char *const axes[3] = {"x", "y", "z"};
    char names[100], why[CSV_WRONG];
    int foreign = 0;

    r->u = csv_column(r->file, "u");
    for (int k = 0; k < 3; k++) {
        r->place[r->n_places] = csv_column(r->file, axes[k]);
        r->places[r->n_places] = k;
        r->n_places += r->place[r->n_places] >= 0;
    }
    if (r->u >= 0) foreign = csv_check_unit(r->file, r->u, "-", why);
    for (int k = 0; k < r->n_places && !foreign; k++)
        foreign = csv_check_unit(r->file, r->place[k], "m", why);
    if (!foreign && t >= 0) foreign = csv_check_unit(r->file, t, "s", why);
    if (foreign) snprintf(wrong, BOUNDARY_TEXT, "%.200s", why);
    if (foreign) return 1;
    if (r->u >= 0 && r->n_places > 0) return 0;
    csv_names(r->file, names, sizeof names);
    snprintf(wrong, BOUNDARY_TEXT,
             "expected columns u, some of x, y, z, and perhaps t; its columns "
             "are: %s",
             names);
    return 1;
}

/* Checks that the rows of one time follow each other, and that their points
 * ascend if they are on a line. Returns the number of levels, or 0 after a
 * message. */
static int count_levels(const struct rows *r, int t, char wrong[BOUNDARY_TEXT])
{
    int n = 1;

    for (int i = 1; i < r->file->n_rows; i++) {
        const double step =
            t < 0 ? 0.0 : number_at(r, i, t) - number_at(r, i - 1, t);
        const int falls = step < 0.0;
        const int x = r->place[0];
        if (falls || (step == 0.0 && r->n_places == 1 &&
                      number_at(r, i, x) <= number_at(r, i - 1, x))) {
            snprintf(wrong, BOUNDARY_TEXT,
                     "row %d: %s does not rise; sort the rows%s", i + 1,
                     falls ? "t" : r->file->name[x],
                     falls || t < 0 ? "" : " of each time");
            return 0;
        }
        n += step > 0.0;
    }
    return n;
}

/* Fills the levels from their rows. */
static void file_profile_fill(struct levels *l, struct rows *r, int t,
                              const struct boundary_request *q)
{
    const int rows = r->file->n_rows;

    r->sorted = alloc_zeroed((size_t)rows, sizeof *r->sorted);
    for (int i = 0; i < l->n; i++) {
        r->n = 1;
        while (t >= 0 && r->first + r->n < rows &&
               number_at(r, r->n, t) == number_at(r, 0, t))
            r->n++;
        if (t < 0) r->n = rows;
        l->time[i] = t >= 0 ? number_at(r, 0, t) : 0.0;
        if (r->n_places > 1) file_profile_sort(r);
        for (int j = 0; j < l->n_faces; j++)
            l->value[(long)i * l->n_faces + j] = inlet_profile_face_mean(
                q->mesh, q->patch->first + j, file_profile_value_at, r);
        r->first += r->n;
    }
    free(r->sorted);
}

static int file_profile_create(const struct boundary_request *q,
                               struct boundary *b, char wrong[BOUNDARY_TEXT])
{
    struct csv file;
    struct rows r = {.file = &file};
    char why[CSV_WRONG];

    if (csv_read(&file, q->file, why) != 0) {
        snprintf(wrong, BOUNDARY_TEXT, "%.100s: %.150s", q->file->path, why);
        return 1;
    }
    const int t = csv_column(&file, "t");
    const int n = file_profile_find_columns(&r, t, wrong) == 0
                      ? count_levels(&r, t, wrong)
                      : 0;
    if (n > 0) {
        struct levels *const l =
            alloc_zeroed(1, sizeof *l + (size_t)n * (1 + (size_t)q->patch->n) *
                                            sizeof(double));
        l->n = n;
        l->n_faces = q->patch->n;
        l->value = l->time + n;
        file_profile_fill(l, &r, t, q);
        b->memory = l;
        b->profile = n == 1 ? l->value : NULL;
        b->varying = n == 1 ? NULL : file_profile_varying;
    }
    csv_release(&file);
    return n == 0;
}

static const struct key keys[] = {
    {"fluid.<patch>.file", KEY_FILE, "", "", KEY_OPTIONAL,
     "of the profile `file`: a table with columns u, some of x, y, z [m], and "
     "perhaps t [s]; beside the case unless it begins with /",
     "", "", KEY_AT(boundary_options, file),
     KEY_GIVEN(boundary_options, has_file)},
    KEY_END};

const struct inlet_profile file_profile = {
    .name = "file",
    .what = "velocities at points, and perhaps times, from a file",
    .equations = "",
    .function = "file_profile_value_at",
    .keys = {keys},
    .asks = "file",
    .create = file_profile_create,
};
