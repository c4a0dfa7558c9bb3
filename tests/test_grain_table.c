/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/population/insertion.h"
#include "base/csv.h"

#include "facts.h"
#include "scratch.h"

#include <stdlib.h>

FACTS_IN_A_FOLDER;

static const char *file_of(const char *text)
{
    const char *const path = scratch_path(dir, "grains.txt");
    FILE *const f = fopen(path, "w");

    fputs(text, f);
    fclose(f);
    return path;
}

/* The spheres that the dumps and the data files here hold. */
static void are_the_two(const struct insertion_sphere *list, long n)
{
    ck_assert_ptr_nonnull(list);
    ck_assert_int_eq(n, 2);
    ck_assert_double_eq(list[0].x[0], 1.0);
    ck_assert_double_eq(list[0].x[1], 2.0);
    ck_assert_double_eq(list[0].x[2], 3.0);
    ck_assert_double_eq(list[0].d, 0.5);
    ck_assert_double_eq(list[1].x[1], 5.0);
    ck_assert_double_eq(list[1].d, 1.0);
}

static struct insertion_sphere *grain_table_read(const char *path, long *n)
{
    struct input in = input_of(path);
    struct insertion_sphere *const list = grain_table_parse(&in, n);

    input_release(&in);
    return list;
}

/* Two snapshots of LIGGGHTS, the columns in its order; the second one counts,
 * and its radius is half a diameter. */
FACT(the_last_snapshot_of_a_dump_is_read)
{
    long n;
    const char *const path = file_of(
        "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS\n0 1\n"
        "ITEM: ATOMS id type x y z vx radius \n1 1 9 9 9 0 9 \n"
        "ITEM: TIMESTEP\n5\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS\n0 1\n"
        "ITEM: ATOMS id type radius x z y vx \n7 1 0.25 1 3 2 0 \n"
        "3 1 0.5 4 6 5 0 \n");
    struct insertion_sphere *const list = grain_table_read(path, &n);

    are_the_two(list, n);
    free(list);
}

/* A place that goes on across the periods counts where there is no other. */
FACT(unwrapped_places_of_a_dump_are_read)
{
    long n;
    struct insertion_sphere *const list = grain_table_read(
        file_of("ITEM: ATOMS id xu yu zu x diameter\n1 7 2 3 1 0.5\n"
                "2 9 5 6 4 1\n"),
        &n);

    are_the_two(list, n);
    free(list);
}

static const char *const marks[] = {"", CSV_UTF_8};

FACT_FOR_EACH(a_table_is_read_by_the_names_of_its_columns, 2)
{
    long n;
    char text[128];
    snprintf(text, sizeof text, "%s%s", marks[_i],
             "# of a spreadsheet\n\"z (m)\";\"diameter [m]\";\"x [m]\";y(m)\n"
             "3;0.5;1;2\n\n6;0.25;4;5\n");
    const char *const path = file_of(text);
    struct insertion_sphere *const list = grain_table_read(path, &n);

    ck_assert_int_eq(n, 2);
    ck_assert_double_eq(list[0].x[0], 1.0);
    ck_assert_double_eq(list[0].x[1], 2.0);
    ck_assert_double_eq(list[0].x[2], 3.0);
    ck_assert_double_eq(list[1].d, 0.25);
    free(list);
}

/* As LAMMPS writes it, and by hand with a remark for a title: the head is of no
 * interest, nor is what follows the atoms. */
FACT(a_data_file_has_its_spheres_in_the_section_of_atoms)
{
    static const char *const heads[] = {"LAMMPS data file, timestep = 5\n",
                                        "# by hand\n"};
    static const char *const styles[] = {"Atoms # sphere\n\n", "Atoms\n\n"};
    static const char *const ends[] = {" 0 0 -1\n", "\n"};
    char text[512];
    long n;

    for (int i = 0; i < 2; i++) {
        snprintf(text, sizeof text,
                 "%s\n 2 atoms\n 1 atom types\n\n 0 1 xlo xhi\n\n%s"
                 "7 1 0.5 2500 1 2 3%s3 1 1e-0 2500 4 5 6%s\n"
                 "Velocities\n\n7 0 0 0 0 0 0\n3 0 0 0 0 0 0\n",
                 heads[i], styles[i], ends[i], ends[i]);
        const char *const path = file_of(text);
        struct insertion_sphere *const list = grain_table_read(path, &n);
        are_the_two(list, n);
        free(list);
    }
}

/* Atoms of another style have no diameter. */
FACT(a_data_file_of_other_atoms_is_refused)
{
    long n;

    scratch_listen(dir);
    ck_assert_ptr_null(grain_table_read(
        file_of("LAMMPS data file\n\n1 atoms\n\nAtoms # atomic\n\n"
                "1 1 0.5 1 2\n"),
        &n));
    char *const said = scratch_heard(dir);
    ck_assert_ptr_nonnull(strstr(said, "found the style atomic"));
    free(said);
}

/* Numbers alone are x y z d, as ever. */
FACT(a_file_without_names_is_no_table)
{
    long n;
    const char *const path = file_of("# x y z d\n1 2 3 0.5\n");

    struct insertion_sphere *const list = grain_table_read(path, &n);
    ck_assert_int_eq(n, 1);
    ck_assert_double_eq(list[0].d, 0.5);
    free(list);
}

/* What a remark, brackets, a count or the name of units state of the rows is
 * believed or refused: d of the first sphere [m], or the message. YADE's
 * export.text writes #format x_y_z_r; LAMMPS takes blanks and remarks anywhere
 * in a data file (read_data.cpp). */
static const struct {
    const char *text;
    double d;
    const char *said;
} stated[] = {
    {"#format x_y_z_r\n1\t2\t3\t0.25\n", 0.5, ""},
    {"#format x_y_z_r_id\n1 2 3 0.25 7\n", 0.5, ""},
    {"# x y z radius in metres\n1 2 3 0.25\n", 0.5, ""},
    {"# 1000 beads of 2 mm\n# x, y, z, d (m)\n1 2 3 0.5\n", 0.5, ""},
    {"# four spheres, by hand\n1 2 3 0.5\n", 0.5, ""},
    {"# x y z d\n#\n1, 2, 3, 0.5\n", 0.5, ""},
    {"x y z r\n1 2 3 0.25\n", 0.5, ""},
    {"# X Y Z R\n1 2 3 0.25\n", 0.0, "columns are: X Y Z R"},
    {"# x y z d and colour\n1 2 3 0.5 6 7 8\n", 0.0, "more than 4 numbers"},
    {"# x y d\n1 2 0.5\n", 0.0, "columns are: x y d"},
    {"# x [mm] y [mm] z [mm] d [mm]\n1 2 3 4\n", 0.0, "mm"},
    {"# lengths in cm\nx y z d\n1 2 3 4\n", 0.0, "line 1 speaks of cm"},
    {"x [mm],y [mm],z [mm],d [mm]\n1,2,3,4\n", 0.0, "column x is in [mm]"},
    {"x,y,z,d (mm)\n1,2,3,4\n", 0.0, "column d is in [mm]"},
    {" one sphere\n\n\t1  atoms # of glass\n\n 0 1 xlo xhi\n\n Atoms # sphere "
     "\n\n  # here\n 1 1 0.5 2500 1 2 3 # the first\n\n Velocities\n\n1 0 0 "
     "0\n",
     0.5, ""},
    {"1000 beads\n\n1 atoms\n\nAtoms\n\n1 1 0.5 2500 1 2 3\n", 0.5, ""},
    {"of glass\n\n3 atoms\n\nAtoms\n\n1 1 0.5 2500 1 2 3\n", 0.0,
     "it counts 3 atoms, but has 1"},
    {"LAMMPS data file, units = lj\n\n1 atoms\n\nAtoms\n\n1 1 1 1 1 2 3\n", 0.0,
     "its units are lj"},
    {"ITEM: UNITS\ncgs\nITEM: ATOMS x y z radius\n1 2 3 4\n", 0.0,
     "its units are cgs"},
    {"ITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS x y z radius\n1 2 3 0.25\nITEM: "
     "NUMBER OF ATOMS\n2\nITEM: ATOMS x y z radius\n1 2 3 0.25\n",
     0.0, "it counts 2 atoms, but has 1"},
};

FACT_FOR_EACH(what_a_file_states_of_its_rows_is_believed_or_refused,
              sizeof stated / sizeof *stated)
{
    long n;

    scratch_listen(dir);
    struct insertion_sphere *const list =
        grain_table_read(file_of(stated[_i].text), &n);
    char *const said = scratch_heard(dir);
    ck_assert_ptr_nonnull(strstr(said, stated[_i].said));
    ck_assert_int_eq(list == NULL, stated[_i].d == 0.0);
    if (list != NULL) ck_assert_double_eq(list[0].x[1], 2.0);
    if (list != NULL) ck_assert_double_eq(list[0].d, stated[_i].d);
    if (list != NULL) ck_assert_str_eq(said, "");
    free(said);
    free(list);
}

FACT(a_table_without_sizes_or_with_half_a_row_is_refused)
{
    static const char *const texts[] = {"x y z\n1 2 3\n",
                                        "x y z d\n1 2 3\n",
                                        "x y z d\n1 2 3 4 5\n",
                                        "x y z d\n1 2 3 -4\n",
                                        "x y z d\n1 2 nan 4\n",
                                        "x y z d\n",
                                        "ITEM: ATOMS id x y radius\n1 2 3 4\n"};
    long n;

    scratch_listen(dir);
    for (int i = 0; i < 7; i++)
        ck_assert_ptr_null(grain_table_read(file_of(texts[i]), &n));
    char *const said = scratch_heard(dir);
    ck_assert_ptr_nonnull(strstr(said, "expected columns x, y, z and d"));
    ck_assert_ptr_nonnull(strstr(said, "line 2: expected 4 numbers"));
    free(said);
}
