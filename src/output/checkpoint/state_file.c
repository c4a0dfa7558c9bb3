/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/checkpoint/state_file.h"

#include <hdf5.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <zlib.h>

#include "base/alloc.h"
#include "base/file.h"
#include "base/text.h"

struct state_file {
    struct state state;
    hid_t file;
    char *path;  /* for messages */
    long arrays; /* [-] visited so far */
    int kept;    /* 1: what the file was made in remains when it is closed */
    unsigned char *memory; /* then this */
};

/* The last line: the checksum of all bytes before it. */
enum { LAST_LINE = 24, GROWTH = 1 << 20 };

static void state_file_last_line(char line[LAST_LINE + 1],
                                 const unsigned char *bytes, size_t size)
{
    snprintf(line, LAST_LINE + 1, "\nwinnow crc32 %08lx\n\n",
             (unsigned long)crc32_z(0, bytes, size));
}

/* --- in and out ----------------------------------------------------------- */

static hid_t state_file_type_of(enum state_type type)
{
    return type == STATE_REAL    ? H5T_NATIVE_DOUBLE
           : type == STATE_WHOLE ? H5T_NATIVE_INT
                                 : H5T_NATIVE_LONG;
}

static size_t state_file_bytes_of(const struct state_array *a)
{
    const size_t one = a->type == STATE_REAL    ? sizeof(double)
                       : a->type == STATE_WHOLE ? sizeof(int)
                                                : sizeof(long);
    return one * (size_t)a->rows * (size_t)a->width;
}

static unsigned checksum(const struct state_array *a)
{
    return (unsigned)crc32_z(0, a->values, state_file_bytes_of(a));
}

/* Of one row or column: a list, else a table. */
static int state_file_shape_of(const struct state_array *a, hsize_t shape[2])
{
    shape[0] = (hsize_t)a->rows;
    shape[1] = (hsize_t)a->width;
    return a->width > 1 ? 2 : 1;
}

static int put_attribute(hid_t at, const char *name, hid_t type,
                         const void *value)
{
    const hid_t space = H5Screate(H5S_SCALAR);
    const hid_t made =
        H5Acreate2(at, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    const int failed = H5Awrite(made, type, value) < 0;

    H5Aclose(made);
    H5Sclose(space);
    return failed;
}

static hid_t string_type(const char *text)
{
    const hid_t type = H5Tcopy(H5T_C_S1);

    H5Tset_size(type, strlen(text) + 1);
    return type;
}

static int state_file_write_text(hid_t at, const char *name, const char *text)
{
    const hid_t type = string_type(text);
    const int failed = put_attribute(at, name, type, text);
    H5Tclose(type);
    return failed;
}

static int state_file_save(void *store, const struct state_array *a)
{
    struct state_file *const f = store;
    const unsigned sum = checksum(a);
    hsize_t shape[2];
    const hid_t space =
        H5Screate_simple(state_file_shape_of(a, shape), shape, NULL);
    const hid_t with = H5Pcreate(H5P_LINK_CREATE);

    H5Pset_create_intermediate_group(with, 1);
    const hid_t made = H5Dcreate2(f->file, a->path, state_file_type_of(a->type),
                                  space, with, H5P_DEFAULT, H5P_DEFAULT);
    const int failed = H5Dwrite(made, state_file_type_of(a->type), H5S_ALL,
                                H5S_ALL, H5P_DEFAULT, a->values) < 0 ||
                       state_file_write_text(made, "unit", a->unit) != 0 ||
                       put_attribute(made, "crc32", H5T_NATIVE_UINT, &sum) != 0;
    H5Dclose(made);
    H5Pclose(with);
    H5Sclose(space);
    f->arrays++;
    if (failed)
        fprintf(stderr, "winnow: the state cannot be saved: %s\n", a->path);
    return failed;
}

static int has_shape(hid_t data, const struct state_array *a)
{
    hsize_t shape[2], there[2] = {0, 0};
    const int n = state_file_shape_of(a, shape);
    const hid_t space = H5Dget_space(data);
    const int fits = H5Sget_simple_extent_ndims(space) == n &&
                     H5Sget_simple_extent_dims(space, there, NULL) == n &&
                     there[0] == shape[0] && (n < 2 || there[1] == shape[1]);

    H5Sclose(space);
    return fits;
}

/* A single number beside an array or the whole; -1 if there is none. */
static long attribute(hid_t of, const char *name)
{
    const hid_t at = H5Aopen(of, name, H5P_DEFAULT);
    const hid_t space = at < 0 ? at : H5Aget_space(at);
    long value = -1;

    if (space >= 0 && H5Sget_simple_extent_npoints(space) == 1)
        H5Aread(at, H5T_NATIVE_LONG, &value);
    if (space >= 0) H5Sclose(space);
    if (at >= 0) H5Aclose(at);
    return value;
}

/* Opens what lies in the file in one piece, all of it: what is neither packed
 * nor elsewhere takes no more room than the file. *bytes are its size. */
static hid_t opened_array(hid_t file, const char *path, size_t *bytes)
{
    const hid_t data = H5Dopen2(file, path, H5P_DEFAULT);

    *bytes = 0;
    if (data < 0) return data;
    const hid_t how = H5Dget_create_plist(data), type = H5Dget_type(data),
                space = H5Dget_space(data);
    const hssize_t n = H5Sget_simple_extent_npoints(space);
    if (H5Pget_layout(how) == H5D_CONTIGUOUS &&
        H5Pget_external_count(how) == 0 && n > 0 &&
        H5Dget_storage_size(data) / (hsize_t)n == H5Tget_size(type))
        *bytes = (size_t)H5Dget_storage_size(data);
    H5Sclose(space);
    H5Tclose(type);
    H5Pclose(how);
    if (*bytes > 0) return data;
    H5Dclose(data);
    return H5I_INVALID_HID;
}

/* Of what moves; means and pictures have cells where nothing was, and a single
 * number may say that nothing came yet. */
static int has_no_number(const struct state_array *a)
{
    const double *const x = a->values;
    const long n = a->rows * a->width;

    if (a->type != STATE_REAL || strncmp(a->path, "/recorder/", 10) == 0)
        return 0;
    for (long i = 0; i < n; i++)
        if (n > 1 ? !isfinite(x[i]) : isnan(x[i])) return 1;
    return 0;
}

static int state_file_load(void *store, const struct state_array *a)
{
    struct state_file *const f = store;
    size_t bytes;
    const hid_t data = opened_array(f->file, a->path, &bytes);

    if (data < 0)
        return state_wrong(&f->state, "%s is not there, which this case needs",
                           a->path);
    const char *why = NULL;
    if (!has_shape(data, a))
        why = "has another number of entries than this case";
    else if (H5Dread(data, state_file_type_of(a->type), H5S_ALL, H5S_ALL,
                     H5P_DEFAULT, a->values) < 0)
        why = "cannot be read";
    else if (attribute(data, "crc32") != (long)checksum(a))
        why = "is damaged: its checksum does not match";
    else if (has_no_number(a))
        why = "has an entry that is no finite number";
    H5Dclose(data);
    f->arrays++;
    return why != NULL ? state_wrong(&f->state, "%s %s", a->path, why) : 0;
}

/* --- files ---------------------------------------------------------------- */

/* HDF5 would print its own account of each failure. */
static hid_t in_memory(void)
{
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);

    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    H5Pset_fapl_core(access, GROWTH, 0);
    return access;
}

/* The path becomes its own. */
static struct state_file *file_of(hid_t file, char *path, int loading)
{
    struct state_file *const f = alloc_zeroed(1, sizeof *f);

    f->file = file;
    f->path = path;
    f->state.loading = loading;
    f->state.visit = loading ? state_file_load : state_file_save;
    f->state.store = f;
    f->state.file = f->path;
    f->state.remedy = "run the case anew, without --resume";
    return f;
}

/* What HDF5 makes a file in is ours: a copy would be as large again. Room that
 * is not written to takes no memory, and a block with so much of it grows where
 * it is: small ones leave a hole at each step. */
enum { ROOM = 1 << 26 };

static void *memory_grown(void *memory, size_t size, H5FD_file_image_op_t why,
                          void *of)
{
    (void)why, (void)of;
    return realloc(memory, size + ROOM);
}

static herr_t memory_left(void *memory, H5FD_file_image_op_t why, void *of)
{
    struct state_file *const f = of;

    (void)why;
    if (f->kept)
        f->memory = memory;
    else
        free(memory);
    return 0;
}

static void *state_file_same(void *of)
{
    return of;
}

static herr_t state_file_remains(void *of)
{
    (void)of;
    return 0;
}

struct state_file *state_file_create(void)
{
    struct state_file *const f = file_of(-1, strdup("state"), 0);
    H5FD_file_image_callbacks_t ours = {.image_realloc = memory_grown,
                                        .image_free = memory_left,
                                        .udata_copy = state_file_same,
                                        .udata_free = state_file_remains,
                                        .udata = f};
    const hid_t access = in_memory();

    H5Pset_file_image_callbacks(access, &ours);
    f->file = H5Fcreate("state", H5F_ACC_TRUNC, H5P_DEFAULT, access);
    H5Pclose(access);
    return f;
}

void state_file_free(struct state_file *f)
{
    if (f == NULL) return;
    if (f->file >= 0) H5Fclose(f->file);
    free(f->path);
    free(f);
}

struct state *state_file_state(struct state_file *f)
{
    return &f->state;
}

void state_file_put_text(struct state_file *f, const char *name,
                         const char *text)
{
    const hid_t type = string_type(text), space = H5Screate(H5S_SCALAR);
    const hid_t made = H5Dcreate2(f->file, name, type, space, H5P_DEFAULT,
                                  H5P_DEFAULT, H5P_DEFAULT);

    H5Dwrite(made, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text);
    H5Dclose(made);
    H5Sclose(space);
    H5Tclose(type);
}

/* The number of arrays is written last. */
struct state_image state_file_image(struct state_file *f)
{
    struct state_image image = {NULL, 0};

    put_attribute(f->file, "arrays", H5T_NATIVE_LONG, &f->arrays);
    H5Fflush(f->file, H5F_SCOPE_GLOBAL);
    const ssize_t size = H5Fget_file_image(f->file, NULL, 0);
    f->kept = !f->state.failed && size > 0;
    H5Fclose(f->file);
    f->file = -1;
    if (f->kept) {
        image.size = (size_t)size + LAST_LINE;
        image.bytes = realloc(f->memory, image.size + 1);
    }
    if (image.bytes != NULL)
        state_file_last_line((char *)image.bytes + size, image.bytes,
                             (size_t)size);
    state_file_free(f);
    return image;
}

/* The old file gets its second name when the new one has been written, so a
 * full disk leaves both as they were; a file system without such names keeps
 * one. */
int state_file_write(const struct state_image *image, const char *path,
                     const char *before)
{
    struct file *const f = file_create(path);

    if (f == NULL) return 1;
    FILE *const out = file_stream(f);
    if (fwrite(image->bytes, 1, image->size, out) == image->size &&
        fflush(out) == 0 && before != NULL && access(path, F_OK) == 0) {
        unlink(before);
        (void)!link(path, before);
    }
    return file_commit(f);
}

/* A file whose bytes are all there, and as they were written. */
static int is_whole(const char *bytes, size_t length)
{
    char line[LAST_LINE + 1];

    if (length < LAST_LINE) return 0;
    state_file_last_line(line, (const unsigned char *)bytes,
                         length - LAST_LINE);
    return memcmp(bytes + length - LAST_LINE, line, LAST_LINE) == 0;
}

/* Two images of one name that are open at a time would be one for HDF5, and
 * there must be no file of that name. */
static hid_t state_file_opened(const char *path, char *bytes, size_t length)
{
    const hid_t access = in_memory();
    char *const name = file_join(path, "image");

    H5Pset_file_image(access, bytes, length);
    const hid_t file = H5Fopen(name, H5F_ACC_RDONLY, access);
    H5Pclose(access);
    free(name);
    return file;
}

/* A text of a length that is fixed, as each is written; NULL if it is none. */
static char *state_file_read_text(const struct state_file *f, const char *name)
{
    size_t bytes;
    const hid_t at = opened_array(f->file, name, &bytes);
    char *text = NULL;

    if (at < 0) return NULL;
    const hid_t type = H5Dget_type(at);
    if (H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0 &&
        H5Tget_size(type) == bytes) {
        text = alloc_zeroed(bytes + 1, 1);
        H5Dread(at, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text);
    }
    H5Tclose(type);
    H5Dclose(at);
    return text;
}

/* Lines without other control characters, for texts are shown. */
char *state_file_text(struct state_file *f, const char *name)
{
    char *const text = state_file_read_text(f, name);

    if (text == NULL) return alloc_zeroed(1, 1);
    for (char *line = text, *end; *line != '\0'; line = end) {
        end = line + strcspn(line, "\n");
        const char kept = *end;
        *end = '\0';
        text_blank(line);
        *end = kept;
        end += kept != '\0';
    }
    return text;
}

double state_file_number(struct state_file *f, const char *path)
{
    size_t bytes;
    const hid_t at = opened_array(f->file, path, &bytes);
    double x = NAN;

    if (at < 0) return NAN;
    const hid_t type = H5Dget_type(at);
    if (bytes == H5Tget_size(type))
        H5Dread(at, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, &x);
    H5Tclose(type);
    H5Dclose(at);
    return x;
}

/* 1 if the texts that there are can be read, and the time is one. */
static int has_form(struct state_file *f)
{
    static const char *const names[] = {"program", "case_file", "case",
                                        "settings"};
    int holds = H5Lexists(f->file, "t", H5P_DEFAULT) <= 0 ||
                (state_file_number(f, "/t") >= 0.0 &&
                 isfinite(state_file_number(f, "/t")));

    for (int i = 0; i < 4 && holds; i++) {
        char *const text = state_file_read_text(f, names[i]);
        holds = text != NULL || H5Lexists(f->file, names[i], H5P_DEFAULT) <= 0;
        free(text);
    }
    return holds;
}

struct state_file *state_file_open(const char *path, const char **why)
{
    struct input in = input_of(path);
    struct state_file *const f = state_file_of(&in, why);

    input_release(&in);
    return f;
}

struct state_file *state_file_of(const struct input *in, const char **why)
{
    *why = access(in->path, F_OK) == 0 ? in->why : NULL;
    if (in->text == NULL) return NULL;
    *why = "it is damaged: its checksum does not match";
    const hid_t file =
        is_whole(in->text, in->length)
            ? state_file_opened(in->path, in->text, in->length - LAST_LINE)
            : H5I_INVALID_HID;
    if (file < 0) return NULL;
    struct state_file *const f = file_of(file, input_named(in), 1);
    f->state.most = (long)(in->length / sizeof(int));
    *why = "its time or a text in it is of another form";
    if (has_form(f)) return f;
    state_file_free(f);
    return NULL;
}

int state_file_all_visited(const struct state_file *f)
{
    const long arrays = attribute(f->file, "arrays");

    if (arrays == f->arrays) return 0;
    return state_wrong(&f->state,
                       "it has %ld arrays, of which this case knows %ld",
                       arrays, f->arrays);
}
