/* case_bodies.h -- the group `bodies` of a case.  Chapter "Resolving the
 * grains". */
#ifndef CASE_RESOLVED_CASE_BODIES_H
#define CASE_RESOLVED_CASE_BODIES_H

#include "case/settings.h"
#include "coupling/simulation.h"
#include "case/models.h"
#include "resolved/body_seal.h"

extern const struct kind case_bodies_method;

/* The lists of bodies in the order in which they are numbered, ended by NULL;
 * how many there are in all; and 1 if number i of a list has this motion. */
extern const char case_bodies_spheres[];
extern const char *const case_bodies_lists[];
int case_bodies_count(const struct settings *s);
int case_bodies_is(const struct settings *s, const char *of, int i,
                   const char *motion);

/* case_body_mass.c: the spring of all contacts of bodies, for which the files
 * of their shapes are read. */
struct case_bodies_contact {
    double stiffness; /* [N/m] */
    int dem_steps;    /* [-] particle steps in a step of the fluid */
};
struct case_bodies_contact case_bodies_contact(const struct settings *s);

/* The virtual mass C_v [-] of number i of a list. */
double case_bodies_virtual_mass(const struct settings *s, const char *of,
                                int i);
/* The deepest overlap of free ones that is to be expected [-]. */
double case_bodies_expected_overlap(const struct settings *s);
int case_bodies_check_stiffness(const struct settings *s); /* 0, or 2 */

/* Before there are particles, after all else that is; and after all else has
 * been created. 0, or 2 after a message. */
int case_bodies_complete(const struct settings *s, struct simulation *sim,
                         struct dem_options *o);
int case_bodies_add(const struct settings *s, struct simulation *sim);

struct case_scales;
/* case_bodies_report.c: prints the section of `check`. */
void case_bodies_report(const struct settings *s,
                        const struct case_scales *scales);

/* case_bodies_check.c: 0, or 2 after a message; and the widths of a cell [m].
 */
int case_bodies_check(const struct settings *s);
/* The same, and for bodies in the places where they start. */
int case_bodies_check_start(const struct settings *s);
/* case_bodies.c: what they shut off at the start, and the least that a
 * prescribed one leaves of its way to a wall at the end [m]; 0, or 2 after a
 * message. */
struct case_bodies_first {
    struct body_seal seal;
    double left; /* HUGE_VAL: it goes to no wall */
};
int case_bodies_start(const struct settings *s,
                      struct case_bodies_first *first);
extern const double case_bodies_least_cells; /* [-] in a body */
void case_bodies_cell_widths(const struct settings *s, double h[3]);

#endif
