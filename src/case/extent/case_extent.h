/* case_extent.h -- how large the space of a case is, and what is in it. */
#ifndef CASE_EXTENT_CASE_EXTENT_H
#define CASE_EXTENT_CASE_EXTENT_H

#include "case/settings.h"

/* The cells that the case asks for, before there is a mesh; 0 for one from
 * files. They may be more than an int holds. */
double case_extent_cells(const struct settings *s);

/* [m^3] of all cells. */
double case_extent_volume(const struct settings *s);

/* 1 if the point is inside [m]. */
int case_extent_holds(const struct settings *s, const double x[3]);

#endif
