/* body_seal.h -- fluid that bodies shut off from every outlet.
 * Chapter "Resolving the grains".
 *
 * Cells that no body holds make parts, joined through their faces. What an
 * inlet or a body that moves pushes into a part without an outlet has no way
 * but through a body, whatever the friction there.
 */
#ifndef RESOLVED_BODY_SEAL_H
#define RESOLVED_BODY_SEAL_H

#include "fluid/fluid.h"

struct solid_bodies;

/* A gap of less than a cell. */
struct body_seal_gap {
    int beside;   /* [-] 1 + the body beside it; 0: there is none */
    int across;   /* [-] 1 + the body on the other side of it; 0: a wall */
    double width; /* [-] in cells */
};

struct body_seal {
    int outside;    /* [-] cells in no body */
    int inlet;      /* [-] 1: one is cut off from every outlet */
    int pushes;     /* [-] 1 + the body that pushes into a part without an
                       outlet; 0: none */
    double covered; /* [-] of the area of an inlet, what bodies hold at most */
    struct body_seal_gap closed, open; /* the widest of them */
};

/* To be called while links are made, after closed_gap_find: body_of is
 * positive in the cells that a body holds, and not above 0 in all others. */
void body_seal_find(struct solid_bodies *b, const struct fluid *fl);

/* Between which two a gap is, and what becomes of it. */
enum { BODY_SEAL_TEXT = 120 };
void body_seal_describe(const struct body_seal_gap *g, int open,
                        char text[BODY_SEAL_TEXT]);

/* Gaps of less than a cell.
 *
 * Of the flow that a pressure drives through a gap of n cells a mesh makes 1 +
 * 2/n^2 of the exact one, and with n = 1 at least: three times too much and
 * more. Nothing is nearer. So the body holds the cells, with the velocity of
 * Couette's flow, if the gap does not change; else the fluid has to get out of
 * it, and it stays open. */

/* To be called when body_of is 1 + the body around a cell, else 0: where body i
 * holds a cell of a gap it is 1 + i + the number of bodies afterwards. The
 * widest that is closed, and that stays open, begin b->seal anew. Returns how
 * many cells it has closed. */
int closed_gap_find(struct solid_bodies *b, const struct fluid *fl);

/* Which body holds a cell of such a gap; negative: none does. */
int closed_gap_of(const struct solid_bodies *b, int c);

/* Changes the velocity of a body [m/s] to that of Couette's flow in cell c, at
 * the distance s [m] from it: beside a wall that fluid sticks to. */
void closed_gap_velocity(const struct fluid *fl, int c, double s, double u[3]);

#endif
