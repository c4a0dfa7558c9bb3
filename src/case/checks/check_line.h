/* check_line.h -- a line of `winnow check`. */
#ifndef CASE_CHECKS_CHECK_LINE_H
#define CASE_CHECKS_CHECK_LINE_H

/* Prints a number with its name, its unit and a remark. */
void check_line(const char *name, double value, const char *unit,
                const char *remark);

#endif
