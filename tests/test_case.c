/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/averaging.h"
#include "coupling/drag.h"
#include "dem/attraction.h"
#include "dem/contact.h"
#include "dem/surfaces/surface.h"
#include "case/build.h"
#include "case/particles/case_materials.h"
#include "case/case_mesh.h"
#include "tell/check.h"
#include "record/recorder_part.h"
#include "case/resume/resume.h"
#include "case/models.h"
#include "case/schema.h"
#include "case/case_file.h"
#include "case/settings.h"

#include "facts.h"
#include "capture.h"
#include "scratch.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static char said[CAPTURE_TEXT];

static struct settings *read_case(const char *file, const char *override,
                                  int *code)
{
    const char *const overrides[] = {override};
    struct capture c = capture_begin(2);
    struct settings *const s =
        case_file_read(file, override != NULL, overrides, code);

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

FACT(the_cases_are_right)
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

FACT(something_must_be_there_to_compute)
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

FACT(each_side_of_the_box_is_described_once)
{
    refused("fluid.left=slip", "left is given twice, by left and sides");
    refused("mesh.periodic=[true,false,false]", "x is periodic");
    refused("mesh.periodic=[false,false,true]", "no front_back");
    refused("fluid={density=1;viscosity=1;step=1;}", "the side left");
}

FACT(sizes_are_possible_and_known_by_their_names)
{
    static const char two[] =
        "particles.sizes=({name=\"sand\";distribution=\"uniform\";"
        "min=1e-3;max=2e-3;},{name=\"grit\";distribution=\"normal\";"
        "mean=1e-3;deviation=1e-4;min=5e-4;max=2e-3;})";
    const char *const overrides[] = {
        two, "particles.bed={count=2000;sizes=\"sand\";}",
        "particles.bed.sizes=snad"};
    int code;

    refused("particles.integrator=heun", "is for cases without exchange");
    refused("particles.bed={count=3;}", "give either diameter or sizes");
    refused("particles.bed.sizes=sand", "not both");
    refused("particles.sizes=({name=\"a\";distribution=\"normal\";})",
            "a, which is normal: it needs mean");
    refused("particles.sizes=({name=\"a\";distribution=\"gauss\";})",
            "expected");
    struct settings *const s =
        case_file_read("cases/mueller-bed.cfg", 2, overrides, &code);
    ck_assert_ptr_nonnull(s);
    settings_free(s);
    struct capture c = capture_begin(2);
    ck_assert_ptr_null(
        case_file_read("cases/mueller-bed.cfg", 3, overrides, &code));
    capture_end(&c, said);
    ck_assert_ptr_nonnull(strstr(said, "did you mean sand"));
}

/* What the reference loop does not know is refused before a run. */
FACT_FOR_EACH(the_reference_loop_is_refused_what_it_does_not_know, 2)
{
    static const char *const methods[2] = {"particles.list=all-pairs",
                                           "particles.list=link-cells"};
    static const char *const asked[2] = {
        "particles.surfaces=({name=\"floor\";shape=\"plane\";"
        "point=[0.0,0.01,0.0];normal=[0.0,1.0,0.0];})",
        "particles.prescribed=({id=0;velocity=[0.1,0.0,0.0];})"};
    static const char *const why[2] = {"does not support surfaces; verlet does",
                                       "does not support prescribed particles"};

    for (int k = 0; k < 2; k++) {
        const char *const overrides[] = {methods[_i], asked[k]};
        struct capture c = capture_begin(2);
        int code;
        ck_assert_ptr_null(
            case_file_read("cases/small-bed.cfg", 2, overrides, &code));
        capture_end(&c, said);
        ck_assert_int_eq(code, 2);
        ck_assert_msg(strstr(said, why[k]) != NULL, "%s", said);
    }
}

FACT(what_flows_in_must_be_able_to_flow_out)
{
    refused("fluid.top=slip", "there is an inlet and no outlet");
}

FACT(average_is_no_wider_than_the_mesh_by_far)
{
    refused("averaging.bandwidth=1e10", "1e+10 m is more than 10 times");
    refused("averaging={method=\"images\";delta_05=1e10;}",
            "averaging.delta_05: 1e+10 m is more than 10 times");
    refused("averaging={method=\"two-grid\";bandwidth=1e-9;}",
            "a second grid of cells of 1e-09 m would have");
}

FACT(whole_number_is_written_without_point_or_exponent)
{
    refused("particles.bed.count=1e12",
            "at most 2147483647 and without point or exponent");
    refused("particles.bed.count=1000000000000", "at most 2147483647");
    refused("mesh.cells=[1e3, 1e3, 1.0]", "without point or exponent");
}

FACT(cells_are_of_a_size_that_can_be_computed)
{
    refused("mesh.grading=[1.0,1e-12,1.0]",
            "the widest cell is 1e+12 times the narrowest in y; at most 1e+06");
    refused("mesh.grading=[1.0,1e-300,1.0]", "between 1e-30 and 1e+30 [-]");
    refused("mesh.size=[1e300,1e300,1e300]", "between 1e-12 and 1e+12 [m]");
    refused("mesh.size=[1e-60,1.0,1.0]", "between 1e-12 and 1e+12 [m]");
}

/* Half of the smallest double has no square and no reciprocal. */
FACT(numbers_have_magnitudes_that_their_units_can_have)
{
    refused("particles.bed.diameter=4.9e-324",
            "particles.bed.diameter: expected 0 or a magnitude between 1e-12 "
            "and 1e+12 [m], found 4.94066e-324");
    refused("fluid.bottom.inlet=4.9e-324", "between 1e-20 and 3e+08 [m/s]");
    refused("fluid.bottom.inlet=((0.0,0.0),(1e300,1e9))", "[m/s], found 1e+09");
    refused("fluid.density=1e300", "between 1e-12 and 1e+20 [kg/m^3]");
    refused("effects.gravity=[0.0,-1e200,0.0]", "found -1e+200");
    refused("mesh.size=[1.0,1e-300,1.0]", "[m], found 1e-300");
    refused("particles.grains.young=1e-300", "between 1e-30 and 1e+30 [Pa]");
}

/* As scripts write them: the cosine of a right angle. */
FACT(what_rounding_leaves_of_a_0_is_a_direction_still)
{
    int code;
    settings_free(read_case("cases/mueller-bed.cfg",
                            "effects.gravity=[6e-317,-9.81,6e-17]", &code));
    ck_assert_int_eq(code, 0);
}

FACT(sink_without_a_side_requires_a_region)
{
    refused("particles.sinks=({side=\"none\";})",
            "sink 0: give either side, or from and to");
}

static void put_text(const char *path, const char *text)
{
    FILE *const f = fopen(path, "w");

    fputs(text, f);
    fclose(f);
}

/* The files may go as soon as the case is read. */
FACT(files_that_a_case_names_are_read_once)
{
    char dir[64];
    int code;

    scratch_make(dir);
    put_text(scratch_path(dir, "floor.stl"),
             "solid\nfacet normal 0 1 0\nouter loop\nvertex 0 0.1 0\n"
             "vertex 0 0.1 9\nvertex 9 0.1 0\nendloop\nendfacet\nendsolid\n");
    put_text(scratch_path(dir, "grains.txt"), "0.5 0.5 0.5 0.1\n");
    put_text(scratch_path(dir, "case.cfg"),
             "mesh = { size = [1, 1, 1]; cells = [1, 1, 1]; };\n"
             "particles = { contact = \"linear\"; step = 1e-4;\n"
             "grains = { density = 1e3; restitution = 0.5; friction = 0.5;\n"
             "stiffness = 1e3; }; insert = ({ file = \"grains.txt\"; });\n"
             "surfaces = ({ name = \"floor\"; shape = \"stl\";\n"
             "file = \"floor.stl\"; }); };\n"
             "output = { end = 1.0; every = 1.0; };\n");
    struct settings *const s =
        read_case(scratch_path(dir, "case.cfg"), NULL, &code);
    ck_assert_msg(s != NULL, "%s", said);
    char *const before = case_text_lines(s);
    scratch_clear(dir);
    ck_assert_int_eq(build_particles_check(s), 0);
    char *const after = case_text_lines(s);
    ck_assert_str_eq(after, before);
    ck_assert_ptr_nonnull(strstr(after, "insert.0.file = crc32 "));
    ck_assert_ptr_null(strstr(after, "crc32 00000000"));
    free(before);
    free(after);
    settings_free(s);
}

FACT(a_mesh_and_the_profile_of_an_inlet_are_read_once)
{
    char dir[64], copy[256];
    int code;

    scratch_make(dir);
    snprintf(copy, sizeof copy, "cp -R tests/data/poly/one-cell %s/mesh", dir);
    ck_assert_int_eq(system(copy), 0);
    put_text(scratch_path(dir, "u.csv"), "x [m], u\n0, 1\n1, 1\n");
    put_text(scratch_path(dir, "case.cfg"),
             "mesh = { polymesh = \"mesh\"; };\n"
             "fluid = { density = 1.0; viscosity = 1e-5; step = 1e-3;\n"
             "defaultFaces = { inlet = 1.0; profile = \"file\";\n"
             "file = \"u.csv\"; }; top = { outlet = 0.0; };\n"
             "bottom = \"no-slip\"; };\n"
             "output = { end = 1.0; every = 1.0; };\n");
    struct settings *const s =
        read_case(scratch_path(dir, "case.cfg"), NULL, &code);
    ck_assert_msg(s != NULL, "%s", said);
    scratch_clear(dir);
    struct simulation *const sim = build_simulation(s, &code);
    ck_assert_ptr_nonnull(sim);
    char *const lines = case_text_lines(s);
    ck_assert_ptr_null(strstr(lines, "crc32 00000000"));
    ck_assert_ptr_nonnull(strstr(lines, "defaultFaces.file = crc32 "));
    free(lines);
    build_free(sim);
    settings_free(s);
}

FACT(member_of_the_settings_knows_its_key)
{
    int code;
    struct settings *const s = read_case("cases/mueller-bed.cfg", NULL, &code);

    ck_assert_msg(s != NULL, "%s", said);
    ck_assert_str_eq(KEY_OF(s, fluid.cfl), "fluid.cfl");
    ck_assert_str_eq(KEY_OF(s, mesh.box.periodic), "mesh.periodic");
    ck_assert_str_eq(KEY_OF(s, particles.contact), "particles.contact");
    ck_assert_str_eq(KEY_OF(s, particles.has_bed), "particles.bed");
    ck_assert_str_eq(KEY_OF(s, particles.place), "particles.place");
    ck_assert_str_eq(KEY_OF(s, particles.skin), "particles.skin");
    settings_free(s);
}

FACT(source_with_one_corner_reaches_to_the_end_of_the_box)
{
    int code;
    struct settings *const s =
        read_case("cases/mueller-bed.cfg",
                  "particles.insert=({count=1;diameter=1e-3;rate=1.0;"
                  "from=[0.0,0.1,0.0];})",
                  &code);

    ck_assert_msg(s != NULL, "%s", said);
    const struct insertion_options *const o = &s->particles.insert.item[0].of;
    ck_assert_double_eq(o->lo[1], 0.1);
    double lo[3], hi[3];
    case_mesh_ends(s, lo, hi);
    ck_assert_double_eq(o->hi[1], hi[1]);
    settings_free(s);
}

FACT(every_profile_has_a_file_of_its_own)
{
    static const char two[] =
        "output.profiles=({field=\"eps_f\";height=0.0164;},"
        "{field=\"eps_f\";height=0.0164;from=1.0;})";
    char name[PROFILES_NAME];
    int code;

    struct settings *const s = read_case("cases/mueller-bed.cfg", two, &code);
    ck_assert_ptr_nonnull(s);
    profiles_name(&s->output, 0, name);
    ck_assert_str_eq(name, "eps_f_y16.4mm");
    profiles_name(&s->output, 1, name);
    ck_assert_str_eq(name, "eps_f_y16.4mm_from1s");
    settings_free(s);
    refused("output.profiles=({field=\"p\";height=0.01;from=1.0;},"
            "{field=\"p\";height=0.01;},{field=\"p\";height=0.01;})",
            "profiles 1 and 2 are of the same field");
}

FACT(profiles_along_other_directions_have_other_names)
{
    static const char three[] =
        "output.profiles=({field=\"eps_f\";along=\"y\";x=0.011;},"
        "{field=\"eps_f\";along=\"z\";height=0.011;},"
        "{field=\"eps_f\";z=0.005;})";
    static const char *const names[3] = {"eps_f_along_y_x11mm",
                                         "eps_f_along_z_y11mm", "eps_f_z5mm"};
    int code;

    struct settings *const s = read_case("cases/mueller-bed.cfg", three, &code);
    ck_assert_ptr_nonnull(s);
    for (int i = 0; i < 3; i++) {
        char name[PROFILES_NAME];
        profiles_name(&s->output, i, name);
        ck_assert_str_eq(name, names[i]);
    }
    settings_free(s);
    refused("output.profiles=({field=\"p\";along=\"y\";x=0.01;},"
            "{field=\"p\";height=0.01;},{field=\"p\";along=\"y\";x=0.01;},"
            "{field=\"p\";along=\"y\";x=0.01;})",
            "profiles 2 and 3 are of the same field on the same line from the "
            "same time: both would be p_along_y_x10mm_from0s.csv");
}

/* Names are compared by sorting, not each with all others for each: 1,000 of
 * them would take an hour. */
FACT(a_thousand_profiles_are_read_in_a_second_or_two)
{
    static char many[80000];
    size_t at = (size_t)sprintf(many, "output.profiles=(");
    int code;

    for (int i = 0; i < 1000; i++)
        at += (size_t)sprintf(many + at, "%s{field=\"p\";height=%de-5;}",
                              i > 0 ? "," : "", i);
    strcpy(many + at, ")");
    const clock_t start = clock();
    struct settings *const s = read_case("cases/mueller-bed.cfg", many, &code);
    ck_assert_ptr_nonnull(s);
    ck_assert_double_lt((double)(clock() - start) / CLOCKS_PER_SEC, 10.0);
    settings_free(s);
}

FACT(a_profile_has_one_place_beside_its_direction)
{
    refused("output.profiles=({field=\"p\";})",
            "profile 0 goes along x: expected height or z, in m");
    refused("output.profiles=({field=\"p\";height=0.01;z=0.001;})",
            "and not both");
    refused("output.profiles=({field=\"p\";along=\"y\";height=0.01;})",
            "profile 0 goes along y and so has no height; expected x or z");
    refused("output.profiles=({field=\"p\";along=\"z\";})",
            "profile 0 goes along z: expected x or height");
    refused("output.profiles=({field=\"p\";along=\"y\";x=0.05;})",
            "x 0.05 m is beyond the box, 0.044 m");
    refused("output.profiles=({field=\"p\";along=\"y\";z=-1e-9;})",
            "z -1e-09 m is beyond the box, 0 m");
}

FACT(contact_law_requires_its_constants)
{
    refused("particles.contact=linear",
            "linear needs particles.grains.stiffness");
    refused("particles.grains={density=1;restitution=1;friction=0;}",
            "hertz needs particles.grains.young");
}

#define STEEL                                                                  \
    "{name=\"steel\";young=2e11;poisson=0.3;restitution=0.9;friction=0.3;}"

FACT(materials_are_known_by_their_names)
{
    refused("particles.walls={material=\"grain\";}", "did you mean grains?");
    refused("particles.walls={material=\"\";}", "no material");
    refused("particles.materials=({name=\"steel\";restitution=1;friction=0;})",
            "hertz needs the young of steel");
    refused("particles.materials=(" STEEL "," STEEL ")",
            "the name steel is given twice");
    refused("particles.pairs=({between=\"grains\";and=\"grains\";})",
            "particles.pairs needs particles.materials");
    refused("particles.materials=({name=\"grains\";young=1.0;poisson=0.3;"
            "restitution=1;friction=0;})",
            "the name grains is given twice");
}

/* The materials of a case are those of the particles. */
FACT(materials_of_a_case_reach_the_particles)
{
    const char *const overrides[] = {
        "particles.materials=(" STEEL ")",
        "particles.walls={material=\"steel\";}",
        "particles.pairs=({between=\"steel\";and=\"grains\";friction=0.7;})"};
    int code;
    struct settings *const s =
        case_file_read("cases/mueller-bed.cfg", 3, overrides, &code);

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

FACT(cohesion_is_complete_and_possible)
{
    refused("effects.electrostatic={range=1e-3;}", "no material has a charge");
    refused("particles.grains.charge=1e-12",
            "particles.grains.charge needs effects.electrostatic");
    refused("effects.van_der_waals={hamaker=1e-19;range=1e-10;}",
            "longer than the closest gap");
    refused("effects.van_der_waals={hamaker=1e-19;}",
            "effects.van_der_waals.range is missing");
    refused("effects.capillary={tension=0.07;angle=2.0;}",
            "expected a number >= 0, < 1.5707963 [rad]");
}

/* The cohesion of a case acts on the particles, in the order of the effects.
 */
FACT(cohesion_of_a_case_reaches_the_particles)
{
    const char *const overrides[] = {
        ("effects.capillary={tension=0.07;angle=1.0471975511965976;"
         "range=1e-4;harmonic=true;}"),
        "effects.electrostatic={range=2e-3;permittivity=3.0;}",
        "particles.grains.charge=-4e-12"};
    int code, n;
    struct settings *const s =
        case_file_read("cases/mueller-bed.cfg", 3, overrides, &code);

    ck_assert_ptr_nonnull(s);
    struct attraction *const a = case_materials_attractions(s, &n);
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

FACT(bed_must_fit_into_the_box)
{
    refused("particles.bed.diameter=0.02", "larger than the box");
    refused("particles.bed.count=100000", "would fill 171 % of the box");
    refused("particles.place=({position=[0.01,0.01,0.01];diameter=1e-3;})",
            "not both");
}

FACT(averaging_by_a_bandwidth_requires_one)
{
    refused("averaging={method=\"kernel\";}", "needs averaging.bandwidth");
}

FACT(profiles_lie_inside_the_box)
{
    refused("output.profiles.0.height=0.2", "above the box");
}

FACT(probes_lie_inside_the_box)
{
    refused("output.probes=({field=\"p\"; position=[0.01,0.13,0.0];})",
            "the point [0.01, 0.13, 0] m is outside the box");
}

FACT(empty_bed_and_missing_inlet_are_allowed)
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

FACT(numbers_of_an_effect_come_in_the_order_of_its_keys)
{
    static const struct key keys[] = {
        {"effects", KEY_GROUP, "", "", "", "", "", ""},
        {"effects.gravity", KEY_VECTOR, "m/s^2", "", "", "", "", ""},
        {"fluid.density", KEY_REAL, "kg/m^3", "", "", "", "", ""},
        {"fluid.correctors", KEY_INT, "-", "", "", "", "", ""},
        KEY_END};
    int code;
    double x[5];
    struct settings *const s = read_case("cases/mueller-bed.cfg", NULL, &code);

    ck_assert_msg(s != NULL, "%s", said);
    ck_assert_int_eq(fill_numbers(s, keys, x, 5), 5);
    ck_assert_double_eq(x[1], -9.81);
    ck_assert_double_eq(x[3], 1.2);
    ck_assert_double_eq(x[4], 2.0);
    settings_free(s);
}

/* A function that the source defines: at the beginning of a line, or behind its
 * type there. */
static int is_defined(const char *function)
{
    char command[256];

    snprintf(command, sizeof command,
             "grep -rqE '^([a-zA-Z].*[ *])?%s\\(' src --include='*.[ch]'",
             function);
    return system(command) == 0;
}

/* A descriptor says what the model is, where it comes from and which function
 * computes it; its name is a word that the key of its kind allows, and a word
 * that is not among them is refused with all of them. */
FACT(every_descriptor_of_every_kind_is_complete)
{
    const struct key *tables[CASE_FILE_TABLES];
    char expected[SCHEMA_TEXT];
    struct model m;

    case_file_tables(tables);
    for (const struct kind *k = models_kinds; k->name != NULL; k++) {
        const struct key *const key = schema_find(tables, k->key);

        for (int i = 0; models_at(k, i, &m); i++) {
            ck_assert_msg(m.name[0] != '\0' && m.what != NULL &&
                              m.what[0] != '\0' && m.equations != NULL,
                          "%s %s", k->name, m.name);
            ck_assert_msg(m.function != NULL && is_defined(m.function), "%s %s",
                          k->name, m.name);
            if (key == NULL || key->type != KEY_NAME) continue;
            schema_expected(key, expected);
            ck_assert_ptr_nonnull(strstr(expected, m.name));
            ck_assert(schema_allow_word(key, m.name));
            ck_assert(!schema_allow_word(key, m.what));
        }
    }
}

/* A model's own keys are numbers that always have a value, no more than it has
 * room for, and one of the tables that make them known. */
static void check_own_keys(const char *name, const struct key *own,
                           const struct key *const *tables)
{
    int n = 0, listed = 0;

    for (int t = 0; own != NULL && t < KEY_TABLES; t++)
        listed |= tables[t] == own;
    for (const struct key *k = own; k != NULL && k->path != NULL; k++, n++)
        ck_assert_msg((k->type == KEY_REAL || k->type == KEY_INT ||
                       k->type == KEY_BOOL) &&
                          (k->fallback == NULL || k->fallback[0] != '\0'),
                      "%s: %s", name, k->path);
    ck_assert_msg(own == NULL || (listed && n > 0 && n <= MODEL_NUMBERS), "%s",
                  name);
}

/* A law that lacks one of its functions would not be refused, but called. */
FACT(every_law_and_method_has_its_functions)
{
    for (int i = 0; contact_laws[i] != NULL; i++) {
        const struct contact_law *const law = contact_laws[i];
        ck_assert_msg(law->constants != NULL && law->duration != NULL &&
                          law->wave_time != NULL && law->respond != NULL,
                      "%s", law->name);
    }
    for (int i = 0; drag_laws[i] != NULL; i++) {
        const struct drag_law *const law = drag_laws[i];
        ck_assert_msg(
            (law->own_keys != NULL) == (law->resistance_with != NULL) &&
                (law->resistance != NULL) + (law->factor != NULL) +
                        (law->resistance_with != NULL) ==
                    1 &&
                law->eps_min < law->eps_max && law->Re_min < law->Re_max,
            "%s", law->name);
    }
    for (int i = 0; averaging_methods[i] != NULL; i++) {
        const struct averaging_method *const a = averaging_methods[i];
        ck_assert_msg(a->create != NULL && a->free != NULL &&
                          a->spread != NULL && a->gather != NULL,
                      "%s", a->name);
    }
    for (int i = 0; surface_shapes[i] != NULL; i++) {
        const struct surface_shape *const s = surface_shapes[i];
        const int drawn_apart =
            s == &surface_plane || s == &surface_cylinder || s == &surface_stl;
        ck_assert_msg((s->nearest != NULL || s == &surface_stl) &&
                          (s->point != NULL || drawn_apart),
                      "%s", s->name);
        check_own_keys(s->name, s->own_keys, s->keys);
    }
}

/* What a drag law is tested with is its default, where there is one. */
FACT(every_key_of_a_models_own_has_a_value)
{
    for (int i = 0; contact_laws[i] != NULL; i++) {
        int n = 0;
        const struct key *k = contact_laws[i]->own_keys;
        for (; k != NULL && k->path != NULL; k++)
            n += strncmp(k->path, "particles.grains.", 17) == 0;
        ck_assert_int_le(n, MODEL_NUMBERS);
    }
    for (int i = 0; averaging_methods[i] != NULL; i++)
        check_own_keys(averaging_methods[i]->name,
                       averaging_methods[i]->own_keys,
                       averaging_methods[i]->keys);
    for (int i = 0; drag_laws[i] != NULL; i++) {
        const struct drag_law *const law = drag_laws[i];
        int n = 0;
        check_own_keys(law->name, law->own_keys, law->keys);
        for (const struct key *k = law->own_keys; k != NULL && k->path != NULL;
             k++, n++)
            if (!schema_is_required(k))
                ck_assert_double_eq(law->own[n], atof(k->fallback));
    }
}

/* Every key that a model reads is in the tables, and has a row once: a second
 * one would never be found. */
FACT(every_key_has_one_row)
{
    const struct key *tables[CASE_FILE_TABLES];

    case_file_tables(tables);
    SCHEMA_EACH (key, tables)
        SCHEMA_EACH (other, tables)
            if (other != key && strcmp(other->path, key->path) == 0)
                ck_abort_msg("%s has two rows", key->path);
}

FACT(list_shows_every_model_and_key)
{
    struct capture c = capture_begin(1);
    const struct key *tables[CASE_FILE_TABLES];
    struct model m;

    list_kinds();
    for (const struct kind *k = models_kinds; k->name != NULL; k++)
        ck_assert_int_eq(list_models(k->name), 0);
    capture_end(&c, said);
    for (const struct kind *k = models_kinds; k->name != NULL; k++)
        for (int i = 0; models_at(k, i, &m); i++) {
            ck_assert_ptr_nonnull(strstr(said, m.name));
            ck_assert_ptr_nonnull(strstr(said, m.what));
        }

    c = capture_begin(1);
    ck_assert_int_eq(list_models("keys"), 0);
    capture_end(&c, said);
    case_file_tables(tables);
    SCHEMA_EACH (key, tables) {
        ck_assert_ptr_nonnull(strstr(said, key->path));
        ck_assert_ptr_nonnull(strstr(said, key->what));
    }
}

/* The bed of SX15 Table 1, mesh C: 44 x 120 x 10 mm in 18 x 50 x 4 cells. The
 * paper prints S_c / d_p = 2 for it, rounded. */
FACT(sx15_10_the_size_of_a_cell_is_the_root_of_its_volume)
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
