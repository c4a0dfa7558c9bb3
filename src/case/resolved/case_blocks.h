/* case_blocks.h -- the boxes and cylinders among the bodies of a case.
 * Chapter "Resolving the grains". */
#ifndef CASE_RESOLVED_CASE_BLOCKS_H
#define CASE_RESOLVED_CASE_BLOCKS_H

#include "case/settings.h"
#include "resolved/body_shape.h"

extern const char case_blocks_boxes[], case_blocks_cylinders[];

/* 1 if a box, cylinder or closed surface is free. Then all boxes, cylinders and
 * surfaces touch others with points of their surfaces. */
int case_blocks_touch(const struct settings *s);

/* Number i of one of these two lists: along the axes of the mesh; and as an
 * outline, which turns, NULL if it never does and touches nothing. */
struct body_shape case_blocks_shape(const struct settings *s, const char *list,
                                    int i);
struct body_outline *case_blocks_outline(const struct settings *s,
                                         const char *list, int i);

/* The points of a closed outline that touch others, if any do. */
void case_blocks_add_points(const struct settings *s, struct body_outline *o);

/* 0, or 2 after a message. */
int case_blocks_check(const struct settings *s);

#endif
