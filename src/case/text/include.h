/* include.h -- the text of a case, before it is read. */
#ifndef CASE_TEXT_INCLUDE_H
#define CASE_TEXT_INCLUDE_H

/* The case file and what it includes, which lies in `folder` or, if that is
 * NULL, where the program runs. 0, or the exit code after one message. */
int include_check_file(const char *file, const char *folder);

/* The value of an override, the text of one value: what is wrong with it, or
 * NULL. */
const char *include_check_value(const char *value);

#endif
