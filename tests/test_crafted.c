/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Checkpoints that somebody has made up, each with the right checksums:
 * whatever one holds, the program ends by itself and says one thing. Run under
 * sanitizers this shows that nothing is read or written beyond an array. */
#include <hdf5.h>
#include <limits.h>
#include <math.h>
#include <sys/wait.h>
#include <zlib.h>

#include "facts.h"
#include "scratch.h"

int winnow_main(int argc, char **argv);

static char dir[64];

/* Grains of two materials that touch each other, a wall and a surface, and
 * means of the flow. */
static const char scene[] =
    "mesh = { size = [0.006, 0.012, 0.006]; cells = [3, 6, 3]; };\n"
    "fluid = { density = 1.2; viscosity = 1.8e-5; step = 2e-4; bottom = { "
    "inlet = 0.2; }; top = { outlet = 0.0; }; sides = \"no-slip\"; front_back "
    "= \"slip\"; };\n"
    "particles = { contact = \"linear\"; step = 1e-5; list = \"%s\";\n"
    "  grains = { density = 1000; stiffness = 100; restitution = 0.9; friction "
    "= 0.1; rolling_friction = 0.1; };\n"
    "  materials = ( { name = \"felt\"; stiffness = 10; restitution = 0.5; "
    "friction = 1.0; rolling_friction = 0.1; } );\n"
    "%s"
    "  place = ( { position = [0.003, 0.00199, 0.003]; diameter = 1e-3; },\n"
    "  { position = [0.00305, 0.00298, 0.003]; diameter = 1e-3; },\n"
    "  { position = [0.00049, 0.00399, 0.003]; diameter = 1e-3; } ); };\n"
    "averaging = { method = \"kernel\"; bandwidth = 4e-3; };\n"
    "exchange = { drag = \"syamlal-obrien\"; };\n"
    "effects = { gravity = [0.0, -9.81, 0.0]; pressure_gradient = {}; };\n"
    "output = { end = 4e-3; every = 1e-3; picture = false; statistics = {};\n"
    "  profiles = ( { field = \"u_y\"; height = 0.003; } ); };\n";
static const char walls[] =
    "  surfaces = ( { name = \"floor\"; shape = \"plane\"; point = [0.0, "
    "0.0015, 0.0]; normal = [0.0, 1.0, 0.0]; } );\n";

/* The exit code, or what killed it as a negative number; what it said is in
 * DIR/err. */
static int run(int resume, const char *end)
{
    const pid_t child = fork();
    int status;

    if (child == 0) {
        char *const to_run[] = {"winnow",
                                "run",
                                "a.cfg",
                                "-o",
                                "run",
                                "-j",
                                "1",
                                "--quiet",
                                "-s",
                                (char *)end,
                                resume ? "--resume" : NULL,
                                NULL};
        char *const to_look[] = {"winnow", "status", "run", NULL};
        if (chdir(dir) != 0 || freopen("err", "w", stderr) == NULL ||
            freopen("out", "w", stdout) == NULL)
            _exit(98);
        exit(resume < 0 ? winnow_main(3, (char **)to_look)
                        : winnow_main(resume ? 11 : 10, (char **)to_run));
    }
    ck_assert_int_eq(waitpid(child, &status, 0), child);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

/* Puts the image in the place of the checkpoint, with its last line. */
static void put(const char *image)
{
    size_t n = 0;
    char *const bytes = scratch_read(scratch_path(dir, image), &n);
    FILE *const out = fopen(scratch_path(dir, "run/checkpoint"), "wb");

    fwrite(bytes, 1, n, out);
    fprintf(out, "\nwinnow crc32 %08lx\n\n",
            (unsigned long)crc32_z(0, (unsigned char *)bytes, n));
    fclose(out);
    free(bytes);
    remove(scratch_path(dir, "run/checkpoint.before"));
}

/* A copy of the saved state without its last line, open. */
static hid_t copy(void)
{
    size_t n = 0;
    char *const bytes = scratch_read(scratch_path(dir, "kept"), &n);
    FILE *const out = fopen(scratch_path(dir, "image"), "wb");

    fwrite(bytes, 1, n - 24, out);
    fclose(out);
    free(bytes);
    return H5Fopen(scratch_path(dir, "image"), H5F_ACC_RDWR, H5P_DEFAULT);
}

static void make_state(int which)
{
    char text[sizeof scene + sizeof walls + 64];

    snprintf(text, sizeof text, scene, which ? "link-cells" : "verlet",
             which ? "" : walls);
    scratch_write(scratch_path(dir, "a.cfg"), text);
    ck_assert_int_eq(run(0, "output.end=2e-3"), 0);
    ck_assert_int_eq(
        rename(scratch_path(dir, "run/checkpoint"), scratch_path(dir, "kept")),
        0);
    remove(scratch_path(dir, "run/checkpoint.before"));
}

enum { MOST = 400 };
static char *paths[MOST];
static int n_paths;

static herr_t note(hid_t file, const char *name, const H5O_info_t *info,
                   void *none)
{
    (void)file;
    (void)none;
    if (info->type == H5O_TYPE_DATASET && n_paths < MOST)
        paths[n_paths++] = strdup(name);
    return 0;
}

static void find_arrays(void)
{
    const hid_t file = copy();

    while (n_paths > 0)
        free(paths[--n_paths]);
    H5Ovisit(file, H5_INDEX_NAME, H5_ITER_NATIVE, note, NULL);
    H5Fclose(file);
}

/* Sets the entries of an array, all or the last, and its checksum. 0: it is a
 * text; 1: a whole number; 2: a real one. */
static int poke(const char *path, double value, int all)
{
    const hid_t file = copy(), d = H5Dopen2(file, path, H5P_DEFAULT);
    const hid_t type = H5Dget_type(d), space = H5Dget_space(d);
    const size_t n = (size_t)H5Sget_simple_extent_npoints(space);
    const size_t one = H5Tget_size(type);
    const int kind = H5Tget_class(type) == H5T_FLOAT     ? 2
                     : H5Tget_class(type) == H5T_INTEGER ? 1
                                                         : 0;
    char *const x = calloc(n + 1, one);

    H5Dread(d, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, x);
    for (size_t i = all ? 0 : n - 1; i < n && kind > 0; i++) {
        const int whole = (int)fmin(fmax(value, INT_MIN), INT_MAX);
        const long longer = (long)fmin(fmax(value, -9e18), 9e18);
        memcpy(x + i * one,
               kind == 2  ? (const void *)&value
               : one == 4 ? (const void *)&whole
                          : (const void *)&longer,
               one);
    }
    H5Dwrite(d, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, x);
    const unsigned sum = (unsigned)crc32_z(0, (unsigned char *)x, n * one);
    if (kind > 0) {
        const hid_t a = H5Aopen(d, "crc32", H5P_DEFAULT);
        H5Awrite(a, H5T_NATIVE_UINT, &sum);
        H5Aclose(a);
    }
    free(x);
    H5Sclose(space);
    H5Tclose(type);
    H5Dclose(d);
    H5Fclose(file);
    put("image");
    return kind;
}

/* Ends by itself; where it refuses, it says one thing, and `status` offers no
 * state. */
static int tried(const char *what, double value)
{
    const int code = run(1, "output.end=2.4e-3");
    char *said = scratch_read(scratch_path(dir, "err"), NULL);
    int n = 0;

    for (const char *at = said; (at = strstr(at, "winnow: ")) != NULL; at++)
        n++;
    ck_assert_msg(code == 0 || code == 2 || code == 3, "%s = %g: %d, %s", what,
                  value, code, said);
    ck_assert_msg(code == 0 || n == 1, "%s = %g: %s", what, value, said);
    free(said);
    if (code == 2 && strncmp(what, "recorder/", 9) != 0) {
        ck_assert_int_eq(run(-1, ""), 0);
        said = scratch_read(scratch_path(dir, "out"), NULL);
        ck_assert_msg(strstr(said, "nothing can be resumed") != NULL,
                      "%s = %g: status says %s", what, value, said);
        free(said);
    }
    return code;
}

static const double values[] = {-1.0, INT_MAX, NAN, 1e300, 1e10};
enum { VALUES = sizeof values / sizeof values[0] };

FACT_FOR_EACH(no_number_of_a_checkpoint_leads_out_of_an_array, 2 * VALUES)
{
    int refused = 0;

    make_state(_i % 2);
    find_arrays();
    ck_assert_int_ge(n_paths, 50);
    for (int k = 0; k < n_paths; k++) {
        const double value = values[_i / 2];
        const int kind = poke(paths[k], value, _i / 2 % 2);
        if (kind != (isnan(value) || value > INT_MAX ? 2 : 1)) continue;
        const int code = tried(paths[k], value);
        refused += code == 2;
        if (strcmp(paths[k], "particles/material") == 0)
            ck_assert_msg(code == 2, "a material of %g is taken", value);
        if (kind == 2 && isnan(value) && strncmp(paths[k], "recorder/", 9) != 0)
            ck_assert_msg(code == 2, "%s takes nan", paths[k]);
    }
    ck_assert_int_ge(refused, 4);
}

/* Forms that no state has: an array in the place of a number or a text, a text
 * elsewhere than in its place. */
static void replace(const char *path, hid_t type, int n, size_t size)
{
    const hsize_t shape = (hsize_t)n;
    const hid_t file = copy(), space = H5Screate_simple(1, &shape, NULL);
    char *const bytes = malloc((size_t)n * size + 1);

    memset(bytes, 'A', (size_t)n * size + 1);
    H5Ldelete(file, path, H5P_DEFAULT);
    const hid_t d = H5Dcreate2(file, path, type, space, H5P_DEFAULT,
                               H5P_DEFAULT, H5P_DEFAULT);
    const char *text = "elsewhere";
    H5Dwrite(d, type, H5S_ALL, H5S_ALL, H5P_DEFAULT,
             size == 0 ? (const void *)&text : bytes);
    free(bytes);
    H5Dclose(d);
    H5Sclose(space);
    H5Fclose(file);
    put("image");
}

FACT(a_number_or_a_text_of_another_form_is_refused)
{
    static const char *const texts[] = {"/settings", "/case_file", "/program"};

    make_state(0);
    for (int i = 0; i < 7; i++) {
        const hid_t type = H5Tcopy(H5T_C_S1);
        H5Tset_size(type, i < 3 ? 64 : H5T_VARIABLE);
        if (i < 6)
            replace(texts[i % 3], type, i < 3 ? 1000 : 1, i < 3 ? 64 : 0);
        else
            replace("/t", H5T_NATIVE_DOUBLE, 1000, 8);
        ck_assert_int_eq(tried(texts[i % 3], i), 2);
        ck_assert_int_eq(run(-1, ""), 0);
        char *const said = scratch_read(scratch_path(dir, "out"), NULL);
        ck_assert_ptr_nonnull(strstr(said, "cannot be used"));
        free(said);
        H5Tclose(type);
    }
}

/* In memory where that can be had, for each run waits for the disk. */
static void set_up(void)
{
    strcpy(dir, "/dev/shm/winnow-test-XXXXXX");
    if (mkdtemp(dir) == NULL) scratch_make(dir);
}

static void tear_down(void)
{
    scratch_clear(dir);
}

FACTS
{
    tcase_add_checked_fixture(facts, set_up, tear_down);
    tcase_set_timeout(facts, 300);
}
