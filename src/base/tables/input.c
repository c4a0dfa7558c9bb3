/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/tables/input.h"

#include "base/alloc.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

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

char *input_text(const char *path, size_t *length, const char **why)
{
    *why = input_wrong(path);
    if (*why != NULL) return NULL;
    FILE *const in = fopen(path, "rb");
    const long size = in != NULL ? length_of(in) : -1;
    char *text = NULL;

    if (size >= 0) {
        text = alloc_zeroed((size_t)size + 1, 1);
        *length = fread(text, 1, (size_t)size, in);
    }
    if (text == NULL) *why = strerror(errno);
    if (in != NULL) fclose(in);
    return text;
}
