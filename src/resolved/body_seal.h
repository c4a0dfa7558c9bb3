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
    struct body_seal_gap closed, open; /* the widest of them (closed_gap.h) */
};

/* To be called while links are made, after closed_gap_find: body_of is
 * positive in the cells that a body holds, and not above 0 in all others. */
void body_seal_find(struct solid_bodies *b, const struct fluid *fl);

/* Between which two a gap is, and what becomes of it. */
enum { BODY_SEAL_TEXT = 120 };
void body_seal_describe(const struct body_seal_gap *g, int open,
                        char text[BODY_SEAL_TEXT]);

#endif
