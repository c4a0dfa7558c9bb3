/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/box_domain.h"

#include <math.h>

#include "base/alloc.h"
#include "base/number.h"
#include "base/vector.h"

/* A box may be far larger than its particles; then the cells are widened. */
static int max_cells(int capacity)
{
    return 4 * capacity + 64;
}

struct link_cells *link_cells_create(int capacity, const struct box_domain *box)
{
    struct link_cells *const l = owner_create(sizeof *l);

    l->box = *box;
    l->capacity = capacity;
    l->head = owner_ints(l, max_cells(capacity));
    l->next = owner_ints(l, capacity);
    return l;
}

void link_cells_divide(const double length[3], double reach, int capacity,
                       int cells[3])
{
    double total = HUGE_VAL;

    if (!(reach > 0.0)) reach = HUGE_VAL; /* no particle: one cell */
    for (double width = reach; total > max_cells(capacity); width *= 1.25) {
        total = 1.0;
        for (int k = 0; k < 3; k++) {
            cells[k] = number_clamped(length[k] / width, 1, 1000000);
            total *= cells[k];
        }
    }
}

void link_cells_clear(struct link_cells *l, double reach)
{
    double length[3];

    vector_between(l->box.hi, l->box.lo, length);
    link_cells_divide(length, reach, l->capacity, l->cells);
    for (int k = 0; k < 3; k++)
        l->width[k] = length[k] / l->cells[k];
    for (int c = 0; c < l->cells[0] * l->cells[1] * l->cells[2]; c++)
        l->head[c] = -1;
}

/* A particle outside of a wall belongs to the cell at the wall. */
static int link_cells_coordinate(const struct link_cells *l, int k, double x)
{
    const double in = box_domain_inside(&l->box, k, x) - l->box.lo[k];
    return number_clamped(in / l->width[k], 0, l->cells[k] - 1);
}

/* The number of the cell at c. */
static int link_cells_cell_of(const struct link_cells *l, const int c[3])
{
    return (c[2] * l->cells[1] + c[1]) * l->cells[0] + c[0];
}

void link_cells_add(struct link_cells *l, int i, const double x[3])
{
    const int c[3] = {link_cells_coordinate(l, 0, x[0]),
                      link_cells_coordinate(l, 1, x[1]),
                      link_cells_coordinate(l, 2, x[2])};
    int *const head = &l->head[link_cells_cell_of(l, c)];

    l->next[i] = *head;
    *head = i;
}

int link_cells_beside(int m, int periodic, int at, int found[3])
{
    int n = 0;

    for (int c = at - 1; c <= at + 1; c++)
        if (c >= 0 && c < m)
            found[n++] = c;
        else if (periodic && m > 2)
            found[n++] = (c + m) % m;
    return n;
}

int link_cells_around(const struct link_cells *l, const double x[3],
                      int found[LINK_CELLS_AROUND])
{
    int at[3][3], count[3], n = 0;

    for (int k = 0; k < 3; k++)
        count[k] = link_cells_beside(l->cells[k], l->box.periodic[k],
                                     link_cells_coordinate(l, k, x[k]), at[k]);
    for (int a = 0; a < count[0]; a++)
        for (int b = 0; b < count[1]; b++)
            for (int c = 0; c < count[2]; c++)
                found[n++] = link_cells_cell_of(
                    l, (const int[3]){at[0][a], at[1][b], at[2][c]});
    return n;
}
