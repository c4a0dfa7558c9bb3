/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Flows made for the averaged equations, between walls (tests/manufactured.h):
 * errors of velocity and pressure, root mean square of all cells, the largest,
 * and root mean square of the cells at a wall, with mesh and step halved
 * together; and the orders from the mesh before.
 *
 *   sh figures/run.sh figures/19/19-made.c */
#include "manufactured.h"

#include <stdio.h>

static const struct row {
    const char *name;
    struct manufactured setting;
    int n;
} rows[] = {
    {"box", {.kind = MANUFACTURED_BOX}, 16},
    {"box_A", {.kind = MANUFACTURED_BOX, .shared = 1, .mixture = 1}, 16},
    {"box_drag", {.kind = MANUFACTURED_BOX, .shared = 1, .K = 20.0}, 16},
    {"box_graded", {.kind = MANUFACTURED_BOX, .shared = 1, .grading = 3.0}, 16},
    {"box_sheared",
     {.kind = MANUFACTURED_BOX, .mixture = 1, .grading = 3.0, .shear = {0.4}},
     16},
    {"channel", {.kind = MANUFACTURED_CHANNEL}, 16},
    {"channel_A",
     {.kind = MANUFACTURED_CHANNEL, .shared = 1, .mixture = 1},
     16},
    {"channel_drag",
     {.kind = MANUFACTURED_CHANNEL, .shared = 1, .K = 20.0},
     16},
    {"channel_graded", {.kind = MANUFACTURED_CHANNEL, .grading = 3.0}, 16},
};

/* Its run in three directions begins coarser. */
static const struct row deep[] = {
    {"box_3D", {.kind = MANUFACTURED_BOX, .shared = 1, .grading = 2.0}, 8},
    {"sheared_3D",
     {.kind = MANUFACTURED_BOX, .mixture = 1, .shear = {0.3, 0.2, -0.3}},
     8},
    {"channel_3D",
     {.kind = MANUFACTURED_CHANNEL, .shared = 1, .mixture = 1},
     8},
};

static void print(const char *name, int n, const struct manufactured_error *now,
                  const struct manufactured_error *before)
{
    printf("%s %d %.2e %.2e %.2e %.2e %.2e %.2e", name, n, now->u, now->u_max,
           now->u_wall, now->p, now->p_max, now->p_wall);
    if (before->u > 0.0)
        printf(" %.2f %.2f %.2f %.2f %.2f %.2f", log2(before->u / now->u),
               log2(before->u_max / now->u_max),
               log2(before->u_wall / now->u_wall), log2(before->p / now->p),
               log2(before->p_max / now->p_max),
               log2(before->p_wall / now->p_wall));
    puts("");
}

static void refine(const struct row *r, int flat, int most)
{
    struct manufactured_error before = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};

    for (int n = r->n; n <= most; n *= 2) {
        struct manufactured a = r->setting;
        a.n = n;
        a.flat = flat;
        a.time = "bdf2";
        a.convection = "linear";
        a.end = 0.32;
        a.dt = a.end / n;
        const struct manufactured_error now = manufactured_run(&a);
        print(r->name, n, &now, &before);
        before = now;
    }
}

/* With a name only that flow. */
int main(int argc, char **argv)
{
    puts("# flow cells_a_side u u_max u_wall p p_max p_wall, orders of these");
    for (unsigned i = 0; i < sizeof rows / sizeof rows[0]; i++)
        if (argc < 2 || strcmp(argv[1], rows[i].name) == 0)
            refine(&rows[i], 1, 64);
    for (unsigned i = 0; i < sizeof deep / sizeof deep[0]; i++)
        if (argc < 2 || strcmp(argv[1], deep[i].name) == 0)
            refine(&deep[i], 0, 32);
    return 0;
}
