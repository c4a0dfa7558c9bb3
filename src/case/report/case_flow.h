/* case_flow.h -- how far the fluid moves in a step, before it is computed. */
#ifndef CASE_REPORT_CASE_FLOW_H
#define CASE_REPORT_CASE_FLOW_H

#include "case/settings.h"

/* Prints the velocities of inlets, moving walls and mean flow, and the Courant
 * number that they have with a step of dt [s], between particles that take
 * eps_s [-] of the volume. */
void case_flow_print(const struct settings *s, double dt, double eps_s);

#endif
