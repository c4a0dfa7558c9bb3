/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/series.h"

#include "base/alloc.h"
#include "base/file.h"
#include "base/text.h"
#include "base/number.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct series {
    struct folder *folder;   /* borrowed; NULL: none */
    struct vtk_file *writer; /* of a series of a folder; else NULL */
    char *name, *suffix;
    char *pvd;       /* DIR/NAME.pvd */
    char *file;      /* NAME/NAME_000000.SUFFIX, as listed in the collection */
    char *path;      /* DIR/NAME/NAME_000000.SUFFIX */
    int n, capacity; /* files listed; length of time */
    double *time;    /* [s] of each file, ascending */
};

/* A copy of text with `extra` unused bytes after it. */
static char *copied(const char *text, size_t extra)
{
    const size_t length = strlen(text);

    return memcpy(alloc_zeroed(length + extra + 1, 1), text, length);
}

/* The length of NAME/NAME_<number>.SUFFIX, at most. */
static size_t file_length(const struct series *s)
{
    return 2 * strlen(s->name) + strlen(s->suffix) + 16;
}

/* Writes the name of file i to `file`. */
static void name_file(const struct series *s, int i, char *file)
{
    snprintf(file, file_length(s), "%s/%s_%06d.%s", s->name, s->name, i,
             s->suffix);
}

struct series *series_create(const char *dir, const char *name,
                             const char *suffix)
{
    struct series *const s = owner_create(sizeof *s);
    char *const folder = file_join(dir, name);
    const int failed = file_make_dirs(folder);

    s->name = copied(name, 0);
    s->suffix = copied(suffix, 0);
    s->pvd = copied(folder, 4);
    strcat(s->pvd, ".pvd");
    s->file = owner_zeroed(s, file_length(s), 1);
    s->path = copied(dir, 1 + file_length(s));
    strcat(s->path, "/");
    s->capacity = 64;
    s->time = alloc_doubles(s->capacity);
    free(folder);
    if (!failed) return s;
    series_free(s);
    return NULL;
}

struct series *series_in(struct folder *f, const char *name, const char *suffix)
{
    char pvd[32];

    snprintf(pvd, sizeof pvd, "%s.pvd", name);
    char *const path = folder_file(f, pvd);
    struct series *const s = path == NULL || folder_make(f, name) != 0
                                 ? NULL
                                 : series_create(folder_name(f), name, suffix);
    free(path);
    if (s == NULL) return NULL;
    s->folder = f;
    s->writer = vtk_file_create();
    return s;
}

void series_free(struct series *s)
{
    if (s == NULL) return;
    vtk_file_free(s->writer);
    free(s->name);
    free(s->suffix);
    free(s->pvd);
    free(s->path);
    free(s->time);
    owner_free(s);
}

static void series_append(struct series *s, double time)
{
    if (s->n == s->capacity) {
        s->capacity *= 2;
        s->time = alloc_grown(s->time, s->n, s->capacity, sizeof *s->time);
    }
    s->time[s->n++] = time;
}

int series_count(const struct series *s)
{
    return s->n;
}

const char *series_next(struct series *s)
{
    /* DIR/NAME.pvd and DIR/NAME/... share DIR/ */
    name_file(s, s->n, s->path + strlen(s->pvd) - strlen(s->name) - 4);
    return s->path;
}

static void put_entry(FILE *out, struct series *s, int i)
{
    char text[NUMBER_LENGTH];

    name_file(s, i, s->file);
    fprintf(out, "<DataSet timestep=\"%s\" part=\"0\" file=\"",
            number_text(s->time[i], text));
    text_put(out, s->file, TEXT_XML);
    fprintf(out, "\"/>\n");
}

static int write_collection(struct series *s)
{
    struct file *const f = file_create(s->pvd);
    if (f == NULL) return 1;
    FILE *const out = file_stream(f);
    fprintf(out, "<?xml version=\"1.0\"?>\n"
                 "<VTKFile type=\"Collection\" version=\"1.0\">\n"
                 "<Collection>\n");
    for (int i = 0; i < s->n; i++)
        put_entry(out, s, i);
    fprintf(out, "</Collection>\n</VTKFile>\n");
    return file_commit(f);
}

int series_add(struct series *s, double time)
{
    if (s->n > 0 && !(time > s->time[s->n - 1])) {
        fprintf(stderr, "winnow: %s has a time after %g s already\n", s->pvd,
                time);
        return 1;
    }
    series_append(s, time);
    return write_collection(s);
}

struct vtk_file *series_writer(const struct series *s)
{
    return s->writer;
}

const char *series_begin(struct series *s)
{
    const char *const path = series_next(s);
    return folder_list(s->folder, path) == 0 ? path : NULL;
}

int series_add_particles(struct series *s, int n, const double *const x[3],
                         double time, int n_arrays,
                         const struct vtk_array *arrays)
{
    const char *const path = series_begin(s);
    return path == NULL ||
           vtk_write_particles(s->writer, path, n, x, time, n_arrays, arrays) ||
           series_add(s, time);
}

int series_add_polygons(struct series *s, const struct vtk_polygons *p,
                        double time, int n_arrays,
                        const struct vtk_array *arrays)
{
    const char *const path = series_begin(s);
    return path == NULL ||
           vtk_write_polygons(s->writer, path, p, time, n_arrays, arrays) ||
           series_add(s, time);
}

/* Non-zero after a message if a listed file is not there. */
static int file_missing(struct series *s)
{
    const int n = s->n;
    int missing = 0;

    for (s->n = 0; s->n < n && !missing; s->n++) {
        missing = access(series_next(s), R_OK) != 0;
        if (missing)
            fprintf(stderr, "winnow: %s, which %s lists, cannot be read: %s\n",
                    s->path, s->pvd, strerror(errno));
    }
    s->n = n;
    return missing;
}

void series_state(struct series *s, struct state *state)
{
    int n = s->n;

    state_begin(state, s->name);
    state_count(state, "files", &n, INT_MAX);
    while (state->loading && !state->failed && s->n < n)
        series_append(s, 0.0);
    state_reals(state, "time", "s", s->time, n, 1);
    state_end(state);
    if (!state->loading || state->failed || n == 0) return;
    state->failed = file_missing(s) != 0 || write_collection(s) != 0;
}
