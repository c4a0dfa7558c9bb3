/* scan.h -- the text of a case, a piece at a time. */
#ifndef CASE_SCAN_H
#define CASE_SCAN_H

/* Past whatever begins here: a string, a comment, a word or number, or one
 * other sign. At the end of the text the same place. */
const char *scan_next(const char *text);

/* Numbers of both kinds, [0, -9.81, 0], are a list for libconfig, and no array:
 * the brackets around them become round. */
void scan_mixed(char *text);

/* 1 for what a word or a number is made of. */
int scan_is_word(char c);

#endif
