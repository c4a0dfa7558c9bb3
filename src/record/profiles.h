/* profiles.h -- the names of the files of the profiles that a case asks for. */
#ifndef RECORD_PROFILES_H
#define RECORD_PROFILES_H

#include "case/settings.h"

enum { PROFILES_NAME = 64 };

/* What the file of the i-th profile is called, without its ending: "eps_f" at
 * the height of 0.0164 m is "eps_f_y16.4mm", along y at x = 0.011 m it is
 * "eps_f_along_y_x11mm"; a later one of the same field and line has the
 * beginning of its average besides, "_from1s". */
void profiles_name(const struct settings *s, int i, char name[PROFILES_NAME]);

#endif
