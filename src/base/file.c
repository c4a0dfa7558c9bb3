/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/file.h"

#include "base/alloc.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

struct file {
    FILE *stream;
    char *path;    /* final name */
    char *partial; /* name until file_commit */
};

static char *joined(const char *a, const char *b, const char *c)
{
    const size_t la = strlen(a), lb = strlen(b), lc = strlen(c);
    char *const s = alloc_zeroed(la + lb + lc + 1, 1);

    memcpy(s, a, la);
    memcpy(s + la, b, lb);
    memcpy(s + la + lb, c, lc);
    return s;
}

static int file_report_failure(const char *what, const char *path, int reason)
{
    fprintf(stderr, "winnow: cannot %s %s: %s\n", what, path,
            reason ? strerror(reason) : "a write failed");
    return 1;
}

static void file_release(struct file *f)
{
    free(f->path);
    free(f->partial);
    free(f);
}

/* The reason why the stream failed, or 0 if it did not. A stream records that a
 * write failed but not why, so the write is tried once more: a full disk is
 * still full. Only an unknown reason becomes EIO. */
static int failure(FILE *stream)
{
    const int failed_before = ferror(stream);

    errno = 0;
    if (failed_before) {
        clearerr(stream);
        fputc('\n', stream);
    }
    if (fflush(stream) != 0 || fsync(fileno(stream)) != 0 || failed_before)
        return errno ? errno : EIO;
    return 0;
}

/* Opens a new file: neither an existing one nor the target of a link of that
 * name. */
static FILE *open_new(const char *path)
{
    unlink(path);
    const int file =
        open(path, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    return file < 0 ? NULL : fdopen(file, "wb");
}

/* Whose file PATH.partial is: another program that began to write the same path
 * later has replaced ours, and will rename its own. */
enum owner { NOBODY, ANOTHER, OURS };

static enum owner owner_of(const struct file *f)
{
    struct stat own, named;

    if (fstat(fileno(f->stream), &own) != 0 || lstat(f->partial, &named) != 0)
        return NOBODY;
    return own.st_ino == named.st_ino && own.st_dev == named.st_dev ? OURS
                                                                    : ANOTHER;
}

struct file *file_create(const char *path)
{
    struct file *const f = alloc_zeroed(1, sizeof *f);

    f->path = joined(path, "", "");
    f->partial = joined(path, ".partial", "");
    f->stream = open_new(f->partial);
    if (f->stream == NULL) {
        file_report_failure("write", f->partial, errno);
        file_release(f);
        return NULL;
    }
    return f;
}

FILE *file_stream(struct file *f)
{
    return f->stream;
}

/* The folder itself is not synced: after a power cut it may still name the old
 * file, which is whole too. */
int file_commit(struct file *f)
{
    int reason = failure(f->stream);
    const enum owner owner = owner_of(f);

    if (fclose(f->stream) != 0 && reason == 0) reason = errno;
    if (reason == 0 && owner == NOBODY) reason = ENOENT;
    if (reason == 0 && owner == OURS && rename(f->partial, f->path) != 0)
        reason = errno;
    if (reason != 0) {
        file_report_failure("write", f->path, reason);
        if (owner == OURS) remove(f->partial);
    }
    file_release(f);
    return reason != 0;
}

void file_discard(struct file *f)
{
    if (f == NULL) return;
    if (owner_of(f) == OURS) remove(f->partial);
    fclose(f->stream);
    file_release(f);
}

void file_remove_part(const char *path)
{
    char *const partial = joined(path, ".partial", "");

    remove(partial);
    free(partial);
}

static int is_folder(const char *path)
{
    struct stat s;
    return stat(path, &s) == 0 && S_ISDIR(s.st_mode);
}

int file_make_dirs(const char *path)
{
    char *const part = joined(path, "", "");
    int reason = 0;

    for (char *p = part; *p && reason == 0; p++) {
        char *const end = p + 1;
        const char kept = *end;

        if (kept != '/' && kept != '\0') continue;
        *end = '\0';
        const int failed = mkdir(part, 0777) != 0 ? errno : 0;
        if (failed && !is_folder(part)) reason = failed;
        *end = kept;
    }
    if (reason != 0) file_report_failure("make the folder", path, reason);
    free(part);
    return reason != 0;
}

char *file_join(const char *folder, const char *name)
{
    return joined(folder, "/", name);
}
