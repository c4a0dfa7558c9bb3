/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/pictures/picture.h"

#include "base/alloc.h"
#include "base/file.h"
#include "base/number.h"
#include "base/text.h"
#include "output/pictures/gnuplot.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A particle to be drawn. */
struct disc {
    double x, y, z; /* [m] centre */
    double r;       /* [m] */
    double speed;   /* [m/s] */
};

/* Largest number of points; more would not be visible. */
static const int most_squares[3] = {200, 400, 50}; /* [-] */

static int by_speed(const void *a, const void *b)
{
    const struct disc *const p = a, *const q = b;
    return (p->speed > q->speed) - (p->speed < q->speed);
}

static int by_depth(const void *a, const void *b)
{
    const struct disc *const p = a, *const q = b;
    const int order = (p->z > q->z) - (p->z < q->z);

    return order != 0 ? order : by_speed(a, b);
}

void picture_put_row(FILE *out, int n, const double *row)
{
    char text[NUMBER_LENGTH];

    for (int i = 0; i < n; i++)
        fprintf(out, "%s%c", number_rounded(row[i], 6, text),
                i < n - 1 ? ' ' : '\n');
}

static struct disc *discs_of(const struct picture *p)
{
    struct disc *const discs = alloc_zeroed((size_t)p->n, sizeof discs[0]);

    for (int i = 0; i < p->n; i++)
        discs[i] = (struct disc){.x = p->x[0][i],
                                 .y = p->x[1][i],
                                 .z = p->x[2][i],
                                 .r = 0.5 * p->d[i],
                                 .speed = sqrt(p->v[0][i] * p->v[0][i] +
                                               p->v[1][i] * p->v[1][i] +
                                               p->v[2][i] * p->v[2][i])};
    return discs;
}

struct file *picture_open(struct folder *folder, const char *name)
{
    char *const path = folder_file(folder, name);
    struct file *const f = path == NULL ? NULL : file_create(path);

    free(path);
    return f;
}

/* The nearer particles cover the farther ones. */
int picture_write_particles(struct folder *folder, const char *name,
                            const struct picture *p)
{
    struct file *const f = picture_open(folder, name);
    if (f == NULL) return 1;
    struct disc *const discs = discs_of(p);

    qsort(discs, (size_t)p->n, sizeof discs[0], by_depth);
    fprintf(file_stream(f), "# x [m]  y [m]  radius [m]  speed [m/s]\n");
    for (int i = 0; i < p->n; i++) {
        const struct disc *const s = &discs[i];
        picture_put_row(file_stream(f), 4,
                        (double[4]){s->x, s->y, s->r, s->speed});
    }
    free(discs);
    return file_commit(f);
}

/* The largest speed of all but 1 % of the particles: with the largest of all,
 * one fast particle would make the colours of the others equal. */
double picture_speed_scale(const struct picture *p)
{
    if (p->n == 0) return 0.0;
    struct disc *const discs = discs_of(p);
    qsort(discs, (size_t)p->n, sizeof discs[0], by_speed);
    const int i = number_clamped(0.99 * (p->n - 1), 0, p->n - 1);
    const double speed = discs[i].speed;
    free(discs);
    return speed;
}

/* Mean over the cells along the depth, weighted by their volumes. */
static double depth_average(const struct mesh *m, const double *eps, int i,
                            int j)
{
    const int *const n = m->box.n;
    double amount = 0.0, volume = 0.0;

    for (int k = 0; k < n[2]; k++) {
        const int c = i + n[0] * (j + n[1] * k);
        amount += m->V[c] * eps[c];
        volume += m->V[c];
    }
    return amount / volume;
}

static void put_columns(FILE *out, const struct picture *p)
{
    const struct box *const b = &p->mesh->box;
    const double *const x = b->edge[0], *const y = b->edge[1];

    for (int j = 0; p->eps && j < b->n[1]; j++)
        for (int i = 0; i < b->n[0]; i++) {
            const double eps = depth_average(p->mesh, p->eps, i, j);
            picture_put_row(out, 5,
                            (double[5]){x[i], x[i + 1], y[j], y[j + 1], eps});
        }
}

/* Mean of the cells at n points along the depth from x on; 0 if all points are
 * outside the mesh. */
static double picture_sampled(const struct picture *p, double x[3], double step,
                              int n)
{
    double sum = 0.0, offset[3];
    int met = 0;

    for (int k = 0; k < n; k++, x[2] += step) {
        const int c = mesh_cell_and_offset(p->mesh, x, offset);
        if (c < 0) continue;
        sum += p->eps[c];
        met++;
    }
    return met > 0 ? sum / met : 0.0;
}

/* A polyhedral mesh has no columns of cells; squares half as wide as a mean
 * cell are used instead. */
static void put_squares(FILE *out, const struct picture *p)
{
    const struct mesh *const m = p->mesh;
    double volume = 0.0, width[3];
    int n[3];

    for (int c = 0; c < m->n_cells; c++)
        volume += m->V[c];
    for (int k = 0; k < 3; k++) {
        const double L = m->hi[k] - m->lo[k];
        const double fit = ceil(2.0 * L / cbrt(volume / m->n_cells));
        n[k] = number_clamped(fit, 1, most_squares[k]);
        width[k] = L / n[k];
    }
    for (int j = 0; p->eps && j < n[1]; j++)
        for (int i = 0; i < n[0]; i++) {
            const double x = m->lo[0] + i * width[0];
            const double y = m->lo[1] + j * width[1];
            double point[3] = {x + 0.5 * width[0], y + 0.5 * width[1],
                               m->lo[2] + 0.5 * width[2]};
            const double eps = picture_sampled(p, point, width[2], n[2]);
            if (eps > 0.0)
                picture_put_row(
                    out, 5, (double[5]){x, x + width[0], y, y + width[1], eps});
        }
}

static int put_void_fraction(struct folder *folder, const struct picture *p)
{
    struct file *const f = picture_open(folder, "picture/void_fraction.txt");
    if (f == NULL) return 1;

    fprintf(file_stream(f), "# edges of a column of cells: left right bottom "
                            "top [m]  void fraction [-]\n");
    if (p->mesh->shape == NULL)
        put_columns(file_stream(f), p);
    else
        put_squares(file_stream(f), p);
    return file_commit(f);
}

void picture_put_number(FILE *out, const char *name, double value,
                        const char *unit)
{
    char text[NUMBER_LENGTH];

    fprintf(out, "%s = %s%s # [%s]\n", name, number_rounded(value, 9, text),
            value == floor(value) && fabs(value) < 1e9 ? ".0" : "", unit);
}

void picture_put_box(FILE *out, const struct picture *p, double fast)
{
    const double *const lo = p->mesh->lo, *const hi = p->mesh->hi;

    fprintf(out, "# The numbers of this run.\n");
    fputs("title = ", out);
    text_put(out, p->title, TEXT_GNUPLOT);
    fputc('\n', out);
    picture_put_number(out, "time", p->time, "s");
    picture_put_number(out, "x0", lo[0], "m");
    picture_put_number(out, "x1", hi[0], "m");
    picture_put_number(out, "y0", lo[1], "m");
    picture_put_number(out, "y1", hi[1], "m");
    picture_put_number(out, "fast", fast, "m/s, which 99 of 100 keep below");
}

void picture_put_program(FILE *out, const char *const *program)
{
    for (; *program != NULL; program++)
        fprintf(out, "%s\n", *program);
}

static int picture_put_script(struct folder *folder, const struct picture *p)
{
    struct file *const f = picture_open(folder, "picture/bed.gp");
    const double speed = picture_speed_scale(p);
    if (f == NULL) return 1;

    FILE *const out = file_stream(f);
    picture_put_box(out, p, speed > 0.0 ? speed : 1.0);
    fprintf(out, "particles = %d\nwith_void = %d\nwith_pressure = %d\n", p->n,
            p->eps != NULL, p->pressure);
    fprintf(out, "with_walls = %d\n\n", p->walls);
    picture_put_program(out, picture_bed);
    return file_commit(f);
}

int picture_write(struct folder *folder, const struct picture *p)
{
    if (folder_make(folder, "picture") != 0) return 1;
    if (p->u != NULL && p->x[0] == NULL) return picture_flow_write(folder, p);
    return picture_write_particles(folder, "picture/particles.txt", p) ||
           put_void_fraction(folder, p) || picture_put_script(folder, p);
}

int picture_draw(struct folder *folder, const char *below, const char *png,
                 int *drawn)
{
    char above[64], log[64];

    snprintf(above, sizeof above, "../%s", png);
    snprintf(log, sizeof log, "%s/gnuplot.log", below);
    char *const listed = folder_file(folder, png);
    char *const also = listed != NULL ? folder_file(folder, log) : NULL;
    const int failed = also == NULL;
    char *const path = file_join(folder_name(folder), below);
    if (!failed)
        *drawn = gnuplot_draw(&(struct gnuplot){.folder = path,
                                                .script = "bed.gp",
                                                .above = "..",
                                                .png = above,
                                                .log = "gnuplot.log"}) == 0;
    free(listed);
    free(also);
    free(path);
    return failed;
}
