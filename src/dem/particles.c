/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/particles.h"

#include <assert.h>
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "dem/clumps.h"

enum { MAX_ATTACHED = 128, OWN = 17 };

/* All arrays that are sorted with the particles; the first OWN are those of
 * struct particles. */
struct attachments {
    int n;
    struct attachment {
        double *array;
        int width; /* [-] numbers a particle */
        const char *name, *unit;
    } row[MAX_ATTACHED];
};

struct particles *particles_create(int capacity)
{
    struct particles *const ps = owner_create(sizeof *ps);
    double **const own[OWN] = {&ps->x,   &ps->y,  &ps->z,  &ps->vx, &ps->vy,
                               &ps->vz,  &ps->wx, &ps->wy, &ps->wz, &ps->d,
                               &ps->m,   &ps->ex, &ps->ey, &ps->ez, &ps->cfx,
                               &ps->cfy, &ps->cfz};
    static const char *const named[OWN][2] = {
        {"x", "m"},      {"y", "m"},    {"z", "m"},      {"vx", "m/s"},
        {"vy", "m/s"},   {"vz", "m/s"}, {"wx", "rad/s"}, {"wy", "rad/s"},
        {"wz", "rad/s"}, {"d", "m"},    {"m", "kg"},     {"ex", "N"},
        {"ey", "N"},     {"ez", "N"},   {"cfx", "N"},    {"cfy", "N"},
        {"cfz", "N"}};

    ps->capacity = capacity;
    ps->id = owner_ints(ps, capacity);
    ps->attached = owner_zeroed(ps, 1, sizeof *ps->attached);
    for (int a = 0; a < OWN; a++)
        *own[a] = particles_new_array(ps, named[a][0], named[a][1], 1);
    return ps;
}

void particles_free(struct particles *ps)
{
    if (ps == NULL) return;
    free(ps->across);
    owner_free(ps);
}

void particles_add_implicit_drag(struct particles *ps)
{
    if (ps->drag_coefficient != NULL) return;
    ps->drag_coefficient =
        particles_new_array(ps, "drag_coefficient", "kg/s", 1);
    ps->added_mass = particles_new_array(ps, "added_mass", "kg", 1);
    ps->drag_impulse = particles_new_array(ps, "drag_impulse", "N s", 3);
}

int particles_add(struct particles *ps, const double x[3], double d,
                  double density)
{
    const struct attachments *const a = ps->attached;
    const int i = ps->n++;

    assert(ps->n <= ps->capacity);
    for (int k = 0; k < a->n; k++) /* a removed particle leaves its values */
        memset(a->row[k].array + a->row[k].width * i, 0,
               (size_t)a->row[k].width * sizeof(double));
    ps->x[i] = x[0];
    ps->y[i] = x[1];
    ps->z[i] = x[2];
    ps->d[i] = d;
    ps->id[i] = ps->next_id++;
    ps->m[i] = density * particles_volume(ps, i);
    if (ps->material != NULL) ps->material[i] = 0;
    return i;
}

void particles_add_material(struct particles *ps)
{
    if (ps->material == NULL) ps->material = owner_ints(ps, ps->capacity);
}

void particles_attach(struct particles *ps, const char *name, const char *unit,
                      double *array, int width)
{
    struct attachments *const a = ps->attached;

    assert(a->n < MAX_ATTACHED);
    a->row[a->n++] = (struct attachment){array, width, name, unit};
}

double *particles_new_array(struct particles *ps, const char *name,
                            const char *unit, int width)
{
    double *const array = owner_doubles(ps, width * ps->capacity);

    particles_attach(ps, name, unit, array, width);
    return array;
}

void particles_detach(struct particles *ps, const double *array)
{
    struct attachments *const a = ps->attached;
    int k = OWN;

    while (k < a->n && a->row[k].array != array)
        k++;
    if (k < a->n) a->row[k] = a->row[--a->n];
}

/* `most` numbers of each row at a time; so many of each fit into `copy`. */
static void permute_array(double *array, int width, const int *order, int n,
                          double *copy, int most)
{
    for (int first = 0; first < width; first += most) {
        const int many = width - first < most ? width - first : most;
        for (int i = 0; i < n; i++)
            for (int k = 0; k < many; k++)
                copy[many * i + k] = array[width * i + first + k];
        for (int i = 0; i < n; i++)
            for (int k = 0; k < many; k++)
                array[width * i + first + k] = copy[many * order[i] + k];
    }
}

static void permute_ints(int *array, const int *order, int n, int *copy)
{
    memcpy(copy, array, (size_t)n * sizeof *copy);
    for (int i = 0; i < n; i++)
        array[i] = copy[order[i]];
}

void particles_permute_share(struct particles *ps, const int *order, int share,
                             int of, double *work)
{
    const struct attachments *const a = ps->attached;
    const int most = PARTICLES_SHARES / of;
    double *const copy = work + (size_t)share * (size_t)(most * ps->n);

    for (int k = share; k < a->n; k += of)
        permute_array(a->row[k].array, a->row[k].width, order, ps->n, copy,
                      most);
    if (share < of - 1) return;
    permute_ints(ps->id, order, ps->n, (int *)copy);
    if (ps->material != NULL)
        permute_ints(ps->material, order, ps->n, (int *)copy);
}

void particles_permute(struct particles *ps, const int *order)
{
    double *const work = alloc_doubles(PARTICLES_SHARES * ps->n);

    particles_permute_share(ps, order, 0, 1, work);
    free(work);
}

void particles_remove(struct particles *ps, const int *removed)
{
    int *const order = alloc_ints(ps->n);
    int n_kept = 0, end = ps->n;

    if (ps->clumps != NULL) clumps_remove(ps, removed);
    for (int i = 0; i < ps->n; i++)
        order[removed[i] ? --end : n_kept++] = i;
    particles_permute(ps, order);
    ps->n = n_kept;
    free(order);
}

/* The name of array k; where several have one, the second is NAME_2. */
static void full_name(const struct attachments *a, int k, char name[64])
{
    int number = 1;

    for (int i = 0; i < k; i++)
        number += strcmp(a->row[i].name, a->row[k].name) == 0;
    snprintf(name, 64, number > 1 ? "%s_%d" : "%s", a->row[k].name, number);
}

void particles_state(struct particles *ps, struct state *s)
{
    const struct attachments *const a = ps->attached;

    state_begin(s, "particles");
    state_count(s, "count", &ps->n, ps->capacity);
    state_count(s, "next_id", &ps->next_id, ps->capacity);
    state_indices(s, "id", ps->id, ps->n, 0, ps->next_id - 1);
    state_wholes(s, "material", "-", ps->material, ps->n, 1);
    for (int k = 0; k < a->n; k++) {
        char name[64];
        full_name(a, k, name);
        state_reals(s, name, a->row[k].unit, a->row[k].array, ps->n,
                    a->row[k].width);
    }
    if (ps->clumps != NULL) clumps_state(ps, s);
    state_end(s);
}

double particles_widest(const struct particles *ps)
{
    double widest = 0.0;

    for (int i = 0; i < ps->n; i++)
        widest = fmax(widest, ps->d[i]);
    return widest;
}

double particles_volume(const struct particles *ps, int i)
{
    const double V = M_PI / 6.0 * ps->d[i] * ps->d[i] * ps->d[i];

    return ps->clumps == NULL ? V : V * clumps_filled(ps, i);
}
