/* boundary_check.h -- the boundaries of the fluid, before there is one. */
#ifndef CASE_CHECKS_BOUNDARY_CHECK_H
#define CASE_CHECKS_BOUNDARY_CHECK_H

#include "case/settings.h"

/* 0 if all inlets and rotating walls can be built; else 2 after a message. */
int boundary_check(const struct settings *s);

#endif
