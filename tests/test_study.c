/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a study computes: choices, measures, truths, means with their errors,
 * orders. The processes are in tests/tables/study.txt. */
#include "output/summary.h"
#include "study/outcome.h"

#include "facts.h"
#include "scratch.h"

#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>
#include <math.h>

/* --- choices -------------------------------------------------------------- */

static struct choices two_choices(void)
{
    struct choices c = {0};

    ck_assert_int_eq(choices_add(&c, "a.step=4e-3, 2e-3,1e-3"), 0);
    ck_assert_int_eq(
        choices_add(&c, "mesh.cells:threads=[8,4,1]:\"x,y\",[16,4,1]:z"), 0);
    return c;
}

/* Commas in brackets and quotes separate nothing. */
FACT(values_split_at_top_level_commas_and_keys_cross)
{
    struct choices c = two_choices();
    struct texts set = {0};

    ck_assert_int_eq(choices_variants(&c), 6);
    choices_overrides(&c, 3, &set); /* entries 1 and 1 */
    ck_assert_int_eq(set.n, 2);
    ck_assert_str_eq(set.text[0], "a.step=2e-3");
    ck_assert_str_eq(set.text[1], "mesh.cells=[16,4,1]");
    ck_assert_str_eq(choices_value(&c, 3, "threads"), "z");
    texts_free(&set);
    char *const label = choices_label(&c, 2, 0);
    ck_assert_str_eq(label, "cells=[8,4,1], threads=\"x,y\"");
    free(label);
    ck_assert_int_eq(choices_with(&c, 3, 0, 2), 5);
    choices_free(&c);
}

/* A group that a case does not have cannot be written as a value. */
FACT(a_value_as_is_sets_nothing)
{
    struct choices c = {0};
    struct texts set = {0};

    ck_assert_int_eq(choices_add(&c, "effects.saffman=as-is, {}"), 0);
    choices_overrides(&c, 0, &set);
    ck_assert_int_eq(set.n, 0);
    choices_overrides(&c, 1, &set);
    ck_assert_int_eq(set.n, 1);
    ck_assert_str_eq(set.text[0], "effects.saffman={}");
    texts_free(&set);
    choices_free(&c);
}

/* A step gets smaller; of cells only those that change count, and more of them
 * are smaller. A word among numbers has no size, and the numbers keep theirs.
 */
FACT(sizes_fall_from_coarse_to_fine)
{
    struct choices c = two_choices();

    ck_assert_double_eq(choices_size(&c.of[0], 0) / choices_size(&c.of[0], 2),
                        4.0);
    ck_assert_double_eq(choices_size(&c.of[1], 0) / choices_size(&c.of[1], 1),
                        2.0);
    ck_assert_int_eq(choices_axis(&c), 0);
    choices_free(&c);
    ck_assert_int_eq(choices_add(&c, "averaging.method=pcm,kernel"), 0);
    ck_assert_double_nan(choices_size(&c.of[0], 0));
    ck_assert_int_eq(choices_axis(&c), -1);
    choices_free(&c);
    ck_assert_int_eq(choices_add(&c, "particles.skin=8e-4,4e-4,auto,1e-4"), 0);
    ck_assert_double_eq(choices_size(&c.of[0], 1) / choices_size(&c.of[0], 3),
                        4.0);
    ck_assert_double_nan(choices_size(&c.of[0], 2));
    ck_assert_int_eq(choices_axis(&c), 0);
    choices_free(&c);
}

/* --- statistics ----------------------------------------------------------- */

/* q = 3 + 0.7 h^1.6 exactly, at sizes that do not halve. */
FACT(richardson_finds_the_order_and_the_limit)
{
    const double h[3] = {1.0, 0.5, 0.2};
    double q[3];

    for (int i = 0; i < 3; i++)
        q[i] = 3.0 + 0.7 * pow(h[i], 1.6);
    const double p = curve_richardson(h, fabs(q[1] - q[0]) / fabs(q[2] - q[1]));
    /* bisected to 1e-17 of the interval; the powers round */
    ck_assert_double_eq_tol(p, 1.6, 1e-12);
    const double q_0 = q[2] + (q[2] - q[1]) / (pow(h[1] / h[2], p) - 1.0);
    ck_assert_double_eq_tol(q_0, 3.0, 1e-12);
    ck_assert_double_eq_tol(curve_order(1.0, 0.7, 0.5, 0.7 / 8.0), 3.0, 1e-14);
    ck_assert_double_nan(curve_richardson(h, 0.5)); /* they part */
}

/* A curve of two points; its errors are `error`. */
static struct curve line_of(double low, double high, double error)
{
    struct curve c = curve_create(2);

    c.x[1] = 1.0;
    c.value[0] = low;
    c.value[1] = high;
    c.error[0] = c.error[1] = error;
    return c;
}

/* Changes of (4, 8) and (1, 2) have the ratio 4, the order 2 if sizes halve; if
 * the second is back, or within the errors, there is no order. */
FACT(changes_that_turn_back_or_are_chance_have_no_order)
{
    static const double h[3] = {4.0, 2.0, 1.0};
    struct curve of[] = {line_of(0.0, 0.0, 0.0), line_of(4.0, 8.0, 0.0),
                         line_of(5.0, 10.0, 0.0), line_of(3.0, 6.0, 0.0),
                         line_of(5.0, 10.0, 1.0)};

    ck_assert_double_eq_tol(
        curve_richardson(h, curve_changes(&of[0], &of[1], &of[2])), 2.0,
        1e-12); /* bisected */
    ck_assert_double_eq_tol(curve_changes(&of[0], &of[1], &of[3]), -4.0, 1e-14);
    ck_assert_double_nan(curve_richardson(h, -4.0));
    ck_assert_double_nan(curve_changes(&of[0], &of[1], &of[4]));
    for (int i = 0; i < 5; i++)
        curve_free(&of[i]);
}

/* Seeds that give the same bits have no standard error, though their sum
 * rounds; those that scatter have that of their scatter, of 0.1 and 0.3 it is
 * 0.1, or their own if it is larger. */
FACT(a_mean_over_seeds_has_the_error_of_their_scatter)
{
    struct curve of[] = {line_of(0.1, 0.1, 0.0), line_of(0.1, 0.3, 0.0),
                         line_of(0.1, 0.1, 0.0), line_of(0.1, 0.3, 0.6)};
    struct curve mean = curve_mean(3, of);

    ck_assert_double_eq(mean.error[0], 0.0);
    curve_free(&mean);
    mean = curve_mean(2, of);
    ck_assert_double_eq_tol(mean.value[1], 0.2, 1e-16); /* rounding */
    ck_assert_double_eq_tol(mean.error[1], 0.1, 1e-16);
    curve_free(&mean);
    mean = curve_mean(2, &of[2]);
    ck_assert_double_eq_tol(mean.error[1], 0.3, 1e-16); /* 0.6 / 2 */
    curve_free(&mean);
    for (int i = 0; i < 4; i++)
        curve_free(&of[i]);
}

/* x_k = phi x_k-1 + noise: neighbours are alike, and the mean of n is as
 * uncertain as that of n (1 - phi) / (1 + phi) independent samples, 1/19 of
 * them for phi = 0.9. The error of an error from a few dozen blocks is some
 * 15 %; taking the samples as independent misses by a factor of 4.4. */
FACT(flyvbjerg89_blocks_find_the_error_of_a_correlated_mean)
{
    enum { N = 65536 };
    const double phi = 0.9;
    gsl_rng *const rng = gsl_rng_alloc(gsl_rng_mt19937);
    double *const x = calloc(N, sizeof *x);

    for (int i = 1; i < N; i++)
        x[i] = phi * x[i - 1] + gsl_ran_gaussian(rng, 1.0);
    const double exact = 1.0 / (1.0 - phi) / sqrt(N);
    const double found = curve_block_error(N, x);
    ck_assert_double_gt(found, 0.7 * exact);
    ck_assert_double_lt(found, 1.6 * exact);
    ck_assert_double_lt(curve_scatter(N, x), 0.3 * exact);
    free(x);
    gsl_rng_free(rng);
}

/* --- what runs have written ----------------------------------------------- */

static const char summary[] =
    "{\n  \"case\": \"a \\\"steps\\\": 7 {\",\n  \"steps\": 12,\n"
    "  \"exit_code\": null,\n  \"seconds\": {\n    \"cfd\": 0.25,\n"
    "    \"steps\": 3\n  },\n  \"worst\": {\n    \"overlap\": 1e-3\n  }\n}\n";

FACT(numbers_of_a_summary_are_found_by_their_path)
{
    char dir[64];

    scratch_make(dir);
    scratch_write(scratch_path(dir, "summary.json"), summary);
    ck_assert_double_eq(read_summary_number(dir, "steps"), 12.0);
    ck_assert_double_eq(read_summary_number(dir, "seconds.cfd"), 0.25);
    ck_assert_double_eq(read_summary_number(dir, "seconds.steps"), 3.0);
    ck_assert_double_eq(read_summary_number(dir, "worst.overlap"), 1e-3);
    ck_assert_double_nan(read_summary_number(dir, "exit_code"));
    ck_assert_double_nan(read_summary_number(dir, "cfd"));
    ck_assert_double_nan(read_summary_number(dir, "case"));
    ck_assert_double_nan(read_summary_number(dir, "seconds.overlap"));
    ck_assert_double_nan(read_summary_number(dir, "steps.cfd"));
    scratch_clear(dir);
}

/* A quote, a backslash and an end of line, as the summary writes them. */
FACT(texts_of_a_summary_are_those_that_were_written)
{
    char dir[64];

    scratch_make(dir);
    scratch_write(scratch_path(dir, "summary.json"),
                  "{\n  \"exit_reason\": \"a \\\"b\\\" \\\\u\\u000ac\"\n}\n");
    char *const text = read_summary_text(dir, "exit_reason");
    ck_assert_str_eq(text, "a \"b\" \\u\nc");
    free(text);
    scratch_clear(dir);
}

/* A history of v = 10 t, cut in its last row. */
static struct curve taken(const char *text)
{
    char dir[64];
    struct measure m = {.column = -1};
    static const struct {
        const char *text;
        struct measure as;
    } all[] = {{"last", {.how = MEASURE_LAST, .from = NAN, .to = NAN}},
               {"@0.15", {.how = MEASURE_LAST, .from = 0.15, .to = NAN}},
               {"mean", {.how = MEASURE_MEAN, .from = NAN, .to = NAN}},
               {"mean@0.1..0.3", {.how = MEASURE_MEAN, .from = 0.1, .to = 0.3}},
               {"max", {.how = MEASURE_MAX, .from = NAN, .to = 0.2}},
               {"curve", {.how = MEASURE_CURVE, .from = 0.3, .to = NAN}}};

    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++)
        if (strcmp(all[i].text, text) == 0) m = all[i].as;
    m.column = -1;
    strcpy(m.file, "history.csv");
    strcpy(m.name, "v");
    scratch_make(dir);
    scratch_write(scratch_path(dir, "history.csv"),
                  "time [s],w [-],v [m/s]\n0,0,0\n0.1,0,1\n0.2,0,2\n0.3,0,3\n"
                  "0.4,0,4\n0.5,0");
    const struct curve c = measure_take(&m, dir);
    scratch_clear(dir);
    return c;
}

FACT(a_measure_reduces_a_column_as_it_says)
{
    static const struct {
        const char *text;
        double value;
        int n;
    } all[] = {{"last", 4.0, 1}, {"@0.15", 1.5, 1},         {"mean", 3.0, 1},
               {"max", 2.0, 1},  {"mean@0.1..0.3", 2.0, 1}, {"curve", 3.0, 2}};

    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
        struct curve c = taken(all[i].text);
        ck_assert_int_eq(c.n, all[i].n);
        ck_assert_double_eq_tol(c.value[0], all[i].value, 1e-14);
        curve_free(&c);
    }
}

/* Rows each 0.1 s, and one where the run ends, 0.04 s later. Of two bodies each
 * time has two rows. A profile over cells that shrink has no such row. */
FACT(a_mean_counts_the_rows_that_were_due)
{
    static const struct {
        const char *head, *rows;
        enum measure_how how;
        double from, value;
    } all[] = {
        {"time [s]", "0,0\n0.1,1\n0.2,2\n0.3,3\n0.34,9\n", MEASURE_MEAN, NAN,
         2.5},
        {"time [s]", "0,0\n0.1,1\n0.2,2\n0.3,3\n0.4,9\n", MEASURE_MEAN, 0.3, 6},
        {"time [s]", "0,0\n0.1,1\n0.2,2\n0.3,3\n0.34,9\n", MEASURE_MAX, NAN, 9},
        {"time [s]", "0,0\n0.1,1\n0.2,2\n0.3,3\n0.34,9\n", MEASURE_MEAN, 0.32,
         9},
        {"time [s]", "0.1,1\n0.1,2\n0.2,3\n0.2,4\n0.3,5\n0.3,6\n", MEASURE_MEAN,
         0.3, 5.5},
        {"time [s]", "0.1,1\n0.1,2\n0.2,3\n0.2,4\n0.23,5\n0.23,6\n",
         MEASURE_MEAN, 0.2, 3.5},
        {"x [m]", "0,0\n0.1,1\n0.2,2\n0.3,3\n0.34,9\n", MEASURE_MEAN, 0.3, 6}};

    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
        const struct measure m = {.how = all[i].how,
                                  .file = "history.csv",
                                  .column = 1,
                                  .from = all[i].from,
                                  .to = NAN};
        char dir[64], text[256];
        scratch_make(dir);
        snprintf(text, sizeof text, "%s,v [m/s]\n%s", all[i].head, all[i].rows);
        scratch_write(scratch_path(dir, "history.csv"), text);
        struct curve c = measure_take(&m, dir);
        ck_assert_int_eq(c.n, 1);
        ck_assert_double_eq_tol(c.value[0], all[i].value, 1e-14);
        curve_free(&c);
        scratch_clear(dir);
    }
}

/* A run that ended at once has one row; of the time 0.4 s it knows nothing. */
FACT(one_row_says_nothing_of_another_time)
{
    const struct measure m = {
        .file = "history.csv", .column = 1, .from = 0.4, .to = NAN};
    char dir[64];

    scratch_make(dir);
    scratch_write(scratch_path(dir, "history.csv"), "time [s],v [m/s]\n0,3\n");
    struct curve c = measure_take(&m, dir);
    ck_assert_double_nan(c.value[0]);
    curve_free(&c);
    scratch_clear(dir);
}

/* A profile says of each mean how sure it is, or nan after too few samples. */
FACT(a_profile_comes_with_its_standard_errors)
{
    char dir[64];
    const struct measure m = {.how = MEASURE_CURVE,
                              .file = "profile.csv",
                              .column = 1,
                              .from = NAN,
                              .to = NAN};

    scratch_make(dir);
    scratch_write(scratch_path(dir, "profile.csv"),
                  "x [m],us_y_mean [m/s],us_y_std [m/s],us_y_error [m/s]\n"
                  "0,1,0.3,0.1\n1,nan,nan,nan\n2,3,0.3,nan\n");
    struct curve c = measure_take(&m, dir);
    ck_assert_int_eq(c.n, 2);
    ck_assert_double_eq(c.error[0], 0.1);
    ck_assert_double_eq(c.value[1], 3.0);
    ck_assert_double_eq(c.error[1], 0.0);
    curve_free(&c);
    scratch_clear(dir);
}

/* --- truths --------------------------------------------------------------- */

static double truth_of(const char *text, double x)
{
    struct truth t;

    ck_assert_int_eq(truth_parse(&t, text), 0);
    const double value = truth_value(&t, x);
    truth_free(&t);
    return value;
}

FACT(a_formula_is_computed_as_one_writes_it)
{
    ck_assert_double_eq(truth_of("-2^2+3*4/2", 0.0), 2.0);
    ck_assert_double_eq(truth_of("2^3^2", 0.0), 512.0);
    ck_assert_double_eq(truth_of("1 - 2 - 3", 0.0), -4.0);
    ck_assert_double_eq(truth_of("0.05*(1-exp(-t/4e-4))", 8e-4),
                        0.05 * (1.0 - exp(-2.0)));
    ck_assert_double_eq(truth_of("sqrt(x)/cos(pi)", 4.0), -2.0);
}

/* Measured values come as other programs write them: lines that end with CR LF,
 * blanks around commas, empty fields, a last line without an end. What is not
 * there is a gap, drawn across; beyond the ends nothing is known. */
FACT(a_table_of_measured_values_may_have_gaps)
{
    char dir[64];
    struct truth t;

    scratch_make(dir);
    const char *const path = scratch_path(dir, "a.csv");
    scratch_write(path,
                  "x [m], q [-]\r\n0 , 1\r\n\r\n1,\r\n2,nan\r\n# no\r\n4, 3");
    ck_assert_int_eq(truth_parse(&t, path), 0);
    ck_assert_double_eq_tol(truth_value(&t, 1.0), 1.5, 1e-15); /* rounding */
    ck_assert_double_eq(truth_value(&t, 4.0), 3.0);
    ck_assert_double_nan(truth_value(&t, 4.1));
    truth_free(&t);
    scratch_write(path, "x,q\n0,1\n1;2\n");
    ck_assert_int_eq(truth_parse(&t, path), 2);
    truth_free(&t);
    scratch_write(path, "x,q\n0,1\n1,2\n2");
    ck_assert_int_eq(truth_parse(&t, path), 2);
    truth_free(&t);
    scratch_clear(dir);
}

/* The key of `winnow eval`, with the time left to the samples: the end of the
 * course is the stream, its start the acceleration u_f / tau_p, which
 * XS11:3.17 gives by another way; the next term is of relative order
 * t/tau_p = 2e-6. */
FACT(xs11_4_1_is_a_truth_in_time)
{
    static const char key[] = "XS11:4.1 rho_s=2000 eps_s=0.4 rho_f=1000 "
                              "mu=1e-3 d=8.3e-5 u_f=0.05";
    const double tau = truth_of("XS11:3.17 rho_s=2000 eps_s=0.4 rho_f=1000 "
                                "mu=1e-3 d=8.3e-5 u_r=0.05",
                                0.0);

    ck_assert_double_eq_tol(truth_of(key, 1.0), 0.05, 1e-9);
    ck_assert_double_eq_tol(truth_of(key, 1e-10) * tau / (0.05 * 1e-10), 1.0,
                            1e-5);
    ck_assert_double_eq(truth_of(key, 0.0), 0.0);
}

/* --- the case as it stands ------------------------------------------------ */

static const char scene[] =
    "title = \"a\"; mesh = { size = [0.01, 0.01, 0.01]; cells = [1, 4, 1]; };\n"
    "fluid = { density = 1; viscosity = 1; step = 1e-2;\n"
    "  bottom_top = \"no-slip\"; sides = \"slip\"; front_back = \"slip\"; };\n"
    "output = { end = 1; every = 1; };\n";

/* A default counts as well as what is written, and 0.01 is 1e-2. */
/* The variant that the case is, among those of the words. */
static int standing(const char *dir, int n, const char *const *choices)
{
    const char *words[16] = {scratch_path(dir, "scene.cfg"), "--measure",
                             "steps", "-o", "nowhere"};
    struct plan p;
    int code, runs = 0;

    for (int i = 0; i < n; i++) {
        words[5 + 2 * i] = "-s";
        words[6 + 2 * i] = choices[i];
    }
    ck_assert_int_eq(plan_create(&p, 5 + 2 * n, words), 0);
    struct run *const run = runs_create(&p, &runs, &code);
    ck_assert_int_eq(code, 0);
    const int found = runs_standing(&p, runs, run);
    runs_free(runs, run);
    plan_free(&p);
    return found;
}

/* However a number is written: as 1 or 1.0, 0.02 or 2e-2. */
FACT(the_case_as_it_stands_is_found_among_its_variants)
{
    char dir[64];

    scratch_make(dir);
    scratch_write(scratch_path(dir, "scene.cfg"), scene);
    ck_assert_int_eq(
        standing(dir, 4,
                 (const char *[]){"fluid.step=2e-2,0.01",
                                  "fluid.time=bdf2,euler",
                                  "fluid.density=1000,1.0", "output.end=0.5"}),
        7);
    ck_assert_int_eq(standing(dir, 1, (const char *[]){"fluid.step=0.02,0.03"}),
                     -1);
    scratch_clear(dir);
}
