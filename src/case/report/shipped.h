/* shipped.h -- the cases that come with the program: listed, and copied to
 * begin one's own with.
 */
#ifndef CASE_REPORT_SHIPPED_H
#define CASE_REPORT_SHIPPED_H

/* A line for each: its name and size, its title and what to look at. Returns
 * the exit code, after a message if it is not 0. */
int shipped_list(void);

#endif
