/* case_bodies.h -- the group `bodies` of a case.  Chapter "Resolving the
 * grains". */
#ifndef CASE_RESOLVED_CASE_BODIES_H
#define CASE_RESOLVED_CASE_BODIES_H

#include "case/case_part.h"
#include "case/models.h"

extern const struct kind case_bodies_method;
extern const struct case_part case_bodies_part;
extern const struct key case_bodies_keys[];

/* case_body_mass.c: spring [N/m] of their contacts, how long a mass [kg]
 * touches a wall [s], the virtual mass C_v [-] of number i of a list, what a
 * contact of it has to stop [kg], and particle steps in a step of the fluid. */
double case_bodies_stiffness(const struct settings *s);
double case_bodies_impact_time(const struct settings *s, double m);
double case_bodies_virtual_mass(const struct settings *s, const char *of,
                                int i);
double case_bodies_contact_mass(const struct settings *s, const char *of, int i,
                                double C_v);
int case_bodies_dem_steps(const struct settings *s);

/* case_bodies_report.c: prints the section of `check`. */
void case_bodies_report(const struct settings *s,
                        const struct case_scales *scales);

/* case_bodies_check.c: 0, or 2 after a message; and the widths of a cell [m].
 */
int case_bodies_check(const struct settings *s);
extern const double case_bodies_least_cells; /* [-] in a body */
void case_bodies_cell_widths(const struct settings *s, double h[3]);

#endif
