/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/fluid_parts.h"

#include "base/alloc.h"

static int runs_of_row(const int *mark, int first, int end, struct run *to)
{
    int n = 0;

    for (int c = first; c < end; c++) {
        if (mark[c] != 0) continue;
        if (c == first || mark[c - 1] != 0) n++;
        if (to != NULL && (c == first || mark[c - 1] != 0)) to[n - 1].first = c;
        if (to != NULL) to[n - 1].end = c + 1;
    }
    return n;
}

static struct fluid_parts *find_runs(const struct box *box, const int *mark)
{
    const int width = box->n[0], rows = box->n[1] * box->n[2];
    struct fluid_parts *const p = owner_create(sizeof *p);

    p->box = box;
    p->row = owner_ints(p, rows + 1);
#pragma omp parallel for schedule(static)
    for (int k = 0; k < rows; k++)
        p->row[k + 1] = runs_of_row(mark, k * width, (k + 1) * width, NULL);
    for (int k = 0; k < rows; k++)
        p->row[k + 1] += p->row[k];
    p->runs = p->row[rows];
    p->run = owner_zeroed(p, (size_t)p->runs + 1, sizeof *p->run);
#pragma omp parallel for schedule(static)
    for (int k = 0; k < rows; k++)
        runs_of_row(mark, k * width, (k + 1) * width, &p->run[p->row[k]]);
    for (int e = 0; e < p->runs; e++)
        p->run[e].root = e;
    return p;
}

static int root_of(const struct fluid_parts *p, int e)
{
    struct run *const run = p->run;

    while (run[e].root != e) {
        run[e].root = run[run[e].root].root;
        e = run[e].root;
    }
    return e;
}

static void join(const struct fluid_parts *p, int a, int b)
{
    a = root_of(p, a);
    b = root_of(p, b);
    if (a < b)
        p->run[b].root = a;
    else
        p->run[a].root = b;
}

/* The runs of two rows that have cells beside each other. */
static void join_rows(const struct fluid_parts *p, int row, int other)
{
    const int way = (other - row) * p->box->n[0];
    int a = p->row[row], b = p->row[other];

    while (a < p->row[row + 1] && b < p->row[other + 1]) {
        const int from = p->run[a].first + way, to = p->run[a].end + way;
        if (from < p->run[b].end && p->run[b].first < to) join(p, a, b);
        if (to < p->run[b].end)
            a++;
        else
            b++;
    }
}

static void join_runs(const struct fluid_parts *p)
{
    const int *const n = p->box->n, *const periodic = p->box->periodic;

    for (int k = 0; k < n[1] * n[2]; k++) {
        const int last = p->row[k + 1] - 1;
        if (k % n[1] > 0 || periodic[1])
            join_rows(p, k, k % n[1] > 0 ? k - 1 : k + n[1] - 1);
        if (k >= n[1] || periodic[2])
            join_rows(p, k, k >= n[1] ? k - n[1] : k + n[1] * (n[2] - 1));
        if (periodic[0] && last > p->row[k] &&
            p->run[p->row[k]].first == k * n[0] &&
            p->run[last].end == (k + 1) * n[0])
            join(p, p->row[k], last);
    }
}

struct fluid_parts *fluid_parts_find(const struct box *box, const int *mark)
{
    struct fluid_parts *const p = find_runs(box, mark);

    join_runs(p);
    for (int e = p->runs - 1; e > 0; e--) {
        struct run *const run = &p->run[e], *const root =
                                                &p->run[root_of(p, e)];
        run->root = (int)(root - p->run);
        if (root == run) continue;
        run->next = root->next;
        root->next = e;
    }
    return p;
}

int fluid_parts_run(const struct fluid_parts *p, int c)
{
    int e = p->row[c / p->box->n[0]];

    while (p->run[e].end <= c)
        e++;
    return e;
}

int fluid_parts_cells(const struct fluid_parts *p, int root, int *part)
{
    int n = 0, e = root;

    do {
        for (int c = p->run[e].first; c < p->run[e].end; c++)
            part[n++] = c;
        e = p->run[e].next;
    } while (e > 0);
    return n;
}
