/* file.h -- files that appear whole or not at all.
 *
 * Everything is written to PATH.partial and takes its name only when the last
 * byte is on the disk: a reader, a crash or a full disk never meets half a
 * file, and the old file stays until the new one is complete. Every failure
 * gives one message on stderr, with the path and the reason.
 */
#ifndef FILE_H
#define FILE_H

#include <stdio.h>

struct file;

/* Opens PATH.partial for writing, anew: what had that name is gone, a link is
 * not followed. NULL after a message if that fails. */
struct file *file_create(const char *path);

/* Where to write; errors may be left to file_commit, the stream keeps them. */
FILE *file_stream(struct file *f);

/* Flushes to the disk, closes and renames to PATH; f is gone afterwards. If
 * anything failed since file_create: a message, no PATH.partial, non-zero. */
int file_commit(struct file *f);

/* Gives the file up: f and PATH.partial are gone. file_discard(NULL) is fine.
 */
void file_discard(struct file *f);

/* For a program that ends while PATH may be at work: PATH.partial is gone. */
void file_remove_part(const char *path);

/* Makes a folder and those above it, as mkdir -p; non-zero after a message. */
int file_make_dirs(const char *path);

/* "A/B" as a new string, released with free(). */
char *file_join(const char *folder, const char *name);

#endif
