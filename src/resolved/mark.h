/* mark.h -- which cells a body holds, and with which friction.
 * Chapter "Resolving the grains".
 *
 * With s the distance of a cell's centre from the surface, > 0 outside,
 *
 *   hold = C max(rho/dt, mu/h^2)                              s <= 0
 *   hold = sum over faces of mu |S| max(0, -s_nb) / (|d| V s)     s > 0
 *
 * A velocity u - u_b in proportion to s is linear, and its Laplacian vanishes.
 * The neighbour inside has 0 instead of the negative value that continues it,
 * and hold s is what is missing: the wall is at s = 0 and not at the centre of
 * a cell. The error is of second order, and hold does not contain dt.
 *
 * Where a moving body is nearer than a cell to a wall or to another body, the
 * cells between have two velocities to follow, and the fluid has no way out.
 * So a cell beside a wall, or beside a cell of another body, to which the body
 * can come nearer, is left to the fluid; lubrication (body_motion.h) adds what
 * such a gap of a cell lacks.
 */
#ifndef RESOLVED_MARK_H
#define RESOLVED_MARK_H

#include "mesh/mesh.h"
#include "resolved/solid_bodies.h"

/* C [-]: inside, the fluid moves with the body up to 1/C. */
extern const double mark_friction_inside;

/* Makes the links of all bodies where they are now, for steps of
 * fl->options.dt. Nothing is done if neither the bodies nor the step have
 * changed. */
void mark_bodies(struct solid_bodies *b, const struct fluid *fl);

/* The fluid, which rests, has from the beginning what a body that it moves
 * holds of it: of the velocity of the body and with the momentum rho V U.
 * Otherwise the body would lose this in the first step. */
void mark_start(struct solid_bodies *b, struct fluid *fl);

/* 1 if the gap between body i and body j, or if that is negative a wall with
 * the area S, may change. */
int mark_gap_changes(const struct solid_bodies *b, int i, int j,
                     const double S[3]);

/* Solid fraction of cell c [-], whose centre is at the distance s [m], as of a
 * plane surface. */
double mark_fraction(const struct mesh *m, int c, double s);

/* The cells in and around a body. */

/* The cells of a box around a point.
 *
 * The mesh is a box of equal cells. In a periodic direction the indices go on
 * beyond its ends. */

struct cell_window {
    int first[3], last[3]; /* [-] of each direction */
};

/* Walks over the indices at[3] of its cells, along x fastest. */
#define CELL_WINDOW_EACH(at, w)                                                \
    for (at[2] = (w).first[2]; at[2] <= (w).last[2]; at[2]++)                  \
        for (at[1] = (w).first[1]; at[1] <= (w).last[1]; at[1]++)              \
            for (at[0] = (w).first[0]; at[0] <= (w).last[0]; at[0]++)

/* The cells with a part within `extent` [m] of x [m], and one more layer. A
 * cell beside both ends of an extent that nearly meets itself across the period
 * is there twice; where the extent is a period long or longer, each is once. */
struct cell_window cell_window_around(const struct mesh *m, const double x[3],
                                      const double extent[3]);

/* The cell at these indices, and how far its centre is from x [m]. */
int cell_window_cell(const struct mesh *m, const int at[3], const double x[3],
                     double r[3]);

/* 1 if the box goes on beyond cell c on this side: 2 k the lower, 2 k + 1 the
 * upper one of direction k. */
static inline int box_goes_on(const struct box *b, int c, int side)
{
    const int k = side / 2, n = b->n[k];
    const int at = (k > 0 ? c / (k > 1 ? b->n[0] * b->n[1] : b->n[0]) : c) % n;

    if (b->periodic[k]) return n > 1;
    return side % 2 ? at < n - 1 : at > 0;
}

/* 1 if cell c touches no end of the box, so that the six beside it are c +- 1,
 * c +- a row, c +- a layer. */
static inline int box_is_amid(const struct box *b, int c)
{
    const int x = c % b->n[0], rows = c / b->n[0];
    const int y = rows % b->n[1], z = rows / b->n[1];

    return x > 0 && x < b->n[0] - 1 && y > 0 && y < b->n[1] - 1 && z > 0 &&
           z < b->n[2] - 1;
}

/* 1 if the cells beside cell c have the mark that it has. 0 also for a cell at
 * an end of the box, for which the faces are to be asked. */
static inline int box_is_alike(const struct box *b, const int *mark, int c)
{
    const int row = b->n[0], layer = row * b->n[1];

    return box_is_amid(b, c) && mark[c - 1] == mark[c] &&
           mark[c + 1] == mark[c] && mark[c - row] == mark[c] &&
           mark[c + row] == mark[c] && mark[c - layer] == mark[c] &&
           mark[c + layer] == mark[c];
}

/* What is done in cell c, whose centre is at r [m] from that of body i and at
 * the distance s [m] from its surface. */
typedef void body_cells_act(void *by, int i, int c, const double r[3],
                            double s);

/* In each cell with a part in the body's box, and one layer more. */
void body_cells_each(const struct solid_bodies *b, const struct mesh *m, int i,
                     body_cells_act *act, void *by);

#endif
