/* SPDX-License-Identifier: GPL-3.0-or-later */
/* compare.c -- how far two checkpoints are apart.
 *
 *   compare CELLS A B
 *   compare velocities A
 *
 * A and B are of one machine or of several ranks. The first prints the largest
 * and the rms difference of a position [m] of the particles, which are known by
 * their ids, and the largest differences of u and p of the fluid, over the
 * largest u and p of A. The second prints the id and the velocity of each
 * particle. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <lammps/library.h>

#include "base/alloc.h"
#include "output/checkpoint/state_file.h"

enum { MOST = 10000000, NAME = 64 };

struct content {
    int n;
    double *x, *v; /* [m], [m/s] 3 a particle, by their ids */
    double *u, *p;
};

static void give_up(const char *path, const char *why)
{
    fprintf(stderr, "compare: %s: %s\n", path, why ? why : "not there");
    exit(4);
}

static void make_room(struct content *c, int n)
{
    c->n = n;
    c->x = alloc_doubles(3 * n);
    c->v = alloc_doubles(3 * n);
}

/* Of one machine. */
static void take_state(struct content *c, struct state *s, int cells)
{
    static const char *const name[6] = {"x", "y", "z", "vx", "vy", "vz"};
    int n;

    state_begin(s, "particles");
    state_count(s, "count", &n, MOST);
    int *const id = alloc_ints(n);
    make_room(c, n);
    state_wholes(s, "id", "-", id, n, 1);
    for (int k = 0; k < 6; k++) {
        double *const unsorted = alloc_doubles(n);
        state_reals(s, name[k], k < 3 ? "m" : "m/s", unsorted, n, 1);
        for (int i = 0; i < n; i++)
            (k < 3 ? c->x : c->v)[3 * id[i] + k % 3] = unsorted[i];
        free(unsorted);
    }
    free(id);
    state_end(s);
    state_begin(s, "fluid");
    state_reals(s, "u", "m/s", c->u, cells, 3);
    state_reals(s, "p", "Pa", c->p, cells, 1);
    state_end(s);
}

/* Of several ranks: LAMMPS reads its own file. */
static void take_grains(struct content *c, const char *path)
{
    char *words[] = {"compare", "-log", "none", "-screen", "none", "-nocite"};
    void *const lammps = lammps_open_no_mpi(6, words, NULL);
    char line[4200];

    snprintf(line, sizeof line, "read_restart %s", path);
    lammps_command(lammps, line);
    const int n = *(int *)lammps_extract_global(lammps, "nlocal");
    const int *const id = lammps_extract_atom(lammps, "id");
    double **const x = lammps_extract_atom(lammps, "x");
    double **const v = lammps_extract_atom(lammps, "v");
    make_room(c, n);
    for (int i = 0; i < n; i++) {
        memcpy(&c->x[3 * (id[i] - 1)], x[i], 3 * sizeof(double));
        memcpy(&c->v[3 * (id[i] - 1)], v[i], 3 * sizeof(double));
    }
    lammps_close(lammps);
}

/* An array of the file of cells, before which its name stands. */
static void take_cells(const char *path, const char *name, double *to, int n)
{
    FILE *const f = fopen(path, "rb");
    char at[NAME];

    if (f == NULL) give_up(path, NULL);
    while (fread(at, 1, NAME, f) == NAME && strcmp(at, name) != 0)
        fseek(f, 1 - NAME, SEEK_CUR);
    if (strcmp(at, name) != 0 ||
        fread(to, sizeof *to, (size_t)n, f) != (size_t)n)
        give_up(path, name);
    fclose(f);
}

static struct content load(const char *path, int cells)
{
    const char *why;
    struct state_file *const f = state_file_open(path, &why);
    struct content c = {.u = alloc_doubles(3 * cells),
                        .p = alloc_doubles(cells)};
    char other[4096];

    if (f == NULL) give_up(path, why);
    const double slot = state_file_number(f, "/processes/slot");
    if (isfinite(slot)) {
        snprintf(other, sizeof other, "%s.grains.%.0f", path, slot);
        take_grains(&c, other);
        snprintf(other, sizeof other, "%s.cells.%.0f", path, slot);
        if (cells > 0) take_cells(other, "/fluid/u", c.u, 3 * cells);
        if (cells > 0) take_cells(other, "/fluid/p", c.p, cells);
    } else {
        take_state(&c, state_file_state(f), cells);
        if (state_file_state(f)->failed) exit(4);
    }
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
    const struct content c = load(path, 0);

    for (int i = 0; i < c.n; i++)
        printf("%d %.17g %.17g %.17g\n", i, c.v[3 * i], c.v[3 * i + 1],
               c.v[3 * i + 2]);
    return 0;
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
            rr += pow(a.x[3 * i + k] - b.x[3 * i + k], 2.0);
        most = fmax(most, sqrt(rr));
        squares += rr;
    }
    printf("%.3e %.3e %.3e %.3e\n", most, sqrt(squares / (a.n > 0 ? a.n : 1)),
           largest(a.u, b.u, 3 * cells), largest(a.p, b.p, cells));
    return 0;
}
