/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/population/bed_file.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "base/alloc.h"
#include "base/file.h"
#include "base/tables/input.h"
#include "base/number.h"
#include "dem/population/sizes.h"

enum { LINE = 256, FACTS = 24, COLUMNS = 11, LAST_LINE = 15 };

/* `other` of a spring against a surface (surface_history.c); against the walls
 * of the box it is -1 to -6. */
enum { SURFACE_SPRING = -7 };

/* "name a b c" with numbers that read back exactly. */
static void fact(char line[LINE], const char *name, int n, const double *value)
{
    char number[NUMBER_LENGTH];
    int at = snprintf(line, LINE, "%s", name);

    for (int k = 0; k < n; k++)
        at += snprintf(line + at, (size_t)(LINE - at), " %s",
                       number_text(value[k], number));
    snprintf(line + at, (size_t)(LINE - at), "\n");
}

/* Of several sizes, what tells one distribution from another. */
static void size_fact(char line[LINE], const struct bed_options *bed)
{
    const struct sizes *const s = bed->sizes;

    if (s == NULL)
        fact(line, "diameter", 1, &bed->diameter);
    else
        fact(line, "sizes", 5,
             (const double[5]){sizes_min(s), sizes_max(s), sizes_moment(s, 1),
                               sizes_moment(s, 2), sizes_moment(s, 3)});
}

/* Beds in files are of material 0; this is its pair with the wall. */
static void wall_fact(char line[LINE], const struct dem_options *o)
{
    const struct material_pair p =
        materials_pair(&o->material, o->materials, 0, o->materials->wall);
    double known[7 + MODEL_NUMBERS] = {
        p.of[1]->young, p.of[1]->poisson, p.stiffness, p.tangential,
        p.restitution,  p.friction,       p.rolling};

    memcpy(&known[7], p.of[1]->own, sizeof p.of[1]->own);
    fact(line, "wall", o->law->own_keys != NULL ? 7 + MODEL_NUMBERS : 7, known);
}

static void attraction_fact(char line[LINE], const struct attraction *a)
{
    const double known[] = {a->range, a->strength, a->closest,
                            a->harmonic ? 1.0 : 0.0,
                            a->charge != NULL ? a->charge[0] : 0.0};

    fact(line, a->law->name, 5, known);
}

/* What the bed was made with, a line a fact; returns how many. */
static int facts(char text[FACTS][LINE], const struct bed_options *bed,
                 const struct dem_options *o)
{
    const struct material *const m = &o->material;
    int n = 0;

    snprintf(text[n++], LINE, "winnow bed 2, contact %s\n", o->law->name);
    snprintf(text[n++], LINE, "count %d\n", bed->count);
    snprintf(text[n++], LINE, "seed %d\n", bed->seed);
    snprintf(text[n++], LINE, "periodic %d %d %d\n", o->periodic[0],
             o->periodic[1], o->periodic[2]);
    size_fact(text[n++], bed);
    fact(text[n++], "density", 1, &bed->density);
    fact(text[n++], "jitter", 1, &bed->jitter);
    fact(text[n++], "settle", 1, &bed->settle);
    fact(text[n++], "gravity", 3, bed->gravity);
    fact(text[n++], "box from", 3, o->lo);
    fact(text[n++], "box to", 3, o->hi);
    fact(text[n++], "young", 1, &m->young);
    fact(text[n++], "poisson", 1, &m->poisson);
    fact(text[n++], "stiffness", 1, &m->stiffness);
    fact(text[n++], "tangential", 1, &m->tangential);
    fact(text[n++], "restitution", 1, &m->restitution);
    fact(text[n++], "friction", 1, &m->friction);
    if (m->rolling > 0.0) fact(text[n++], "rolling", 1, &m->rolling);
    if (o->law->own_keys != NULL) fact(text[n++], "own", MODEL_NUMBERS, m->own);
    if (o->materials != NULL) wall_fact(text[n++], o);
    if (o->n_surfaces > 0)
        snprintf(text[n++], LINE, "surfaces %d crc32 %08lx\n", o->n_surfaces,
                 o->surfaces_checksum);
    for (int k = 0; k < o->n_attractions && n < FACTS; k++)
        attraction_fact(text[n++], &o->attractions[k]);
    return n;
}

/* Where the COLUMNS numbers of a particle are. */
static void columns(const struct particles *ps, double *column[COLUMNS])
{
    double *const all[COLUMNS] = {ps->x,  ps->y,  ps->z,  ps->vx,
                                  ps->vy, ps->vz, ps->wx, ps->wy,
                                  ps->wz, ps->d,  ps->m};
    memcpy(column, all, sizeof all);
}

static void write_bed(FILE *f, const struct particles *ps,
                      const struct bed_histories *histories, int with_roll)
{
    double *column[COLUMNS];

    columns(ps, column);
    fprintf(f, "particles %d\n", ps->n);
    for (int i = 0; i < ps->n; i++) {
        fprintf(f, "%d", ps->id[i]);
        for (int k = 0; k < COLUMNS; k++)
            fprintf(f, " %a", column[k][i]);
        fprintf(f, "\n");
    }
    fprintf(f, "springs %d\n", histories->n);
    for (int q = 0; q < histories->n; q++) {
        const struct dem_history *const s = &histories->list[q];
        fprintf(f, "%d %d %a %a %a", s->id, s->other, s->xi[0], s->xi[1],
                s->xi[2]);
        for (int k = 0; with_roll && k < 3; k++)
            fprintf(f, " %a", s->roll_angle[k]);
        for (int k = 0; s->other == SURFACE_SPRING && k < 3; k++)
            fprintf(f, " %a", s->n[k]);
        fprintf(f, "\n");
    }
}

static int rolls(const struct dem_options *o)
{
    return materials_have_rolling(&o->material, o->materials);
}

/* The checksum of all bytes before it. */
static void bed_file_last_line(char line[LAST_LINE + 1], const char *bytes,
                               size_t n)
{
    snprintf(line, LAST_LINE + 1, "crc32 %08lx\n",
             (unsigned long)crc32_z(0, (const unsigned char *)bytes, n));
}

int bed_file_save(const char *path, const struct particles *ps,
                  const struct bed_histories *histories,
                  const struct bed_options *bed, const struct dem_options *dem)
{
    char text[FACTS][LINE], last[LAST_LINE + 1], *bytes;
    size_t length;
    struct file *const file = file_create(path);

    if (file == NULL) return 1;
    FILE *const out = open_memstream(&bytes, &length);
    const int count = facts(text, bed, dem);
    for (int n = 0; n < count; n++)
        fputs(text[n], out);
    write_bed(out, ps, histories, rolls(dem));
    fclose(out);
    bed_file_last_line(last, bytes, length);
    fwrite(bytes, 1, length, file_stream(file));
    fputs(last, file_stream(file));
    free(bytes);
    return file_commit(file);
}

/* The number of the line after them, 0 after a message: the first line that
 * differs says what the bed was made with instead. */
static int check_facts(FILE *f, const char *path, const struct bed_options *bed,
                       const struct dem_options *dem)
{
    char text[FACTS][LINE], line[LINE];

    const int count = facts(text, bed, dem);
    for (int n = 0; n < count; n++) {
        if (fgets(line, LINE, f) == NULL) line[0] = 0;
        if (strcmp(line, text[n]) == 0) continue;
        line[strcspn(line, "\n")] = 0;
        text[n][strcspn(text[n], "\n")] = 0;
        fprintf(stderr,
                "winnow: %s:%d: this bed was made with \"%s\", not with "
                "\"%s\"; remove the file to make it anew\n",
                path, n + 1, line, text[n]);
        return 0;
    }
    return count + 1;
}

static const char incomplete[] = "the bed is not complete";

/* What is wrong with particle i of those from `first`, or NULL. */
static const char *misfit(const struct particles *ps, int i, int first,
                          const struct bed_options *bed,
                          const struct dem_options *dem, char *known)
{
    const double x[3] = {ps->x[i], ps->y[i], ps->z[i]}, d = ps->d[i];
    const double least = bed->sizes ? sizes_min(bed->sizes) : bed->diameter;
    const double most = bed->sizes ? sizes_max(bed->sizes) : bed->diameter;
    const double speeds =
        ps->vx[i] + ps->vy[i] + ps->vz[i] + ps->wx[i] + ps->wy[i] + ps->wz[i];
    const int id = ps->id[i] - first;

    if (id < 0 || id >= bed->count || known[id]++)
        return "its id is not one of the bed's, or is given twice";
    for (int k = 0; k < 3; k++)
        if (!(x[k] >= dem->lo[k] && x[k] <= dem->hi[k]))
            return "it is not in the box";
    if (!isfinite(speeds)) return "its velocity or spin is not a number";
    if (!(d >= least && d <= most))
        return "its diameter is not one of the bed's";
    /* The mass is the product in another order: rounded differently. */
    if (!(fabs(ps->m[i] / (bed->density * particles_volume(ps, i)) - 1.0) <
          1e-12))
        return "its mass does not belong to its diameter";
    return NULL;
}

/* Reads a particle; NULL, or what is wrong with it. */
static const char *read_particle(FILE *f, struct particles *ps, int i)
{
    double *column[COLUMNS];

    columns(ps, column);
    if (fscanf(f, "%d", &ps->id[i]) != 1) return incomplete;
    for (int k = 0; k < COLUMNS; k++)
        if (fscanf(f, "%la", &column[k][i]) != 1) return incomplete;
    return NULL;
}

static const char *read_particles(FILE *f, struct particles *ps,
                                  const struct bed_options *bed,
                                  const struct dem_options *dem, int *line)
{
    const char *wrong = NULL;
    const int first = ps->next_id;
    int n = -1;

    if (fscanf(f, " particles %d", &n) != 1 || n != bed->count)
        return "expected \"particles\" and as many as the bed has";
    char *const known = alloc_zeroed((size_t)n, 1);
    for (int i = ps->n; i < ps->n + n && wrong == NULL; i++) {
        ++*line;
        wrong = read_particle(f, ps, i);
        if (wrong == NULL) wrong = misfit(ps, i, first, bed, dem, known);
    }
    free(known);
    if (wrong != NULL) return wrong;
    ps->n += n;
    ps->next_id += n;
    return NULL;
}

/* Those against surfaces come last. */
static int spring_fits(const struct dem_history *s,
                       const struct dem_history *old, int count,
                       const struct dem_options *dem)
{
    const int least = dem->n_surfaces > 0 ? SURFACE_SPRING : -6;
    const int late = old != NULL && old->other == SURFACE_SPRING;

    return s->id >= 0 && s->id < count && s->other >= least &&
           s->other < (late ? SURFACE_SPRING + 1 : count) &&
           isfinite(s->xi[0] + s->xi[1] + s->xi[2]) &&
           isfinite(s->n[0] + s->n[1] + s->n[2]) &&
           isfinite(s->roll_angle[0] + s->roll_angle[1] + s->roll_angle[2]);
}

static const char *read_spring(FILE *f, struct dem_history *s, int with_roll)
{
    if (fscanf(f, "%d %d %la %la %la", &s->id, &s->other, &s->xi[0], &s->xi[1],
               &s->xi[2]) != 5)
        return incomplete;
    for (int k = 0; with_roll && k < 3; k++)
        if (fscanf(f, "%la", &s->roll_angle[k]) != 1) return incomplete;
    for (int k = 0; s->other == SURFACE_SPRING && k < 3; k++)
        if (fscanf(f, "%la", &s->n[k]) != 1) return incomplete;
    return NULL;
}

/* Sixty contacts a sphere, and some with walls, are more than any bed has. */
static const char *read_histories(FILE *f, int count,
                                  struct bed_histories *histories,
                                  const struct dem_options *dem, int *line)
{
    const int with_roll = rolls(dem);
    int n = -1;

    ++*line;
    if (fscanf(f, " springs %d", &n) != 1) return incomplete;
    if (n < 0 || n > 100L * count + 100)
        return "there are more contacts than the bed can have";
    histories->n = n;
    histories->list = alloc_zeroed((size_t)n, sizeof *histories->list);
    for (int q = 0; q < n; q++) {
        struct dem_history *const s = &histories->list[q];
        ++*line;
        const char *const wrong = read_spring(f, s, with_roll);
        if (wrong != NULL) return wrong;
        if (!spring_fits(s, q > 0 ? s - 1 : NULL, count, dem))
            return "this contact cannot be in the bed";
    }
    return NULL;
}

/* A digit that was changed makes another number, which may be possible. */
static const char *damage(const char *bytes, size_t length)
{
    char line[LAST_LINE + 1];

    if (length < LAST_LINE) return incomplete;
    bed_file_last_line(line, bytes, length - LAST_LINE);
    return memcmp(bytes + length - LAST_LINE, line, LAST_LINE) == 0
               ? NULL
               : "the file is damaged: its checksum does not match";
}

int bed_file_load(const char *path, struct particles *ps,
                  struct bed_histories *histories,
                  const struct bed_options *bed, const struct dem_options *dem)
{
    const char *why, *wrong = NULL;
    size_t length;
    char *const bytes = input_text(path, &length, &why);
    FILE *const f = bytes != NULL ? fmemopen(bytes, length + 1, "r") : NULL;
    int line;

    if (f == NULL) {
        free(bytes);
        if (errno == ENOENT) return BED_ABSENT;
        fprintf(stderr, "winnow: %s: %s\n", path,
                why != NULL ? why : strerror(errno));
        return BED_REFUSED;
    }
    line = check_facts(f, path, bed, dem);
    if (line > 0) {
        wrong = read_particles(f, ps, bed, dem, &line);
        if (wrong == NULL)
            wrong = read_histories(f, bed->count, histories, dem, &line);
        if (wrong == NULL) wrong = damage(bytes, length);
        if (wrong != NULL)
            fprintf(stderr,
                    "winnow: %s:%d: %s; remove the file to make the bed anew\n",
                    path, line, wrong);
    }
    fclose(f);
    free(bytes);
    return line == 0 || wrong != NULL ? BED_REFUSED : BED_CREATED;
}
