/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene.c -- the states of a run, thinned to what the page has room for. */
#include "base/alloc.h"
#include "base/number.h"
#include "report/page.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Most points and triangles of a state, and most states. */
enum { MOST_POINTS = 20000, MOST_TRIANGLES = 10000, MOST_STATES = 200 };

static const struct kind_of_series {
    const char *name;
    int polygons;
} kinds[] = {{"fluid", 0},       {"particles", 0},     {"bodies", 0},
             {"body_clumps", 0}, {"body_surfaces", 1}, {"surfaces", 1}};
enum { SERIES = sizeof kinds / sizeof kinds[0] };

/* The files of a series, and their times [s]. */
struct listed {
    struct texts file;
    double *time;
};

struct scene {
    struct page *page;
    struct listed of[SERIES];
    struct plane plane[PLANES]; /* of the mesh of the file before */
    int planes;                 /* [-] of them that are shown */
    long beside; /* [byte] of those that are not in the middle, so far */
    int wrong;   /* files that could not be read */
    size_t every[SERIES]; /* [-] 1: all of its points are shown */
};

/* DIR/NAME.pvd; a file elsewhere than in DIR/NAME is left out. */
static void scene_read_list(struct scene *s, int k)
{
    struct listed *const l = &s->of[k];
    char name[64];
    size_t length;

    snprintf(name, sizeof name, "%s.pvd", kinds[k].name);
    char *const text = vtk_read_text(s->page->folder, name, &length);
    const int n = snprintf(name, sizeof name, "%s/", kinds[k].name);
    for (char *at = text; at != NULL; at++) {
        at = strstr(at, "timestep=\"");
        char *const file = at != NULL ? strstr(at, "file=\"") : NULL;
        char *const end = file != NULL ? strchr(file + 6, '"') : NULL;
        if (end == NULL) break;
        *end = '\0';
        if (strncmp(file + 6, name, (size_t)n) != 0 ||
            strchr(file + 6 + n, '/') != NULL) {
            s->wrong++;
        } else {
            if ((l->file.n & (l->file.n - 1)) == 0)
                l->time = alloc_grown(l->time, l->file.n, 2 * l->file.n + 1,
                                      sizeof *l->time);
            l->time[l->file.n] = strtod(at + 10, NULL);
            texts_add(&l->file, "%s", file + 6);
        }
        at = end;
    }
    free(text);
}

/* Every `step`-th of the points of an array. */
static void put_array(struct scene *s, int k, double t, const char *name,
                      int components, size_t n, size_t step, double *value)
{
    const size_t width = (size_t)components;
    size_t kept = 0;

    if (value == NULL) return;
    for (size_t i = 0; i * width < n; i += step, kept++)
        memmove(value + kept * width, value + i * width, width * sizeof *value);
    page_put_numbers(s->page, &(struct page_numbers){.series = kinds[k].name,
                                                     .name = name,
                                                     .time = t,
                                                     .n = kept * width,
                                                     .value = value,
                                                     .more = ""});
}

/* The lengths of vectors, in the place of these. */
static size_t lengths_of(double *v, size_t n)
{
    for (size_t i = 0; i < n / 3; i++)
        v[i] = hypot(hypot(v[3 * i], v[3 * i + 1]), v[3 * i + 2]);
    return n / 3;
}

static size_t scene_step(struct scene *s, int k, size_t n, size_t most)
{
    const size_t step = n > most ? (n + most - 1) / most : 1;

    if (step > s->every[k]) s->every[k] = step;
    return step;
}

static int scene_put_points(struct scene *s, int k, double t,
                            const struct vtk_read *f)
{
    static const struct {
        const char *name, *shown;
        int components; /* 3: its length is shown */
    } of[] = {{"diameter", "diameter", 1},
              {"id", "id", 1},
              {"body", "body", 1},
              {"velocity", "speed", 3},
              {"force", "force", 3},
              {"fluid_force", "fluid_force", 3},
              {"contact_force", "contact_force", 3}};
    size_t n, m;
    double *const x = vtk_read_array(f, "position", 3, &n);
    const size_t step = scene_step(s, k, n / 3, MOST_POINTS);

    put_array(s, k, t, "position", 3, n, step, x);
    for (size_t i = 0; i < sizeof of / sizeof of[0]; i++) {
        double *const value =
            vtk_read_array(f, of[i].name, of[i].components, &m);
        if (of[i].components == 3 && value != NULL) m = lengths_of(value, m);
        if (3 * m == n) put_array(s, k, t, of[i].shown, 1, m, step, value);
        free(value);
    }
    free(x);
    return x == NULL;
}

/* The triangles of polygons, three corners each, where there is room for them;
 * how many there are. */
static size_t fan(const struct vtk_shapes *p, double *triangle)
{
    size_t n = 0;

    for (size_t i = 0; i < p->n; i++) {
        const double *const first = vtk_read_corner(p, i, 0);
        const double *before = vtk_read_corner(p, i, 1), *x;
        for (size_t q = 2; (x = vtk_read_corner(p, i, q)) != NULL; q++, n++) {
            const double *const of[3] = {first, before, x};
            for (int j = 0; j < 3 && triangle != NULL; j++)
                memcpy(triangle + 9 * n + 3 * j, of[j], 3 * sizeof *x);
            before = x;
        }
    }
    return n;
}

static int put_polygons(struct scene *s, int k, double t,
                        const struct vtk_read *f)
{
    struct vtk_shapes p;
    const int wrong = vtk_read_shapes(&p, f);

    if (!wrong) {
        const size_t n = fan(&p, NULL);
        double *const triangle = alloc_zeroed(9 * n, sizeof *triangle);
        fan(&p, triangle);
        put_array(s, k, t, "triangle", 9, 9 * n,
                  scene_step(s, k, n, MOST_TRIANGLES), triangle);
        free(triangle);
        size_t m;
        double *const body = vtk_read_array(f, "body", 1, &m);
        if (m == n)
            put_array(s, k, t, "body", 1, m,
                      scene_step(s, k, n, MOST_TRIANGLES), body);
        free(body);
    }
    vtk_read_shapes_free(&p);
    return wrong;
}

/* A field in a slice: of the side that comes first in a row. */
static void put_slice(struct scene *s, double t, int q, const char *name,
                      const double *field)
{
    const struct plane *const p = &s->plane[q];
    const int n = p->n[0] * p->n[1], axis = q % 3;
    const long before = ftell(s->page->out);
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    char more[256];

    if (n == 0) return;
    double *const value = alloc_doubles(n);
    for (int i = 0; i < n; i++)
        value[i] = p->cell[i] >= 0 ? field[p->cell[i]] : NAN;
    snprintf(more, sizeof more,
             " data-axis=\"%d\" data-at=\"%.6g\" data-size=\"%d %d\" "
             "data-box=\"%.9g %.9g %.9g %.9g %.9g %.9g\"",
             axis, p->at, p->n[0], p->n[1], p->low[a], p->high[a], p->low[b],
             p->high[b], p->low[axis], p->high[axis]);
    page_put_numbers(s->page, &(struct page_numbers){.series = "fluid",
                                                     .name = name,
                                                     .time = t,
                                                     .n = (size_t)n,
                                                     .value = value,
                                                     .more = more});
    if (q >= 3) s->beside += ftell(s->page->out) - before;
    free(value);
}

static int put_fluid(struct scene *s, double t, const struct vtk_read *f)
{
    static const char *const names[] = {"void_fraction", "pressure",
                                        "velocity"};
    int found = 0;

    for (int i = 0; i < 3; i++) {
        size_t n;
        double *const field = vtk_read_array(f, names[i], i < 2 ? 1 : 3, &n);
        if (i == 2 && field != NULL) n = lengths_of(field, n);
        if (field != NULL && n != (size_t)s->plane[0].cells) {
            plane_free(s->plane);
            if (plane_make(s->plane, f, n) != 0) n = 0;
        }
        if (field != NULL && n > 0 && n == (size_t)s->plane[0].cells) {
            found = 1;
            for (int q = 0; q < s->planes; q++)
                put_slice(s, t, q, i < 2 ? names[i] : "speed", field);
        }
        free(field);
    }
    return !found;
}

/* State i of n, of the files of each series those at that share. */
static void put_state(struct scene *s, int i, int n)
{
    for (int k = 0; k < SERIES; k++) {
        const struct listed *const l = &s->of[k];
        struct vtk_read f;

        if (l->file.n == 0) continue;
        const int at =
            n > 1 ? number_clamped((double)i * (l->file.n - 1) / (n - 1) + 0.5,
                                   0, l->file.n - 1)
                  : l->file.n - 1;
        const double t = l->time[at];
        char *const name = l->file.text[at];
        if (name[0] == '\0') continue; /* of a state before */
        const int closed = vtk_read_open(&f, s->page->folder, name);
        s->wrong += closed              ? 1
                    : k == 0            ? put_fluid(s, t, &f)
                    : kinds[k].polygons ? put_polygons(s, k, t, &f)
                                        : scene_put_points(s, k, t, &f);
        vtk_read_close(&f);
        name[0] = '\0';
    }
}

/* The last state first, which shows what one takes. */
static void put_states(struct scene *s, int all)
{
    const long before = ftell(s->page->out);
    s->planes = PLANES;
    put_state(s, 0, 1);
    long each = 1 + ftell(s->page->out) - before;
    if (s->beside > 0 && (double)each * all > (double)page_room(s->page)) {
        s->planes = 3;
        each -= s->beside;
        texts_add(&s->page->left,
                  "slices beside the middle are of the last state alone");
    }
    const int n = number_clamped((double)page_room(s->page) / (double)each, 0,
                                 all < MOST_STATES ? all : MOST_STATES);
    int shown = 1;

    for (int i = 0; i < n - 1 && page_room(s->page) > each; i++, shown++)
        put_state(s, i, n);
    if (shown < all)
        texts_add(&s->page->left, "%d of %d states are in the page", shown,
                  all);
}

void page_put_scene(struct page *p)
{
    struct scene s = {.page = p};
    int all = 0;

    for (int k = 0; k < SERIES; k++) {
        scene_read_list(&s, k);
        if (s.of[k].file.n > all) all = s.of[k].file.n;
    }
    if (all > 0) put_states(&s, all);
    for (int k = 0; k < SERIES; k++) {
        if (s.every[k] > 1)
            texts_add(&p->left, "of the %s one in %zu is in the page",
                      kinds[k].name, s.every[k]);
        texts_free(&s.of[k].file);
        free(s.of[k].time);
    }
    if (s.wrong > 0)
        texts_add(&p->left, "%d files of the scene could not be read", s.wrong);
    plane_free(s.plane);
}
