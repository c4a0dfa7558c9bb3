/* triangles.h -- triangles, and a search for near ones.  Chapter "Walls". */
#ifndef DEM_SURFACES_TRIANGLES_H
#define DEM_SURFACES_TRIANGLES_H

#include "base/file.h"

/* --- a point and a triangle */

/* The point q of the triangle that is nearest to y [m]. The triangle has an
 * area. */
void triangle_nearest(const double corner[3][3], const double y[3],
                      double q[3]);

/* Unit normal, by the right hand from corner to corner; 0 if it has no area. */
void triangle_normal(const double corner[3][3], double n[3]);

/* 1 if the way from a to b leads through the triangle; a way that begins or
 * ends on it does not. */
int triangle_crossed(const double corner[3][3], const double a[3],
                     const double b[3]);

/* --- a set of triangles with a search for near ones.
 *
 * They lie in a grid of cells about as wide as a triangle, each in every cell
 * that its bounding box overlaps. They do not move: for a moving surface points
 * are transformed into its frame.
 */

struct triangles {
    int n;
    double (*corner)[3][3]; /* [m] three corners each */
    double lo[3], hi[3];    /* [m] the box around all of them */
    int cells[3];           /* [-] of the grid */
    double inverse[3];      /* [1/m] of their width */
    int *start, *member;    /* [-] the triangles of a cell */
};

/* The corners are copied. */
struct triangles *triangles_create(int n, double (*corner)[3][3]);

/* Those whose bounding box is within `reach` [m] of y in each direction, each
 * once, in ascending order within a cell; *found grows to hold them. */
struct triangle_list {
    int n, capacity;
    int *number;
};
void triangles_near(const struct triangles *t, const double y[3], double reach,
                    struct triangle_list *found);

/* --- stl: triangles from an STL file.
 *
 * Text ("solid ... facet ... endsolid", any number of solids) or binary (80
 * bytes of anything, the number of triangles, 50 bytes each). The length tells
 * which: a file that is as long as its binary head announces is binary, even
 * if it begins with "solid". The normals in the file are not used. */

struct stl {
    int n;
    double (*corner)[3][3]; /* [m] if that is the unit of the file */
    int dropped;            /* [-] triangles without an area, left out */
};

/* Non-zero after one message with the file and the line (or, of a binary file,
 * the number of the triangle): it cannot be read, or is no STL, or has no
 * triangle. Release with stl_release. */
int stl_parse(const struct input *file, struct stl *s);
void stl_release(struct stl *s);

#endif
