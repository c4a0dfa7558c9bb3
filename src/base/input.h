/* input.h -- files that are read.
 *
 * Only ordinary ones: a device has no end, a pipe without a writer is waited
 * for for ever, and a folder is none; but fopen takes them all.
 */
#ifndef INPUT_H
#define INPUT_H

#include <stddef.h>

/* Why the file cannot be read, in words; errno says whether it is there. NULL
 * if it can. */
const char *input_wrong(const char *path);

/* All of it, with a zero byte after the end, for free(); *length without that
 * byte. NULL if it cannot be read, and *why says so. */
char *input_text(const char *path, size_t *length, const char **why);

#endif
