/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bed_cache.c -- large beds that were settled once.  Chapter "Nothing is lost".
 *
 * A bed is kept under a name that is a hash of all that decides it: the lines
 * of the case but those that come later (KEY_AFTER_BED), the files that they
 * name, and the program. */
#include "case/resume/resume.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/file.h"
#include "output/checkpoint/state_file.h"

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
    if (s->particles.bed_file != NULL || s->particles.bed_clump != NULL ||
        s->particles.bed.count < LEAST_COUNT ||
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

/* --- the file, a state (state_file.h) ------------------------------------- */

static const char made_with[] = "bed_made_with";

static int bed_cache_save(const char *path, struct particles *ps,
                          struct bed_histories *histories,
                          const struct bed_options *bed,
                          const struct dem_options *dem)
{
    struct state_file *const f = state_file_create();
    char *const facts = bed_made_with(bed, dem);

    state_file_put_text(f, made_with, facts);
    bed_state(ps, histories, bed, dem, state_file_state(f));
    struct state_image image = state_file_image(f);
    const int failed =
        image.bytes == NULL || state_file_write(&image, path, NULL) != 0;
    free(image.bytes);
    free(facts);
    return failed;
}

static const char bed_remedy[] = "remove the file to make the bed anew";

/* Non-zero after a message: the first line that differs says what the bed was
 * made with instead. */
static int is_of_another(const struct input *in, const char *was,
                         const char *now)
{
    while (*was != '\0' || *now != '\0') {
        const int a = (int)strcspn(was, "\n"), b = (int)strcspn(now, "\n");
        if (a != b || strncmp(was, now, (size_t)a) != 0)
            return input_refuse(in, 0,
                                "this bed was made with \"%.*s\", not with "
                                "\"%.*s\"; %s",
                                a, was, b, now, bed_remedy);
        was += a + (was[a] == '\n');
        now += b + (now[b] == '\n');
    }
    return 0;
}

/* Non-zero after a message. */
static int bed_cache_load(struct state_file *f, const struct input *in,
                          struct particles *ps, struct bed_histories *histories,
                          const struct bed_options *bed,
                          const struct dem_options *dem)
{
    char *const was = state_file_text(f, made_with);
    char *const now = bed_made_with(bed, dem);
    struct state *const s = state_file_state(f);
    int wrong = is_of_another(in, was, now);

    s->remedy = bed_remedy;
    if (!wrong) bed_state(ps, histories, bed, dem, s);
    wrong = wrong || s->failed || state_file_all_visited(f) != 0;
    free(was);
    free(now);
    return wrong;
}

static int load_or_create(const struct input *in, struct particles *ps,
                          struct bed_histories *histories,
                          const struct bed_options *bed,
                          const struct dem_options *dem, struct bed_report *r)
{
    const char *why = NULL;
    struct state_file *const f = in != NULL ? state_file_of(in, &why) : NULL;

    if (f == NULL && why != NULL) {
        input_refuse(in, 0, "%s; %s", why, bed_remedy);
        return BED_REFUSED;
    }
    if (f == NULL) {
        const int code = bed_create(ps, bed, dem, r, histories);
        return in != NULL && code == BED_CREATED &&
                       bed_cache_save(in->path, ps, histories, bed, dem) != 0
                   ? BED_UNSAVED
                   : code;
    }
    const int wrong = bed_cache_load(f, in, ps, histories, bed, dem);
    state_file_free(f);
    if (!wrong) bed_measure(ps, bed, dem, r);
    return wrong ? BED_REFUSED : BED_CREATED;
}

int bed_cache_create(const struct input *file, struct particles *ps,
                     struct dem *run, const struct bed_options *bed,
                     const struct dem_options *dem, struct bed_report *r)
{
    struct bed_histories histories = {0, NULL};

    *r = (struct bed_report){.settled = 1};
    const int code = load_or_create(file, ps, &histories, bed, dem, r);
    if (code == BED_CREATED || code == BED_UNSAVED)
        dem_restore_histories(run, histories.list, histories.n);
    free(histories.list);
    return code;
}
