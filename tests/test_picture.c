/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/pictures/picture.h"
#include "facts.h"
#include "scratch.h"

static char dir[64];
static struct folder *folder;

static void set_up(void)
{
    scratch_make(dir);
    folder = folder_open(dir);
    ck_assert_int_eq(folder_begin(folder), 0);
}

static void tear_down(void)
{
    folder_free(folder);
    scratch_clear(dir);
}

/* Two cells deep, the front one twice as deep as the back one, and three
 * particles, the first in front of the others. */
static struct mesh *box(void)
{
    return mesh_create_box(&(struct box_spec){
        .size = {0.5, 1.0, 0.3}, .cells = {2, 1, 2}, .grading = {1, 1, 2}});
}

static const double eps[4] = {0.4, 1.0, 0.7, 1.0};
static const double x[3] = {0.1, 0.2, 0.4}, y[3] = {0.5, 0.25, 0.75};
static const double z[3] = {0.25, 0.125, 0.0625}, d[3] = {0.1, 0.2, 0.3};
static const double velocity[12] = {1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 0};
static const double vx[3] = {3.0, 0.0, 0.0}, vy[3] = {4.0, 1.0, 0.0};
static const double vz[3] = {0.0, 0.0, 0.0};

static const double upwards[3] = {0.0, 1.0, 0.0};

static struct picture sample(const struct mesh *m)
{
    return (struct picture){.title = "'A bed's \"_{title}_\" `x` \\",
                            .time = 0.5,
                            .up = upwards,
                            .mesh = m,
                            .eps = eps,
                            .n = 3,
                            .x = {x, y, z},
                            .v = {vx, vy, vz},
                            .d = d};
}

/* 1 if gnuplot has drawn the picture. */
static int drawn_in(struct folder *f)
{
    int drawn = 0;

    ck_assert_int_eq(picture_draw(f, "picture", "bed.png", &drawn), 0);
    return drawn;
}

FACT(particles_are_listed_from_back_to_front)
{
    struct mesh *const m = box();
    const struct picture p = sample(m);

    ck_assert_int_eq(picture_write(folder, &p), 0);
    scratch_assert_text(scratch_path(dir, "picture/particles.txt"),
                        "# x [m]  y [m]  radius [m]  speed [m/s]\n"
                        "0.4 0.75 0.15 0\n"
                        "0.2 0.25 0.1 1\n"
                        "0.1 0.5 0.05 5\n");
    mesh_free(m);
}

/* Left 0.4 in a third of the depth and 0.7 in two: 0.6. */
FACT(the_void_fraction_is_averaged_over_the_depth_by_volume)
{
    struct mesh *const m = box();
    const struct picture p = sample(m);

    ck_assert_int_eq(picture_write(folder, &p), 0);
    scratch_assert_text(scratch_path(dir, "picture/void_fraction.txt"),
                        "# edges of a column of cells: left right bottom top "
                        "[m]  void fraction [-]\n"
                        "0 0.25 0 1 0.6\n"
                        "0.25 0.5 0 1 1\n");
    mesh_free(m);
}

/* The same scene, turned so that z or x leads upwards: what was towards the eye
 * is there still. */
FACT_FOR_EACH(a_picture_has_the_way_up_upwards, 2)
{
    const int up = _i == 0 ? 2 : 0, right = _i == 0 ? 0 : 1,
              deep = 3 - up - right;
    const double upward[3] = {up == 0, up == 1, up == 2};
    struct box_spec spec = {.cells = {2, 2, 2}, .grading = {1, 1, 1}};
    double near[3];

    spec.size[right] = 0.5, spec.size[up] = 1.0, spec.size[deep] = 0.3;
    spec.cells[up] = 1, spec.grading[deep] = 2;
    struct mesh *const m = mesh_create_box(&spec);
    struct picture p = sample(m);
    for (int i = 0; i < 3; i++)
        near[i] = 0.3 - z[i];
    p.up = upward;
    p.x[right] = x, p.x[up] = y, p.x[deep] = near;
    ck_assert_int_eq(picture_write(folder, &p), 0);
    scratch_assert_text(scratch_path(dir, "picture/particles.txt"),
                        _i == 0 ? "# x [m]  z [m]  radius [m]  speed [m/s]\n"
                                  "0.4 0.75 0.15 0\n"
                                  "0.2 0.25 0.1 1\n"
                                  "0.1 0.5 0.05 5\n"
                                : "# y [m]  x [m]  radius [m]  speed [m/s]\n"
                                  "0.4 0.75 0.15 0\n"
                                  "0.2 0.25 0.1 1\n"
                                  "0.1 0.5 0.05 5\n");
    scratch_assert_text(scratch_path(dir, "picture/void_fraction.txt"),
                        "# edges of a column of cells: left right bottom top "
                        "[m]  void fraction [-]\n"
                        "0 0.25 0 1 0.6\n"
                        "0.25 0.5 0 1 1\n");
    mesh_free(m);
}

/* Whether gnuplot drew it: with and without each panel, in a folder whose name
 * needs quoting. Without gnuplot the message must name what to install. */
FACT(gnuplot_draws_every_kind_of_case_or_its_absence_is_reported)
{
    struct mesh *const m = box();
    char name[80], png[96];
    const int here = system("gnuplot --version >/dev/null 2>&1") == 0;

    snprintf(name, sizeof name, "%s/it's a \"bed\"", dir);
    snprintf(png, sizeof png, "%s/bed.png", name);
    struct folder *const odd = folder_open(name);
    ck_assert_int_eq(folder_begin(odd), 0);
    scratch_listen(dir);
    for (int kind = 0; kind < 9; kind++) {
        struct picture p = sample(m);
        p.n = kind & 1 ? 3 : 0;
        p.eps = kind & 2 ? eps : NULL;
        p.pressure = kind & 4 ? 1 : 0;
        if (kind == 8) { /* a flow without particles */
            p.x[0] = NULL;
            p.u = velocity;
            p.p = eps;
        }
        ck_assert_int_eq(picture_write(odd, &p), 0);
        if (p.pressure)
            scratch_write(
                scratch_path(name, "history.csv"),
                kind & 1 ? "time [s],buoyant_weight [Pa],pressure_drop [Pa]\n"
                           "0,100,0\n0.5,100,80\n1,100,101\n"
                         : "time [s],buoyant_weight [Pa],pressure_drop [Pa]\n");
        remove(png);
        ck_assert_int_eq(drawn_in(odd), here);
        ck_assert_int_eq(scratch_exists(png), here);
        ck_assert(!scratch_exists(scratch_path(name, "bed.png.partial")));
    }
    folder_free(odd);
    char *const said = scratch_heard(dir);
    if (here)
        ck_assert_str_eq(said, "");
    else
        ck_assert_ptr_nonnull(strstr(said, "apt-get install gnuplot"));
    free(said);
    mesh_free(m);
}

FACT(without_gnuplot_it_is_said_what_to_install)
{
    struct mesh *const m = box();
    const struct picture p = sample(m);

    scratch_listen(dir);
    ck_assert_int_eq(picture_write(folder, &p), 0);
    setenv("PATH", dir, 1);
    ck_assert_int_eq(drawn_in(folder), 0);
    char *const said = scratch_heard(dir);
    ck_assert_ptr_nonnull(strstr(said, "apt-get install gnuplot-nox"));
    free(said);
    setenv("PATH", "/usr/bin:/bin", 1);
    mesh_free(m);
}

FACT(a_failing_gnuplot_leaves_its_words_and_no_picture)
{
    struct mesh *const m = box();
    const struct picture p = sample(m);

    scratch_listen(dir);
    ck_assert_int_eq(picture_write(folder, &p), 0);
    scratch_write(scratch_path(dir, "gnuplot"),
                  "#!/bin/sh\necho half >$4\necho broken; exit 1\n");
    chmod(scratch_path(dir, "gnuplot"), 0755);
    setenv("PATH", dir, 1);
    ck_assert_int_eq(drawn_in(folder), 0);
    setenv("PATH", "/usr/bin:/bin", 1);
    scratch_assert_text(scratch_path(dir, "picture/gnuplot.log"),
                        GNUPLOT_SAYS "broken\n");
    ck_assert(!scratch_exists(scratch_path(dir, "bed.png")));
    ck_assert(!scratch_exists(scratch_path(dir, "bed.png.partial")));
    char *const said = scratch_heard(dir);
    ck_assert_ptr_nonnull(strstr(said, "picture/gnuplot.log"));
    free(said);
    mesh_free(m);
}

FACT(a_picture_that_cannot_be_written_is_reported)
{
    struct mesh *const m = box();
    const struct picture p = sample(m);

    scratch_listen(dir);
    scratch_write(scratch_path(dir, "picture"), "a file");
    ck_assert_int_ne(picture_write(folder, &p), 0);
    mesh_free(m);
}

FACTS
{
    tcase_add_checked_fixture(facts, set_up, tear_down);
}
