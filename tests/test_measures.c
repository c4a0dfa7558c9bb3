/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/build.h"
#include "case/case_file.h"
#include "coupling/effect.h"
#include "coupling/effects.h"
#include "facts.h"

#include <gsl/gsl_math.h>
#include <gsl/gsl_rng.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* 12 x 24 cells of 1 mm, one of 2 mm in the depth, and 4 times 6 spheres. */
static struct simulation *build(const char *named)
{
    static const char *const rest =
        "mesh = { size = [0.012, 0.024, 0.002]; cells = [12, 24, 1]; };\n"
        "fluid = { density = 1.2; viscosity = 1.8e-5; step = 2e-4;\n"
        "  bottom = { inlet = 0.5; }; top = { outlet = 0.0; };\n"
        "  sides = \"slip\"; front_back = \"slip\"; };\n"
        "particles = { contact = \"linear\"; step = 2e-5;\n"
        "  grains = { density = 1000; stiffness = 50.0; restitution = 0.9;\n"
        "             friction = 0.1; };\n"
        "  bed = { count = 400; diameter = 0.4e-3; settle = 0.0; }; };\n"
        "averaging = { method = \"pcm\"; };\n"
        "exchange = { drag = \"gidaspow\"; };\n"
        "output = { end = 1.0; every = 1.0; };\n";
    char path[] = "/tmp/winnow-measures-XXXXXX";
    const int fd = mkstemp(path);
    FILE *const f = fdopen(fd, "w");
    int code;

    fprintf(f, "%s%s", rest, named);
    fclose(f);
    struct settings *const s = case_file_read(path, 0, NULL, &code);
    remove(path);
    ck_assert_ptr_nonnull(s);
    struct simulation *const sim = build_simulation(s, &code);
    ck_assert_ptr_nonnull(sim);
    ck_assert_int_eq(sim->n_effects, 1);
    settings_free(s);
    return sim;
}

/* eps_f = 0.9 in a rectangle of cells, their first and last columns and rows.
 */
static void blow(struct simulation *sim, int x1, int y1, int x2, int y2)
{
    for (int j = y1; j <= y2; j++)
        for (int i = x1; i <= x2; i++)
            sim->fluid->eps[i + 12 * j] = 0.9;
}

static void fill(struct simulation *sim)
{
    for (int c = 0; c < sim->mesh->n_cells; c++)
        sim->fluid->eps[c] = 0.4;
}

static const double *row(struct simulation *sim)
{
    static double values[8];
    const struct effect_state *const e = &sim->effects[0];

    e->effect->columns->row(e->memory, sim, values);
    return values;
}

static const char bubbles[] = "effects = { bubbles = { threshold = 0.8; "
                              "height = 0.0085; smallest = 0.0012; }; };";

/* 4 x 3 cells and 2 x 2, which touch in a corner only; one cell, of a diameter
 * of 1.13 mm, is too small; what is at the top is no bubble, though it is
 * joined to cells far down. Volumes are sums of cells: rounding. */
FACT(a_bubble_is_what_is_joined_by_faces_and_closed)
{
    struct simulation *const sim = build(bubbles);

    fill(sim);
    blow(sim, 2, 4, 5, 6);
    blow(sim, 6, 7, 7, 8);
    blow(sim, 10, 2, 10, 2);
    blow(sim, 0, 20, 11, 23);
    blow(sim, 11, 10, 11, 20);
    const double *const b = row(sim);
    ck_assert_double_eq(b[0], 2.0);
    ck_assert_double_eq_tol(b[1], 16 * 2e-9, 1e-20);
    ck_assert_double_eq_tol(b[2], sqrt(4.0 * 12e-6 / M_PI), 1e-12);
    build_free(sim);
}

/* Three rows high, one row a step: it is in the row from 8 to 9 mm for three
 * steps and is counted once, and so is the next one. */
FACT(a_bubble_that_rises_passes_a_height_once)
{
    struct simulation *const sim = build(bubbles);

    for (int j = 0; j < 14; j++) {
        fill(sim);
        blow(sim, 2, j, 5, j + 2);
        if (j >= 6) blow(sim, 8, j - 6, 10, j - 4);
        ck_assert_double_eq(row(sim)[3], j < 6 ? 0.0 : j < 12 ? 1.0 : 2.0);
    }
    build_free(sim);
}

static const char mixing[] = "effects = { mixing = { sample = 1.001e-3; "
                             "direction = [1.0, 0.0, 0.0]; }; };";

/* Particle i, counted along x, goes to a place of its own: `at` says how many
 * samples of 1 mm from the left. */
static void put(struct simulation *sim, int (*at)(int i, int n, gsl_rng *r),
                gsl_rng *r)
{
    struct particles *const ps = sim->particles;

    for (int i = 0; i < ps->n; i++) {
        ps->x[i] = (at(ps->id[i], ps->n, r) + 0.5) * 1e-3;
        ps->y[i] = ps->z[i] = 0.5e-3;
    }
}

static int by_turns(int i, int n, gsl_rng *r)
{
    (void)n;
    (void)r;
    return i / 2 % 10;
}

static int by_chance(int i, int n, gsl_rng *r)
{
    (void)i;
    (void)n;
    return (int)gsl_rng_uniform_int(r, 10);
}

/* The two halves lie in bands of 1 mm in turn, near both ends of each. A sample
 * is as wide as a band, so that each has one kind and M = 0; with samples of
 * another width some have both. Tolerance: rounding. */
FACT(lacey_of_what_is_not_mixed_is_zero)
{
    struct simulation *const sim = build(mixing);
    struct particles *const ps = sim->particles;
    double *const before = malloc((size_t)ps->n * sizeof *before);
    double middle = 0.0;

    for (int i = 0; i < ps->n; i++)
        before[i] = ps->x[i];
    for (int i = 0; i < ps->n; i++) { /* the median, by counting */
        int below = 0;
        for (int j = 0; j < ps->n; j++)
            below += before[j] < before[i];
        if (below == ps->n / 2) middle = before[i];
    }
    ck_assert_double_gt(middle, 0.0);
    for (int i = 0; i < ps->n; i++)
        ps->x[i] = (before[i] < middle ? 0.0 : 1e-3) + i % 5 * 2e-3 +
                   (i % 2 ? 1e-4 : 9e-4);
    ck_assert_double_eq_tol(row(sim)[0], 0.0, 1e-12);
    free(before);
    build_free(sim);
}

/* Random places give 1 on average, samples of any size; of 4000 draws of 400
 * in 10 samples the mean is known to 0.0002. With 1 / n of the mean sample in
 * place of (K - 1) / (N - 1) it is 1.0025, and without the random part 0.98. */
FACT(lacey_of_random_places_is_one)
{
    struct simulation *const sim = build(mixing);
    gsl_rng *const chance = gsl_rng_alloc(gsl_rng_mt19937);
    double mean = 0.0;

    for (int draw = 0; draw < 4000; draw++) {
        put(sim, by_chance, chance);
        mean += row(sim)[0] / 4000;
    }
    ck_assert_double_eq_tol(mean, 1.0, 0.001);
    put(sim, by_turns, chance); /* more even than chance */
    ck_assert_double_gt(row(sim)[0], 0.99);
    gsl_rng_free(chance);
    build_free(sim);
}
