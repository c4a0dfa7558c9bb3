/* input.h -- files that are read.
 *
 * Only ordinary files are accepted. A device has no end, a pipe without a
 * writer blocks for ever, and a folder has no bytes, although fopen opens all
 * of them.
 */
#ifndef BASE_TABLES_INPUT_H
#define BASE_TABLES_INPUT_H

#include <stddef.h>

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
};
struct input input_of(const char *path);
void input_release(struct input *in);

/* Files that were read, each once, the last one first. */
struct inputs {
    struct input in;
    struct inputs *before;
};
const struct input *input_kept(struct inputs **all, const char *path);
void input_forget(struct inputs **all);

/* All of a file that is packed by gzip, as input_text: its bytes are counted
 * before memory is taken. */
int input_is_packed(const struct input *in);
char *input_unpacked(const struct input *in, size_t *length, const char **why);

#endif
