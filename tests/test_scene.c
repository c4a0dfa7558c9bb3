/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/capillary.h"
#include "particles/electrostatic.h"
#include "scene/case_cohesion.h"
#include "scene/case_materials.h"
#include "scene/check.h"
#include "scene/lines.h"
#include "scene/list.h"
#include "scene/models.h"
#include "scene/rows.h"
#include "scene/scene.h"

#include "capture.h"

#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char said[CAPTURE_TEXT];

static struct settings *read_case(const char *file, const char *override,
                                  int *code)
{
    const char *const overrides[] = {override};
    struct capture c = capture_begin(2);
    struct settings *const s =
        scene_read(file, override != NULL, overrides, code);

    capture_end(&c, said);
    return s;
}

static void refused(const char *override, const char *part)
{
    int code;

    ck_assert_ptr_null(read_case("cases/mueller-bed.cfg", override, &code));
    ck_assert_int_eq(code, 2);
    ck_assert_msg(strstr(said, part) != NULL, "no \"%s\" in %s", part, said);
}

START_TEST(the_cases_are_right)
{
    static const char *const cases[] = {
        "cases/mueller-bed.cfg", "cases/small-bed.cfg",
        "cases/settling-sphere.cfg", "cases/packed-column.cfg",
        "cases/tapered-bed.cfg"};

    for (int i = 0; i < 5; i++) {
        int code;
        struct settings *const s = read_case(cases[i], NULL, &code);

        ck_assert_msg(s != NULL, "%s", said);
        ck_assert_int_eq(code, 0);
        settings_free(s);
    }
}
END_TEST

START_TEST(something_must_be_there_to_compute)
{
    FILE *const f = fopen("/tmp/winnow-empty.cfg", "w");
    int code;

    fputs("mesh = { size = [1, 1, 1]; cells = [1, 1, 1]; };\n"
          "output = { end = 1; every = 1; };\n",
          f);
    fclose(f);
    ck_assert_ptr_null(read_case("/tmp/winnow-empty.cfg", NULL, &code));
    remove("/tmp/winnow-empty.cfg");
    ck_assert_int_eq(code, 2);
    ck_assert_ptr_nonnull(strstr(said, "neither fluid nor particles"));
}
END_TEST

START_TEST(each_side_of_the_box_is_described_once)
{
    refused("fluid.left=slip", "left is given twice, by left and sides");
    refused("mesh.periodic=[true,false,false]", "x is periodic");
    refused("mesh.periodic=[false,false,true]", "no front_back");
    refused("fluid={density=1;viscosity=1;step=1;}", "the side left");
}
END_TEST

START_TEST(sizes_are_possible_and_known_by_their_names)
{
    static const char two[] =
        "particles.sizes=({name=\"sand\";distribution=\"uniform\";"
        "least=1e-3;most=2e-3;},{name=\"grit\";distribution=\"normal\";"
        "mean=1e-3;deviation=1e-4;least=5e-4;most=2e-3;})";
    const char *const overrides[] = {
        two, "particles.bed={count=2000;sizes=\"sand\";}",
        "particles.bed.sizes=snad"};
    int code;

    refused("particles.integrator=heun", "goes without a fluid");
    refused("particles.bed={count=3;}", "give either diameter or sizes");
    refused("particles.bed.sizes=sand", "not both");
    refused("particles.sizes=({name=\"a\";distribution=\"normal\";})",
            "a, which is normal: it asks for mean");
    refused("particles.sizes=({name=\"a\";distribution=\"gauss\";})",
            "expected");
    struct settings *const s =
        scene_read("cases/mueller-bed.cfg", 2, overrides, &code);
    ck_assert_ptr_nonnull(s);
    settings_free(s);
    struct capture c = capture_begin(2);
    ck_assert_ptr_null(
        scene_read("cases/mueller-bed.cfg", 3, overrides, &code));
    capture_end(&c, said);
    ck_assert_ptr_nonnull(strstr(said, "did you mean sand"));
}
END_TEST

START_TEST(what_flows_in_must_be_able_to_flow_out)
{
    refused("fluid.top=slip", "there is an inlet and no outlet");
}
END_TEST

START_TEST(average_is_no_wider_than_the_mesh_by_far)
{
    refused("averaging.bandwidth=1e10", "1e+10 m is more than 10 times");
    refused("averaging={method=\"images\";delta_05=1e10;}",
            "averaging.delta_05: 1e+10 m is more than 10 times");
    refused("averaging={method=\"two-grid\";bandwidth=1e-9;}",
            "a second grid of cells of 1e-09 m would have");
}
END_TEST

START_TEST(whole_number_is_written_without_point_or_exponent)
{
    refused("particles.bed.count=1e12",
            "at most 2147483647 and without point or exponent");
    refused("particles.bed.count=1000000000000", "at most 2147483647");
    refused("mesh.cells=[1e3, 1e3, 1.0]", "without point or exponent");
}
END_TEST

START_TEST(sink_without_a_side_asks_for_a_region)
{
    refused("particles.sinks=({side=\"none\";})",
            "sink 0: give either side, or from and to");
}
END_TEST

START_TEST(every_profile_has_a_file_of_its_own)
{
    static const char two[] =
        "output.profiles=({field=\"eps_f\";height=0.0164;},"
        "{field=\"eps_f\";height=0.0164;from=1.0;})";
    char name[LINES_NAME];
    int code;

    struct settings *const s = read_case("cases/mueller-bed.cfg", two, &code);
    ck_assert_ptr_nonnull(s);
    lines_name(s, 0, name);
    ck_assert_str_eq(name, "eps_f_y16.4mm");
    lines_name(s, 1, name);
    ck_assert_str_eq(name, "eps_f_y16.4mm_from1s");
    settings_free(s);
    refused("output.profiles=({field=\"p\";height=0.01;from=1.0;},"
            "{field=\"p\";height=0.01;},{field=\"p\";height=0.01;})",
            "profiles 1 and 2 are of the same field");
}
END_TEST

START_TEST(contact_law_asks_for_its_constants)
{
    refused("particles.contact=linear",
            "linear asks for particles.grains.stiffness");
    refused("particles.grains={density=1;restitution=1;friction=0;}",
            "hertz asks for particles.grains.young");
}
END_TEST

#define STEEL                                                                  \
    "{name=\"steel\";young=2e11;poisson=0.3;restitution=0.9;friction=0.3;}"

START_TEST(materials_are_known_by_their_names)
{
    refused("particles.walls={material=\"grain\";}", "did you mean grains?");
    refused("particles.walls={material=\"\";}", "no material");
    refused("particles.materials=({name=\"steel\";restitution=1;friction=0;})",
            "hertz asks for the young of steel");
    refused("particles.materials=(" STEEL "," STEEL ")",
            "the name steel is given twice");
    refused("particles.pairs=({between=\"grains\";and=\"grains\";})",
            "particles.pairs needs particles.materials");
    refused("particles.materials=({name=\"grains\";young=1.0;poisson=0.3;"
            "restitution=1;friction=0;})",
            "the name grains is given twice");
}
END_TEST

/* What a case says of its materials is what the particles are made of. */
START_TEST(materials_of_a_case_reach_the_particles)
{
    const char *const overrides[] = {
        "particles.materials=(" STEEL ")",
        "particles.walls={material=\"steel\";}",
        "particles.pairs=({between=\"steel\";and=\"grains\";friction=0.7;})"};
    int code;
    struct settings *const s =
        scene_read("cases/mueller-bed.cfg", 3, overrides, &code);

    ck_assert_ptr_nonnull(s);
    struct materials *const all = case_materials_create(s);
    ck_assert_int_eq(all->n, 2);
    ck_assert_int_eq(all->wall, 1);
    ck_assert_double_eq(all->further[0].young, 2e11);
    ck_assert_int_eq(all->n_measured, 1);
    ck_assert_int_eq(all->measured[0].a, 1);
    ck_assert_int_eq(all->measured[0].b, 0);
    ck_assert_double_eq(all->measured[0].friction, 0.7);
    ck_assert_double_lt(all->measured[0].restitution, 0.0);
    free(all);
    settings_free(s);
}
END_TEST

START_TEST(cohesion_is_complete_and_possible)
{
    refused("effects.electrostatic={range=1e-3;}", "no material has a charge");
    refused("particles.grains.charge=1e-12",
            "particles.grains.charge needs effects.electrostatic");
    refused("effects.van_der_waals={hamaker=1e-19;range=1e-10;}",
            "longer than the closest gap, 4e-10 m");
    refused("effects.van_der_waals={hamaker=1e-19;}",
            "effects.van_der_waals.range is missing");
    refused("effects.capillary={tension=0.07;angle=2.0;}",
            "expected a number >= 0, < 1.5707963 [rad]");
}
END_TEST

/* What a case says of its cohesion is what acts, in the order of the effects.
 */
START_TEST(cohesion_of_a_case_reaches_the_particles)
{
    const char *const overrides[] = {
        ("effects.capillary={tension=0.07;angle=1.0471975511965976;"
         "range=1e-4;harmonic=true;}"),
        "effects.electrostatic={range=2e-3;permittivity=3.0;}",
        "particles.grains.charge=-4e-12"};
    int code, n;
    struct settings *const s =
        scene_read("cases/mueller-bed.cfg", 3, overrides, &code);

    ck_assert_ptr_nonnull(s);
    struct attraction *const a = case_cohesion_create(s, &n);
    ck_assert_int_eq(n, 2);
    ck_assert_ptr_eq(a[0].law, &electrostatic);
    ck_assert_double_eq(a[0].range, 2e-3);
    ck_assert_double_eq(a[0].strength, 3.0);
    ck_assert_double_eq(a[0].charge[0], -4e-12);
    ck_assert_ptr_eq(a[1].law, &capillary);
    ck_assert_double_eq_tol(a[1].strength, 0.035, 1e-12);
    ck_assert_double_eq(a[1].range, 1e-4);
    ck_assert_int_eq(a[1].harmonic, 1);
    free(a);
    settings_free(s);
}
END_TEST

START_TEST(bed_must_fit_into_the_box)
{
    refused("particles.bed.diameter=0.02", "more than the box has room for");
    refused("particles.bed.count=100000", "would fill 171 % of the box");
    refused("particles.place=({position=[0.01,0.01,0.01];diameter=1e-3;})",
            "not both");
}
END_TEST

START_TEST(averaging_by_a_width_asks_for_one)
{
    refused("averaging={method=\"kernel\";}", "asks for averaging.bandwidth");
}
END_TEST

START_TEST(profiles_lie_inside_the_box)
{
    refused("output.profiles.0.height=0.2", "above the box");
}
END_TEST

START_TEST(probes_lie_inside_the_box)
{
    refused("output.probes=({field=\"p\"; position=[0.01,0.13,0.0];})",
            "the point [0.01, 0.13, 0] m is outside the box");
}
END_TEST

START_TEST(empty_bed_and_missing_inlet_are_allowed)
{
    int code;
    struct settings *s =
        read_case("cases/mueller-bed.cfg", "particles.bed.count=0", &code);

    ck_assert_msg(s != NULL, "%s", said);
    settings_free(s);
    s = read_case("cases/mueller-bed.cfg", "fluid.bottom=no-slip", &code);
    ck_assert_msg(s != NULL, "%s", said);
    settings_free(s);
}
END_TEST

START_TEST(numbers_of_an_effect_come_in_the_order_of_its_keys)
{
    static const struct key keys[] = {
        {"effects", KEY_GROUP, "", "", "", "", "", ""},
        {"effects.gravity", KEY_VECTOR, "m/s^2", "", "", "", "", ""},
        {"fluid.density", KEY_REAL, "kg/m^3", "", "", "", "", ""},
        {"fluid.correctors", KEY_INT, "-", "", "", "", "", ""},
        {NULL, KEY_GROUP, NULL, NULL, NULL, NULL, NULL, NULL}};
    int code;
    double x[5];
    struct settings *const s = read_case("cases/mueller-bed.cfg", NULL, &code);

    ck_assert_msg(s != NULL, "%s", said);
    ck_assert_int_eq(scene_parameters(s, keys, x, 5), 5);
    ck_assert_double_eq(x[1], -9.81);
    ck_assert_double_eq(x[3], 1.2);
    ck_assert_double_eq(x[4], 2.0);
    settings_free(s);
}
END_TEST

/* The words that a key allows are the names of the models of its kind, and
 * each model reads keys that there are. */
START_TEST(models_and_keys_name_the_same)
{
    const struct key *tables[SCENE_TABLES];
    struct model m;

    scene_tables(tables);
    for (const struct kind *k = models_kinds; k->name != NULL; k++) {
        const struct key *const key = rows_find(tables, k->key);
        char words[ROWS_TEXT] = "";

        for (int i = 0; k->model(i, &m); i++) {
            char path[64];
            int used;

            snprintf(words + strlen(words), sizeof words - strlen(words),
                     "%s%s", i > 0 ? " | " : "", m.name);
            ck_assert_msg(m.what[0] != '\0' && m.function[0] != '\0', "%s",
                          m.name);
            for (const char *p = m.keys; sscanf(p, "%63s%n", path, &used) == 1;
                 p += used)
                ck_assert_msg(strstr(path, "<patch>") != NULL ||
                                  rows_find(tables, path) != NULL,
                              "%s", path);
        }
        if (key != NULL && key->type == KEY_NAME)
            ck_assert_str_eq(words, key->allowed);
    }
}
END_TEST

START_TEST(list_shows_every_model_and_key)
{
    struct capture c = capture_begin(1);
    const struct key *tables[SCENE_TABLES];
    const struct key *key;
    struct model m;

    list_kinds();
    for (const struct kind *k = models_kinds; k->name != NULL; k++)
        ck_assert_int_eq(list_models(k->name), 0);
    capture_end(&c, said);
    for (const struct kind *k = models_kinds; k->name != NULL; k++)
        for (int i = 0; k->model(i, &m); i++) {
            ck_assert_ptr_nonnull(strstr(said, m.name));
            ck_assert_ptr_nonnull(strstr(said, m.what));
        }

    c = capture_begin(1);
    ck_assert_int_eq(list_models("keys"), 0);
    capture_end(&c, said);
    scene_tables(tables);
    for (int i = 0; (key = rows_at(tables, i)) != NULL; i++) {
        ck_assert_ptr_nonnull(strstr(said, key->path));
        ck_assert_ptr_nonnull(strstr(said, key->what));
    }
}
END_TEST

/* The bed of SX15 Table 1, mesh C: 44 x 120 x 10 mm in 18 x 50 x 4 cells. They
 * print S_c / d_p = 2 for it, rounded. */
START_TEST(sx15_10_the_size_of_a_cell_is_the_root_of_its_volume)
{
    int code;
    struct settings *const s = read_case("cases/mueller-bed.cfg", NULL, &code);
    struct capture c = capture_begin(1);
    double S_c = 0.0;

    ck_assert_int_eq(check_case(s), 0);
    capture_end(&c, said);
    const char *const line = strstr(said, "  S_c ");
    ck_assert_ptr_nonnull(line);
    ck_assert_int_eq(sscanf(line, " S_c %lf m", &S_c), 1);
    ck_assert_double_eq_tol(S_c, cbrt(44e-3 / 18 * 120e-3 / 50 * 10e-3 / 4),
                            1e-6); /* four digits are printed */
    ck_assert_double_eq_tol(S_c / 1.2e-3, 2.0, 0.05);
    settings_free(s);
}
END_TEST

int main(void)
{
    Suite *const s = suite_create("scene");
    TCase *const t = tcase_create("core");
    SRunner *r;
    int failed;

    suite_add_tcase(s, t);
    tcase_add_test(t, the_cases_are_right);
    tcase_add_test(t, sx15_10_the_size_of_a_cell_is_the_root_of_its_volume);
    tcase_add_test(t, something_must_be_there_to_compute);
    tcase_add_test(t, each_side_of_the_box_is_described_once);
    tcase_add_test(t, sizes_are_possible_and_known_by_their_names);
    tcase_add_test(t, what_flows_in_must_be_able_to_flow_out);
    tcase_add_test(t, average_is_no_wider_than_the_mesh_by_far);
    tcase_add_test(t, whole_number_is_written_without_point_or_exponent);
    tcase_add_test(t, sink_without_a_side_asks_for_a_region);
    tcase_add_test(t, every_profile_has_a_file_of_its_own);
    tcase_add_test(t, contact_law_asks_for_its_constants);
    tcase_add_test(t, materials_are_known_by_their_names);
    tcase_add_test(t, materials_of_a_case_reach_the_particles);
    tcase_add_test(t, cohesion_is_complete_and_possible);
    tcase_add_test(t, cohesion_of_a_case_reaches_the_particles);
    tcase_add_test(t, bed_must_fit_into_the_box);
    tcase_add_test(t, averaging_by_a_width_asks_for_one);
    tcase_add_test(t, profiles_lie_inside_the_box);
    tcase_add_test(t, probes_lie_inside_the_box);
    tcase_add_test(t, empty_bed_and_missing_inlet_are_allowed);
    tcase_add_test(t, numbers_of_an_effect_come_in_the_order_of_its_keys);
    tcase_add_test(t, models_and_keys_name_the_same);
    tcase_add_test(t, list_shows_every_model_and_key);
    r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed != 0;
}
