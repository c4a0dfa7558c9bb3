/* forces.h -- forces of the fluid on its walls, as a case asks for them. */
#ifndef CASE_FORCES_FORCES_H
#define CASE_FORCES_FORCES_H

#include "case/settings.h"

/* How the columns of one begin: its name, or its patches or surfaces, of which
 * the first letters are taken if there are many. */
enum { FORCES_NAME = 64 };
void forces_name(const struct output_force *o, char name[FORCES_NAME]);

/* 0 if the case asks for what there is; else 2 after a message. */
int forces_check(const struct settings *s);

/* 1 if the case lets the fluid flow through a patch that it names. */
int forces_is_open(const struct settings *s, const char *patch);

#endif
