/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/tables/input.h"

#include "base/alloc.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

const char *input_wrong(const char *path)
{
    struct stat info;

    errno = 0;
    if (stat(path, &info) != 0) return strerror(errno);
    if (S_ISDIR(info.st_mode)) return "it is a folder";
    if (!S_ISREG(info.st_mode)) return "it is a device or a pipe, not a file";
    return access(path, R_OK) == 0 ? NULL : strerror(errno);
}

/* The length of an open file, or -1. */
static long length_of(FILE *in)
{
    const long length = fseek(in, 0, SEEK_END) == 0 ? ftell(in) : -1;

    return length >= 0 && fseek(in, 0, SEEK_SET) == 0 ? length : -1;
}

/* Room for so many bytes and the zero; NULL, with the reason, if there is not
 * twice as much memory: the numbers of a file take about as much as itself. */
static char *input_room(long size, const char **why)
{
    if (2.0 * (double)size < alloc_left())
        return alloc_zeroed((size_t)size + 1, 1);
    *why = "it takes more memory than is left";
    errno = ENOMEM;
    return NULL;
}

char *input_text(const char *path, size_t *length, const char **why)
{
    *why = input_wrong(path);
    if (*why != NULL) return NULL;
    FILE *const in = fopen(path, "rb");
    const long size = in != NULL ? length_of(in) : -1;
    char *text = NULL;

    if (size >= 0) {
        text = input_room(size, why);
        if (text != NULL) *length = fread(text, 1, (size_t)size, in);
    } else {
        *why = strerror(errno);
    }
    if (in != NULL) fclose(in);
    return text;
}

struct input input_of(const char *path)
{
    struct input in = {.path = strdup(path)};

    in.text = input_text(path, &in.length, &in.why);
    return in;
}

void input_release(struct input *in)
{
    free(in->path);
    free(in->text);
}

/* Of what is packed in some megabytes, which may be without end, no more than
 * `most` [byte] is counted; -1 if it is damaged. */
static long unpacked_size(gzFile f, double most)
{
    static const unsigned piece = 1 << 16;
    char *const bytes = alloc_zeroed(piece, 1);
    long size = 0;
    int n;

    while ((n = gzread(f, bytes, piece)) > 0 && (double)size <= most)
        size += n;
    free(bytes);
    return n < 0 || gzrewind(f) != 0 ? -1 : size;
}

char *input_unpacked(const char *path, size_t *length, const char **why)
{
    static const size_t piece = 1 << 30; /* gzread counts by an int */
    char *text = NULL;

    *why = input_wrong(path);
    if (*why != NULL) return NULL;
    const gzFile f = gzopen(path, "rb");
    const long size = f != NULL ? unpacked_size(f, alloc_left()) : -1;
    *why = "damaged";
    errno = EIO;
    if (size >= 0) text = input_room(size, why);
    for (*length = 0; text != NULL && *length < (size_t)size;) {
        const size_t rest = (size_t)size - *length;
        const int n =
            gzread(f, &text[*length], (unsigned)(rest < piece ? rest : piece));
        if (n <= 0) break;
        *length += (size_t)n;
    }
    if (f != NULL) gzclose(f);
    return text;
}
