/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mesh/poly/poly.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"

void poly_raw_release(struct poly_raw *r)
{
    free(r->part);
    free(r->point);
    free(r->start);
    free(r->corner);
    free(r->owner);
    free(r->neighbour);
    free(r->middle);
    free(r->area);
    free(r->V);
    free(r->centre);
    free(r->number);
}

/* --- the five files ------------------------------------------------------ */

static int read_points(struct poly_raw *r, const char *dir)
{
    struct poly_file p;

    poly_file_open(&p, r->files, dir, "points");
    r->n_points = poly_file_count(&p, (int)strlen("(0 0 0)"));
    r->point = alloc_doubles(3 * r->n_points);
    poly_file_begin(&p, r->n_points);
    for (int i = 0; i < r->n_points && !p.failed; i++) {
        if (!p.in_bytes) poly_file_expect(&p, "(");
        for (int k = 0; k < 3; k++)
            r->point[3 * i + k] = poly_file_real(&p);
        if (!p.in_bytes) poly_file_expect(&p, ")");
    }
    poly_file_end(&p, r->n_points);
    poly_file_close(&p);
    return p.failed;
}

/* Adds the n corners of face f to the list, where they are the next words or
 * bytes. */
static void add_corners(struct poly_raw *r, struct poly_file *p, int f, int n,
                        int *room)
{
    if (n < 3) poly_file_wrong(p, "a face of %d points, expected >= 3", n);
    if (n > INT_MAX / 2 - r->start[f])
        poly_file_wrong(p, "more corners of faces than %d", INT_MAX / 2);
    if (p->failed) return;
    r->start[f + 1] = r->start[f] + n;
    if (r->start[f + 1] > *room) {
        *room = 2 * r->start[f + 1];
        r->corner =
            alloc_grown(r->corner, r->start[f], *room, sizeof *r->corner);
    }
    for (int i = r->start[f]; i < r->start[f + 1] && !p->failed; i++) {
        r->corner[i] = poly_file_int(p);
        if (r->corner[i] >= r->n_points)
            poly_file_wrong(p, "point %d of %d", r->corner[i], r->n_points);
    }
}

/* n ( a b c ... ) for each face. */
static void read_each_face(struct poly_raw *r, struct poly_file *p, int *room)
{
    poly_file_expect(p, "(");
    for (int f = 0; f < r->n_faces && !p->failed; f++) {
        const int n = poly_file_count(p, (int)strlen("0 "));
        poly_file_begin(p, n);
        add_corners(r, p, f, n, room);
        poly_file_end(p, n);
    }
    poly_file_expect(p, ")");
}

/* A list of where each face begins, and one of all corners. */
static void read_compact_faces(struct poly_raw *r, struct poly_file *p,
                               int *room)
{
    int *const first = alloc_ints(r->n_faces + 1);

    poly_file_begin(p, r->n_faces + 1);
    for (int f = 0; f <= r->n_faces; f++)
        first[f] = poly_file_int(p);
    poly_file_end(p, r->n_faces + 1);
    const int n = poly_file_count(p, (int)strlen("0 "));
    if (first[0] != 0 || first[r->n_faces] != n)
        poly_file_wrong(p, "%d corners of faces, expected %d", n,
                        first[r->n_faces]);
    poly_file_begin(p, n);
    for (int f = 0; f < r->n_faces && !p->failed; f++)
        add_corners(r, p, f, first[f + 1] - first[f], room);
    poly_file_end(p, n);
    free(first);
}

static int read_faces(struct poly_raw *r, const char *dir)
{
    struct poly_file p;
    int room;

    poly_file_open(&p, r->files, dir, "faces");
    const int compact = p.is_binary && p.is_compact;
    r->n_faces =
        poly_file_count(&p, (int)strlen(compact ? "0 " : "3(0 1 2)")) - compact;
    if (r->n_faces < 0) poly_file_wrong(&p, "there are no faces");
    if (p.failed) r->n_faces = 0;
    room = 4 * r->n_faces;
    r->start = alloc_ints(r->n_faces + 1);
    r->corner = alloc_ints(room);
    if (compact)
        read_compact_faces(r, &p, &room);
    else
        read_each_face(r, &p, &room);
    poly_file_close(&p);
    return p.failed;
}

/* Reads owner or neighbour, one cell for each face. */
static int *read_cells(struct poly_raw *r, const char *dir, const char *name,
                       int *n, int *failed)
{
    struct poly_file p;

    poly_file_open(&p, r->files, dir, name);
    *n = poly_file_count(&p, 0);
    if (*n > r->n_faces)
        poly_file_wrong(&p, "%d entries, but there are %d faces", *n,
                        r->n_faces);
    if (p.failed) *n = 0;
    int *const cell = alloc_ints(*n);
    poly_file_begin(&p, *n);
    for (int f = 0; f < *n && !p.failed; f++) {
        cell[f] = poly_file_int(&p);
        if (cell[f] >= r->n_faces)
            poly_file_wrong(&p, "cell %d is more than there are faces",
                            cell[f]);
        if (cell[f] >= r->n_cells) r->n_cells = cell[f] + 1;
    }
    poly_file_end(&p, *n);
    *failed |= p.failed;
    poly_file_close(&p);
    return cell;
}

/* Passes over what is left of an entry, up to its ; or, of a dictionary, to the
 * brace that ends it. */
static void skip_entry(struct poly_file *p, char word[POLY_WORD])
{
    int depth = 0, was_dictionary = 0;

    for (; !p->failed; poly_file_word(p, word)) {
        depth += strcmp(word, "{") == 0;
        was_dictionary = strcmp(word, "}") == 0;
        depth -= was_dictionary;
        if (depth == 0 && (was_dictionary || strcmp(word, ";") == 0)) return;
    }
}

/* Reads one entry of a patch: key value; or key { ... }. */
static void read_entry(struct poly_file *p, struct poly_part *part,
                       const char *key)
{
    char word[POLY_WORD];

    if (strcmp(key, "nFaces") == 0)
        part->n = poly_file_int(p);
    else if (strcmp(key, "startFace") == 0)
        part->first = poly_file_int(p);
    poly_file_word(p, word);
    if (strcmp(key, "type") == 0)
        snprintf(part->type, sizeof part->type, "%.63s", word);
    if (strcmp(key, "neighbourPatch") == 0)
        snprintf(part->other, sizeof part->other, "%.63s", word);
    skip_entry(p, word);
}

static void read_part(struct poly_raw *r, struct poly_file *p,
                      struct poly_part *part)
{
    static const char *const known[] = {
        "patch", "wall", "empty", "symmetry", "symmetryPlane", "cyclic", NULL};
    char word[POLY_WORD];
    int i = 0;

    poly_file_word(p, word);
    part->line = p->line;
    snprintf(part->name, sizeof part->name, "%.63s", word);
    if (strcmp(word, part->name) != 0)
        poly_file_wrong(p, "patch %s: the name is longer than 63 letters",
                        word);
    for (const struct poly_part *q = r->part; q < part; q++)
        if (strcmp(q->name, part->name) == 0)
            poly_file_wrong(p, "patch %s: the name is there twice", word);
    poly_file_expect(p, "{");
    for (poly_file_word(p, word); !p->failed && strcmp(word, "}") != 0;
         poly_file_word(p, word))
        read_entry(p, part, word);
    while (known[i] != NULL && strcmp(known[i], part->type) != 0)
        i++;
    if (known[i] == NULL && part->n > 0)
        poly_file_wrong(p,
                        "patch %s: type %s is not read; expected patch, wall, "
                        "empty, symmetry, symmetryPlane or cyclic",
                        part->name, part->type);
    if (r->n_faces > 0 &&
        (part->first < r->n_inner || part->first > r->n_faces - part->n))
        poly_file_wrong(p, "patch %s: faces %d to %d are not of the boundary",
                        part->name, part->first, part->first + part->n - 1);
}

int poly_raw_read_parts(struct poly_raw *r, const char *dir)
{
    struct poly_file p;

    poly_file_open(&p, r->files, dir, "boundary");
    r->n_parts = poly_file_count(&p, 4);
    if (r->n_parts > POLY_RAW_PATCHES)
        poly_file_wrong(&p, "at most %d patches", POLY_RAW_PATCHES);
    if (p.failed) r->n_parts = 0;
    r->part = alloc_zeroed((size_t)r->n_parts + 1, sizeof *r->part);
    poly_file_expect(&p, "(");
    for (int i = 0; i < r->n_parts && !p.failed; i++)
        read_part(r, &p, &r->part[i]);
    poly_file_expect(&p, ")");
    poly_file_close(&p);
    return p.failed;
}

int poly_raw_read(struct poly_raw *r, const char *dir)
{
    int n_owner = 0, failed = 0;

    if (read_points(r, dir) || read_faces(r, dir)) return 1;
    r->owner = read_cells(r, dir, "owner", &n_owner, &failed);
    if (failed) return 1;
    r->neighbour = read_cells(r, dir, "neighbour", &r->n_inner, &failed);
    if (failed || poly_raw_read_parts(r, dir)) return 1;
    if (n_owner == r->n_faces) return 0;
    fprintf(stderr, "winnow: %s/owner: %d entries, but there are %d faces\n",
            dir, n_owner, r->n_faces);
    return 1;
}

/* --- geometry ------------------------------------------------------------ */

/* A face is divided into triangles about the mean of its corners. The sum of
 * their areas is its area, and the mean of their middles, weighted by area, is
 * its middle. */
static void measure_face(struct poly_raw *r, int f)
{
    const int n = r->start[f + 1] - r->start[f];
    const int *const corner = &r->corner[r->start[f]];
    double mean[3] = {0.0, 0.0, 0.0}, sum = 0.0;
    double *const S = &r->area[3 * f], *const x = &r->middle[3 * f];

    for (int i = 0; i < n; i++)
        for (int k = 0; k < 3; k++)
            mean[k] += r->point[3 * corner[i] + k] / n;
    for (int i = 0; i < n; i++) {
        const double *const a = &r->point[3 * corner[i]];
        const double *const b = &r->point[3 * corner[(i + 1) % n]];
        const double u[3] = {a[0] - mean[0], a[1] - mean[1], a[2] - mean[2]};
        const double v[3] = {b[0] - mean[0], b[1] - mean[1], b[2] - mean[2]};
        double c[3];
        vector_cross(u, v, c);
        const double size = vector_length(c);
        sum += size;
        for (int k = 0; k < 3; k++) {
            S[k] += 0.5 * c[k];
            x[k] += size * (a[k] + b[k] + mean[k]) / 3.0;
        }
    }
    for (int k = 0; k < 3; k++)
        x[k] = sum > 0.0 ? x[k] / sum : mean[k];
}

/* A cell is divided into pyramids about the mean of the middles of its faces,
 * which give its volume and centre. */
static void poly_raw_measure_cells(struct poly_raw *r)
{
    double *const mean = alloc_doubles(3 * r->n_cells);
    int *const count = alloc_ints(r->n_cells);

    for (int f = 0; f < r->n_faces; f++)
        for (int side = 0; side < 1 + (f < r->n_inner); side++) {
            const int c = side == 0 ? r->owner[f] : r->neighbour[f];
            count[c]++;
            for (int k = 0; k < 3; k++)
                mean[3 * c + k] += r->middle[3 * f + k];
        }
    for (int i = 0; i < 3 * r->n_cells; i++)
        mean[i] /= count[i / 3];
    for (int f = 0; f < r->n_faces; f++)
        for (int side = 0; side < 1 + (f < r->n_inner); side++) {
            const int c = side == 0 ? r->owner[f] : r->neighbour[f];
            const double *const x = &r->middle[3 * f], *const o = &mean[3 * c];
            const double h[3] = {x[0] - o[0], x[1] - o[1], x[2] - o[2]};
            const double V =
                (side == 0 ? 1.0 : -1.0) * vector_dot(&r->area[3 * f], h) / 3.0;
            r->V[c] += V;
            for (int k = 0; k < 3; k++)
                r->centre[3 * c + k] += V * (0.75 * x[k] + 0.25 * o[k]);
        }
    for (int i = 0; i < 3 * r->n_cells; i++)
        r->centre[i] /= r->V[i / 3];
    free(mean);
    free(count);
}

/* The cell with the largest closure error: |sum of S| over its surface. */
static int least_closed(const struct poly_raw *r, double *worst)
{
    double *const sum = alloc_doubles(4 * r->n_cells);
    int which = 0;

    for (int f = 0; f < r->n_faces; f++)
        for (int side = 0; side < 1 + (f < r->n_inner); side++) {
            const int c = side == 0 ? r->owner[f] : r->neighbour[f];
            const double *const S = &r->area[3 * f];
            for (int k = 0; k < 3; k++)
                sum[4 * c + k] += side == 0 ? S[k] : -S[k];
            sum[4 * c + 3] += vector_length(S);
        }
    *worst = 0.0;
    for (int c = 0; c < r->n_cells; c++) {
        const double open = vector_length(&sum[4 * c]);
        if (open <= *worst * sum[4 * c + 3]) continue;
        *worst = open / sum[4 * c + 3];
        which = c;
    }
    free(sum);
    return which;
}

static int wrong_face(const struct poly_raw *r, const char *dir)
{
    for (int f = 0; f < r->n_faces; f++) {
        const double *const S = &r->area[3 * f];
        if (f < r->n_inner && r->owner[f] == r->neighbour[f]) {
            fprintf(stderr,
                    "winnow: %s/neighbour: face %d has the cell %d on both "
                    "sides\n",
                    dir, f, r->owner[f]);
            return 1;
        }
        if (vector_dot(S, S) > 0.0) continue;
        fprintf(stderr, "winnow: %s/faces: face %d has no area\n", dir, f);
        return 1;
    }
    return 0;
}

static int wrong_cell(const struct poly_raw *r, const char *dir)
{
    double open;
    const int c = least_closed(r, &open);

    if (open > 1e-6) {
        fprintf(stderr,
                "winnow: %s/owner: cell %d is not closed: its faces miss %.2g "
                "of its surface; one is missing, has another cell, or its "
                "points in the wrong order\n",
                dir, c, open);
        return 1;
    }
    for (int b = 0; b < r->n_cells; b++)
        if (!(r->V[b] > 0.0)) {
            fprintf(stderr,
                    "winnow: %s: cell %d has the volume %g m^3, expected > 0; "
                    "its faces do not close it or point inward\n",
                    dir, b, r->V[b]);
            return 1;
        }
    return 0;
}

/* The link from centre to centre points in the direction of S, not against
 * it. */
static int wrong_link(const struct poly_raw *r, const char *dir)
{
    for (int f = 0; f < r->n_inner; f++) {
        const double *const a = &r->centre[3 * r->owner[f]];
        const double *const b = &r->centre[3 * r->neighbour[f]];
        const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
        if (vector_dot(d, &r->area[3 * f]) > 0.0) continue;
        fprintf(stderr,
                "winnow: %s/faces: face %d: the centres of the cells %d and "
                "%d beside it do not lie on its two sides; such a mesh is too "
                "crooked to compute on\n",
                dir, f, r->owner[f], r->neighbour[f]);
        return 1;
    }
    return 0;
}

int poly_raw_measure(struct poly_raw *r, const char *dir)
{
    r->middle = alloc_doubles(3 * r->n_faces);
    r->area = alloc_doubles(3 * r->n_faces);
    r->V = alloc_doubles(r->n_cells);
    r->centre = alloc_doubles(3 * r->n_cells);
    for (int f = 0; f < r->n_faces; f++)
        measure_face(r, f);
    poly_raw_measure_cells(r);
    return wrong_face(r, dir) || wrong_cell(r, dir) || wrong_link(r, dir);
}

/* The largest distance of a corner from the plane of its face [m]. */
double poly_raw_warp(const struct poly_raw *r)
{
    double most = 0.0;

    for (int f = 0; f < r->n_faces; f++) {
        const double *const S = &r->area[3 * f], *const x = &r->middle[3 * f];
        const double size = vector_length(S);
        for (int i = r->start[f]; i < r->start[f + 1]; i++) {
            const double *const p = &r->point[3 * r->corner[i]];
            const double d[3] = {p[0] - x[0], p[1] - x[1], p[2] - x[2]};
            most = fmax(most, fabs(vector_dot(d, S)) / size);
        }
    }
    return most;
}
