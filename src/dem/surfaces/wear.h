/* wear.h -- what particles wear off a wall.
 * Chapter "Walls".
 *
 * A grain that strikes a wall at the speed U and the angle alpha from it cuts
 * out a volume, and one that slides wears off another,
 *
 *   V = c m U^2/(4 p) f(alpha)                                   [Finnie60]
 *   f = sin 2 alpha - 3 sin^2 alpha   for 3 tan alpha <= 1
 *       cos^2 alpha/3                 else
 *   V = k_A/p int F_n ds                                         [Archard53]
 *
 * with the hardness p of the wall. An impact is the first step of a contact,
 * before any force has changed the velocity, so V does not depend on the step.
 * The way s of sliding between two positions is that by which the spring of
 * friction gave way; a grain that sticks wears nothing.
 */
#ifndef DEM_SURFACES_WEAR_H
#define DEM_SURFACES_WEAR_H

#include "base/state.h"

struct surface;

struct wear_of {
    double hardness; /* [Pa] p; 0: it does not wear */
    double cutting;  /* [-] c */
    double archard;  /* [-] k_A */
};

/* Of one face since the run began: a triangle, or a whole plane or cylinder. */
struct wear_face {
    double worn;          /* [m^3] */
    double normal, shear; /* [N s] sums of the forces' sizes over time */
};

struct wear {
    int n;                  /* [-] faces of all that wear; 0: none does */
    int *first;             /* [-] of each surface; -1: it does not wear */
    struct wear_face *face; /* those of one surface in their order */
};

/* The arrays belong to the owner (base/alloc.h). */
struct wear wear_create(void *owner, const struct surface *list, int n);
int wear_faces(const struct surface *s);

/* Volumes [m^3]: of an impact of a mass [kg] with the velocity v [m/s] relative
 * to a wall with the normal n, and of sliding so far [m] under a force [N]. */
double wear_finnie(const struct wear_of *w, double mass, const double v[3],
                   const double n[3]);
double wear_archard(const struct wear_of *w, double F_n, double way);

/* Visits n faces (state.h). */
void wear_state(struct wear_face *face, int n, struct state *s);

#endif
