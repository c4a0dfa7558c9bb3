/* outline.h -- surfaces as polygons for display.
 *
 * A plane is drawn within the box, a cylinder as 64 flat sides as long as the
 * box, triangles as they are, any other shape as a net of its points.
 */
#ifndef OUTPUT_PICTURES_OUTLINE_H
#define OUTPUT_PICTURES_OUTLINE_H

#include "dem/surfaces/surface.h"

#include <stdio.h>

struct outline {
    int n_points, n_polygons, point_room, polygon_room;
    double *x;   /* [m] 3 a point */
    int *corner; /* [-] 0, 1, ...: polygons have no points in common */
    int *end;    /* [-] number of points up to the end of each polygon */
    int *of;     /* [-] the number of its surface */
};

void outline_release(struct outline *o);

/* Replaces the contents of o by all surfaces at time t [s]. */
void outline_draw(struct outline *o, const struct surface *list, int n,
                  const double lo[3], const double hi[3], double t);

/* Writes a segment, its places along the first two axes, for each polygon that
 * crosses the plane at z [m] along the third, each followed by an empty line,
 * with a number's shortest text. */
void outline_section(FILE *out, const struct outline *o, const int axis[3],
                     double z);

#endif
