/* body_seal.h -- fluid that bodies shut off from every outlet.
 * Chapter "Resolving the grains".
 *
 * Cells that no body holds make parts, joined through their faces. What an
 * inlet or a body that moves pushes into a part without an outlet has no way
 * but through a body, whatever the friction there. Of a gap beside a body that
 * is narrower than half a cell the body holds the cells: it is closed.
 */
#ifndef RESOLVED_BODY_SEAL_H
#define RESOLVED_BODY_SEAL_H

#include "fluid/fluid.h"

struct solid_bodies;

struct body_seal {
    int outside;  /* [-] cells in no body */
    int inlet;    /* [-] 1: one is cut off from every outlet */
    int pushes;   /* [-] 1 + the body that pushes into a part without an outlet;
                     0: none */
    int beside;   /* [-] 1 + the body with the widest gap that is closed; 0 */
    int across;   /* [-] 1 + the body on the other side of it; 0: a wall */
    double width; /* [-] of this gap, in cells */
};

/* To be called while links are made: body_of is positive in the cells that a
 * body holds inside, and not above 0 in all others. */
struct body_seal body_seal_find(struct solid_bodies *b, const struct fluid *fl);

/* Between which two the widest gap is, and what becomes of it. */
enum { BODY_SEAL_TEXT = 80 };
void body_seal_describe(const struct body_seal *s, char text[BODY_SEAL_TEXT]);

#endif
