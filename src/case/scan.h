/* scan.h -- the text of a case, looked at before libconfig reads it.
 *
 * libconfig ends the program where an included file is a folder, and waits for
 * ever where it is a pipe. It holds a whole number without a point in an int
 * and silently reads a larger one as another number: 70000000000 Pa of Young's
 * modulus would become 1280523264.
 */
#ifndef CASE_SCAN_H
#define CASE_SCAN_H

#include "base/file.h"

/* Numbers of both kinds, [0, -9.81, 0], are a list for libconfig, and no array:
 * the brackets around them become round. */
void scan_mixed(char *text);

/* The first number that is too large in the text, outside strings and comments;
 * NULL if there is none. *line is its line, the first being 1. */
const char *scan_digits(const char *text, int *line);

/* The case file and what it includes, which lies in `folder` or, if that is
 * NULL, where the program runs; all are kept with the files that were read. 0,
 * or the exit code after one message. */
int scan_file(struct inputs **files, const char *file, const char *folder);

/* The value of an override, the text of one value: what is wrong with it, or
 * NULL. */
const char *scan_value(const char *value);

#endif
