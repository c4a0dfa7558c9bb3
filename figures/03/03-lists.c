/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 03-lists.c -- who is near whom in a settled bed, one grain deep.
 *
 * 2000 spheres of 1 mm between two walls 1.2 mm apart.
 *
 *   03-lists counts   pairs that a search would look at, and that lists hold
 *   03-lists skin     lists made in 4000 steps of the bed thrown up, and pairs
 *                     in each of them, for some skins
 *   03-lists picture  place and strip of each sphere; then one sphere and those
 *                     in its neighbour list; then the edges of the cells
 */
#include <gsl/gsl_math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "dem/bed.h"
#include "dem/contact_linear.h"
#include "dem/fast/neighbours.h"

static const double d = 1e-3, skin = 1e-3 / 6.0;

static struct dem_options box(void)
{
    const struct dem_options o = {
        .law = &contact_linear,
        .material = {.stiffness = 200.0, .restitution = 0.8, .friction = 0.2},
        .step = 1e-5,
        .hi = {0.04, 0.12, 0.0012}};
    return o;
}

static struct particles *settled(const struct dem_options *o)
{
    const struct bed_options bed = {.count = 2000,
                                    .diameter = d,
                                    .density = 2000.0,
                                    .seed = 5,
                                    .jitter = 0.5,
                                    .gravity = {0.0, -9.81, 0.0},
                                    .settle = 1.0};
    struct particles *const ps = particles_create(bed.count);
    struct bed_histories springs = {0};
    struct bed_report r = {0};

    if (bed_fill(ps, &bed, o) != 0 ||
        bed_settle(ps, &bed, o, &r, &springs) != 0)
        exit(1);
    free(springs.list);
    return ps;
}

/* The lists as dem_run makes them, with a margin of 2 um. */
static struct neighbours *lists(struct particles *ps,
                                const struct dem_options *o)
{
    const struct box_domain b = box_domain_of(o->lo, o->hi, o->periodic);
    struct neighbours *const nb = neighbours_create(ps, &b);

    nb->skin = skin;
    neighbours_begin_run(nb, 1);
    neighbours_load(nb);
    neighbours_refresh(nb, 1e-6, 0.0);
    return nb;
}

static double coordinate(const struct particles *ps, int k, int i)
{
    return (k == 0 ? ps->x : k == 1 ? ps->y : ps->z)[i];
}

/* Origin and width of the cells, as grid.c divides them. */
static void cells(const struct particles *ps, double origin[3], double width[3])
{
    for (int k = 0; k < 3; k++) {
        double hi = -1.0;
        origin[k] = 1.0;
        for (int i = 0; i < ps->n; i++) {
            origin[k] = fmin(origin[k], coordinate(ps, k, i));
            hi = fmax(hi, coordinate(ps, k, i));
        }
        const double L = hi - origin[k];
        width[k] = L / fmax(1.0, floor(L / (d + skin)));
    }
}

static void counts(struct particles *ps, const struct neighbours *nb)
{
    double origin[3], width[3];
    int beside = 0, touch = 0, near = 0, chosen = 0;

    cells(ps, origin, width);
    for (int i = 0; i < ps->n; i++)
        for (int j = 0; j < i; j++) {
            int apart = 0;
            double r2 = 0.0;
            for (int k = 0; k < 3; k++) {
                const double x = coordinate(ps, k, i) - origin[k];
                const double y = coordinate(ps, k, j) - origin[k];
                const int c = (int)(x / width[k]), e = (int)(y / width[k]);
                apart |= abs(c - e) > 1;
                r2 += (x - y) * (x - y);
            }
            beside += !apart;
            touch += r2 < d * d;
        }
    for (int s = 0; s < nb->n_chunks; s++) {
        near += nb->chunks[s].pairs.n;
        chosen += nb->chunks[s].contacts.n_pairs;
    }
    printf("all = %d\ncells = %d\nneighbour_list = %d\ncontacts = %d\ntouch = "
           "%d\n",
           ps->n * (ps->n - 1) / 2, beside, near, chosen, touch);
    printf("chunks = %d\n", nb->n_chunks);
}

static void skins(struct particles *ps, struct dem_options *o)
{
    static const double parts[] = {40.0, 20.0, 12.0, 6.0, 3.0, 1.5};

    puts("# skin over d, lists made, pairs in one over spheres");
    for (int k = 0; k < 6; k++) {
        struct particles *const own = particles_create(ps->n);
        struct dem_report r;
        double pairs = 0.0;

        o->skin = d / parts[k];
        for (int i = 0; i < ps->n; i++) {
            const double x[3] = {ps->x[i], ps->y[i], ps->z[i]};
            particles_add(own, x, d, 2000.0);
            own->ey[i] = -9.81 * own->m[i];
            own->vy[i] = 0.5 + 5.0 * ps->y[i];
        }
        struct dem *const dem = dem_create(own, o);
        if (dem_run(dem, 4000, &r) != 0) exit(1);
        for (int i = 0; i < ps->n; i++)
            for (int j = 0; j < i; j++) {
                const double reach = d + o->skin;
                pairs += gsl_pow_2(ps->x[i] - ps->x[j]) +
                             gsl_pow_2(ps->y[i] - ps->y[j]) +
                             gsl_pow_2(ps->z[i] - ps->z[j]) <=
                         reach * reach;
            }
        printf("%5.3f  %4ld  %.2f\n", o->skin / d, r.rebuilds, pairs / ps->n);
        dem_free(dem);
        particles_free(own);
    }
}

static void picture(const struct particles *ps, const struct neighbours *nb)
{
    double origin[3], width[3];

    puts("# x, y [mm], strip");
    for (int s = 0; s < nb->n_chunks; s++)
        for (int i = nb->chunks[s].begin; i < nb->chunks[s].end; i++)
            printf("%.3f %.3f %d\n", 1e3 * ps->x[i], 1e3 * ps->y[i], s);
    const struct chunk *const s = &nb->chunks[0];
    const int a = (s->end - s->begin) / 2;
    printf("\n\n# one, and its partners\n%.3f %.3f\n",
           1e3 * ps->x[s->begin + a], 1e3 * ps->y[s->begin + a]);
    for (int q = s->pairs.start[a]; q < s->pairs.start[a + 1]; q++)
        printf("%.3f %.3f\n", 1e3 * ps->x[s->pairs.partner[q]],
               1e3 * ps->y[s->pairs.partner[q]]);
    cells(ps, origin, width);
    printf(
        "\n\n# the cells: origin and width in x and y\n%.4f %.4f %.4f %.4f\n",
        1e3 * origin[0], 1e3 * width[0], 1e3 * origin[1], 1e3 * width[1]);
}

int main(int argc, char **argv)
{
    const char *const mode = argc == 2 ? argv[1] : "";
    struct dem_options o = box();
    struct particles *const ps = settled(&o);
    struct neighbours *const nb = lists(ps, &o);

    if (strcmp(mode, "counts") == 0) counts(ps, nb);
    if (strcmp(mode, "skin") == 0) skins(ps, &o);
    if (strcmp(mode, "picture") == 0) picture(ps, nb);
    neighbours_free(nb);
    particles_free(ps);
    return 0;
}
