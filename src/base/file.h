/* file.h -- files that are written completely or not at all, and files that
 * are read.
 *
 * Everything is written to PATH.partial and takes its name only when the last
 * byte is on the disk: neither a crash nor a full disk leaves half a file under
 * PATH, and the old file stays until the new one is complete. Every failure
 * gives one message on stderr, with the path and the reason.
 */
#ifndef BASE_FILE_H
#define BASE_FILE_H

#include <stddef.h>
#include <stdio.h>

struct file;

/* Opens PATH.partial for writing, anew: an older file of that name is removed,
 * and a link is not followed. NULL after a message if that fails. */
struct file *file_create(const char *path);

/* The stream to write to. Errors need not be checked before file_commit. */
FILE *file_stream(struct file *f);

/* Flushes to the disk, closes and renames to PATH; f is released. If anything
 * failed since file_create: a message, no PATH.partial, non-zero. */
int file_commit(struct file *f);

/* A whole file of so many bytes; non-zero after a message. */
int file_write(const char *path, const char *bytes, size_t n);

/* Prints that an action on a path failed, and why: errno, or 0 of a write;
 * returns 1. */
int file_report_failure(const char *what, const char *path, int reason);

/* Discards the file: removes PATH.partial and releases f. file_discard(NULL) is
 * fine. */
void file_discard(struct file *f);

/* Removes PATH.partial, for a program that ends while PATH is being written. */
void file_remove_part(const char *path);

/* Makes a folder and those above it, as mkdir -p; non-zero after a message. */
int file_make_dirs(const char *path);

/* 1 if the folder of a path is there, and is that of another path or lies in
 * it, wherever links lead. */
int file_is_within(const char *path, const char *beside);

/* "A/B" as a new string, released with free(). */
char *file_join(const char *folder, const char *name);

/* --- input: files that are read.
 *
 * Only ordinary files are accepted. A device has no end, a pipe without a
 * writer blocks for ever, and a folder has no bytes, although fopen opens all
 * of them.
 */

/* The reason why the file cannot be read, in words, with errno set; NULL if it
 * can be read. */
const char *input_wrong(const char *path);

/* The whole file with a zero byte after the end, released with free(); *length
 * does not count that byte. NULL if it cannot be read or the memory that is
 * left does not hold it, with the reason in *why. */
char *input_text(const char *path, size_t *length, const char **why);

/* A file that was read: NULL as the text, and why not. */
struct input {
    char *path, *text;
    size_t length;
    const char *why;
    char *asked; /* the place of the name in a case, or NULL */
};
struct input input_of(const char *path);

/* Prints what is wrong in it, by its path and line (0: none), after the place
 * that names it; returns 1. */
int input_refuse(const struct input *in, int line, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* The path, after the place that names it, as a new string. */
char *input_named(const struct input *in);
void input_release(struct input *in);

/* Files that were read, each once, the last one first. */
struct inputs {
    struct input in;
    struct inputs *before;
};
struct input *input_kept(struct inputs **all, const char *path);
void input_forget(struct inputs **all);

/* All of a file that is packed by gzip, as input_text: its bytes are counted
 * before memory is taken. */
int input_is_packed(const struct input *in);
char *input_unpacked(const struct input *in, size_t *length, const char **why);

#endif
