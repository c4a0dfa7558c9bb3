/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/text.h"

#include "case/case_file.h"
#include "case/schema.h"
#include "facts.h"
#include "scratch.h"
#include "study/plan.h"

/* A line break, an escape code, its one-byte form, delete, the shortest. */
static const char *const controls[] = {"\\n", "\\x1b[2J", "\xc2\x9b", "\\x7f",
                                       "\\x01"};
enum { CONTROLS = sizeof controls / sizeof controls[0] };

FACTS_IN_A_FOLDER;

/* A case with this key alone, each group on the way a list if it is one. */
static void write_case(const struct key *const *tables, const char *path,
                       const char *value)
{
    FILE *const out = fopen(scratch_path(dir, "case.cfg"), "w");
    char part[SCHEMA_TEXT], ends[SCHEMA_TEXT] = "";
    size_t n = 0;

    for (const char *dot; (dot = strchr(path + n, '.')) != NULL;) {
        snprintf(part, sizeof part, "%.*s", (int)(dot - path), path);
        const struct key *const k = schema_find(tables, part);
        const int list = k != NULL && k->type == KEY_LIST;
        fprintf(out, "%s = %s{ ", part + n, list ? "(" : "");
        n = (size_t)(dot + 1 - path);
        memmove(ends + 4, ends, strlen(ends) + 1);
        memcpy(ends, list ? " });" : " }; ", 4);
    }
    fprintf(out, "%s = \"%s\";%s\n", path + n, value, ends);
    fclose(out);
}

/* How many keys of texts there are; each was refused with each control. */
static int refused(const struct key *const *tables)
{
    int n = 0, code;

    SCHEMA_EACH (k, tables) {
        char path[SCHEMA_TEXT], value[64];
        const char *const side = strstr(k->path, KEY_ANY_PATCH);

        if (k->type != KEY_TEXT && k->type != KEY_FILE) continue;
        snprintf(path, sizeof path, "%.*s%s%s",
                 side != NULL ? (int)(side - k->path) : 0, k->path,
                 side != NULL ? "top" : "",
                 side != NULL ? side + strlen(KEY_ANY_PATCH) : k->path);
        for (int i = 0; i < CONTROLS; i++) {
            snprintf(value, sizeof value, "a%sb", controls[i]);
            write_case(tables, path, value);
            scratch_listen(dir);
            struct settings *const s = settings_create(
                scratch_path(dir, "case.cfg"), 0, NULL, tables, &code);
            char *const said = scratch_heard(dir);
            ck_assert_msg(s == NULL && code == 2, "%s took a%sb", path,
                          controls[i]);
            ck_assert_msg(strstr(said, "case.cfg:1: ") != NULL &&
                              strstr(said, path) != NULL &&
                              strstr(said, "control character") != NULL,
                          "%s: %s", path, said);
            said[strcspn(said, "\n")] = '\0';
            ck_assert_ptr_null(text_control(said));
            free(said);
        }
        n++;
    }
    return n;
}

FACT(no_key_takes_a_text_with_a_control_character)
{
    const struct key *tables[CASE_FILE_TABLES];
    const struct key *const of_study[] = {plan_keys, NULL};

    case_file_tables(tables);
    ck_assert_int_ge(refused(tables), 20);
    ck_assert_int_ge(refused(of_study), 7);
}

static const char nasty[] = "a'b\"c$(touch x)`touch x`\\<d>&|, \"\"\" &";

static const char *put(const char *text, enum text_target target)
{
    static char *made;
    size_t length;

    free(made);
    FILE *const out = open_memstream(&made, &length);
    text_put(out, text, target);
    fclose(out);
    return made;
}

FACT(a_shell_gets_the_very_word)
{
    char command[256], said[256] = "";

    snprintf(command, sizeof command, "cd %s && printf %%s %s; ls", dir,
             put(nasty, TEXT_SHELL));
    FILE *const shell = popen(command, "r");
    ck_assert_ptr_nonnull(fgets(said, sizeof said, shell));
    ck_assert_int_eq(pclose(shell), 0);
    ck_assert_str_eq(said, nasty);
    ck_assert_str_eq(put("", TEXT_SHELL), "''");
    ck_assert_str_eq(put("runs/a-1.cfg", TEXT_SHELL), "runs/a-1.cfg");
}

FACT(each_target_has_its_quotes)
{
    ck_assert_str_eq(put("a b\"`x`\\'@", TEXT_GNUPLOT),
                     "\"a b\\042\\140x\\140\\134\\047\\100\"");
    ck_assert_str_eq(put("a\"b\\", TEXT_CASE), "\"a\\\"b\\\\\"");
    ck_assert_str_eq(put("a\"b", TEXT_DATA), "\"a'b\"");
    ck_assert_str_eq(put("\"\"\" b &", TEXT_LAMMPS), "''' b +");
    ck_assert_str_eq(put("a<b>|&", TEXT_PAGE), "a&lt;b>\\|&amp;");
    ck_assert_str_eq(put("a<b>\"&", TEXT_XML), "a&lt;b&gt;&quot;&amp;");
    ck_assert_str_eq(put("a,\"b", TEXT_CSV), "\"a,\"\"b\"");
    ck_assert_str_eq(put("a b", TEXT_CSV), "a b");
}

FACT(no_target_gets_a_control_character)
{
    for (int target = TEXT_PLAIN; target <= TEXT_XML; target++) {
        const char *const made = put("a\nb\x1b"
                                     "2J\xc2\x9b"
                                     "c\x7f\xc3\xa9",
                                     (enum text_target)target);
        ck_assert_ptr_null(text_control(made));
        ck_assert_ptr_nonnull(strstr(made, "a b 2J c \xc3\xa9"));
    }
}
