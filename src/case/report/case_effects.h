/* case_effects.h -- which effects a case calls for.
 * Chapter "Further forces". */
#ifndef CASE_REPORT_CASE_EFFECTS_H
#define CASE_REPORT_CASE_EFFECTS_H

#include "coupling/effect_scales.h"
#include "case/checks/case_scales.h"

/* The scales from which the effects estimate their forces. */
struct effect_scales case_effects_scales(const struct settings *s,
                                         const struct case_scales *in);

/* Prints the estimate of every effect, named or not, and how the phases should
 * be coupled. */
void case_effects_print(const struct settings *s, const struct case_scales *in);

#endif
