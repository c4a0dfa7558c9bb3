/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/insertion.h"

#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/input.h"
#include "base/interrupt.h"
#include "base/number.h"

/* Places tried a step for one sphere: beyond 30 % of solids hardly any is free,
 * and what waits is asked again in the next step. */
enum { ATTEMPTS = 200, LINE = 256 };

/* 0 <= u < 1 from four numbers: the mixer of SplitMix64 [Steele14]. */
static double chance(unsigned long seed, long k, long attempt, int which)
{
    const uint64_t part[4] = {seed, (uint64_t)k, (uint64_t)attempt,
                              (uint64_t)which};
    uint64_t z = 0;

    for (int i = 0; i < 4; i++) {
        z += part[i] + 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        z ^= z >> 31;
    }
    return (double)(z >> 11) / 9007199254740992.0;
}

double insertion_diameter(const struct insertion_options *o, long k)
{
    if (o->list != NULL) return o->list[k].d;
    if (o->sizes == NULL) return o->diameter;
    return sizes_quantile(o->sizes, chance(o->seed, k, 0, 3));
}

void insertion_place(const struct insertion_options *o, long k, long attempt,
                     double d, double x[3])
{
    for (int a = 0; a < 3; a++) {
        const double room = o->hi[a] - o->lo[a] - d;
        const double u = chance(o->seed, k, attempt, a);
        x[a] = o->list != NULL ? o->list[k].x[a]
                               : o->lo[a] + 0.5 * d + u * fmax(room, 0.0);
    }
}

long insertion_due(const struct insertion *in, double t)
{
    const struct insertion_options *const o = &in->options;

    if (t < o->start) return 0;
    if (o->rate <= 0.0) return o->count;
    const double n = floor((t - o->start) * o->rate) + 1.0;
    long due;
    return number_long(n, &due) != 0 || due > o->count ? o->count : due;
}

/* Who of the particles may touch a sphere in the region: their indices. */
struct crowd {
    int n;
    int *who;
};

/* x_i - x along direction k, nearest image. */
static double apart(const struct particles *ps, const struct domain *box, int i,
                    int k, const double x[3])
{
    const double *const at = k == 0 ? ps->x : k == 1 ? ps->y : ps->z;
    const double dx = at[i] - x[k];
    return dx - box->length[k] * rint(dx * box->inverse[k]);
}

static struct crowd crowd_of(const struct insertion_options *o,
                             const struct particles *ps,
                             const struct domain *box)
{
    struct crowd c = {0, alloc_ints(ps->capacity)};
    double middle[3];

    for (int k = 0; k < 3; k++)
        middle[k] = 0.5 * (o->lo[k] + o->hi[k]);
    for (int i = 0; i < ps->n; i++) {
        int near = 1;
        for (int k = 0; k < 3; k++)
            near &= fabs(apart(ps, box, i, k, middle)) <=
                    0.5 * (o->hi[k] - o->lo[k]) + 0.5 * ps->d[i];
        if (near || o->list != NULL) c.who[c.n++] = i;
    }
    return c;
}

static int is_free(const struct crowd *c, const struct particles *ps,
                   const struct domain *box, const double x[3], double d)
{
    for (int q = 0; q < c->n; q++) {
        const int i = c->who[q];
        const double reach = 0.5 * (d + ps->d[i]);
        double r2 = 0.0;
        for (int k = 0; k < 3; k++) {
            const double dx = apart(ps, box, i, k, x);
            r2 += dx * dx;
        }
        if (r2 < reach * reach) return 0;
    }
    return 1;
}

/* The next sphere, if it finds room. */
static int place_next(struct insertion *in, struct crowd *c,
                      struct particles *ps, const struct domain *box)
{
    const struct insertion_options *const o = &in->options;
    const double d = insertion_diameter(o, in->done);
    double x[3];

    for (int a = 0; a < (o->list != NULL ? 1 : ATTEMPTS); a++) {
        insertion_place(o, in->done, in->tried++, d, x);
        if (!is_free(c, ps, box, x, d)) continue;
        if (o->room.holds != NULL && !o->room.holds(o->room.where, x, 0.5 * d))
            continue;
        const int i = particles_add(ps, x, d, o->density);
        if (ps->material != NULL) ps->material[i] = o->material;
        ps->vx[i] = o->velocity[0];
        ps->vy[i] = o->velocity[1];
        ps->vz[i] = o->velocity[2];
        c->who[c->n++] = i;
        in->done++;
        in->tried = 0;
        return 1;
    }
    return 0;
}

int insertion_step(struct insertion *in, struct particles *ps,
                   const struct domain *box, double t)
{
    const long due = insertion_due(in, t);
    int added = 0;

    if (in->done >= due) return 0;
    struct crowd crowd = crowd_of(&in->options, ps, box);
    while (in->done < due && ps->n < ps->capacity && !interrupt_arrived() &&
           place_next(in, &crowd, ps, box))
        added++;
    free(crowd.who);
    return added;
}

/* Non-zero if the line is neither a remark nor four numbers. */
static int parse(const char *line, struct insertion_one *one, int *is_one)
{
    const char *const text = line + strspn(line, " \t\r\n");
    char rest;

    *is_one = *text != '#' && *text != '\0';
    if (!*is_one) return 0;
    return sscanf(text, "%lf %lf %lf %lf %c", &one->x[0], &one->x[1],
                  &one->x[2], &one->d, &rest) != 4 ||
           !(one->d > 0.0) ||
           !isfinite(one->x[0] + one->x[1] + one->x[2] + one->d);
}

struct insertion_one *insertion_read(const char *path, long *n)
{
    const char *const why = input_wrong(path);
    FILE *const f = why == NULL ? fopen(path, "r") : NULL;
    struct insertion_one *list = NULL;
    long room = 0, number = 0;
    char line[LINE];
    int is_one, wrong = 0;

    *n = 0;
    if (f == NULL) {
        fprintf(stderr, "winnow: %s: %s\n", path,
                why != NULL ? why : strerror(errno));
        return NULL;
    }
    while (!wrong && fgets(line, LINE, f) != NULL) {
        if (*n == room) {
            room = 2 * room + 64;
            struct insertion_one *const more =
                alloc_zeroed((size_t)room, sizeof *more);
            if (*n > 0) memcpy(more, list, (size_t)*n * sizeof *more);
            free(list);
            list = more;
        }
        number++;
        wrong = parse(line, &list[*n], &is_one);
        *n += is_one;
    }
    fclose(f);
    if (!wrong && *n > 0) return list;
    fprintf(stderr,
            "winnow: %s:%ld: expected x y z d, four numbers [m], d > 0\n", path,
            number);
    free(list);
    return NULL;
}
