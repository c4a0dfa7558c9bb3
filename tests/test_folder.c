/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/folder.h"
#include "facts.h"
#include "scratch.h"

#include "base/file.h"

#include <sys/wait.h>

static char dir[64], name[72];

static void set_up(void)
{
    scratch_make(dir);
    snprintf(name, sizeof name, "%s/run", dir);
    scratch_listen(dir);
}

static void tear_down(void)
{
    scratch_clear(dir);
}

static void assert_said(const char *part)
{
    char *const said = scratch_heard(dir);

    if (strstr(said, part) == NULL)
        ck_abort_msg("no \"%s\" in: %s", part, said);
    free(said);
}

/* What tells that a run has written a file, of both that run_once writes. */
static const char of_run[] = "\"program\": \"winnow \", <VTKFile";

/* A run that writes two files and lists a third that it does not write. */
static void run_once(const char *where)
{
    struct folder *const f = folder_open(where);

    ck_assert_ptr_nonnull(f);
    ck_assert_int_eq(folder_begin(f), 0);
    static const char *const names[] = {
        "summary.json", "fluid/fluid_000000.vtr", "history.csv"};
    ck_assert_int_eq(folder_make(f, "fluid"), 0);
    for (int i = 0; i < 3; i++) {
        char *const path = folder_file(f, names[i]);
        ck_assert_ptr_nonnull(path);
        if (i < 2) scratch_write(path, of_run);
        free(path);
    }
    folder_free(f);
}

FACT(what_is_listed_goes_and_what_is_not_stays)
{
    run_once(name);
    scratch_write(scratch_path(name, "notes.txt"), "mine");
    scratch_write(scratch_path(name, "fluid/mine.vtr"), "mine");
    scratch_write(scratch_path(name, "history.csv.partial"), "time [s], h");
    struct folder *const f = folder_open(name);
    ck_assert_ptr_nonnull(f);
    ck_assert(scratch_exists(scratch_path(name, "summary.json")));
    ck_assert_int_eq(folder_is_used(f), 1);
    ck_assert_int_eq(folder_begin(f), 0);
    folder_free(f);
    ck_assert(!scratch_exists(scratch_path(name, "summary.json")));
    ck_assert(!scratch_exists(scratch_path(name, "fluid/fluid_000000.vtr")));
    ck_assert(!scratch_exists(scratch_path(name, "history.csv.partial")));
    scratch_assert_text(scratch_path(name, "notes.txt"), "mine");
    scratch_assert_text(scratch_path(name, "fluid/mine.vtr"), "mine");
    scratch_assert_text(scratch_path(name, "manifest.txt"), MANIFEST_HEAD);
}

static const char *const named[] = {"history.csv.partial",
                                    "checkpoint.grains.0", "fluid.pvd",
                                    "frames/gnuplot.log"};

/* By content where there is some, not by the name alone. */
FACT_FOR_EACH(what_no_run_has_written_is_in_the_way_whatever_its_name, 4)
{
    char list[256];

    run_once(name);
    ck_assert_int_eq(mkdir(scratch_path(name, "frames"), 0777), 0);
    scratch_write(scratch_path(name, named[_i]), "mine");
    snprintf(list, sizeof list, "%ssummary.json\nfluid/fluid_000000.vtr\n%s%s",
             MANIFEST_HEAD, _i > 0 ? named[_i] : "", _i > 0 ? "\n" : "");
    scratch_write(scratch_path(name, "manifest.txt"), list);
    ck_assert_ptr_null(folder_open(name));
    assert_said(named[_i]);
    scratch_assert_text(scratch_path(name, named[_i]), "mine");
}

/* The first run locks the folder in another process, which is then killed. */
FACT(a_second_run_is_refused_and_a_dead_one_holds_nothing)
{
    char number[32];
    int ready[2], status;
    char byte;

    run_once(name);
    ck_assert_int_eq(pipe(ready), 0);
    const pid_t other = fork();
    if (other == 0) {
        if (folder_open(name) != NULL && write(ready[1], "x", 1) == 1) pause();
        _exit(1);
    }
    ck_assert_int_eq(read(ready[0], &byte, 1), 1);
    ck_assert_ptr_null(folder_open(name));
    snprintf(number, sizeof number, "(process %ld)", (long)other);
    assert_said(number);
    scratch_assert_text(scratch_path(name, "summary.json"), of_run);
    kill(other, SIGKILL);
    ck_assert_int_eq(waitpid(other, &status, 0), other);
    struct folder *const f = folder_open(name);
    ck_assert_ptr_nonnull(f);
    folder_free(f);
}

static const char *const strange[] = {
    "../x\n",  "/tmp/x\n", "..\n",   "fluid/../x\n", "\n",
    "a/b/c\n", "./x\n",    "a/b/\n", "fluid/..\n",   "a\001b\n"};

FACT_FOR_EACH(a_manifest_that_names_what_is_not_inside_is_refused, 10)
{
    char text[128];

    scratch_write(scratch_path(dir, "x"), "mine");
    run_once(name);
    snprintf(text, sizeof text, "%ssummary.json\n%s", MANIFEST_HEAD,
             strange[_i]);
    scratch_write(scratch_path(name, "manifest.txt"), text);
    ck_assert_ptr_null(folder_open(name));
    scratch_assert_text(scratch_path(name, "summary.json"), of_run);
    scratch_assert_text(scratch_path(dir, "x"), "mine");
    assert_said("manifest.txt:3: not the list of a run's files");
}

FACT(a_manifest_of_another_program_is_refused)
{
    scratch_write(scratch_path(dir, "manifest.txt"), "summary.json\n");
    ck_assert_ptr_null(folder_open(dir));
    assert_said("manifest.txt:1: not the list of a run's files");
    scratch_assert_text(scratch_path(dir, "manifest.txt"), "summary.json\n");
}

FACT(a_line_cut_short_by_a_crash_is_no_name)
{
    run_once(name);
    scratch_write(scratch_path(name, "notes"), "mine");
    scratch_write(scratch_path(name, "manifest.txt"),
                  MANIFEST_HEAD "summary.json\nfluid/fluid_000000.vtr\nnotes");
    struct folder *const f = folder_open(name);
    ck_assert_ptr_nonnull(f);
    ck_assert_int_eq(folder_begin(f), 0);
    folder_free(f);
    ck_assert(scratch_exists(scratch_path(name, "notes")));
}

/* Lists of others, and the last name of each, which holds "mine". */
static const struct {
    const char *list, *name;
} foreign[] = {{"thesis.doc\n", "thesis.doc"},
               {"fluid/\nfluid/thesis.doc\n", "fluid/thesis.doc"},
               {"notes/\nnotes/history.csv\n", "notes/history.csv"},
               {"history.csv\n", "history.csv"},
               {"summary.json\n", "summary.json"},
               {"checkpoint\n", "checkpoint"},
               {"bed.png\n", "bed.png"},
               {"fluid/fluid_000000.vtr\n", "fluid/fluid_000000.vtr"},
               {"case.cfg\n", "case.cfg"},
               {"case/\ncase/thesis.doc\n", "case/thesis.doc"}};
enum { FOREIGN = sizeof foreign / sizeof foreign[0] };

FACT_FOR_EACH(a_list_removes_only_what_a_run_has_written, FOREIGN)
{
    char text[128];

    for (int i = 0; i < 3; i++)
        file_make_dirs(scratch_path(
            name, (const char *const[]){"fluid", "notes", "case"}[i]));
    snprintf(text, sizeof text, "%s%s", MANIFEST_HEAD, foreign[_i].list);
    scratch_write(scratch_path(name, "manifest.txt"), text);
    scratch_write(scratch_path(name, foreign[_i].name), "mine");
    ck_assert_ptr_null(folder_open(name));
    scratch_assert_text(scratch_path(name, foreign[_i].name), "mine");
    assert_said("and no run has written that");
}

FACT(a_link_in_the_place_of_a_file_of_a_run_stays)
{
    char away[72];

    run_once(name);
    snprintf(away, sizeof away, "%s/away", dir);
    scratch_write(away, of_run);
    ck_assert_int_eq(remove(scratch_path(name, "summary.json")), 0);
    ck_assert_int_eq(symlink(away, scratch_path(name, "summary.json")), 0);
    ck_assert_ptr_null(folder_open(name));
    ck_assert(scratch_exists(scratch_path(name, "summary.json")));
}

FACT(a_file_of_the_case_goes_with_the_case_that_names_it)
{
    run_once(name);
    file_make_dirs(scratch_path(name, "case"));
    scratch_write(scratch_path(name, "manifest.txt"),
                  MANIFEST_HEAD "case.cfg\ncase/\ncase/plate.stl\n");
    scratch_write(scratch_path(name, "case/plate.stl"), "of a run");
    scratch_write(scratch_path(name, "case.cfg"),
                  "# The case of this run, by winnow 0\n\n"
                  "file = \"case/plate.stl\";");
    remove(scratch_path(name, "summary.json"));
    remove(scratch_path(name, "fluid/fluid_000000.vtr"));
    struct folder *const f = folder_open(name);
    ck_assert_ptr_nonnull(f);
    ck_assert_int_eq(folder_begin(f), 0);
    folder_free(f);
    ck_assert(!scratch_exists(scratch_path(name, "case")));
}

static const char *const wanted[] = {"summary.json", "particles.pvd",
                                     "fluid/fluid_000009.vtu",
                                     "profiles/eps_f_y1mm.csv"};

FACT_FOR_EACH(a_foreign_file_that_would_be_overwritten_refuses_the_folder, 4)
{
    file_make_dirs(scratch_path(name, "fluid"));
    file_make_dirs(scratch_path(name, "profiles"));
    scratch_write(scratch_path(name, wanted[_i]), "mine");
    ck_assert_ptr_null(folder_open(name));
    scratch_assert_text(scratch_path(name, wanted[_i]), "mine");
    ck_assert(!scratch_exists(scratch_path(name, "manifest.txt")));
    assert_said(wanted[_i]);
}

FACT(a_link_out_of_the_folder_is_not_followed)
{
    char away[72];

    snprintf(away, sizeof away, "%s/away", dir);
    run_once(name);
    file_make_dirs(away);
    scratch_write(scratch_path(away, "fluid_000000.vtr"), "mine");
    ck_assert_int_eq(remove(scratch_path(name, "fluid/fluid_000000.vtr")), 0);
    ck_assert_int_eq(rmdir(scratch_path(name, "fluid")), 0);
    ck_assert_int_eq(symlink(away, scratch_path(name, "fluid")), 0);
    ck_assert_ptr_null(folder_open(name));
    scratch_assert_text(scratch_path(away, "fluid_000000.vtr"), "mine");
    assert_said("fluid is in the way");
}

FACT(a_folder_in_which_nothing_was_begun_goes_with_those_above)
{
    struct folder *f = folder_open(scratch_path(dir, "a//b/c/"));

    ck_assert_ptr_nonnull(f);
    folder_abandon(f);
    folder_free(f);
    ck_assert(!scratch_exists(scratch_path(dir, "a")));
    run_once(scratch_path(dir, "a"));
    f = folder_open(scratch_path(dir, "a"));
    folder_abandon(f);
    folder_free(f);
    ck_assert(scratch_exists(scratch_path(dir, "a/summary.json")));
}

FACTS
{
    tcase_add_checked_fixture(facts, set_up, tear_down);
}
