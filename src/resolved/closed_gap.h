/* SPDX-License-Identifier: GPL-3.0-or-later */
/* closed_gap.h -- gaps of less than a cell.  Chapter "Resolving the grains".
 *
 * Of the flow that a pressure drives through a gap of n cells a mesh makes 1 +
 * 2/n^2 of the exact one, and with n = 1 at least: three times too much and
 * more. Nothing is nearer. So the body holds the cells, with the velocity of
 * Couette's flow, if the gap does not change; else the fluid has to get out of
 * it, and it stays open.
 */
#ifndef RESOLVED_CLOSED_GAP_H
#define RESOLVED_CLOSED_GAP_H

#include "resolved/solid_bodies.h"

/* To be called when body_of is 1 + the body around a cell, else 0: where body i
 * holds a cell of a gap it is 1 + i + the number of bodies afterwards. The
 * widest that is closed, and that stays open, begin b->seal anew. */
void closed_gap_find(struct solid_bodies *b, const struct fluid *fl);

/* Which body holds a cell of such a gap; negative: none does. */
int closed_gap_of(const struct solid_bodies *b, int c);

/* Changes the velocity of a body [m/s] to that of Couette's flow in cell c, at
 * the distance s [m] from it: beside a wall that fluid sticks to. */
void closed_gap_velocity(const struct fluid *fl, int c, double s, double u[3]);

#endif
