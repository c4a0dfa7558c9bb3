/* scratch.h -- for tests of output: a temporary folder, files read back, and
 * the messages on stderr. */
#ifndef SCRATCH_H
#define SCRATCH_H

#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* A new folder under /tmp, and the end of it. */
static inline void scratch_make(char dir[64])
{
    strcpy(dir, "/tmp/winnow-test-XXXXXX");
    ck_assert_ptr_nonnull(mkdtemp(dir));
}

static inline void scratch_clear(const char *dir)
{
    char command[80];

    snprintf(command, sizeof command, "rm -rf %s", dir);
    ck_assert_int_eq(system(command), 0);
}

/* Each fact of the program has a new folder, `dir`. */
#define FACTS_IN_A_FOLDER                                                      \
    static char dir[64];                                                       \
    static void scratch_set_up(void)                                           \
    {                                                                          \
        scratch_make(dir);                                                     \
    }                                                                          \
    static void scratch_tear_down(void)                                        \
    {                                                                          \
        scratch_clear(dir);                                                    \
    }                                                                          \
    FACTS                                                                      \
    {                                                                          \
        tcase_add_checked_fixture(facts, scratch_set_up, scratch_tear_down);   \
    }                                                                          \
    static char dir[64]

/* DIR/NAME, in one of a few places used in turn. */
static inline const char *scratch_path(const char *dir, const char *name)
{
    static char path[8][256];
    static int next;

    next = (next + 1) % 8;
    snprintf(path[next], sizeof path[next], "%s/%s", dir, name);
    return path[next];
}

static inline int scratch_exists(const char *path)
{
    return access(path, F_OK) == 0;
}

/* The whole file with a closing zero, released with free(); NULL without
 * it. */
static inline char *scratch_read(const char *path, size_t *size)
{
    FILE *const in = fopen(path, "rb");
    if (in == NULL) return NULL;

    fseek(in, 0, SEEK_END);
    const size_t n = (size_t)ftell(in);
    char *const text = calloc(n + 1, 1);
    rewind(in);
    ck_assert_uint_eq(fread(text, 1, n, in), n);
    fclose(in);
    if (size) *size = n;
    return text;
}

static inline void scratch_write(const char *path, const char *text)
{
    FILE *const out = fopen(path, "wb");
    ck_assert_ptr_nonnull(out);
    fputs(text, out);
    fclose(out);
}

static inline void scratch_assert_text(const char *path, const char *expected)
{
    char *const text = scratch_read(path, NULL);
    ck_assert_ptr_nonnull(text);
    ck_assert_str_eq(text, expected);
    free(text);
}

/* Redirects stderr to DIR/said; each test is a process of its own. */
static inline void scratch_listen(const char *dir)
{
    ck_assert_ptr_nonnull(freopen(scratch_path(dir, "said"), "w", stderr));
}

/* The messages since then, to be freed. */
static inline char *scratch_heard(const char *dir)
{
    fflush(stderr);
    return scratch_read(scratch_path(dir, "said"), NULL);
}

#endif
