/* case_averaging_report.h -- what a case's averaging keeps and what it smears.
 */
#ifndef CASE_REPORT_CASE_AVERAGING_REPORT_H
#define CASE_REPORT_CASE_AVERAGING_REPORT_H

#include "case/settings.h"

/* What the numbers depend on beside the settings. */
struct averaging_scales {
    double S_c;    /* [m] cube root of the mean cell */
    double d;      /* [m] largest diameter */
    double volume; /* [m^3] of the particles of a bed; 0: none */
    double eps_s;  /* [-] of a packed bed */
};

/* Prints the bandwidth beside cells, particles and bed, and what the method
 * asks for. */
void case_averaging_print(const struct settings *s,
                          const struct averaging_scales *k);

#endif
