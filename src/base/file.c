/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _XOPEN_SOURCE 700 /* realpath */
#include "base/file.h"

#include "base/alloc.h"
#include "base/number.h"
#include "base/text.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

struct file {
    FILE *stream;
    char *path;    /* final name */
    char *partial; /* name until file_commit */
};

/* The text a b c, allocated. */
static char *joined(const char *a, const char *b, const char *c)
{
    const size_t la = strlen(a), lb = strlen(b), lc = strlen(c);
    char *const s = alloc_zeroed(la + lb + lc + 1, 1);

    memcpy(s, a, la);
    memcpy(s + la, b, lb);
    memcpy(s + la + lb, c, lc);
    return s;
}

/* The folder that a path leads to, as a new string; NULL if it is not there. */
static char *file_folder(const char *path)
{
    const char *const slash = strrchr(path, '/');
    char *const folder =
        slash == NULL ? strdup(".") : strndup(path, (size_t)(slash + 1 - path));
    char *const real = realpath(folder, NULL);

    free(folder);
    return real;
}

int file_is_within(const char *path, const char *beside)
{
    char *const in = file_folder(path), *const of = file_folder(beside);
    const size_t n = of != NULL ? strlen(of) : 0;
    const int is = in != NULL && of != NULL && strncmp(in, of, n) == 0 &&
                   (n == 1 || in[n] == '/' || in[n] == '\0');

    free(in);
    free(of);
    return is;
}

int file_report_failure(const char *what, const char *path, int reason)
{
    fprintf(stderr, "winnow: cannot %s %s: %s\n", what, path,
            reason ? strerror(reason) : "a write failed");
    return 1;
}

/* Frees the memory of a file that is closed. */
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

/* Whether the name of the partial file leads to our file, another one or
 * none. */
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

int file_write(const char *path, const char *bytes, size_t n)
{
    struct file *const f = file_create(path);

    if (f == NULL) return 1;
    fwrite(bytes, 1, n, f->stream);
    return file_commit(f);
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
        if (failed && !is_folder(part))
            reason =
                failed == EEXIST && access(part, F_OK) == 0 ? ENOTDIR : failed;
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

/* --- input ---------------------------------------------------------------- */

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
    free(in->asked);
}

char *input_named(const struct input *in)
{
    return joined(in->asked != NULL ? in->asked : "", in->path, "");
}

int input_refuse(const struct input *in, int line, const char *format, ...)
{
    char *const named = input_named(in);
    char message[512];
    va_list values;

    va_start(values, format);
    vsnprintf(message, sizeof message, format, values);
    va_end(values);
    text_wrong(named, line, "%s", message);
    free(named);
    return 1;
}

/* One that was not there is looked for again: a run writes its bed. */
struct input *input_kept(struct inputs **all, const char *path)
{
    struct inputs *k = *all;

    while (k != NULL && strcmp(k->in.path, path) != 0)
        k = k->before;
    if (k == NULL) {
        k = alloc_zeroed(1, sizeof *k);
        *k = (struct inputs){input_of(path), *all};
        *all = k;
    } else if (k->in.text == NULL) {
        const struct input again = input_of(path);
        input_release(&k->in);
        k->in = again;
    }
    return &k->in;
}

void input_forget(struct inputs **all)
{
    while (*all != NULL) {
        struct inputs *const k = *all;
        *all = k->before;
        input_release(&k->in);
        free(k);
    }
}

int input_is_packed(const struct input *in)
{
    return in->length > 2 && memcmp(in->text, "\x1f\x8b", 2) == 0;
}

/* Gives the stream its next bytes, which it counts by an int: of the file if it
 * has taken all, and room in `to`. */
static void feed(z_stream *z, const struct input *in, char *to, size_t room)
{
    static const size_t piece = 1 << 30;

    if (z->avail_in == 0) {
        if (z->next_in == NULL) z->next_in = (Bytef *)in->text;
        const char *const at = (const char *)z->next_in;
        const size_t rest = in->length - (size_t)(at - in->text);
        z->avail_in = (unsigned)(rest < piece ? rest : piece);
    }
    z->next_out = (Bytef *)to;
    z->avail_out = (unsigned)(room < piece ? room : piece);
}

/* Of what is packed in some megabytes, which may be without end, no more than
 * `most` [byte] is counted; with `to`, which has room for one more, it is
 * stored there. -1 if it is damaged. Files that follow one another are one. */
static long unpack(const struct input *in, double most, char *to)
{
    char piece[1 << 14];
    z_stream z = {0};
    long size = 0, limit = LONG_MAX - 1;
    int code = inflateInit2(&z, 15 + 16); /* with the header of gzip */

    number_long(floor(most), &limit); /* or as it is, for no limit */
    while (code == Z_OK && size <= limit) {
        const size_t room =
            to == NULL ? sizeof piece : (size_t)(limit - size) + 1;
        feed(&z, in, to == NULL ? piece : to + size, room);
        if (z.avail_in == 0) break;
        const unsigned before = z.avail_out;
        code = inflate(&z, Z_NO_FLUSH);
        size += before - z.avail_out;
        if (code == Z_STREAM_END && z.avail_in > 2 && z.next_in[0] == 0x1f)
            code = inflateReset(&z);
    }
    inflateEnd(&z);
    return code == Z_STREAM_END || size > limit ? size : -1;
}

char *input_unpacked(const struct input *in, size_t *length, const char **why)
{
    const long size = unpack(in, alloc_left(), NULL);
    char *const text = size >= 0 ? input_room(size, why) : NULL;

    if (size < 0) *why = "damaged";
    *length = size < 0 ? 0 : (size_t)size;
    if (text != NULL) unpack(in, (double)size, text);
    return text;
}
