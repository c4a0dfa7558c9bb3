/* checks.h -- what keys must say together.
 *
 * Each key alone has been checked against its row; here a case is checked as a
 * whole: something to compute, every side of the box described once, an outlet
 * for what flows in, a contact law with the constants it asks for, a bed that
 * fits into the box.
 */
#ifndef CHECKS_H
#define CHECKS_H

#include "scene/settings.h"

/* 0, or 2 after one message. */
int checks_whole(const struct settings *s);

#endif
