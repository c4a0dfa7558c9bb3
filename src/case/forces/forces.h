/* forces.h -- forces of the fluid on its walls, as a case asks for them. */
#ifndef CASE_FORCES_FORCES_H
#define CASE_FORCES_FORCES_H

#include "case/settings.h"

/* 1 if the case lets the fluid flow through a patch that it names. */
int forces_is_open(const struct settings *s, const char *patch);

#endif
