/* outline.h -- surfaces as polygons for display.
 *
 * Of a plane, what lies in the box; of a cylinder, 64 flat sides as long as the
 * box; triangles as they are.
 */
#ifndef OUTPUT_OUTLINE_H
#define OUTPUT_OUTLINE_H

#include "dem/surfaces/surface.h"

struct outline {
    int n_points, n_polygons, point_room, polygon_room;
    double *x;   /* [m] 3 a point */
    int *corner; /* [-] 0, 1, ...: each polygon has points of its own */
    int *end;    /* [-] number of points up to the end of each polygon */
    int *of;     /* [-] the number of its surface */
};

void outline_release(struct outline *o);

/* All surfaces as they are at time t [s], instead of what o held. */
void outline_draw(struct outline *o, const struct surface *list, int n,
                  const double lo[3], const double hi[3], double t);

#endif
