/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/manifest/manifest.h"

#include "base/alloc.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const char summary[] = "summary.json";

static int manifest_complaint(const char *what, const char *dir,
                              const char *name)
{
    fprintf(stderr, "winnow: cannot %s %s/%s: %s\n", what, dir, name,
            strerror(errno));
    return 1;
}

/* --- reading -------------------------------------------------------------- */

/* A name that stays where it is. */
static int is_plain(const char *part, size_t length)
{
    for (size_t i = 0; i < length; i++)
        if ((unsigned char)part[i] < 0x20 || part[i] == 0x7f) return 0;
    return length > 0 && strncmp(part, ".", length) != 0 &&
           strncmp(part, "..", length) != 0;
}

/* "a" or "a/b", or the folder "a/". */
static int manifest_is_inside(const char *name)
{
    const char *const slash = strchr(name, '/');

    if (slash == NULL) return is_plain(name, strlen(name));
    return is_plain(name, (size_t)(slash - name)) &&
           (slash[1] == '\0' || (strchr(slash + 1, '/') == NULL &&
                                 is_plain(slash + 1, strlen(slash + 1))));
}

static int by_name(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

/* The descriptor is not duplicated: to close another one would release the
 * lock. */
char *manifest_text(int file, size_t *length)
{
    struct stat s;

    if (fstat(file, &s) != 0) return NULL;
    if (!S_ISREG(s.st_mode)) {
        errno = EINVAL;
        return NULL;
    }
    char *const text = alloc_zeroed((size_t)s.st_size + 1, 1);
    for (*length = 0; *length < (size_t)s.st_size;) {
        const ssize_t n = pread(file, text + *length,
                                (size_t)s.st_size - *length, (off_t)*length);
        if (n <= 0) {
            free(text);
            return NULL;
        }
        *length += (size_t)n;
    }
    return text;
}

static int foreign(const char *path, int line)
{
    fprintf(stderr,
            "winnow: %s:%d: not the list of a run's files; to run here, move "
            "what is in the folder away, or choose another one with -o\n",
            path, line);
    return 1;
}

/* The names after the head. A last line without a newline was cut off by a
 * crash and is dropped. */
static int manifest_split(struct manifest *m, size_t length, const char *path)
{
    const size_t head = strlen(MANIFEST_HEAD);
    int lines = 0;

    if (length > 0 && strncmp(m->text, MANIFEST_HEAD, head) != 0)
        return foreign(path, 1);
    for (size_t i = 0; i < length; i++)
        lines += m->text[i] == '\n';
    m->name = alloc_zeroed((size_t)lines, sizeof *m->name);
    for (char *at = m->text + (length > 0 ? head : 0), *end;
         (end = memchr(at, '\n', length - (size_t)(at - m->text))) != NULL;
         at = end + 1) {
        *end = '\0';
        if (strlen(at) != (size_t)(end - at) || !manifest_is_inside(at))
            return foreign(path, m->n + 2);
        m->name[m->n++] = at;
    }
    return 0;
}

int manifest_read(struct manifest *m, int file, const char *path)
{
    size_t length = 0;

    *m = (struct manifest){0};
    errno = EIO;
    m->text = manifest_text(file, &length);
    if (m->text == NULL) {
        fprintf(stderr, "winnow: cannot read %s: %s\n", path, strerror(errno));
        return 1;
    }
    if (manifest_split(m, length, path) != 0) return 1;
    qsort(m->name, (size_t)m->n, sizeof *m->name, by_name);
    return 0;
}

void manifest_release(struct manifest *m)
{
    free(m->text);
    free(m->name);
    *m = (struct manifest){0};
}

int manifest_has(const struct manifest *m, const char *name)
{
    return m->n > 0 && bsearch(&name, m->name, (size_t)m->n, sizeof *m->name,
                               by_name) != NULL;
}

/* --- removing ------------------------------------------------------------- */

/* Removes one file, *removed counts it; none is as good. */
static int remove_one(int here, const char *name, int *removed)
{
    if (unlinkat(here, name, 0) != 0) return errno != ENOENT;
    (*removed)++;
    return 0;
}

/* Removes the file and its partial version. */
static int remove_both(int here, const char *name, int *removed)
{
    char *const partial = alloc_zeroed(strlen(name) + 9, 1);
    int parts = 0;

    strcat(strcpy(partial, name), ".partial");
    const int failed = remove_one(here, name, removed) != 0 ||
                       remove_one(here, partial, &parts) != 0;
    free(partial);
    return failed;
}

/* "a/b": b in the folder a, if that is a folder and no link to one. "a/": the
 * folder, if it is empty. */
static int remove_below(int here, const char *name, int *removed)
{
    const char *const slash = strchr(name, '/');
    char *const folder = alloc_zeroed(strlen(name) + 1, 1);
    int failed = 0;

    memcpy(folder, name, (size_t)(slash - name));
    const int below =
        openat(here, folder, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (below < 0)
        failed = errno != ENOENT;
    else if (slash[1] == '\0')
        unlinkat(here, folder, AT_REMOVEDIR);
    else
        failed = remove_both(below, slash + 1, removed);
    const int reason = errno;
    if (below >= 0) close(below);
    free(folder);
    errno = reason;
    return failed;
}

int manifest_remove(const struct manifest *m, int here, const char *dir,
                    int *removed)
{
    *removed = 0;
    if (manifest_has(m, summary) && remove_both(here, summary, removed) != 0)
        return manifest_complaint("remove", dir, summary);
    for (int i = m->n - 1; i >= 0; i--) { /* "a/" after all "a/b" */
        const int failed = strchr(m->name[i], '/') == NULL
                               ? remove_both(here, m->name[i], removed)
                               : remove_below(here, m->name[i], removed);
        if (failed) return manifest_complaint("remove", dir, m->name[i]);
    }
    return 0;
}

/* The names of a text, which it takes over; 0 lines if it is empty. */
static struct manifest manifest_list_of(char *text, size_t length)
{
    struct manifest m = {.text = text};
    int lines = 0;

    for (size_t i = 0; i < length; i++)
        lines += text[i] == '\n';
    m.name = alloc_zeroed((size_t)lines, sizeof *m.name);
    for (char *at = text, *end; (end = strchr(at, '\n')) != NULL;
         at = end + 1) {
        *end = '\0';
        m.name[m.n++] = at;
    }
    qsort(m.name, (size_t)m.n, sizeof *m.name, by_name);
    return m;
}

/* Only the names that `kept` does not have. */
static void forget_kept(struct manifest *m, const struct manifest *kept)
{
    int n = 0;

    for (int i = 0; i < m->n; i++)
        if (manifest_is_inside(m->name[i]) && !manifest_has(kept, m->name[i]))
            m->name[n++] = m->name[i];
    m->n = n;
}

int manifest_cut(int file, const char *path, long length, int here,
                 const char *dir)
{
    size_t all = 0, kept = (size_t)length;
    char *const text = manifest_text(file, &all);
    int removed;

    if (text == NULL || all < kept || kept < strlen(MANIFEST_HEAD)) {
        fprintf(stderr, "winnow: %s lists the files of another run\n", path);
        free(text);
        return 1;
    }
    char *const later = strcpy(alloc_zeroed(all - kept + 1, 1), text + kept);
    text[kept] = '\0';
    struct manifest old = manifest_list_of(text, kept);
    struct manifest gone = manifest_list_of(later, all - kept);
    forget_kept(&gone, &old);
    const int failed = manifest_remove(&gone, here, dir, &removed);
    manifest_release(&old);
    manifest_release(&gone);
    if (!failed && ftruncate(file, length) != 0)
        return manifest_complaint("cut", dir, "manifest.txt");
    return failed;
}
