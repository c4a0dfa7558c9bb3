/* triangle_tree.h -- the nearest of many triangles.
 * Chapter "Resolving the grains".
 *
 * A binary tree of boxes: each contains the boxes of its two halves, the last
 * ones a few triangles. A box farther away than the nearest triangle so far is
 * passed over with all that is in it.
 */
#ifndef RESOLVED_SHAPES_TRIANGLE_TREE_H
#define RESOLVED_SHAPES_TRIANGLE_TREE_H

struct triangle_tree;

/* The corners [m] are borrowed. */
struct triangle_tree *triangle_tree_create(int n, double (*corner)[3][3]);
void triangle_tree_free(struct triangle_tree *t);

/* The triangle nearest to y [m], and q, its point that is. To begin with `near`
 * saves time, if that is one not far away. */
int triangle_tree_nearest(const struct triangle_tree *t, const double y[3],
                          int near, double q[3]);

/* Goes into the boxes, from lo to hi [m], and calls `act` for what is in the
 * smallest ones. Of two halves the one with the lower rank is first; those of
 * rank HUGE_VAL are passed over. */
struct triangle_tree_search {
    double (*rank)(void *by, const double lo[3], const double hi[3]);
    void (*act)(void *by, int i);
};
void triangle_tree_walk(const struct triangle_tree *t,
                        const struct triangle_tree_search *search, void *by);

#endif
