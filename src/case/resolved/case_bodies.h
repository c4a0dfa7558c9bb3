/* case_bodies.h -- the group `bodies` of a case.  Chapter "Resolving the
 * grains". All bodies stand in one array, with their shapes, which are made
 * once: the checks, the numbers of `check` and the simulation read it. */
#ifndef CASE_RESOLVED_CASE_BODIES_H
#define CASE_RESOLVED_CASE_BODIES_H

#include "case/settings.h"
#include "coupling/simulation.h"
#include "resolved/body_seal.h"
#include "resolved/body_shape.h"

struct case_body {
    const struct body_setup *says;
    enum body_list list;
    const char *path;        /* of that list */
    int number;              /* [-] in it */
    struct body_shape plain; /* of a sphere or block, before it is turned */
    struct body_outline *outline; /* of what turns or touches; NULL: none */
    double R_min, R_max;          /* [m] of the balls of a clump */
};

struct case_bodies {
    int n;
    struct case_body *item;
    int touch; /* [-] 1: a box, cylinder or surface is free, and all of them
                  touch others with points of their surfaces */
    double lo[3], hi[3], h[3]; /* [m] ends of the box, widths of a cell */
    int periodic[3];
};

/* Gives the settings their bodies; settings_free releases them. */
void case_bodies_keep(struct settings *s);
void case_bodies_release(struct settings *s);

/* Makes the outline, from its file if it has one. 0, or 2 after a message. */
int case_bodies_outline(const struct settings *s, struct case_body *b);

/* The spring of all contacts of bodies. */
struct case_bodies_contact {
    double stiffness; /* [N/m] */
    int dem_steps;    /* [-] particle steps in a step of the fluid */
};
struct case_bodies_contact case_bodies_contact(const struct settings *s);

/* The virtual mass C_v [-]; the deepest overlap of free ones that is to be
 * expected [-]. */
double case_bodies_virtual_mass(const struct settings *s,
                                const struct case_body *b);
double case_bodies_expected_overlap(const struct settings *s);
int case_bodies_check_stiffness(const struct settings *s); /* 0, or 2 */
/* All of them, before they hold the fluid; NULL after a message. */
struct solid_bodies *case_bodies_create(const struct settings *s);

/* Before there are particles, after all else that is; and after all else has
 * been created. 0, or 2 after a message. */
int case_bodies_complete(const struct settings *s, struct simulation *sim,
                         struct dem_options *o);
int case_bodies_add(const struct settings *s, struct simulation *sim);

/* case_bodies_report.c: prints the section of `check`. */
void case_bodies_report(const struct settings *s);

/* case_bodies_check.c: what a case may not ask of them, also in the places
 * where they start. 0, or 2 after a message. */
int case_bodies_check(const struct settings *s);
/* What they shut off at the start, and the least that a prescribed one leaves
 * of its way to a wall at the end [m]; 0, or 2 after a message. */
struct case_bodies_first {
    struct body_seal seal;
    double left; /* HUGE_VAL: it goes to no wall */
};
int case_bodies_start(const struct settings *s,
                      struct case_bodies_first *first);

#endif
