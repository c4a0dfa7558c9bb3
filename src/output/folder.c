/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/folder.h"

#include "base/alloc.h"
#include "base/file.h"

#include <assert.h>
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const char manifest[] = "manifest.txt";
static const char ahead[] = FOLDER_EARLY_FILE;

struct folder {
    char *dir;
    size_t there; /* [bytes] of dir that were a folder before */
    char *path;   /* of the manifest */
    int here;     /* descriptor of the folder; negative: not open */
    int file;     /* of the manifest, locked; negative: not open */
    int fresh;    /* [-] 1: the manifest was not there before */
    int resumes;  /* [-] 1: what is listed stays, tables are continued */
    int headed;   /* [-] 1: the manifest has its head already */
    off_t length; /* [bytes] of the manifest, whole lines */
    struct manifest old;
};

/* --- ownership of the folder ---------------------------------------------- */

/* Cuts the last name off a path; returns the length that is left. */
static size_t cut_last(char *path)
{
    size_t n = strlen(path);

    while (n > 0 && path[n - 1] == '/')
        n--;
    while (n > 0 && path[n - 1] != '/')
        n--;
    path[n] = '\0';
    return n;
}

/* The length of the part of the path that exists already. */
static size_t length_there(const char *dir)
{
    char *const part = strcpy(alloc_zeroed(strlen(dir) + 1, 1), dir);
    size_t n = strlen(part);
    struct stat s;

    while (n > 0 && stat(part, &s) != 0) {
        n = cut_last(part);
    }
    free(part);
    return n;
}

/* Non-zero after a message if another process has the lock. */
static int lock(struct folder *f)
{
    struct flock l = {.l_type = F_WRLCK, .l_whence = SEEK_SET};

    if (fcntl(f->file, F_SETLK, &l) == 0) return 0;
    f->fresh = 0;
    if (errno != EACCES && errno != EAGAIN)
        return file_report_failure("lock", f->path, errno);
    fcntl(f->file, F_GETLK, &l);
    fprintf(stderr,
            "winnow: another run (process %ld) writes into %s; wait for its "
            "end, or choose another folder with -o\n",
            (long)l.l_pid, f->dir);
    return 1;
}

/* The manifest may have been removed between our opening and our lock. */
static int is_still_there(const struct folder *f)
{
    struct stat own, named;

    return fstat(f->file, &own) == 0 &&
           fstatat(f->here, manifest, &named, AT_SYMLINK_NOFOLLOW) == 0 &&
           own.st_ino == named.st_ino && own.st_dev == named.st_dev;
}

static int open_manifest(struct folder *f)
{
    const int how = O_RDWR | O_APPEND | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;

    f->file = openat(f->here, manifest, how | O_CREAT | O_EXCL, 0666);
    f->fresh = f->file >= 0;
    if (f->file < 0 && errno == EEXIST)
        f->file = openat(f->here, manifest, how);
    return f->file < 0 && errno != ENOENT
               ? file_report_failure("write", f->path, errno)
               : 0;
}

static int folder_open_locked(struct folder *f)
{
    if (file_make_dirs(f->dir) != 0) return 1;
    f->here = open(f->dir, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (f->here < 0)
        return file_report_failure("open the folder", f->dir, errno);
    for (int turn = 0; turn < 100; turn++) {
        if (open_manifest(f) != 0) return 1;
        if (f->file < 0) continue; /* removed, since it existed */
        if (lock(f) != 0) return 1;
        if (is_still_there(f)) return 0;
        close(f->file);
        f->file = -1;
    }
    errno = ENOENT;
    return file_report_failure("write", f->path, errno);
}

/* --- contents of the folder ----------------------------------------------- */

/* Non-zero after a message for the first name of the old list under which no
 * run has written what is there: a list from elsewhere removes nothing. */
static int lists_foreign(const struct folder *f)
{
    for (int i = 0; i < f->old.n; i++) {
        if (manifest_is_of_run(f->here, f->old.name[i])) continue;
        fprintf(stderr,
                "winnow: %s lists %s, and no run has written that; to run "
                "here, move what is in the folder away, or choose another one "
                "with -o\n",
                f->path, f->old.name[i]);
        return 1;
    }
    return 0;
}

static int folder_is_foreign(const struct folder *f, const char *name)
{
    if (manifest_contents(name) == NULL || manifest_has(&f->old, name))
        return 0;
    if ((manifest_is_half(name) || strcmp(name, "report.html") == 0) &&
        manifest_is_of_run(f->here, name))
        return 0;
    if (f->fresh)
        fprintf(stderr,
                "winnow: %s is not there, the list of the files of a run: "
                "without it %s/%s may be another program's; move it away, or "
                "choose another folder with -o\n",
                f->path, f->dir, name);
    else
        fprintf(stderr,
                "winnow: %s/%s is in the way: no run that %s tells of has "
                "written it; move it away, or choose another folder with -o\n",
                f->dir, name, manifest);
    return 1;
}

/* Non-zero after a message if a run would overwrite something there. */
static int looked_into(const struct folder *f, const char *folder)
{
    const int file =
        openat(f->here, folder, O_RDONLY | O_DIRECTORY | O_NOFOLLOW);
    DIR *const list = file < 0 ? NULL : fdopendir(file);
    int wrong = 0;

    if (list == NULL && errno == ENOENT) return 0;
    if (list == NULL) {
        fprintf(stderr,
                "winnow: %s/%s is in the way: a run needs a folder of that "
                "name; move it away, or choose another folder with -o\n",
                f->dir, folder);
        return 1;
    }
    for (struct dirent *e; !wrong && (e = readdir(list)) != NULL;) {
        if (strcmp(e->d_name, ".") == 0 || strcmp(e->d_name, "..") == 0)
            continue;
        char *const name = file_join(folder, e->d_name);
        wrong = folder_is_foreign(f, name[0] == '.' ? name + 2 : name);
        free(name);
    }
    closedir(list);
    return wrong;
}

long folder_process(const char *dir)
{
    char *const path = file_join(dir, manifest);
    const int file = open(path, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    struct flock l = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
    const int found = file >= 0 && fcntl(file, F_GETLK, &l) == 0;

    if (file >= 0) close(file);
    free(path);
    return found && l.l_type != F_UNLCK ? (long)l.l_pid : 0;
}

void folder_abandon(struct folder *f)
{
    char *const part = strcpy(alloc_zeroed(strlen(f->dir) + 1, 1), f->dir);
    size_t n = strlen(part);

    if (f->fresh && faccessat(f->here, ahead, F_OK, 0) != 0)
        unlinkat(f->here, manifest, 0);
    while (n > f->there) {
        rmdir(part); /* if it is empty */
        n = cut_last(part);
    }
    free(part);
}

void folder_free(struct folder *f)
{
    if (f == NULL) return;
    if (f->file >= 0) close(f->file);
    if (f->here >= 0) close(f->here);
    manifest_release(&f->old);
    free(f->dir);
    free(f->path);
    free(f);
}

struct folder *folder_open(const char *dir)
{
    struct folder *const f = alloc_zeroed(1, sizeof *f);

    f->here = f->file = -1;
    f->dir = strcpy(alloc_zeroed(strlen(dir) + 1, 1), dir);
    f->path = file_join(dir, manifest);
    f->there = length_there(dir);
    int wrong =
        folder_open_locked(f) || manifest_read(&f->old, f->file, f->path);
    for (int i = 0; manifest_folders[i] != NULL && !wrong; i++)
        wrong = looked_into(f, manifest_folders[i]);
    if (!wrong && !lists_foreign(f)) return f;
    folder_abandon(f);
    folder_free(f);
    return NULL;
}

/* An empty list. Non-zero after a message. */
static int write_head(struct folder *f)
{
    f->length = (off_t)strlen(MANIFEST_HEAD);
    errno = ENOSPC; /* if only a part is written */
    f->headed = ftruncate(f->file, 0) == 0 &&
                write(f->file, MANIFEST_HEAD, (size_t)f->length) == f->length;
    return f->headed ? 0 : file_report_failure("write", f->path, errno);
}

/* Makes an empty list, where there is none yet. */
char *folder_early_file(struct folder *f)
{
    if (f->fresh && !f->headed && write_head(f) != 0) return NULL;
    return file_join(f->dir, FOLDER_EARLY_FILE);
}

int folder_is_used(const struct folder *f)
{
    return f->old.n > 0;
}

int folder_begin(struct folder *f)
{
    int removed;

    if (manifest_remove(&f->old, f->here, f->dir, &removed) != 0) return 1;
    manifest_release(&f->old);
    f->fresh = 0;
    return write_head(f);
}

void folder_resume(struct folder *f)
{
    f->resumes = 1;
    f->fresh = 0;
    f->length = lseek(f->file, 0, SEEK_END);
}

void folder_state(struct folder *f, struct state *s)
{
    long length = (long)f->length;

    if (!s->loading && fsync(f->file) != 0)
        s->failed = file_report_failure("write", f->path, errno);
    state_long(s, "manifest_bytes", "-", &length);
    if (!s->loading || s->failed) return;
    s->failed = manifest_cut(f->file, f->path, length, f->here, f->dir) != 0;
    f->length = (off_t)length;
    f->resumes = 0;
}

int folder_add(struct folder *f, const char *name)
{
    if (f->resumes && manifest_has(&f->old, name)) return 0;
    const size_t length = strlen(name);
    char *const line = strcpy(alloc_zeroed(length + 2, 1), name);

    assert(manifest_contents(name) != NULL || manifest_is_folder(name));
    line[length] = '\n';
    errno = ENOSPC; /* if only a part is written */
    const ssize_t n = write(f->file, line, length + 1);
    free(line);
    if (n == (ssize_t)length + 1) {
        f->length += n;
        return 0;
    }
    file_report_failure("write", f->path, errno);
    if (n > 0 && ftruncate(f->file, f->length) != 0)
        file_report_failure("take half a line off", f->path, errno);
    return 1;
}

/* --- files ---------------------------------------------------------------- */

char *folder_file(struct folder *f, const char *name)
{
    return folder_add(f, name) == 0 ? file_join(f->dir, name) : NULL;
}

int folder_make(struct folder *f, const char *name)
{
    char *const entry = file_join(name, "");
    char *const path = file_join(f->dir, name);
    const int failed = folder_add(f, entry) != 0 || file_make_dirs(path) != 0;

    free(entry);
    free(path);
    return failed;
}

int folder_list(struct folder *f, const char *path)
{
    return folder_add(f, path + strlen(f->dir) + 1);
}

struct table *folder_table(struct folder *f, const char *name,
                           struct table_head *head)
{
    const char *const *const names = (const char *const *)head->name;
    char *const path = folder_file(f, name);
    struct table *const made = path == NULL ? NULL
                               : f->resumes
                                   ? table_open(path, head->n, names)
                                   : table_create(path, head->n, names);

    free(path);
    table_head_clear(head);
    return made;
}

const char *folder_name(const struct folder *f)
{
    return f->dir;
}
