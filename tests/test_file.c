/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/file.h"
#include "facts.h"
#include "scratch.h"

#include <errno.h>
#include <signal.h>
#include <sys/resource.h>

FACTS_IN_A_FOLDER;

/* Limits the size of files, as on a full disk; the write then fails with EFBIG
 * in place of ENOSPC. Returns the old limit. */
static rlim_t limit_file_size(rlim_t bytes)
{
    struct rlimit limit;

    signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &limit);
    const rlim_t before = limit.rlim_cur;
    limit.rlim_cur = bytes;
    ck_assert_int_eq(setrlimit(RLIMIT_FSIZE, &limit), 0);
    return before;
}

FACT(a_file_has_its_name_only_when_it_is_whole)
{
    const char *const path = scratch_path(dir, "a");
    struct file *const f = file_create(path);

    ck_assert_ptr_nonnull(f);
    fprintf(file_stream(f), "whole");
    fflush(file_stream(f));
    ck_assert(!scratch_exists(path));
    ck_assert_int_eq(file_commit(f), 0);
    scratch_assert_text(path, "whole");
    ck_assert(!scratch_exists(scratch_path(dir, "a.partial")));
}

FACT(the_old_file_stays_until_the_new_one_is_whole)
{
    const char *const path = scratch_path(dir, "a");

    scratch_write(path, "old");
    struct file *f = file_create(path);
    fprintf(file_stream(f), "half");
    fflush(file_stream(f));
    scratch_assert_text(path, "old");
    file_discard(f);
    scratch_assert_text(path, "old");
    ck_assert(!scratch_exists(scratch_path(dir, "a.partial")));
    f = file_create(path);
    fprintf(file_stream(f), "new");
    ck_assert_int_eq(file_commit(f), 0);
    scratch_assert_text(path, "new");
    file_discard(NULL);
}

FACT(a_link_with_the_name_of_a_part_is_not_followed)
{
    const char *const path = scratch_path(dir, "a");

    scratch_write(scratch_path(dir, "mine"), "mine");
    ck_assert_int_eq(symlink("mine", scratch_path(dir, "a.partial")), 0);
    struct file *const f = file_create(path);
    fprintf(file_stream(f), "new");
    ck_assert_int_eq(file_commit(f), 0);
    scratch_assert_text(path, "new");
    scratch_assert_text(scratch_path(dir, "mine"), "mine");
}

FACT(of_two_that_write_one_file_the_last_to_begin_has_it)
{
    const char *const path = scratch_path(dir, "a");
    struct file *const first = file_create(path);
    struct file *const second = file_create(path);
    fprintf(file_stream(first), "first");
    fprintf(file_stream(second), "second");
    ck_assert_int_eq(file_commit(first), 0);
    ck_assert(!scratch_exists(path));
    ck_assert_int_eq(file_commit(second), 0);
    scratch_assert_text(path, "second");
}

FACT(a_partial_file_that_is_removed_is_reported)
{
    scratch_listen(dir);
    struct file *const f = file_create(scratch_path(dir, "a"));
    ck_assert_int_eq(remove(scratch_path(dir, "a.partial")), 0);
    ck_assert_int_ne(file_commit(f), 0);
}

/* 1000 bytes fail only when they are flushed, 100000 while they are written. */
FACT_FOR_EACH(a_full_disk_is_reported_with_path_and_reason_and_leaves_nothing,
              2)
{
    const int size = _i == 0 ? 1000 : 100000;
    const char *const path = scratch_path(dir, "a");
    char expected[512];

    scratch_listen(dir);
    snprintf(expected, sizeof expected, "winnow: cannot write %s: %s\n", path,
             strerror(EFBIG));
    struct file *const f = file_create(path);
    const rlim_t before = limit_file_size(500);
    for (int i = 0; i < size; i++)
        fputc('x', file_stream(f));
    const int failed = file_commit(f);
    limit_file_size(before);
    ck_assert_int_ne(failed, 0);
    ck_assert(!scratch_exists(path));
    ck_assert(!scratch_exists(scratch_path(dir, "a.partial")));
    char *const said = scratch_heard(dir);
    ck_assert_str_eq(said, expected);
    free(said);
}

FACT(a_file_in_a_missing_folder_is_refused_with_its_path)
{
    scratch_listen(dir);
    ck_assert_ptr_null(file_create(scratch_path(dir, "none/a")));
    char *const said = scratch_heard(dir);
    ck_assert_ptr_nonnull(strstr(said, "none/a"));
    ck_assert_ptr_nonnull(strstr(said, strerror(ENOENT)));
    free(said);
}

FACT(a_name_that_is_a_folder_is_reported_and_leaves_nothing)
{
    scratch_listen(dir);
    ck_assert_int_eq(file_make_dirs(scratch_path(dir, "a/b")), 0);
    struct file *const f = file_create(scratch_path(dir, "a"));
    fputc('x', file_stream(f));
    ck_assert_int_ne(file_commit(f), 0);
    ck_assert(!scratch_exists(scratch_path(dir, "a.partial")));
    char *const said = scratch_heard(dir);
    ck_assert_ptr_nonnull(strstr(said, scratch_path(dir, "a:")));
    free(said);
}

FACT(folders_are_made_with_those_above_and_may_be_there_already)
{
    for (int i = 0; i < 2; i++)
        ck_assert_int_eq(file_make_dirs(scratch_path(dir, "a//b/c/")), 0);
    struct stat s;
    ck_assert_int_eq(stat(scratch_path(dir, "a/b/c"), &s), 0);
    ck_assert(S_ISDIR(s.st_mode));
}

FACT(a_folder_below_a_file_is_refused_with_its_path)
{
    scratch_listen(dir);
    scratch_write(scratch_path(dir, "a"), "");
    ck_assert_int_ne(file_make_dirs(scratch_path(dir, "a")), 0);
    ck_assert_int_ne(file_make_dirs(scratch_path(dir, "a/b")), 0);
    char *const said = scratch_heard(dir);
    ck_assert_ptr_nonnull(strstr(said, scratch_path(dir, "a/b: ")));
    free(said);
}
