/* include.h -- the files that a case is made of, looked at before they are
 * read.
 *
 * libconfig ends the program where an included file is a folder, and waits for
 * ever where it is a pipe.
 */
#ifndef CASE_INCLUDE_H
#define CASE_INCLUDE_H

/* 0 if the case and all that it includes, looked for in the folder (or NULL),
 * are texts that can be read. After a message: 4 if one cannot be read, 2 if it
 * is no text. */
int include_check(const char *file, const char *folder);

#endif
