/* digits.h -- detection of integers that libconfig would misread.
 *
 * libconfig holds a whole number without a point in an int and silently reads a
 * larger one as another number: 70000000000 Pa of Young's modulus would become
 * 1280523264. Such numbers are found in the text itself.
 */
#ifndef CASE_TEXT_DIGITS_H
#define CASE_TEXT_DIGITS_H

/* The first such number in the text, outside strings and comments; NULL if
 * there is none. *line is its line, the first being 1. */
const char *digits_find(const char *text, int *line);

/* 0, or 2 after a message about such a number in the text of a file. */
int digits_check(const char *file, const char *text);

#endif
