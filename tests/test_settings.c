/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/case_file.h"
#include "case/models.h"
#include "case/settings.h"

#include "facts.h"
#include "capture.h"

#include <stdlib.h>
#include <string.h>

static const struct key effect_keys[] = {
    {"effects.gravity", KEY_VECTOR, "m/s^2", "", KEY_OPTIONAL, "weight", "",
     ""},
    {"effects.pull", KEY_GROUP, "", "", KEY_OPTIONAL, "a pull", "",
     "particles"},
    {"effects.pull.force", KEY_REAL, "N", "> 0", NULL, "how strong", "", ""},
    {"output.profiles", KEY_LIST, "", "", "", "a list of groups", "", ""},
    {"output.profiles.field", KEY_NAME, "", "eps_f | p | u_x", NULL, "a word",
     "", ""},
    {"output.profiles.height", KEY_REAL, "m", ">= 0", NULL, "a number", "", ""},
    {"output.profiles.from", KEY_REAL, "s", ">= 0", "0.0", "one with a default",
     "", ""},
    KEY_END};

static const char good[] =
    "title = \"a test\";\n"                                    /* 1 */
    "mesh = { size = [1.0, 2.0, 3.0]; cells = [4, 5, 6]; };\n" /* 2 */
    "fluid = {\n"                                              /* 3 */
    "    density = 1000; viscosity = 1e-3;\n"                  /* 4 */
    "    step = 1e-4;\n"                                       /* 5 */
    "    sides = \"no-slip\"; front_back = \"slip\";\n"        /* 6 */
    "    bottom = { inlet = ((0.0, 0.0), (15.0, 1.5)); };\n"   /* 7 */
    "    top = { outlet = 0.0; };\n"                           /* 8 */
    "};\n"                                                     /* 9 */
    "effects = { gravity = [0.0, -9.81, 0.0]; };\n"            /* 10 */
    "output = { end = 2.0; every = 1;\n"                       /* 11 */
    "    profiles = ( { field = \"eps_f\"; height = 0.5; },\n" /* 12 */
    "                 { field = \"u_x\"; height = 1; from = 0.5; } );\n" /* 13
                                                                          */
    "};\n"; /* 14 */

static char folder[32];
static char path[64];

static void make_folder(void)
{
    strcpy(folder, "/tmp/winnow-settings-XXXXXX");
    ck_assert_ptr_nonnull(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/case.cfg", folder);
}

static void remove_folder(void)
{
    char included[64];

    snprintf(included, sizeof included, "%s/part.cfg", folder);
    remove(included);
    remove(path);
    rmdir(folder);
}

static void write_file(const char *name, const char *text)
{
    FILE *const f = fopen(name, "w");

    ck_assert_ptr_nonnull(f);
    fputs(text, f);
    fclose(f);
}

/* Reads a case text with overrides, ended by NULL; `said` receives the
 * messages. */
static struct settings *read_case(const char *text,
                                  const char *const *overrides, int *code,
                                  char said[CAPTURE_TEXT])
{
    const struct key *tables[CASE_FILE_TABLES] = {
        case_file_keys, mesh_keys,      fluid_keys,
        particles_keys, averaging_keys, coupling_keys,
        effects_keys,   output_keys,    effect_keys};

    struct settings *s;
    struct capture c;
    int n = 0;

    while (tables[n] != NULL)
        n++;
    models_tables(&tables[n], CASE_FILE_TABLES - 1 - n);
    n = 0;
    while (overrides[n] != NULL)
        n++;
    if (text != NULL) write_file(path, text);
    c = capture_begin(2);
    s = settings_create(path, n, overrides, tables, code);
    capture_end(&c, said);
    return s;
}

static struct settings *good_with(const char *override)
{
    const char *const overrides[] = {override, NULL};
    static char said[CAPTURE_TEXT];
    int code;
    struct settings *const s = read_case(good, overrides, &code, said);

    ck_assert_msg(s != NULL, "%s", said);
    ck_assert_int_eq(code, 0);
    ck_assert_str_eq(said, "");
    return s;
}

/* The case must be refused with exit code 2 and one message that holds each of
 * the parts, apart by '~'. */
static void refused(const char *text, const char *override, const char *parts)
{
    const char *const overrides[] = {override, NULL};
    static char said[CAPTURE_TEXT], part[256];
    int code;

    ck_assert_ptr_null(read_case(text, overrides, &code, said));
    ck_assert_int_eq(code, 2);
    ck_assert_int_eq(strncmp(said, "winnow: ", 8), 0);
    while (*parts != '\0') {
        snprintf(part, sizeof part, "%.*s", (int)strcspn(parts, "~"), parts);
        ck_assert_msg(strstr(said, part) != NULL, "no \"%s\" in %s", part,
                      said);
        parts += strlen(part);
        parts += *parts == '~';
    }
}

/* The good case with the first `old` replaced. */
static const char *with(const char *old, const char *new)
{
    static char text[4096];
    const char *const at = strstr(good, old);

    ck_assert_ptr_nonnull(at);
    snprintf(text, sizeof text, "%.*s%s%s", (int)(at - good), good, new,
             at + strlen(old));
    return text;
}

FACT(values_come_back_as_the_case_says)
{
    struct settings *const s = good_with(NULL);

    ck_assert_str_eq(settings_text(s, "title"), "a test");
    ck_assert_double_eq(settings_real(s, "fluid.density"), 1000.0);
    ck_assert_double_eq(settings_real(s, "fluid.viscosity"), 1e-3);
    ck_assert_double_eq(settings_real(s, "output.every"), 1.0);
    ck_assert_double_eq(s->mesh.box.size[1], 2.0);
    ck_assert_int_eq(s->mesh.box.cells[2], 6);
    ck_assert_double_eq(s->effects.gravity[1], -9.81);
    settings_free(s);
}

FACT(left_out_keys_have_their_defaults_and_are_not_named)
{
    struct settings *const s = good_with(NULL);

    ck_assert(settings_has(s, "fluid.step"));
    ck_assert(!settings_has(s, "fluid.correctors"));
    ck_assert_int_eq(settings_int(s, "fluid.correctors"), 2);
    ck_assert_str_eq(settings_text(s, "fluid.continuity"), "mixture");
    ck_assert_double_eq(s->mesh.box.grading[2], 1.0);
    ck_assert_int_eq(s->mesh.box.periodic[0], 0);
    ck_assert_str_eq(settings_text(s, "cites"), "");
    ck_assert(!settings_has(s, "particles"));
    settings_free(s);
}

FACT(lists_hold_groups_with_defaults_of_their_own)
{
    struct settings *const s = good_with(NULL);
    const char *const list = "output.profiles";

    ck_assert_int_eq(settings_length(s, list), 2);
    ck_assert_str_eq(settings_item_text(s, list, 1, "field"), "u_x");
    ck_assert_double_eq(settings_item_real(s, list, 0, "from"), 0.0);
    ck_assert_double_eq(settings_item_real(s, list, 1, "from"), 0.5);
    ck_assert(!settings_item_has(s, list, 0, "from"));
    ck_assert(settings_item_has(s, list, 1, "from"));
    ck_assert_int_eq(settings_length(s, "particles.place"), 0);
    settings_free(s);
}

FACT(inlet_is_a_number_or_a_course_in_time)
{
    struct settings *s = good_with(NULL);
    const struct key_series *u = &settings_side(s, "bottom")->inlet;

    ck_assert_int_eq(u->n, 2);
    ck_assert_double_eq(u->at[1], 15.0);
    ck_assert_double_eq(u->value[1], 1.5);
    settings_free(s);

    s = good_with("fluid.bottom.inlet=1");
    u = &settings_side(s, "bottom")->inlet;
    ck_assert_int_eq(u->n, 1);
    ck_assert_double_eq(u->at[0], 0.0);
    ck_assert_double_eq(u->value[0], 1.0);
    settings_free(s);
}

FACT(side_is_found_alone_or_in_its_pair)
{
    struct settings *const s = good_with(NULL);

    ck_assert_str_eq(settings_side(s, "left")->key, "fluid.sides");
    ck_assert_str_eq(settings_side(s, "front")->key, "fluid.front_back");
    ck_assert_str_eq(settings_side(s, "top")->key, "fluid.top");
    ck_assert_str_eq(settings_text(s, "fluid.sides"), "no-slip");
    settings_free(s);
}

/* libconfig takes whole and real numbers in one array only in round brackets; a
 * text that looks like one, and the lines of messages, stay as they are. */
FACT(vector_may_mix_whole_and_real_numbers)
{
    static const char *const arrays[] = {"[0, -9.81, 0]", "[0.0, -9.81, 0]",
                                         "[ 0,\n\t-9.81 /* ] */, 0 ]"};
    int code;
    char said[CAPTURE_TEXT];
    static const char *const none[] = {NULL};

    for (int i = 0; i < 6; i++) {
        char override[64];
        snprintf(override, sizeof override, "effects.gravity=%s",
                 arrays[i % 3]);
        struct settings *const s =
            i < 3 ? good_with(override)
                  : read_case(with("[0.0, -9.81, 0.0]", arrays[i - 3]), none,
                              &code, said);
        ck_assert_ptr_nonnull(s);
        ck_assert_double_eq(s->effects.gravity[0], 0.0);
        ck_assert_double_eq(s->effects.gravity[1], -9.81);
        settings_free(s);
    }
    struct settings *const s = good_with("title=\"[1, 2.0]\"");
    ck_assert_str_eq(settings_text(s, "title"), "[1, 2.0]");
    settings_free(s);
    refused(with("[1.0, 2.0, 3.0]", "[1, 2.0, -3]"), NULL,
            "case.cfg:2: mesh.size: expected three numbers");
    refused(with("[4, 5, 6]", "[4, 5.0, 6]"), NULL,
            "case.cfg:2: mesh.cells: ~without point");
}

FACT(override_replaces_adds_and_reaches_into_lists)
{
    struct settings *s = good_with("fluid.density=1.2");

    ck_assert_double_eq(settings_real(s, "fluid.density"), 1.2);
    settings_free(s);
    s = good_with("fluid.convection=linear"); /* a bare word */
    ck_assert_str_eq(settings_text(s, "fluid.convection"), "linear");
    settings_free(s);
    s = good_with("title=\"two words\"");
    ck_assert_str_eq(settings_text(s, "title"), "two words");
    settings_free(s);
    s = good_with("output.profiles.1.height=0.25");
    ck_assert_double_eq(settings_item_real(s, "output.profiles", 1, "height"),
                        0.25);
    settings_free(s);
    s = good_with("fluid.bottom={inlet=0.9;}");
    ck_assert_int_eq(settings_side(s, "bottom")->inlet.n, 1);
    settings_free(s);
}

FACT(unknown_key_names_file_line_and_the_nearest)
{
    refused(with("viscosity", "viscsity"), NULL,
            "case.cfg:4: ~fluid.viscsity~did you mean fluid.viscosity~[Pa s]");
    refused(with("fluid = {", "fluids = {"), NULL,
            "case.cfg:3: ~fluids~did you mean fluid");
    refused(with("step = 1e-4", "young = 1e5; step = 1e-4"), NULL,
            "fluid.young~did you mean particles.grains.young");
    refused(with("gravity =", "gravty ="), NULL,
            "case.cfg:10: ~did you mean effects.gravity");
}

FACT(missing_key_names_its_group_and_meaning)
{
    refused(with("    step = 1e-4;", ""), NULL,
            "case.cfg:3: fluid.step is missing~a number > 0 [s]~time step");
    refused(with("height = 0.5;", ""), NULL,
            "case.cfg:12: output.profiles.height is missing~[m]");
    refused("title = \"empty\";", NULL, "case.cfg: mesh is missing");
}

FACT(wrong_value_names_expectation_unit_and_what_was_found)
{
    refused(with("density = 1000", "density = -1000"), NULL,
            "case.cfg:4: fluid.density~number > 0 [kg/m^3]~found -1000");
    refused(with("density = 1000", "density = 0"), NULL, "found 0");
    refused(with("density = 1000", "density = 1e999"), NULL, "found inf");
    refused(with("density = 1000", "density = \"air\""), NULL,
            "found the text \"air\"");
    refused(with("[4, 5, 6]", "[4, 5]"), NULL,
            "mesh.cells~three whole numbers~>= 1~found [4, 5]");
    refused(with("[4, 5, 6]", "[4, 0, 6]"), NULL, "found [4, 0, 6]");
    refused(with("[4, 5, 6]", "[4.0, 5.0, 6.0]"), NULL, "whole numbers");
    refused(with("\"eps_f\"", "\"eps_g\""), NULL,
            "case.cfg:12: ~did you mean eps_f?");
    refused(with("(15.0, 1.5)", "(0.0, 1.5)"), NULL, "fluid.bottom.inlet");
    refused(with("(15.0, 1.5)", "(15.0, -1.5)"), NULL, "fluid.bottom.inlet");
    refused(with("{ outlet = 0.0; }", "{ outlet = 0.0; inlet = 1.0; }"), NULL,
            "case.cfg:8: fluid.top");
    refused(with("effects = {", "effects = { pull = 3;"), NULL,
            "effects.pull: expected a group");
}

FACT(wrong_override_is_named_as_such)
{
    refused(good, "fluid.density=-1", "option -s fluid.density=-1: ~[kg/m^3]");
    refused(good, "fluid.densty=1", "option -s ~did you mean fluid.density");
    refused(good, "density", "expected path.to.key=value");
    refused(good, "title=two words", "quote a text with blanks");
    refused(good, "title.x=1", "a part of the path does not exist");
    refused(good, "output.profiles.7.height=1",
            "a part of the path does not exist");
    refused(good, "output.profiles.4294967296.height=1",
            "a part of the path does not exist");
    refused(good, "output.profiles.0x.height=1",
            "a part of the path does not exist");
    refused(good, "fluid.density=nan", "found the text \"nan\"");
    refused(good, "fluid.density=", "not one value");
    refused(good, "fluid.density=1;title=2", "not one value");
}

FACT(group_that_is_needed_must_be_there)
{
    refused(with("effects = {", "effects = { pull = { force = 1; };"), NULL,
            "case.cfg:10: effects.pull needs particles");
    refused(good, "exchange={drag=\"gidaspow\";}", "exchange needs averaging");
}

FACT(whole_number_too_large_for_an_int_is_not_misread)
{
    refused(with("density = 1000", "density = 70000000000"), NULL,
            "case.cfg:4: 70000000000 is too large");
    refused(good, "fluid.density=70000000000", "too large for a whole number");
    settings_free(good_with("fluid.density=70000000000.0"));
    settings_free(good_with("title=\"call 70000000000\""));
}

FACT(syntax_error_quotes_the_line)
{
    refused("mesh = {\n  size = [0, 1.0 1.0];\n};", NULL,
            "case.cfg:2: syntax error~    size = [0, 1.0 1.0];");
    refused("title = \"a\";\ntitle = \"b\";", NULL, "case.cfg:2: duplicate");
}

FACT(included_file_is_found_beside_the_case_and_named_in_errors)
{
    char part[64], text[5000];

    snprintf(part, sizeof part, "%s/part.cfg", folder);
    write_file(part, "\ncites = 3;\n");
    snprintf(text, sizeof text, "@include \"part.cfg\"\n%s", good);
    refused(text, NULL, "/part.cfg:2: cites");
    write_file(part, "\nv = [0, 1.0];\n");
    refused(text, NULL, "/part.cfg:2: ~write all numbers alike");
    write_file(part, "cites = \"us\";\n");
    snprintf(text, sizeof text, "@include \"part.cfg\"\n%s",
             with("viscosity", "viscsity"));
    refused(text, NULL, "/case.cfg:5: fluid.viscsity");
}

FACT(case_that_cannot_be_read_is_code_4_and_one_that_it_includes_2)
{
    static const char *const none[] = {NULL};
    static char said[CAPTURE_TEXT];
    int code;

    remove(path);
    ck_assert_ptr_null(read_case(NULL, none, &code, said));
    ck_assert_int_eq(code, 4);
    ck_assert_ptr_nonnull(strstr(said, "case.cfg: cannot read"));
    ck_assert_ptr_null(
        read_case("@include \"absent.cfg\"\n", none, &code, said));
    ck_assert_int_eq(code, 2);
    ck_assert_ptr_nonnull(strstr(said, "absent.cfg"));
}

FACTS
{
    tcase_add_checked_fixture(facts, make_folder, remove_folder);
}
