/* triangles.h -- a set of triangles with a search for near ones.
 * Chapter "Walls".
 *
 * They lie in a grid of cells about as wide as a triangle, each in every cell
 * that its bounding box overlaps. They do not move: for a moving surface points
 * are transformed into its frame.
 */
#ifndef DEM_SURFACES_TRIANGLES_H
#define DEM_SURFACES_TRIANGLES_H

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
void triangles_free(struct triangles *t);

/* Those whose bounding box is within `reach` [m] of y in each direction, each
 * once, in ascending order within a cell; *found grows to hold them. */
struct triangle_list {
    int n, capacity;
    int *number;
};
void triangles_near(const struct triangles *t, const double y[3], double reach,
                    struct triangle_list *found);

#endif
