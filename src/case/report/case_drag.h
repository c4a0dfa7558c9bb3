/* case_drag.h -- the time scales and limits of a case's exchange. */
#ifndef CASE_REPORT_CASE_DRAG_H
#define CASE_REPORT_CASE_DRAG_H

#include "case/settings.h"

/* What the limits depend on beside the settings. */
struct drag_scales {
    double d;     /* [m] smallest diameter */
    double inlet; /* [m/s] superficial */
    double eps_s; /* [-] of a packed bed */
    double dt;    /* [s] of the fluid */
};

/* Prints the relaxation times, the sub-steps, and what a bed asks for. */
void case_drag_print(const struct settings *s, const struct drag_scales *k);

#endif
