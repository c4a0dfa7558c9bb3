/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The linker sends every call of the three functions of base/alloc.h through
 * the counters below (-Wl,--wrap, see the Makefile). */
#include "coupling/effects.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "coupling/effects/forces.h"
#include "coupling/coupling.h"
#include "case/build.h"
#include "case/case_file.h"
#include "facts.h"

static long allocations;

void *__real_alloc_zeroed(size_t n, size_t size);
double *__real_alloc_doubles(int n);
int *__real_alloc_ints(int n);
void *__wrap_alloc_zeroed(size_t n, size_t size);
double *__wrap_alloc_doubles(int n);
int *__wrap_alloc_ints(int n);

void *__wrap_alloc_zeroed(size_t n, size_t size)
{
    allocations++;
    return __real_alloc_zeroed(n, size);
}

double *__wrap_alloc_doubles(int n)
{
    allocations++;
    return __real_alloc_doubles(n);
}

int *__wrap_alloc_ints(int n)
{
    allocations++;
    return __real_alloc_ints(n);
}

/* A small bed with these effects; the file is made and removed here. */
static struct simulation *build(const char *named)
{
    static const char *const rest =
        "mesh = { size = [0.012, 0.024, 0.006]; cells = [4, 8, 2]; };\n"
        "fluid = { density = 1.2; viscosity = 1.8e-5; step = 2e-4;\n"
        "  bottom = { inlet = 0.5; }; top = { outlet = 0.0; };\n"
        "  sides = \"slip\"; front_back = \"slip\"; };\n"
        "particles = { contact = \"linear\"; step = 2e-5;\n"
        "  grains = { density = 1000; stiffness = 50.0; restitution = 0.9;\n"
        "             friction = 0.1; };\n"
        "  bed = { count = 100; diameter = 1.2e-3; settle = 0.0; }; };\n"
        "averaging = { method = \"pcm\"; };\n"
        "exchange = { drag = \"gidaspow\"; };\n"
        "output = { end = 1.0; every = 1.0; };\n";
    char path[] = "/tmp/winnow-effects-XXXXXX";
    const int fd = mkstemp(path);
    FILE *const f = fdopen(fd, "w");
    int code;

    fprintf(f, "%s%s", rest, named);
    fclose(f);
    struct settings *const s = case_file_read(path, 0, NULL, &code);
    remove(path);
    ck_assert_ptr_nonnull(s);
    allocations = 0;
    struct simulation *const sim = build_simulation(s, &code);
    ck_assert_ptr_nonnull(sim);
    settings_free(s);
    return sim;
}

/* Which, by name, in any order of the case's list. */
FACT(a_case_has_the_effects_that_it_names_and_no_others)
{
    static const struct {
        const char *named, *has;
    } cases[] = {
        {"", ""},
        {"effects = { };\n", ""},
        {"effects = { gravity = [0.0, -9.81, 0.0]; };\n", "gravity"},
        {"effects = { pressure_gradient = {}; };\n", "pressure_gradient"},
        {"effects = { viscous_stress = {}; };\n", "viscous_stress"},
        {"effects = { time_average = { time = 0.1; }; };\n", "time_average"}};

    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct simulation *const sim = build(cases[i].named);
        const int n = cases[i].has[0] != '\0';

        ck_assert_int_eq(sim->n_effects, n);
        ck_assert_int_eq(sim->effects != NULL, n);
        if (n > 0) ck_assert_str_eq(sim->effects[0].effect->name, cases[i].has);
        build_free(sim);
    }
}

static int calls_before, calls_after;

static void spy_before(void *memory, struct simulation *sim)
{
    (void)memory;
    (void)sim;
    calls_before++;
}

static void spy_after(void *memory, struct simulation *sim)
{
    (void)memory;
    (void)sim;
    calls_after++;
}

/* The loop calls effects only through its list: one call a step and hook for an
 * effect in the list, none for others, none where the hook is missing. */
FACT(an_effect_that_is_not_named_is_never_called)
{
    static const struct effect both = {
        .name = "spy", .before_particles = spy_before, .after_step = spy_after};
    static const struct effect after = {.name = "spy", .after_step = spy_after};
    struct effect_state list[2] = {{.effect = &both}, {.effect = &after}};
    struct simulation *const sim = build("");
    ck_assert_int_eq(sim->n_effects, 0);
    ck_assert_ptr_null(sim->effects);
    ck_assert_int_eq(coupling_start(sim), 0);
    for (int i = 0; i < 3; i++)
        ck_assert_int_eq(coupling_step(sim), 0);
    ck_assert_int_eq(calls_before + calls_after, 0);
    sim->effects = list;
    sim->n_effects = 2;
    for (int i = 0; i < 3; i++)
        ck_assert_int_eq(coupling_step(sim), 0);
    ck_assert_int_eq(calls_before, 3);
    ck_assert_int_eq(calls_after, 6);
    sim->effects = NULL;
    sim->n_effects = 0;
    build_free(sim);
}

/* The lists of pairs grow until they fit, nothing else; after some steps they
 * do. */
FACT(a_step_allocates_nothing)
{
    struct simulation *const sim =
        build("effects = { gravity = [0.0, -9.81, 0.0];\n"
              "  pressure_gradient = {}; time_average = { time = 0.1; }; };\n");
    ck_assert_int_eq(coupling_start(sim), 0);
    for (int i = 0; i < 300; i++)
        ck_assert_int_eq(coupling_step(sim), 0);
    allocations = 0;
    for (int i = 0; i < 100; i++)
        ck_assert_int_eq(coupling_step(sim), 0);
    ck_assert_int_eq(allocations, 0);
    build_free(sim);
}

FACT(every_effect_is_known_by_its_name_and_has_a_row)
{
    for (int i = 0; effects[i] != NULL; i++) {
        char path[64];
        snprintf(path, sizeof path, "effects.%s", effects[i]->name);
        ck_assert_ptr_eq(effect_named(effects[i]->name), effects[i]);
        ck_assert_str_eq(effects[i]->keys[0]->path, path);
    }
    ck_assert_ptr_null(effect_named("magnetism"));
}

/* --- [SX15 11-14] ------------------------------------------------------- */

/* A pulse of one step, of weight dt, is seen at the age t as [SX15 11] has it,
 * dt exp(-t / b_t) / b_t, to the first order in dt / b_t = 0.001. All these
 * weights add up to 1; the line under (11) prints 0. */
FACT(sx15_11_a_value_counts_by_its_age)
{
    const double dt = 1e-3, b_t = 1.0, alpha = time_average_weight(dt, b_t);
    const double pulse = 1.0, nothing = 0.0;
    double mean = 0.0, sum = 0.0;

    time_average_update(alpha, 1, &pulse, &mean);
    for (int n = 0; n < 30000; n++) {
        if (n % 1000 == 0 && n < 5000)
            ck_assert_double_eq_tol(mean / dt, exp(-n * dt / b_t) / b_t, 2e-3);
        sum += mean;
        time_average_update(alpha, 1, &nothing, &mean);
    }
    ck_assert_double_eq_tol(sum, 1.0, 1e-12);
}

FACT(sx15_14_weight_is_one_over_one_plus_dt_over_b)
{
    ck_assert_double_eq_tol(time_average_weight(0.1, 0.4), 0.8, 1e-15);
    ck_assert_double_eq_tol(time_average_weight(0.0, 0.4), 1.0, 1e-15);
}

/* A constant stays; a step is followed as implicit Euler follows [SX15 13]:
 * after n steps 1 - alpha^n, which tends to 1 - exp(-t / b) with order one. */
FACT(sx15_13_mean_follows_a_step_with_order_one)
{
    double error[2];
    for (int k = 0; k < 2; k++) {
        const int n = k == 0 ? 50 : 100;
        const double alpha = time_average_weight(1.0 / n, 0.5), one = 1.0;
        double mean = 0.0, still = 1.0;
        for (int i = 0; i < n; i++) {
            time_average_update(alpha, 1, &one, &mean);
            time_average_update(alpha, 1, &one, &still);
        }
        ck_assert_double_eq_tol(still, 1.0, 1e-14);
        error[k] = mean - (1.0 - exp(-1.0 / 0.5));
    }
    ck_assert_double_eq_tol(log2(error[0] / error[1]), 1.0, 0.03);
}
