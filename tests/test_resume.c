/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A simulation that is saved, built anew and loaded goes on with the same bits,
 * whatever the case has. The effects are those that there are: a new one is
 * tested here as soon as it is in its models.txt. */
#include "coupling/effects.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "case/build.h"
#include "case/case_file.h"
#include "case/resume/resume.h"
#include "coupling/coupling.h"
#include "facts.h"
#include "kept.h"

enum { STEPS = 4, N_EFFECTS = 32, TEXT = 512 };

/* Values of keys that have no default, by the last part of their paths. */
static const char *const required[][2] = {
    {"time", "2e-3"},      {"range", "2e-5"},      {"hamaker", "1e-19"},
    {"tension", "0.01"},   {"roughness", "1e-6"},  {"sigma_low", "0.2"},
    {"sigma_high", "0.2"}, {"height", "0.01"},     {"sample", "4e-3"},
    {"pressure", "10.0"},  {"restitution", "0.9"}, {NULL, NULL}};

static const char *value_of(const char *path)
{
    const char *const last = strrchr(path, '.') + 1;

    for (int i = 0; required[i][0] != NULL; i++)
        if (strcmp(required[i][0], last) == 0) return required[i][1];
    ck_abort_msg("%s has no default: give it a value in test_resume.c", path);
    return NULL;
}

/* "basset = { tolerance = 1e-2; };" */
static void name_effect(const struct effect *e, char text[TEXT])
{
    const struct key *k = e->keys[0];

    if (k->type != KEY_GROUP) {
        snprintf(text, TEXT, "%s = [1.0, -9.0, 0.5];", e->name);
        return;
    }
    snprintf(text, TEXT, "gravity = [1.0, -9.0, 0.5]; %s%s = { ",
             strncmp(e->name, "collision_", 10) == 0
                 ? "particle_stress = { pressure = 10.0; }; "
                 : "",
             e->name);
    for (k++; k->path != NULL; k++)
        if (k->fallback == NULL)
            snprintf(text + strlen(text), TEXT - strlen(text), "%s = %s; ",
                     strrchr(k->path, '.') + 1, value_of(k->path));
    snprintf(text + strlen(text), TEXT - strlen(text), "};");
}

static struct simulation *build(const char *fluid, const char *effect_named)
{
    char path[] = "/tmp/winnow-resume-XXXXXX";
    const int fd = mkstemp(path);
    FILE *const f = fdopen(fd, "w");
    int code;

    fprintf(f,
            "mesh = { size = [0.012, 0.024, 0.006]; cells = [4, 8, 2]; };\n"
            "fluid = { density = 1.2; viscosity = 1.8e-5; step = 2e-4;\n"
            "  bottom = { inlet = 0.8; }; top = { outlet = 0.0; };\n"
            "  sides = \"slip\"; front_back = \"no-slip\"; %s };\n"
            "particles = { contact = \"linear\"; step = %s;\n"
            "  grains = { density = 1000; stiffness = 50.0; restitution = 0.9;"
            "    friction = 0.3; rolling_friction = 0.1; %s };\n"
            "  insert = ( { count = 40; diameter = 1e-3; rate = 1e4;\n"
            "    from = [0.0, 0.012, 0.0]; to = [0.012, 0.024, 0.006]; } );\n"
            "  bed = { count = 100; diameter = 1.2e-3; settle = 0.0; }; };\n"
            "averaging = { method = \"diffusion\"; bandwidth = 4e-3; };\n"
            "exchange = { drag = \"gidaspow\"; };\n"
            "effects = { %s };\n"
            "output = { end = 1.0; every = 1.0; };\n",
            fluid,
            strstr(effect_named, "particle_stress") ? "2e-4; list = \"none\""
                                                    : "2e-5",
            strstr(effect_named, "electro") ? "charge = 1e-12;" : "",
            effect_named);
    fclose(f);
    struct settings *const s = case_file_read(path, 0, NULL, &code);
    remove(path);
    ck_assert_msg(s != NULL, "no case: %s", effect_named);
    struct simulation *const sim = build_simulation(s, &code);
    ck_assert_ptr_nonnull(sim);
    settings_free(s);
    return sim;
}

static void go(struct simulation *sim)
{
    for (int i = 0; i < STEPS; i++)
        ck_assert_int_eq(coupling_step(sim), 0);
}

static struct kept *saved(struct simulation *sim)
{
    struct kept *const kept = kept_create();

    ck_assert_int_eq(simulation_state(sim, &kept->state), 0);
    return kept;
}

/* All but the seconds of the wall clock. */
static void assert_same(const struct kept *a, const struct kept *b)
{
    ck_assert_int_eq(a->n, b->n);
    for (int i = 0; i < a->n; i++) {
        if (strstr(a->array[i].path, "seconds") != NULL) continue;
        ck_assert_str_eq(a->array[i].path, b->array[i].path);
        ck_assert_int_eq((int)a->array[i].size, (int)b->array[i].size);
        ck_assert_msg(
            memcmp(a->array[i].bytes, b->array[i].bytes, a->array[i].size) == 0,
            "%s has other bits", a->array[i].path);
    }
}

static void goes_on_with_the_same_bits(const char *fluid, const char *named)
{
    struct simulation *const a = build(fluid, named);

    ck_assert_int_eq(coupling_start(a), 0);
    go(a);
    struct kept *const half = saved(a);
    struct simulation *const b = build(fluid, named);
    ck_assert_int_eq(simulation_state(b, kept_load(half)), 0);
    go(a);
    go(b);
    struct kept *const end_a = saved(a), *const end_b = saved(b);
    assert_same(end_a, end_b);
    kept_free(half);
    kept_free(end_a);
    kept_free(end_b);
    build_free(a);
    build_free(b);
}

FACT_FOR_EACH(a_simulation_with_any_effect_goes_on_with_the_same_bits,
              N_EFFECTS)
{
    char text[TEXT];

    for (int i = 0; i <= _i; i++)
        if (effects[i] == NULL) return;
    name_effect(effects[_i], text);
    goes_on_with_the_same_bits("", text);
}

FACT(no_effect_is_left_out)
{
    int n = 0;

    while (effects[n] != NULL)
        n++;
    ck_assert_int_le(n, N_EFFECTS);
}

FACT_FOR_EACH(a_flow_with_any_past_goes_on_with_the_same_bits, 4)
{
    static const char *const flows[] = {
        "time = \"bdf2\";", "convection = \"linear\";",
        "time = \"bdf2\"; convection = \"van-leer\"; outer_correctors = 1;",
        "continuity = \"void-rate\";"};

    goes_on_with_the_same_bits(
        flows[_i], "gravity = [0.0, -9.8, 0.0]; pressure_gradient = {};");
}

/* A mark is that of the whole name of a key, and of what is within it. */
FACT(keys_say_what_may_change_and_what_comes_after_the_bed)
{
    static const struct {
        const char *line;
        unsigned mark;
    } keys[] = {{"title = \"\"", KEY_MAY_CHANGE | KEY_AFTER_BED},
                {"output.end = 1.0", KEY_MAY_CHANGE | KEY_AFTER_BED},
                {"output.ending = 1.0", KEY_AFTER_BED},
                {"output.probes.0.field = \"p\"", KEY_AFTER_BED},
                {"ranks = [2, 1, 1]", KEY_MAY_CHANGE},
                {"fluid.left.inlet = 1.0", KEY_AFTER_BED},
                {"mesh.cells = [4, 4, 4]", KEY_AFTER_BED},
                {"mesh.size = [1.0, 1.0, 1.0]", 0},
                {"particles.step = 1e-5", KEY_AFTER_BED},
                {"particles.insert.0.rate = 1.0", KEY_AFTER_BED},
                {"particles.bed.count = 9", 0},
                {"effects.gravity = [0.0, -9.81, 0.0]", 0}};

    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        for (unsigned m = KEY_MAY_CHANGE; m <= KEY_AFTER_BED; m *= 2)
            ck_assert_msg(case_text_is(keys[i].line, m) ==
                              ((keys[i].mark & m) != 0),
                          "mark %u of %s", m, keys[i].line);
}

/* A visit that notes which memory it has seen. */
struct seen {
    struct state state;
    int n;
    const double *begin[KEPT_MOST];
    long length[KEPT_MOST];
};

static int note(void *store, const struct state_array *a)
{
    struct seen *const s = store;

    s->begin[s->n] = a->values;
    s->length[s->n++] = a->rows * a->width;
    return 0;
}

/* What an effect has written as a field of the cells is read in the next
 * picture, before which no step need have set it anew. */
FACT(every_field_that_an_effect_shows_is_visited)
{
    struct simulation *const sim =
        build("", "time_average = { time = 0.01; };");
    struct seen *const s = alloc_zeroed(1, sizeof *s);
    int shown = 0;

    s->state.visit = note;
    s->state.store = s;
    simulation_state(sim, &s->state);
    for (int i = 0; i < sim->n_effects; i++) {
        const struct effect_state *const e = &sim->effects[i];
        struct effect_field f[EFFECT_FIELDS];
        const int n =
            e->effect->fields == NULL ? 0 : e->effect->fields(e->memory, f);
        for (int k = 0; k < n; k++, shown++) {
            int found = 0;
            for (int q = 0; q < s->n; q++)
                found |=
                    s->begin[q] == f[k].values &&
                    s->length[q] == (long)f[k].components * sim->mesh->n_cells;
            ck_assert_msg(found, "%s is not visited", f[k].name);
        }
    }
    ck_assert_int_eq(shown, 2);
    free(s);
    build_free(sim);
}
