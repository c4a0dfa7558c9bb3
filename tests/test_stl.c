/* SPDX-License-Identifier: GPL-3.0-or-later */
/* STL files of both kinds, whole and broken. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "dem/surfaces/triangles.h"
#include "facts.h"
#include "scratch.h"

static const char two_solids[] =
    "solid one with a name\n"
    "  facet normal 0 0 1\n    outer loop\n"
    "      vertex 0 0 0\n      vertex 1.5 0 0\n      vertex 0 2.5e0 0\n"
    "    endloop\n  endfacet\n"
    "endsolid one with a name\n"
    "SOLID\nFACET NORMAL nan nan nan\nOUTER LOOP\n"
    "VERTEX 0 0 1 VERTEX 1 0 1 VERTEX 0 1 1\nENDLOOP\nENDFACET\n"
    "facet normal 0 0 0\nouter loop\n"
    "vertex 0 0 1 vertex 1 0 1 vertex 2 0 1\nendloop\nendfacet\nENDSOLID\n";

static char dir[64];

static void arrive(void)
{
    scratch_make(dir);
    scratch_listen(dir);
}

static void leave(void)
{
    scratch_clear(dir);
}

static int stl_read(const char *path, struct stl *s)
{
    struct input in = input_of(path);
    const int failed = stl_parse(&in, s);

    input_release(&in);
    return failed;
}

/* The message for this text, which must be refused. */
static void refused(const char *text, const char *said)
{
    struct stl s;

    scratch_write(scratch_path(dir, "a.stl"), text);
    ck_assert_int_ne(stl_read(scratch_path(dir, "a.stl"), &s), 0);
    ck_assert_ptr_null(s.corner);
    char *const heard = scratch_heard(dir);
    if (strstr(heard, said) == NULL)
        ck_abort_msg("expected: %s\nheard: %s", said, heard);
    free(heard);
}

FACT(text_with_two_solids_is_read)
{
    struct stl s;

    scratch_write(scratch_path(dir, "a.stl"), two_solids);
    ck_assert_int_eq(stl_read(scratch_path(dir, "a.stl"), &s), 0);
    ck_assert_int_eq(s.n, 2);
    ck_assert_int_eq(s.dropped, 1); /* three corners in line */
    ck_assert_double_eq(s.corner[0][1][0], 1.5);
    ck_assert_double_eq(s.corner[0][2][1], 2.5);
    ck_assert_double_eq(s.corner[1][2][2], 1.0);
    stl_release(&s);
}

/* Writes n triangles of the announced ones, after a head that says "solid", as
 * some programs do. */
static void write_binary(uint32_t announced, int n)
{
    static const float record[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0.25f, 0};
    FILE *const f = fopen(scratch_path(dir, "a.stl"), "wb");
    char head[80] = "solid made by a program";

    fwrite(head, 1, 80, f);
    fwrite(&announced, 4, 1, f);
    for (int t = 0; t < n; t++) {
        fwrite(record, 4, 12, f);
        fwrite("\0\0", 1, 2, f);
    }
    fclose(f);
}

FACT(binary_file_is_known_by_its_length)
{
    struct stl s;

    write_binary(3, 3);
    ck_assert_int_eq(stl_read(scratch_path(dir, "a.stl"), &s), 0);
    ck_assert_int_eq(s.n, 3);
    ck_assert_double_eq(s.corner[2][2][1], 0.25);
    stl_release(&s);
}

FACT(broken_text_is_refused_with_its_line)
{
    refused("solid a\nfacet normal 0 0 1\nouter loop\nvertx 0 0 0\n",
            "a.stl:4: expected \"vertex\", found \"vertx\"");
    refused("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0,5\n",
            "a.stl:4: expected a number, found \"0,5\"");
    refused("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 inf\n",
            "a.stl:4: expected a number, found \"inf\"");
    /* Cut off after 63 letters, it would be another number. */
    refused("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 "
            "1000000000000000000000000000000000000000000000000000000000000000"
            "000e-66\n",
            "a.stl:4: expected a number, found \"1000");
    refused("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0",
            "a.stl:4: expected a number, found the end of the file");
    refused("solid a\nendsolid a\nfacet normal 0 0 1\n",
            "a.stl:3: expected \"solid\", found \"facet\"");
    refused("solid a\nsolid b\n",
            "a.stl:2: expected \"facet\" or \"endsolid\", found \"solid\"");
    refused("solid a\n", "the file ends before \"endsolid\"");
}

FACT(file_without_a_triangle_is_refused)
{
    refused("solid a\nendsolid a\n", "there is no triangle in it");
    refused("", "not an STL file");
    refused("Wavefront? no. But this line is longer than eighty-four bytes, so "
            "that there is a head.\n",
            "not an STL file, or truncated: its header announces");
}

FACT(binary_file_that_is_cut_off_or_not_there_is_refused)
{
    struct stl s;
    FILE *f;

    write_binary(3, 2);
    f = fopen(scratch_path(dir, "a.stl"), "r+b");
    fputs("xxxxx", f); /* otherwise the file would be read as text */
    fclose(f);
    ck_assert_int_ne(stl_read(scratch_path(dir, "a.stl"), &s), 0);
    ck_assert_int_ne(stl_read(scratch_path(dir, "absent.stl"), &s), 0);
    char *const heard = scratch_heard(dir);
    ck_assert_ptr_nonnull(strstr(heard, "announces 3 triangles, which make 234 "
                                        "bytes; it has 184"));
    ck_assert_ptr_nonnull(strstr(heard, "absent.stl: cannot be read: No such"));
    free(heard);
}

FACTS
{
    tcase_add_checked_fixture(facts, arrive, leave);
}
