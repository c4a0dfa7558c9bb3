/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bed_cache.c -- large beds that were settled once.  Chapter "Nothing is lost".
 *
 * A bed is kept under a name that is a hash of all that decides it: the lines
 * of the case but those that come later (KEY_AFTER_BED), the files that they
 * name, and the program. */
#include "case/resume/bed_cache.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/tables/input.h"
#include "case/resume/case_text.h"

/* A smaller bed settles in a second or two. */
enum { LEAST_COUNT = 2000 };

/* The hash FNV-1a. */
static uint64_t hash(uint64_t h, const char *bytes, size_t n)
{
    for (size_t i = 0; i < n; i++)
        h = (h ^ (unsigned char)bytes[i]) * 0x100000001b3u;
    return h;
}

/* Another version of the program may settle the bed differently. */
static uint64_t hash_of_program(uint64_t h)
{
    size_t length = 0;
    const char *why;
    char *const bytes = input_text("/proc/self/exe", &length, &why);

    if (bytes != NULL) h = hash(h, bytes, length);
    free(bytes);
    return h;
}

static uint64_t hash_of_case(const struct settings *s)
{
    char *const lines = case_text_lines(s);
    uint64_t h = hash_of_program(0xcbf29ce484222325u);

    for (const char *at = lines; *at != '\0'; at += strcspn(at, "\n") + 1)
        if (!case_text_is(at, KEY_AFTER_BED) &&
            strncmp(at, CASE_TEXT_STEP, strlen(CASE_TEXT_STEP)) != 0)
            h = hash(h, at, strcspn(at, "\n") + 1);
    free(lines);
    return h;
}

/* $XDG_CACHE_HOME or ~/.cache; 0 if there is neither. */
static int cache_of(char *path, size_t room)
{
    const char *const cache = getenv("XDG_CACHE_HOME");
    const char *const home = getenv("HOME");

    if (cache != NULL && cache[0] == '/')
        snprintf(path, room, "%s", cache);
    else if (home != NULL && home[0] == '/')
        snprintf(path, room, "%s/.cache", home);
    else
        return 0;
    return 1;
}

static int bed_cache_path_of(const struct settings *s, char *path, size_t room)
{
    if (s->particles.bed_file != NULL || s->particles.bed.count < LEAST_COUNT ||
        s->particles.bed.settle <= 0.0 || !cache_of(path, room))
        return 0;
    const size_t used = strlen(path);
    snprintf(path + used, room - used, "/winnow/bed-%016llx",
             (unsigned long long)hash_of_case(s));
    return 1;
}

void bed_cache_forget(const struct settings *s)
{
    char path[SETTINGS_PATH];

    if (bed_cache_path_of(s, path, sizeof path)) unlink(path);
}

int bed_cache_file(const struct settings *s, char *path, size_t room)
{
    char folder[SETTINGS_PATH];

    if (!bed_cache_path_of(s, path, room)) return 0;
    if (access(path, R_OK) == 0) return 1;
    cache_of(folder, sizeof folder);
    mkdir(folder, 0777);
    strncat(folder, "/winnow", sizeof folder - strlen(folder) - 1);
    mkdir(folder, 0777);
    return access(folder, W_OK) == 0;
}
