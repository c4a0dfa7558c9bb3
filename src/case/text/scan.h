/* scan.h -- the text of a case, a piece at a time. */
#ifndef CASE_TEXT_SCAN_H
#define CASE_TEXT_SCAN_H

/* Past whatever begins here: a string, a comment, a word or number, or one
 * other sign. At the end of the text the same place. */
const char *scan_next(const char *text);

/* 1 for what a word or a number is made of. */
int scan_is_word(char c);

#endif
