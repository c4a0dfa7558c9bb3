/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/file.h"
#include "scratch.h"

#include <errno.h>
#include <signal.h>
#include <sys/resource.h>

static char dir[64];

static void set_up(void)
{
    scratch_make(dir);
}

static void tear_down(void)
{
    scratch_clear(dir);
}

/* From here on files end at so many bytes, as on a disk that is full there;
 * the write then fails with EFBIG in place of ENOSPC. Returns the old limit. */
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

START_TEST(a_file_has_its_name_only_when_it_is_whole)
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
END_TEST

START_TEST(the_old_file_stays_until_the_new_one_is_whole)
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
END_TEST

START_TEST(a_link_with_the_name_of_a_part_is_not_followed)
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
END_TEST

START_TEST(of_two_that_write_one_file_the_last_to_begin_has_it)
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
END_TEST

START_TEST(a_part_that_somebody_removes_is_reported)
{
    scratch_listen(dir);
    struct file *const f = file_create(scratch_path(dir, "a"));
    ck_assert_int_eq(remove(scratch_path(dir, "a.partial")), 0);
    ck_assert_int_ne(file_commit(f), 0);
}
END_TEST

/* 1000 bytes fail only when they are flushed, 100000 while they are written. */
START_TEST(a_full_disk_is_reported_with_path_and_reason_and_leaves_nothing)
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
END_TEST

START_TEST(a_file_in_a_missing_folder_is_refused_with_its_path)
{
    scratch_listen(dir);
    ck_assert_ptr_null(file_create(scratch_path(dir, "none/a")));
    char *const said = scratch_heard(dir);
    ck_assert_ptr_nonnull(strstr(said, "none/a"));
    ck_assert_ptr_nonnull(strstr(said, strerror(ENOENT)));
    free(said);
}
END_TEST

START_TEST(a_name_that_is_a_folder_is_reported_and_leaves_nothing)
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
END_TEST

START_TEST(folders_are_made_with_those_above_and_may_be_there_already)
{
    for (int i = 0; i < 2; i++)
        ck_assert_int_eq(file_make_dirs(scratch_path(dir, "a//b/c/")), 0);
    struct stat s;
    ck_assert_int_eq(stat(scratch_path(dir, "a/b/c"), &s), 0);
    ck_assert(S_ISDIR(s.st_mode));
}
END_TEST

START_TEST(a_folder_below_a_file_is_refused_with_its_path)
{
    scratch_listen(dir);
    scratch_write(scratch_path(dir, "a"), "");
    ck_assert_int_ne(file_make_dirs(scratch_path(dir, "a")), 0);
    ck_assert_int_ne(file_make_dirs(scratch_path(dir, "a/b")), 0);
    char *const said = scratch_heard(dir);
    ck_assert_ptr_nonnull(strstr(said, scratch_path(dir, "a/b: ")));
    free(said);
}
END_TEST

int main(void)
{
    Suite *const s = suite_create("file");
    TCase *const t = tcase_create("core");

    suite_add_tcase(s, t);
    tcase_add_checked_fixture(t, set_up, tear_down);
    tcase_add_test(t, a_file_has_its_name_only_when_it_is_whole);
    tcase_add_test(t, the_old_file_stays_until_the_new_one_is_whole);
    tcase_add_test(t, a_link_with_the_name_of_a_part_is_not_followed);
    tcase_add_test(t, of_two_that_write_one_file_the_last_to_begin_has_it);
    tcase_add_test(t, a_part_that_somebody_removes_is_reported);
    tcase_add_loop_test(
        t, a_full_disk_is_reported_with_path_and_reason_and_leaves_nothing, 0,
        2);
    tcase_add_test(t, a_file_in_a_missing_folder_is_refused_with_its_path);
    tcase_add_test(t, a_name_that_is_a_folder_is_reported_and_leaves_nothing);
    tcase_add_test(t,
                   folders_are_made_with_those_above_and_may_be_there_already);
    tcase_add_test(t, a_folder_below_a_file_is_refused_with_its_path);
    SRunner *const r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    const int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed != 0;
}
