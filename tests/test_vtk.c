/* SPDX-License-Identifier: GPL-3.0-or-later */
#define FACTS_OWN_MAIN
#include "facts.h"

#include "output/vtk.h"
#include "scratch.h"
#include "vtk_read.h"

#include <math.h>
#include <signal.h>
#include <stdint.h>
#include <sys/resource.h>
#include <zlib.h>

enum { VTK_BLOCK = 65536 }; /* [bytes] of src/output/compressed */

/* With a folder as argument the program writes samples there, which
 * vtk_check.py reads with VTK itself. The values of a sample follow from the
 * index alone: number v of an array is (v % 1009) * 0.375 - 100, exact in
 * single precision too, or for whole numbers 7 v - 3. */

static char dir[64];
static struct vtk_file *writer;

static void set_up(void)
{
    scratch_make(dir);
    writer = vtk_file_create();
}

static void tear_down(void)
{
    vtk_file_free(writer);
    scratch_clear(dir);
}

/* The array is exactly these bytes, and what follows lies right behind it. */
static const unsigned char *assert_array(const struct parts *p,
                                         const char *name, const void *expected,
                                         size_t size)
{
    const unsigned char *next;
    size_t found;
    unsigned char *const bytes = array_of(p, name, &found, &next);

    ck_assert_uint_eq(found, size);
    ck_assert_int_eq(memcmp(bytes, expected, size), 0);
    free(bytes);
    return next;
}

/* --- What is written ------------------------------------------------------ */

static double *sample_values(int n)
{
    double *const a = malloc((size_t)n * sizeof(double) + 1);

    for (int v = 0; v < n; v++)
        a[v] = v % 1009 * 0.375 - 100.0;
    return a;
}

static struct mesh *sample_box(int nx, int ny, int nz)
{
    return mesh_create_box(&(struct box_spec){.size = {0.3, 0.7, 0.11},
                                              .cells = {nx, ny, nz},
                                              .grading = {1.0, 3.0, 0.5}});
}

/* Noise, which zlib cannot shrink: xorshift, in [0, 1). */
static void fill_with_noise(double *a, int n)
{
    uint64_t bits = 88172645463325252u;

    for (int v = 0; v < n; v++) {
        bits ^= bits << 13, bits ^= bits >> 7, bits ^= bits << 17;
        a[v] = (double)(bits >> 11) / 9007199254740992.0;
    }
}

FACT(a_box_reads_back_bit_for_bit)
{
    struct mesh *const m = sample_box(7, 5, 3);
    double p[105], u[315];
    const struct vtk_array arrays[] = {
        {.name = "void_fraction", .components = 1, .values = p},
        {.name = "velocity", .components = 3, .values = u}};
    const char *const path = scratch_path(dir, "a.vtr");

    fill_with_noise(p, 105);
    fill_with_noise(u, 315);
    p[0] = -0.0, p[1] = 4.9e-324, p[2] = 1e308;
    ck_assert_int_eq(vtk_write_box(writer, path, m, 0.1, 2, arrays), 0);

    const struct parts f = parts_of(path);
    ck_assert_ptr_nonnull(strstr(f.text, "WholeExtent=\"0 7 0 5 0 3\""));
    ck_assert_ptr_nonnull(strstr(f.text, "format=\"ascii\">0.1</DataArray>"));
    assert_array(&f, "x", m->box.edge[0], 8 * sizeof(double));
    assert_array(&f, "y", m->box.edge[1], 6 * sizeof(double));
    assert_array(&f, "z", m->box.edge[2], 4 * sizeof(double));
    assert_array(&f, "void_fraction", p, sizeof p);
    ck_assert_ptr_eq(assert_array(&f, "velocity", u, sizeof u), f.end);
    free(f.text);
    mesh_free(m);
}

FACT(particles_read_back_bit_for_bit)
{
    enum { N = 12345 };
    static double a[7][N], side[3 * N];
    static float narrow[3 * N];
    static int id[N], count[N + 1];
    const double *const x[3] = {a[0], a[1], a[2]};
    const struct vtk_array arrays[] = {
        {.name = "velocity", .components = 3, .split = {a[3], a[4], a[5]}},
        {.name = "spin",
         .components = 3,
         .split = {a[3], a[4], a[5]},
         .single = 1},
        {.name = "diameter", .components = 1, .values = a[6]},
        {.name = "id", .components = 1, .ints = id}};
    const char *const path = scratch_path(dir, "a.vtp");

    fill_with_noise(a[0], 7 * N);
    for (int i = 0; i < N; i++)
        id[i] = 3 * i % N, count[i] = i;
    count[N] = N;
    ck_assert_int_eq(vtk_write_particles(writer, path, N, x, 2.5, 4, arrays),
                     0);
    const struct parts f = parts_of(path);
    for (int v = 0; v < 3 * N; v++)
        side[v] = a[v % 3][v / 3];
    assert_array(&f, "position", side, sizeof side);
    for (int v = 0; v < 3 * N; v++)
        side[v] = a[3 + v % 3][v / 3], narrow[v] = (float)side[v];
    assert_array(&f, "velocity", side, sizeof side);
    assert_array(&f, "spin", narrow, sizeof narrow);
    assert_array(&f, "diameter", a[6], sizeof a[6]);
    assert_array(&f, "connectivity", count, sizeof id);
    assert_array(&f, "offsets", count + 1, sizeof id);
    ck_assert_ptr_eq(assert_array(&f, "id", id, sizeof id), f.end);
    free(f.text);
}

FACT(no_particles_leave_empty_arrays)
{
    const double *const x[3] = {NULL, NULL, NULL};
    const struct vtk_array arrays[] = {
        {.name = "velocity", .components = 3, .values = x[0], .from = 1}};
    const char *const path = scratch_path(dir, "a.vtp");

    ck_assert_int_eq(vtk_write_particles(writer, path, 0, x, 0.0, 1, arrays),
                     0);
    const struct parts f = parts_of(path);
    assert_array(&f, "position", "", 0);
    ck_assert_ptr_nonnull(
        strstr(element_of(&f, "position"), "format=\"appended\""));
    ck_assert_ptr_eq(assert_array(&f, "velocity", "", 0), f.end);
    free(f.text);
}

/* One number less than a block, a block, one more, and the same for two. The
 * last word of the header is 0 where the last block is full. */
FACT_FOR_EACH(blocks_may_be_full_or_not, 6)
{
    const int full = VTK_BLOCK / 8;
    const int n = (1 + _i / 3) * full + _i % 3 - 1;
    double *const a = sample_values(n);
    const struct vtk_array array = {.name = "a", .components = 1, .values = a};
    const double *const x[3] = {a, a, a};
    const char *const path = scratch_path(dir, "a.vtp");

    ck_assert_int_eq(vtk_write_particles(writer, path, n, x, 0.0, 1, &array),
                     0);
    const struct parts f = parts_of(path);
    ck_assert_ptr_eq(assert_array(&f, "a", a, (size_t)n * 8), f.end);
    free(f.text);
    free(a);
}

/* Stored, noise grows by 5 bytes in 16 KiB, to 1.0004; compressed at level 0,
 * the smooth array of zeros would not shrink at all. */
FACT(smooth_arrays_shrink_and_noise_does_not_grow)
{
    enum { N = 40000 };
    static double noise[N], smooth[N];
    const struct vtk_array arrays[] = {
        {.name = "noise", .components = 1, .values = noise},
        {.name = "smooth", .components = 1, .values = smooth}};
    const double *const x[3] = {smooth, smooth, smooth};
    const unsigned char *begin, *middle, *end;
    const char *const path = scratch_path(dir, "a.vtp");
    size_t size;

    fill_with_noise(noise, N);
    ck_assert_int_eq(vtk_write_particles(writer, path, N, x, 0.0, 2, arrays),
                     0);
    const struct parts f = parts_of(path);
    free(array_of(&f, "offsets", &size, &begin));
    free(array_of(&f, "noise", &size, &middle));
    free(array_of(&f, "smooth", &size, &end));
    ck_assert_int_lt(middle - begin, (long)(1.01 * sizeof noise));
    ck_assert_int_lt(end - middle, (long)(0.02 * sizeof smooth));
    free(f.text);
}

FACT(names_are_escaped)
{
    struct mesh *const m = sample_box(1, 1, 1);
    const double one = 1.0;
    const struct vtk_array array = {
        .name = "a & b < \"c\" >", .components = 1, .values = &one};
    const char *const path = scratch_path(dir, "a.vtr");

    ck_assert_int_eq(vtk_write_box(writer, path, m, 0.0, 1, &array), 0);
    const struct parts f = parts_of(path);
    assert_array(&f, "a &amp; b &lt; &quot;c&quot; &gt;", &one, sizeof one);
    free(f.text);
    mesh_free(m);
}

FACT(a_full_disk_leaves_nothing_and_the_writer_goes_on)
{
    enum { N = 20000 };
    static double a[N];
    const double *const x[3] = {a, a, a};
    const char *const path = scratch_path(dir, "a.vtp");
    struct rlimit limit, small;

    scratch_listen(dir);
    fill_with_noise(a, N);
    signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &limit);
    small = limit;
    small.rlim_cur = 100000;
    setrlimit(RLIMIT_FSIZE, &small);
    const int failed = vtk_write_particles(writer, path, N, x, 0.0, 0, NULL);
    setrlimit(RLIMIT_FSIZE, &limit);
    ck_assert_int_ne(failed, 0);
    ck_assert(!scratch_exists(path));
    ck_assert(!scratch_exists(scratch_path(dir, "a.vtp.partial")));
    ck_assert_int_eq(vtk_write_particles(writer, path, N, x, 0.0, 0, NULL), 0);
    ck_assert(scratch_exists(path));
}

/* --- Samples for vtk_check.py --------------------------------------------- */

enum { N_COMPONENTS = 5 };

/* Arrays of all component counts in both precisions, and whole numbers. */
static int write_sample(const char *path, const struct mesh *m, int n)
{
    static const int components[N_COMPONENTS] = {1, 2, 3, 6, 9};
    static char names[2 * N_COMPONENTS][16];
    struct vtk_array arrays[2 * N_COMPONENTS + 2];
    double *const values = sample_values(9 * n + 9);
    int *const whole = malloc((size_t)n * sizeof(int) + 1);
    const double *const x[3] = {values, values + 3, values + 6};

    for (int i = 0; i < n; i++)
        whole[i] = 7 * i - 3;
    for (int i = 0; i < 2 * N_COMPONENTS; i++) {
        const int c = components[i / 2];
        snprintf(names[i], sizeof names[i], "%s_%d", i % 2 ? "f32" : "f64", c);
        arrays[i] = (struct vtk_array){.name = names[i],
                                       .components = c,
                                       .values = values,
                                       .single = i % 2};
    }
    arrays[10] =
        (struct vtk_array){.name = "whole", .components = 1, .ints = whole};
    arrays[11] = (struct vtk_array){
        .name = "a & b < \"c\"", .components = 1, .values = values};
    const int failed =
        m ? vtk_write_box(writer, path, m, 0.1, 12, arrays)
          : vtk_write_particles(writer, path, n, x, 0.1, 12, arrays);
    free(whole);
    free(values);
    return failed;
}

static int write_samples(const char *folder)
{
    const int cells[6][3] = {{1, 1, 1}, {40, 1, 1}, {1, 40, 1},
                             {9, 7, 1}, {1, 6, 8},  {31, 23, 19}};
    const int counts[4] = {0, 1, 8192, 50000};
    char name[64];
    int failed = 0;

    writer = vtk_file_create();
    for (int i = 0; i < 6; i++) {
        struct mesh *const m =
            sample_box(cells[i][0], cells[i][1], cells[i][2]);
        snprintf(name, sizeof name, "box_%dx%dx%d.vtr", cells[i][0],
                 cells[i][1], cells[i][2]);
        failed |= write_sample(scratch_path(folder, name), m, m->n_cells);
        mesh_free(m);
    }
    for (int i = 0; i < 4; i++) {
        snprintf(name, sizeof name, "particles_%d.vtp", counts[i]);
        failed |= write_sample(scratch_path(folder, name), NULL, counts[i]);
    }
    vtk_file_free(writer);
    return failed;
}

FACTS
{
    tcase_add_checked_fixture(facts, set_up, tear_down);
}

int main(int n_arguments, char **argument)
{
    return n_arguments == 2 ? write_samples(argument[1]) : facts_run();
}
