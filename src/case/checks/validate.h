/* validate.h -- checks of a case as a whole.
 *
 * Each key alone has been checked against its row; here a case is checked as a
 * whole: something to compute, every side of the box described once, an outlet
 * for what flows in, a contact law with the constants it asks for, a bed that
 * fits into the box.
 */
#ifndef CASE_CHECKS_VALIDATE_H
#define CASE_CHECKS_VALIDATE_H

#include "case/settings.h"

/* 0, or 2 after one message. */
int validate_case(struct settings *s);

#endif
