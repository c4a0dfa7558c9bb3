/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/means/means.h"
#include "facts.h"
#include "scratch.h"

#include <math.h>

FACTS_IN_A_FOLDER;

/* Graded in all directions, so that no two widths agree. */
static struct mesh *graded_box(void)
{
    return mesh_create_box(&(struct box_spec){.size = {0.4, 1.2, 0.1},
                                              .cells = {6, 9, 5},
                                              .grading = {2.0, 0.3, 4.0}});
}

/* Number `column` of the row-th row below the head. */
static double entry(const char *text, int row, int column)
{
    const char *p = text;

    for (int i = 0; i <= row; i++)
        p = strchr(p, '\n') + 1;
    for (int i = 0; i < column; i++)
        p = strchr(p, ',') + 1;
    return strtod(p, NULL);
}

/* The csv of a profile, to be freed. */
static char *text_of(const struct profile *p)
{
    const char *const path = scratch_path(dir, "p.csv");

    ck_assert_int_eq(profile_write(p, path), 0);
    return scratch_read(path, NULL);
}

/* f = 1 + 2 x - 3 y + 5 z, on every pair of directions: linear in the height
 * by construction, and over the depth its mean is the value in the middle.
 * The tolerance is rounding of a sum of 10 terms of size 5. */
FACT(a_linear_field_is_sampled_exactly_on_a_graded_mesh)
{
    static const double slope[3] = {2.0, -3.0, 5.0};
    struct mesh *const m = graded_box();
    double f[6 * 9 * 5];

    for (int c = 0; c < m->n_cells; c++) {
        f[c] = 1.0;
        for (int k = 0; k < 3; k++)
            f[c] += slope[k] * m->centre[3 * c + k];
    }
    for (int pair = 0; pair < 6; pair++) {
        const int a = pair / 2, up = (a + 1 + pair % 2) % 3, deep = 3 - a - up;
        const double *const y = m->box.edge[up];
        const int n_y = m->box.n[up];
        const double h = 0.37 * y[n_y] + 0.02 * y[1];
        const double depth = m->box.edge[deep][m->box.n[deep]];
        const struct profile_line line = {a, up, h, 0.0};
        const struct profile_field field = {"f", "-", f, 1, 0, NULL};
        struct profile *const p = profile_create(m, &line, &field);

        profile_add(p, 0.0, 1.0);
        char *const text = text_of(p);
        for (int i = 0; i < m->box.n[a]; i++) {
            const double x = 0.5 * (m->box.edge[a][i] + m->box.edge[a][i + 1]);
            ck_assert_double_eq_tol(entry(text, i, 0), x, 1e-15);
            ck_assert_double_eq_tol(entry(text, i, 1),
                                    1.0 + slope[a] * x + slope[up] * h +
                                        slope[deep] * 0.5 * depth,
                                    1e-14);
            ck_assert_double_eq(entry(text, i, 2), 0.0);
        }
        free(text);
        profile_free(p);
    }
    mesh_free(m);
}

FACT(beyond_the_last_centres_the_nearest_row_counts)
{
    struct mesh *const m = graded_box();
    double f[6 * 9 * 5];
    const double heights[3] = {0.0, 1.2, 1.1999};
    const double expected[3] = {0.0, 8.0, 8.0};

    for (int c = 0; c < m->n_cells; c++)
        f[c] = c / 6 % 9;
    for (int i = 0; i < 3; i++) {
        const struct profile_line line = {0, 1, heights[i], 0.0};
        const struct profile_field field = {"f", "-", f, 1, 0, NULL};
        struct profile *const p = profile_create(m, &line, &field);

        profile_add(p, 0.0, 1.0);
        char *const text = text_of(p);
        ck_assert_double_eq_tol(entry(text, 0, 1), expected[i], 1e-14);
        free(text);
        profile_free(p);
    }
    mesh_free(m);
}

/* Velocity 2 where eps_s is 0.6, and 8 where it is 0.2, in two halves of the
 * depth: (0.6 * 2 + 0.2 * 8) / 0.8 = 3.5. In a second sample, eps_s is
 * doubled and the velocity 0.5 everywhere: the mean over time is (0.8 * 3.5 +
 * 1.6 * 0.5) / 2.4 = 1.5, the spread sqrt((0.8 * 2^2 + 1.6 * 1^2) / 2.4). A
 * third, where diffusion has overshot to less than none, does not count. */
FACT(a_weighted_mean_counts_what_is_there)
{
    struct mesh *const m = mesh_create_box(&(struct box_spec){
        .size = {1.0, 1.0, 1.0}, .cells = {1, 1, 2}, .grading = {1, 1, 1}});
    double eps_s[2] = {0.6, 0.2}, u[6] = {9.0, 2.0, 9.0, 9.0, 8.0, 9.0};
    const struct profile_line line = {0, 1, 0.5, 0.0};
    const struct profile_field field = {"u_s", "m/s", u, 3, 1, eps_s};
    struct profile *const p = profile_create(m, &line, &field);

    profile_add(p, 0.0, 1.0);
    char *text = text_of(p);
    ck_assert_double_eq_tol(entry(text, 0, 1), 3.5, 2e-15);
    free(text);
    eps_s[0] = 1.2, eps_s[1] = 0.4, u[1] = u[4] = 0.5;
    profile_add(p, 1.0, 1.0);
    eps_s[0] = eps_s[1] = -0.1, u[1] = u[4] = 7.0;
    profile_add(p, 2.0, 1.0);
    text = text_of(p);
    ck_assert_double_eq_tol(entry(text, 0, 1), 1.5, 2e-15);
    ck_assert_double_eq_tol(entry(text, 0, 2), sqrt(2.0), 2e-15);
    free(text);
    profile_free(p);
    mesh_free(m);
}

FACT(without_a_sample_there_is_no_mean)
{
    struct mesh *const m = graded_box();
    double f[6 * 9 * 5] = {0.0}, none[6 * 9 * 5] = {0.0};
    const struct profile_line line = {0, 1, 0.5, 0.0};
    const struct profile_field field = {"f", "-", f, 1, 0, none};
    struct profile *const p = profile_create(m, &line, &field);

    profile_add(p, 0.0, 1.0);
    char *const text = text_of(p);
    ck_assert(isnan(entry(text, 0, 1)) && isnan(entry(text, 0, 2)));
    free(text);
    profile_free(p);
    mesh_free(m);
}

/* Ten steps of 0.1 add up to less than 1, and still are one second. */
FACT(samples_count_from_the_given_time_on)
{
    struct mesh *const m = graded_box();
    double f[6 * 9 * 5] = {0.0}, time = 0.0;
    const struct profile_line line = {0, 1, 0.5, 1.0};
    const struct profile_field field = {"f", "-", f, 1, 0, NULL};
    struct profile *const p = profile_create(m, &line, &field);

    for (int step = 0; step <= 12; step++) {
        for (int c = 0; c < m->n_cells; c++)
            f[c] = step;
        profile_add(p, time, 0.1);
        time += 0.1;
    }
    char *const text = text_of(p);
    ck_assert_double_eq_tol(entry(text, 0, 1), 11.0, 1e-14);
    ck_assert_double_eq_tol(entry(text, 0, 2), sqrt(2.0 / 3.0), 1e-14);
    free(text);
    profile_free(p);
    mesh_free(m);
}

/* Across a box of four cells 0.1 wide, half the difference of mean and mirror
 * image is 1.5 - i where f = i, and nothing where f is the same on both sides.
 * Of a velocity along the line the image has the other sign: the image of i is
 * -(3 - i), and half of the difference is 1.5 everywhere. Rounding. */
FACT(the_mirror_error_is_half_the_difference_of_the_sides)
{
    struct mesh *const m = mesh_create_box(&(struct box_spec){
        .size = {0.4, 1.0, 1.0}, .cells = {4, 1, 1}, .grading = {1, 1, 1}});
    const double even[4] = {1.0, 5.0, 5.0, 1.0}, odd[4] = {0.0, 1.0, 2.0, 3.0};
    const double u[12] = {0.0, 0.0, 0.0, 1.0, 1.0, 0.0,
                          2.0, 2.0, 0.0, 3.0, 3.0, 0.0};
    const struct profile_line line = {0, 1, 0.5, 0.0};
    const struct profile_field fields[4] = {{"even", "-", even, 1, 0, NULL},
                                            {"odd", "-", odd, 1, 0, NULL},
                                            {"u_x", "m/s", u, 3, 0, NULL},
                                            {"u_y", "m/s", u, 3, 1, NULL}};
    const double expected[4] = {0.0, sqrt(1.25), 1.5, sqrt(1.25)};

    for (int f = 0; f < 4; f++) {
        struct profile *const p = profile_create(m, &line, &fields[f]);
        ck_assert(isnan(profile_mirror_error(p)));
        profile_add(p, 0.0, 1.0);
        ck_assert_double_eq_tol(profile_mirror_error(p), expected[f], 1e-14);
        profile_free(p);
    }
    mesh_free(m);
}

/* Eight samples 0 .. 7 at every point: (12.6) by blocks of one. */
FACT(the_error_of_a_profile_is_that_of_its_blocks)
{
    struct mesh *const m = graded_box();
    double f[6 * 9 * 5] = {0.0};
    const struct profile_line line = {0, 1, 0.5, 0.0};
    const struct profile_field field = {"f", "-", f, 1, 0, NULL};
    struct profile *const p = profile_create(m, &line, &field);

    for (int step = 0; step < 8; step++) {
        for (int c = 0; c < m->n_cells; c++)
            f[c] = step;
        profile_add(p, 0.1 * step, 0.1);
    }
    char *const text = text_of(p);
    ck_assert_double_eq_tol(entry(text, 2, 3), sqrt(0.75), 1e-14);
    ck_assert_double_eq_tol(profile_block_error(p), sqrt(0.75), 1e-14);
    free(text);
    profile_free(p);
    mesh_free(m);
}

FACT(columns_are_named_with_units)
{
    struct mesh *const m = graded_box();
    double f[6 * 9 * 5] = {0.0};
    const struct profile_line line = {2, 0, 0.1, 0.0};
    const struct profile_field field = {"u_y", "m/s", f, 1, 0, NULL};
    struct profile *const p = profile_create(m, &line, &field);
    char *const text = text_of(p);
    static const char head[] =
        "z [m],u_y_mean [m/s],u_y_std [m/s],u_y_error [m/s]\n";

    ck_assert_int_eq(strncmp(text, head, strlen(head)), 0);
    free(text);
    profile_free(p);
    mesh_free(m);
}
