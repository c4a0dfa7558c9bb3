/* case_outlines.h -- the clumps and closed surfaces among the bodies of a case,
 * from their files. Chapter "Resolving the grains". */
#ifndef CASE_RESOLVED_CASE_OUTLINES_H
#define CASE_RESOLVED_CASE_OUTLINES_H

#include "case/settings.h"
#include "resolved/body_outline.h"

extern const char case_outlines_clumps[], case_outlines_surfaces[];

/* Number i of one of these two lists, at its scale. NULL after a message. */
struct body_outline *case_outlines_read(const struct settings *s,
                                        const char *list, int i);

/* The smallest and the largest radius of the balls of clump i [m]; both 0 if
 * its file cannot be read. */
void case_outlines_radii(const struct settings *s, int i, double R[2]);

/* 0, or 2 after a message. */
int case_outlines_check(const struct settings *s);

#endif
