/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/vtk_file.h"

#include "base/alloc.h"
#include "base/file.h"
#include "base/text.h"
#include "output/compressed/vtk_blocks.h"
#include "base/number.h"

#include <assert.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Blanks for an offset and the quote after it: some readers look for the text
 * of the number, without zeros before it. */
enum { OFFSET = 17 };
/* An array whose bytes are still to be written. */
struct pending {
    struct vtk_array array;
    int n;    /* [-] points or cells */
    off_t at; /* [bytes] position of its offset in the file */
};

struct vtk_file {
    struct vtk_blocks *blocks;
    struct file *file;
    FILE *out;
    const char *kind;
    int n_pending;
    struct pending pending[VTK_FILE_ARRAYS];
};

struct vtk_file *vtk_file_create(void)
{
    struct vtk_file *const f = alloc_zeroed(1, sizeof *f);

    f->blocks = vtk_blocks_create();
    return f;
}

void vtk_file_free(struct vtk_file *f)
{
    if (f == NULL) return;
    vtk_blocks_free(f->blocks);
    free(f);
}

static const char *byte_order(void)
{
    const int one = 1;
    return *(const char *)&one ? "LittleEndian" : "BigEndian";
}

static void put_time(FILE *out, double time)
{
    char text[NUMBER_LENGTH];

    fprintf(out,
            "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" "
            "NumberOfTuples=\"1\" format=\"ascii\">%s</DataArray>\n"
            "</FieldData>\n",
            number_text(time, text));
}

int vtk_file_begin(struct vtk_file *f, const char *path, const char *kind,
                   const char *extent, double time)
{
    f->file = file_create(path);
    if (f->file == NULL) return 1;
    f->out = file_stream(f->file);
    f->kind = kind;
    f->n_pending = 0;
    fprintf(f->out,
            "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"%s\" version=\"1.0\" byte_order=\"%s\" "
            "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n"
            "<%s%s>\n",
            kind, byte_order(), kind, extent);
    put_time(f->out, time);
    return 0;
}

FILE *vtk_file_stream(struct vtk_file *f)
{
    return f->out;
}

void vtk_file_array(struct vtk_file *f, const struct vtk_array *a, int n)
{
    assert(f->n_pending < VTK_FILE_ARRAYS);
    assert(a->components >= 1 && a->components <= 9);
    struct pending *const next = &f->pending[f->n_pending++];

    fprintf(f->out, "<DataArray type=\"%s\" Name=\"", vtk_array_type(a));
    text_put(f->out, a->name, TEXT_XML);
    fprintf(f->out,
            "\" NumberOfComponents=\"%d\" format=\"appended\" offset=\"",
            a->components);
    *next = (struct pending){*a, n, ftello(f->out)};
    fprintf(f->out, "%*s/>\n", OFFSET, "");
}

/* VTK silently drops one of two arrays of the same name. */
static int names_differ(int n_arrays, const struct vtk_array *arrays)
{
    for (int i = 0; i < n_arrays; i++)
        for (int j = 0; j < i; j++)
            if (strcmp(arrays[i].name, arrays[j].name) == 0) return 0;
    return 1;
}

void vtk_file_section(struct vtk_file *f, const char *name, int n, int n_arrays,
                      const struct vtk_array *arrays)
{
    assert(names_differ(n_arrays, arrays));
    fprintf(f->out, "<%s>\n", name);
    for (int i = 0; i < n_arrays; i++)
        vtk_file_array(f, &arrays[i], n);
    fprintf(f->out, "</%s>\n", name);
}

int vtk_file_end(struct vtk_file *f)
{
    fprintf(f->out, "</%s>\n<AppendedData encoding=\"raw\">\n_", f->kind);
    const off_t start = ftello(f->out);

    for (int i = 0; i < f->n_pending; i++) {
        const struct pending *const a = &f->pending[i];
        const off_t here = ftello(f->out);

        fseeko(f->out, a->at, SEEK_SET);
        fprintf(f->out, "%lld\"", (long long)(here - start));
        fseeko(f->out, here, SEEK_SET);
        vtk_blocks_write(f->blocks, f->out, &a->array, a->n);
    }
    fprintf(f->out, "\n</AppendedData>\n</VTKFile>\n");
    return file_commit(f->file);
}
