/* SPDX-License-Identifier: GPL-3.0-or-later */
/* compare.c -- how far two checkpoints are apart.
 *
 *   compare CELLS A B
 *   compare velocities A
 *
 * The first prints the largest and the rms difference of a position [m] of the
 * particles, which are known by their ids, and the largest differences of u and
 * p of the fluid, over the largest u and p of A. The second prints the id and
 * the velocity of each particle. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "output/checkpoint/state_file.h"

enum { MOST = 10000000 };

struct content {
    int n, *id;
    double *x[3], *u, *p;
};

static struct content load(const char *path, int cells)
{
    static const char *const name[3] = {"x", "y", "z"};
    const char *why;
    struct state_file *const f = state_file_open(path, &why);
    struct content c = {.u = alloc_doubles(3 * cells),
                        .p = alloc_doubles(cells)};

    if (f == NULL) {
        fprintf(stderr, "compare: %s: %s\n", path, why ? why : "not there");
        exit(4);
    }
    struct state *const s = state_file_state(f);
    state_begin(s, "particles");
    state_count(s, "count", &c.n, MOST);
    c.id = alloc_ints(c.n);
    state_wholes(s, "id", "-", c.id, c.n, 1);
    for (int k = 0; k < 3; k++) {
        double *const unsorted = alloc_doubles(c.n);
        c.x[k] = alloc_doubles(c.n);
        state_reals(s, name[k], "m", unsorted, c.n, 1);
        for (int i = 0; i < c.n; i++)
            if (c.id[i] >= 0 && c.id[i] < c.n) c.x[k][c.id[i]] = unsorted[i];
        free(unsorted);
    }
    state_end(s);
    state_begin(s, "fluid");
    state_reals(s, "u", "m/s", c.u, cells, 3);
    state_reals(s, "p", "Pa", c.p, cells, 1);
    state_end(s);
    if (s->failed) exit(4);
    state_file_free(f);
    return c;
}

static double largest(const double *a, const double *b, int n)
{
    double most = 0.0, off = 0.0;

    for (int i = 0; i < n; i++) {
        most = fmax(most, fabs(a[i]));
        off = fmax(off, fabs(a[i] - b[i]));
    }
    return most > 0.0 ? off / most : off;
}

static int print_velocities(const char *path)
{
    static const char *const name[3] = {"vx", "vy", "vz"};
    const char *why;
    struct state_file *const f = state_file_open(path, &why);
    double *v[3];
    int n = 0;

    if (f == NULL) return 4;
    struct state *const s = state_file_state(f);
    state_begin(s, "particles");
    state_count(s, "count", &n, MOST);
    int *const id = alloc_ints(n);
    state_wholes(s, "id", "-", id, n, 1);
    for (int k = 0; k < 3; k++)
        state_reals(s, name[k], "m/s", v[k] = alloc_doubles(n), n, 1);
    for (int i = 0; i < n; i++)
        printf("%d %.17g %.17g %.17g\n", id[i], v[0][i], v[1][i], v[2][i]);
    return s->failed ? 4 : 0;
}

int main(int argc, char **argv)
{
    double most = 0.0, squares = 0.0;

    if (argc == 3 && strcmp(argv[1], "velocities") == 0)
        return print_velocities(argv[2]);
    if (argc != 4) return 2;
    const int cells = atoi(argv[1]);
    const struct content a = load(argv[2], cells), b = load(argv[3], cells);
    if (a.n != b.n) {
        fprintf(stderr, "compare: %d and %d particles\n", a.n, b.n);
        return 3;
    }
    for (int i = 0; i < a.n; i++) {
        double rr = 0.0;
        for (int k = 0; k < 3; k++)
            rr += pow(a.x[k][i] - b.x[k][i], 2.0);
        most = fmax(most, sqrt(rr));
        squares += rr;
    }
    printf("%.3e %.3e %.3e %.3e\n", most, sqrt(squares / (a.n > 0 ? a.n : 1)),
           largest(a.u, b.u, 3 * cells), largest(a.p, b.p, cells));
    return 0;
}
