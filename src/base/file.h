/* file.h -- files that are written completely or not at all.
 *
 * Everything is written to PATH.partial and takes its name only when the last
 * byte is on the disk: neither a crash nor a full disk leaves half a file under
 * PATH, and the old file stays until the new one is complete. Every failure
 * gives one message on stderr, with the path and the reason.
 */
#ifndef BASE_FILE_H
#define BASE_FILE_H

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

/* Discards the file: removes PATH.partial and releases f. file_discard(NULL) is
 * fine.
 */
void file_discard(struct file *f);

/* Removes PATH.partial, for a program that ends while PATH is being written. */
void file_remove_part(const char *path);

/* Makes a folder and those above it, as mkdir -p; non-zero after a message. */
int file_make_dirs(const char *path);

/* "A/B" as a new string, released with free(). */
char *file_join(const char *folder, const char *name);

#endif
